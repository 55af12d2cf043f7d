// SPDX-License-Identifier: BSD-3-Clause
// Merges radar files and draws the volume off screen: Storm FILE...
#include <vtkNexradDayReader.h>
#include <vtkNexradSession.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradVolumeScene.h>
#include <vtkOpenGLTextureSliceVolumeMapper.h>

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <cstdlib>
#include <iostream>

namespace
{
int CountLitPixels(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  const int* size = window->GetSize();
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  int lit = 0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    const unsigned char* pixel = pixels->GetPointer(3 * i);
    lit += pixel[0] + pixel[1] + pixel[2] > 30 ? 1 : 0;
  }
  return lit;
}

// The same files as the program nexrad3d draws them.
int DrawScene(int count, char* files[])
{
  vtkNew<vtkNexradSession> session;
  for (int i = 0; i < count; ++i)
  {
    session->AddFileName(files[i]);
  }
  session->GetDayReader()->SetDimensions(64, 64, 32);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(200, 200);
  window->AddRenderer(session->GetScene()->GetRenderer());
  if (!session->ShowTimeStep(0))
  {
    return 0;
  }
  window->Render();
  return CountLitPixels(window);
}
} // namespace

int main(int argc, char* argv[])
{
  vtkNew<vtkNexradDayReader> day;
  for (int i = 1; i < argc; ++i)
  {
    day->AddFileName(argv[i]);
  }
  day->SetDimensions(64, 64, 32);

  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputConnection(day->GetOutputPort());
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetScale(1.0, 1.0, 8.0);
  vtkNew<vtkNexradTransferFunction> look;
  look->FillProperty(volume->GetProperty());

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(200, 200);
  window->AddRenderer(renderer);
  window->Render();

  const int lit = CountLitPixels(window);
  std::cout << lit << " pixels show echo\n";
  const int litScene = DrawScene(argc - 1, argv + 1);
  std::cout << litScene << " pixels show echo, map or letters\n";
  return lit > 0 && litScene > lit ? EXIT_SUCCESS : EXIT_FAILURE;
}
