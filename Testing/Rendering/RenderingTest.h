// SPDX-License-Identifier: BSD-3-Clause
// What the tests that draw share: a window, its pictures, and their comparison.
#pragma once

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

/// One volume before a black background, drawn off screen.
class Scene
{
public:
  explicit Scene(int width = 256, int height = 256, int multiSamples = 0);
  ~Scene();

  vtkRenderWindow* GetWindow() { return this->Window; }
  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkVolume* GetVolume() { return this->Volume; }
  vtkVolumeProperty* GetProperty();

  /// Draws the scene with that mapper, or without the volume if it is nullptr.
  Picture Draw(vtkVolumeMapper* mapper);

private:
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

/**
 * The error that VTK's image comparison finds between a picture and Testing/Baseline/Rendering;
 * pixels are compared in place. Writes the picture to the test output folder; without a baseline it
 * says where it lies and returns infinity.
 */
double BaselineError(const Picture& picture, const std::string& name);
/// The largest BaselineError that passes.
constexpr double BaselineTolerance = 1.0;

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
