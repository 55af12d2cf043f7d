// SPDX-License-Identifier: BSD-3-Clause
// Merges radar files at one time and draws the volume: MergeAndDraw PICTURE.png FILE...
#include <vtkNexradDayReader.h>
#include <vtkOpenGLTextureSliceVolumeMapper.h>

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::cerr << "usage: MergeAndDraw PICTURE.png FILE...\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkNexradDayReader> day;
  for (int i = 2; i < argc; ++i)
  {
    day->AddFileName(argv[i]);
  }
  day->SetDimensions(128, 128, 64);
  day->UpdateInformation();

  // The reader publishes the time steps; ask for the one in the middle.
  vtkInformation* information = day->GetOutputInformation(0);
  const int steps = information->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  if (steps == 0)
  {
    return EXIT_FAILURE;
  }
  day->UpdateTimeStep(information->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[steps / 2]);

  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(10.0, 0.0, 0.6, 0.9);
  colour->AddRGBPoint(25.0, 0.0, 0.8, 0.0);
  colour->AddRGBPoint(40.0, 0.9, 0.8, 0.0);
  colour->AddRGBPoint(55.0, 0.9, 0.0, 0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(5.0, 0.0);
  opacity->AddPoint(60.0, 0.8);

  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputConnection(day->GetOutputPort());
  mapper->SetNumberOfSlices(256);

  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetScale(1.0, 1.0, 8.0); // heights stretched eight times
  volume->GetProperty()->SetColor(colour);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetScalarOpacityUnitDistance(5000.0); // m
  volume->GetProperty()->SetInterpolationTypeToLinear();

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(640, 480);
  window->AddRenderer(renderer);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Elevation(-50.0);
  renderer->ResetCameraClippingRange();
  window->Render();

  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(argv[1]);
  writer->SetInputConnection(picture->GetOutputPort());
  writer->Write();
  return EXIT_SUCCESS;
}
