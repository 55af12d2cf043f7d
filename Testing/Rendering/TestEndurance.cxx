// SPDX-License-Identifier: BSD-3-Clause
// A thousand frames in which everything changes: no OpenGL error, no growing memory.
#include "RenderingTest.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <fstream>
#include <iostream>
#include <memory>
#include <unistd.h>
#include <vector>

namespace
{

using namespace nexrad::testing;

class Endurance : public RenderingTest
{
protected:
  /// Resident memory of this process, MiB; its OpenGL is in software, so textures count.
  static double MemoryUsed()
  {
    std::ifstream statistics("/proc/self/statm");
    double total = 0.0;
    double resident = 0.0;
    statistics >> total >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
  }

  /// Changes input, functions, features, window size and, now and then, the window.
  void Change(int frame)
  {
    if (frame % 50 == 0)
    {
      this->Stage = std::make_unique<Scene>(64, 64, frame % 100 == 0 ? 0 : 4);
      SetStormFunctions(this->Stage->GetProperty(), VTK_FLOAT);
      this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 30.0);
      vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
      camera->SetFocalPoint(0.0, 0.0, 12.0);
      camera->SetPosition(50.0, -90.0, 70.0);
      camera->SetViewUp(0.0, 0.0, 1.0);
      camera->SetClippingRange(20.0, 250.0);
    }
    const auto pick = [frame](int period) { return (frame / period) % 2 == 1; };
    this->Stage->GetWindow()->SetSize(pick(7) ? 64 : 80, pick(11) ? 64 : 48);
    this->Stage->GetRenderer()->GetActiveCamera()->Azimuth(3.0);
    this->Mapper->SetInputData(this->Inputs[static_cast<std::size_t>(frame / 5) % 4]);
    this->Mapper->SetBlendMode(frame % 6);
    this->Mapper->SetImageSampleDistance(pick(13) ? 2.0f : 1.0f);
    this->Mapper->SetCropping(pick(17));
    this->Mapper->SetMaskInput(pick(19) ? this->Mask : nullptr);
    this->Mapper->SetMaskTypeToBinary();
    this->Stage->GetProperty()->SetShade(pick(3));
    this->Stage->GetProperty()->GetScalarOpacity()->AddPoint(40.0, 0.1 + 0.01 * (frame % 10));
  }

  void MakeInputs()
  {
    this->Inputs = {MakeStorm(16, VTK_FLOAT), MakeStorm(16, VTK_DOUBLE), MakeStorm(16, VTK_SHORT),
      MakeStorm(16, VTK_UNSIGNED_CHAR)};
    this->Mask = vtkSmartPointer<vtkImageData>::New();
    this->Mask->CopyStructure(this->Inputs[0]);
    this->Mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    auto* values = static_cast<unsigned char*>(this->Mask->GetScalarPointer());
    for (vtkIdType i = 0; i < this->Mask->GetNumberOfPoints(); ++i)
    {
      values[i] = i % 16 < 8 ? 0 : 255;
    }
  }

  std::vector<vtkSmartPointer<vtkImageData>> Inputs;
  vtkSmartPointer<vtkImageData> Mask;
  std::unique_ptr<Scene> Stage;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Mapper;
};

} // namespace

TEST_F(Endurance, AThousandFrames)
{
  this->MakeInputs();
  this->Mapper->SetNumberOfSlices(40);
  this->Mapper->AutoAdjustSampleDistancesOff();
  this->Mapper->SetCroppingRegionPlanes(-20.0, 10.0, -20.0, 10.0, 2.0, 20.0);
  double settled = 0.0;
  int drawn = 0;
  for (int frame = 0; frame < 1000; ++frame)
  {
    this->Change(frame);
    const Picture picture = this->Stage->Draw(this->Mapper); // expects no OpenGL error
    drawn += Compare(picture, picture, this->Stage->Draw(nullptr)).Pixels > 100 ? 1 : 0;
    ASSERT_FALSE(HasFailure()) << "frame " << frame;
    if (frame == 300)
    {
      settled = MemoryUsed();
    }
  }
  this->Stage.reset();
  const double growth = MemoryUsed() - settled;
  std::cout << "grown by " << growth << " MiB from frame 300 on, " << drawn << " frames drawn\n";
  EXPECT_GT(drawn, 700);
  // A leak of one volume texture a frame, or of one picture a window, would be more.
  EXPECT_LT(growth, 16.0);
}
