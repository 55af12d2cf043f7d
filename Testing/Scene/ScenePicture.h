// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

class vtkImageData;
class vtkNexradVolumeScene;
class vtkRenderWindow;
class vtkRenderer;

namespace nexrad::testing
{

/// RGB bytes.
using Picture = vtkSmartPointer<vtkImageData>;

/// A window off screen, with 4 multisamples as the program's pictures have.
class OffScreenWindow
{
public:
  OffScreenWindow(vtkRenderer* renderer, const std::array<int, 2>& size);
  ~OffScreenWindow();

  vtkRenderWindow* Window() { return window; }
  Picture Draw();

private:
  vtkNew<vtkRenderWindow> window;
};

/// The look of scene::UseClassicLook, for tests of one thing: no light, no automatic choices.
void UseClassicLook(vtkNexradVolumeScene* scene);

std::array<int, 3> PixelOf(const Picture& picture, int x, int y);

/// Mean over all pixels and colours of the absolute difference, 0 to 255; infinity when the sizes
/// differ.
double MeanDifference(const Picture& a, const Picture& b);

/// Writes a picture into the tests' output folder for a person to look at. Returns its path.
std::string KeepPicture(const Picture& picture, const std::string& name);

/// Expects a picture to be the baseline of that name (Testing/Baseline/Scene), and a picture that
/// is moved by one pixel not to be.
void ExpectSceneBaseline(const Picture& picture, const std::string& name);

} // namespace nexrad::testing
