// SPDX-License-Identifier: BSD-3-Clause
// What the tests that draw share: a window, its pictures, and their comparison.
#pragma once

#include "OpenGLMessages.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>

class vtkImageData;
class vtkRenderWindow;
class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;
class vtkVolumeProperty;

namespace nexrad::testing
{

/// RGB bytes.
using Picture = vtkSmartPointer<vtkImageData>;
/// Red, green and blue, 0 to 255.
using Color = std::array<double, 3>;

/// One volume before a black background, drawn off screen. With the debug output, whatever OpenGL
/// reports fails the test, up to the end of the window.
class Scene
{
public:
  explicit Scene(int width = 256, int height = 256, int multiSamples = 0, bool debugOutput = true);
  ~Scene();

  vtkRenderWindow* GetWindow() { return this->Window; }
  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkVolume* GetVolume() { return this->Volume; }
  vtkVolumeProperty* GetProperty();
  /// What OpenGL reported; a test that asks for it itself takes it away.
  OpenGLMessages& GetMessages() { return this->Messages; }
  bool HasDebugOutput() const { return this->Watched; }

  /// Draws the scene with that mapper, or without the volume if it is nullptr.
  Picture Draw(vtkVolumeMapper* mapper);

private:
  OpenGLMessages Messages; // before the window, which reports until it is gone
  bool Watched = false;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
};

Color PixelAt(const Picture& picture, int x, int y);

struct Difference
{
  Color Mean{};     ///< mean absolute difference of each channel, 0 to 255
  double Worst = 0; ///< largest difference of any channel
  int Pixels = 0;   ///< that were compared
  double LargestMean() const;
};

/// Compares two pictures over the pixels in which either differs from the background.
Difference Compare(const Picture& a, const Picture& b, const Picture& background);

/// Writes a picture to the test output folder. @return its path
std::string WritePicture(const Picture& picture, const std::string& name);
/// |a - b|, eight times as bright.
Picture DifferencePicture(const Picture& a, const Picture& b);
/// The picture moved to the left by one pixel.
Picture MovedPicture(const Picture& picture);

/// Whether highlights are Phong's, as those of VTK 9.2 and later, in place of Blinn's.
bool HasMirroredHighlights();

/**
 * The error that VTK's image comparison finds between a picture and Testing/Baseline/Rendering;
 * pixels are compared in place. Channels that differ by up to 2 of 255 are forgiven; of the others,
 * what is beyond 2 is summed up, 3 x 255 being 1: a whole pixel. Infinity without a baseline. Where
 * highlights are mirrored, NAME-mirrored.png counts if it exists.
 */
double BaselineError(const Picture& picture, const std::string& name);
/// The largest BaselineError that passes.
constexpr double BaselineTolerance = 0.5;
/// Writes the picture, and expects it to be that of the baseline; the same picture moved by one
/// pixel must be refused.
void ExpectBaseline(const Picture& picture, const std::string& name);

/**
 * Skips the test without a display (fails where NEXRAD_REQUIRE_DISPLAY=1), and fails it on any VTK
 * message or OpenGL error that it did not expect.
 */
class RenderingTest : public ::testing::Test
{
protected:
  RenderingTest();
  ~RenderingTest() override;
  void SetUp() override;
  void TearDown() override;

  /// The VTK messages since the last call.
  std::string TakeMessages();

private:
  class Collector;
  vtkSmartPointer<Collector> Messages;
};

} // namespace nexrad::testing
