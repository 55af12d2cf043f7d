// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

#include <vtkSmartPointer.h>

#include <array>
#include <filesystem>

class vtkImageData;
class vtkRenderWindow;
class vtkRenderer;

namespace nexrad::scene
{

/// Throws Error when there is no X display to draw on. VTK would end the program.
void RequireDisplay();

/// An off-screen window for the renderer of one scene.
class PictureWindow
{
public:
  /// Throws Error when there is no display.
  PictureWindow(vtkRenderer* renderer, const std::array<int, 2>& size);
  ~PictureWindow();
  PictureWindow(const PictureWindow&) = delete;
  PictureWindow& operator=(const PictureWindow&) = delete;

  /// Makes the window's OpenGL context the current one. To be called before the scene is changed
  /// after it was drawn, where other windows draw in between: VTK releases what a scene no longer
  /// needs in the context that is current.
  void MakeCurrent();

  /// Draws the scene as it is now, as GrabPicture does.
  vtkSmartPointer<vtkImageData> Draw();

private:
  vtkSmartPointer<vtkRenderWindow> window;
};

/// Draws a window and gives what it shows: red, green, blue, a byte each. All pictures of the
/// program come from here. Throws Error where VTK or OpenGL reports one meanwhile.
vtkSmartPointer<vtkImageData> GrabPicture(vtkRenderWindow* window);

/// A name for a picture of that time that no file of the folder has yet, with a number from the
/// second on.
std::filesystem::path FreePictureName(const std::filesystem::path& folder, Time time);

/// Writes a picture as PNG, under a temporary name that is renamed at the end. Throws Error when
/// the file cannot be written.
void WritePng(vtkImageData* picture, const std::filesystem::path& path);

} // namespace nexrad::scene
