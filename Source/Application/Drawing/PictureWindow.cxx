// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PictureWindow.h"

#include "Libraries/VtkErrors.h"
#include "Output/OutputFile.h"
#include "nexrad/System/Error.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <X11/Xlib.h>
#undef None // a word of enumerations, in the files that are compiled with this one

#include <cstdlib>
#include <string>

namespace nexrad::scene
{

void RequireDisplay()
{
  Display* display = XOpenDisplay(nullptr);
  if (display == nullptr)
  {
    const char* name = std::getenv("DISPLAY");
    throw Error(std::string("no X display to draw on (DISPLAY is ") +
                (name == nullptr || *name == '\0' ? "not set" : name) +
                "); without a screen, run under xvfb-run -a");
  }
  XCloseDisplay(display);
}

PictureWindow::PictureWindow(vtkRenderer* renderer, const std::array<int, 2>& size)
{
  RequireDisplay();
  window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(4);
  window->SetSize(size[0], size[1]);
  // Else VTK chooses it by the depth buffer, and otherwise where the renderer is in no window yet.
  constexpr double nearest = 0.01; // of the distance that is seen
  renderer->SetNearClippingPlaneTolerance(nearest);
  window->AddRenderer(renderer);
}

PictureWindow::~PictureWindow() = default;

void PictureWindow::MakeCurrent()
{
  window->MakeCurrent();
}

vtkSmartPointer<vtkImageData> PictureWindow::Draw()
{
  return GrabPicture(window);
}

vtkSmartPointer<vtkImageData> GrabPicture(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->SetInputBufferTypeToRGB();
  grabber->ReadFrontBufferOff();
  grabber->ShouldRerenderOn();
  grabber->Update();
  application::ThrowVtkErrors();
  return grabber->GetOutput();
}

std::filesystem::path FreePictureName(const std::filesystem::path& folder, Time time)
{
  const std::string stem = "nexrad3d-" + FormatForFileName(time);
  std::filesystem::path path = folder / (stem + ".png");
  for (int number = 2; std::filesystem::exists(path); ++number)
  {
    path = folder / (stem + "-" + std::to_string(number) + ".png");
  }
  return path;
}

void WritePng(vtkImageData* picture, const std::filesystem::path& path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  application::WriteFile(
    path, bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

} // namespace nexrad::scene
