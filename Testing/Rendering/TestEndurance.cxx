// SPDX-License-Identifier: BSD-3-Clause
// A thousand frames in which everything changes: no message of OpenGL, no growing memory, no object
// left behind.
#include "RenderingTest.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkImageAppendComponents.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <unistd.h>
#include <vector>

namespace
{

using namespace nexrad::testing;

constexpr int Frames = 1000;
/// Until then the shaders of all combinations are compiled, and the memory grows with them.
constexpr int Settled = 600;

/// Enough for all modes, inputs and states to take turns.
constexpr int FramesOfRound = 150;

class Endurance : public RenderingTest
{
protected:
  void SetUp() override
  {
    RenderingTest::SetUp();
    if (IsSkipped() || HasFatalFailure())
    {
      return;
    }
    this->MakeInputs();
    this->Mapper->SetNumberOfSlices(40);
    this->Mapper->AutoAdjustSampleDistancesOff();
    this->Mapper->SetCroppingRegionPlanes(-20.0, 10.0, -20.0, 10.0, 2.0, 20.0);
    this->Mapper->SetMaskTypeToBinary();
  }
  void TearDown() override
  {
    this->Stage.reset();
    this->Other.reset();
    RenderingTest::TearDown();
  }

  /// Resident memory of this process, MiB; its OpenGL is in software, so textures count.
  static double MemoryUsed()
  {
    std::ifstream statistics("/proc/self/statm");
    double total = 0.0;
    double resident = 0.0;
    statistics >> total >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
  }

  /// One of two states that take turns, each lasting so many frames.
  static bool Alternates(int frame, int period) { return (frame / period) % 2 == 1; }

  /// Volumes of several types, dimensions and numbers of components, each with a mask.
  void MakeInputs()
  {
    vtkNew<vtkImageAppendComponents> both;
    both->AddInputData(MakeStorm(16, VTK_UNSIGNED_CHAR, 9));
    both->AddInputData(MakeStorm(16, VTK_UNSIGNED_CHAR, 9));
    both->Update();
    this->Inputs = {MakeStorm(16, VTK_FLOAT), MakeStorm(21, VTK_DOUBLE, 7),
      MakeStorm(12, VTK_SHORT), MakeStorm(17, VTK_UNSIGNED_CHAR, 16), both->GetOutput()};
    for (const auto& input : this->Inputs)
    {
      auto mask = vtkSmartPointer<vtkImageData>::New();
      mask->CopyStructure(input);
      mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
      auto* values = static_cast<unsigned char*>(mask->GetScalarPointer());
      for (vtkIdType i = 0; i < mask->GetNumberOfPoints(); ++i)
      {
        values[i] = i % 16 < 8 ? 0 : 255;
      }
      this->Masks.push_back(mask);
    }
  }

  static std::unique_ptr<Scene> MakeScene(int multiSamples)
  {
    auto scene = std::make_unique<Scene>(64, 64, multiSamples);
    EXPECT_TRUE(scene->HasDebugOutput()) << "OpenGL 4.3 is needed for the debug output";
    SetStormFunctions(scene->GetProperty(), VTK_FLOAT);
    scene->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 30.0);
    vtkCamera* camera = scene->GetRenderer()->GetActiveCamera();
    camera->SetFocalPoint(0.0, 0.0, 12.0);
    camera->SetPosition(50.0, -90.0, 70.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetClippingRange(20.0, 250.0);
    return scene;
  }

  /// Every 50 frames a new window takes the place of the first; the second stays, and every tenth
  /// frame is drawn there.
  Scene& ChangeWindow(int frame)
  {
    if (frame % 50 == 0)
    {
      this->Stage = MakeScene(frame % 100 == 0 ? 0 : 4);
    }
    if (this->Other == nullptr)
    {
      this->Other = MakeScene(0);
    }
    return frame % 10 == 9 ? *this->Other : *this->Stage;
  }

  void ChangeInput(int frame)
  {
    const auto input = static_cast<std::size_t>(frame / 5) % this->Inputs.size();
    this->Components = this->Inputs[input]->GetNumberOfScalarComponents();
    this->Mapper->SetInputData(this->Inputs[input]);
    this->Mapper->SetMaskInput(Alternates(frame, 19) ? this->Masks[input] : nullptr);
    if (frame % 3 == 0)
    {
      this->Inputs[input]->GetPointData()->GetScalars()->Modified(); // as if changed in place
    }
  }

  /// A control point moved, and now and then functions that are new altogether.
  void ChangeFunctions(int frame, vtkVolumeProperty* property)
  {
    property->GetScalarOpacity()->AddPoint(40.0, 0.1 + 0.01 * (frame % 10));
    if (frame % 23 == 0)
    {
      SetStormFunctions(property, VTK_FLOAT);
    }
    vtkNew<vtkPiecewiseFunction> gradientOpacity;
    gradientOpacity->AddPoint(0.0, 0.2);
    gradientOpacity->AddPoint(10.0, 1.0);
    property->SetGradientOpacity(Alternates(frame, 29) ? gradientOpacity.Get() : nullptr);
    property->SetShade(Alternates(frame, 3));
    property->SetInterpolationType(
      Alternates(frame, 31) ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
  }

  void ChangeMapper(int frame)
  {
    // Isosurfaces are those of one component.
    this->Mapper->SetBlendMode(frame % (this->Components == 1 ? 6 : 5));
    this->Mapper->SetImageSampleDistance(Alternates(frame, 13) ? 2.0f : 1.0f);
    this->Mapper->SetCropping(Alternates(frame, 17));
  }

  Scene& Change(int frame)
  {
    Scene& scene = this->ChangeWindow(frame);
    scene.GetWindow()->SetSize(Alternates(frame, 7) ? 64 : 80, Alternates(frame, 11) ? 64 : 48);
    scene.GetRenderer()->GetActiveCamera()->Azimuth(3.0);
    this->ChangeInput(frame);
    this->ChangeFunctions(frame, scene.GetProperty());
    this->ChangeMapper(frame);
    return scene;
  }

  /// Draws that frame, with no message. @return whether there was something to see
  bool DrawFrame(int frame)
  {
    Scene& scene = this->Change(frame);
    const Picture picture = scene.Draw(this->Mapper);
    return Compare(picture, picture, scene.Draw(nullptr)).Pixels > 100;
  }

  std::vector<vtkSmartPointer<vtkImageData>> Inputs;
  std::vector<vtkSmartPointer<vtkImageData>> Masks;
  int Components = 1; ///< of the present input
  std::unique_ptr<Scene> Stage;
  std::unique_ptr<Scene> Other;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Mapper;
};

} // namespace

TEST_F(Endurance, AThousandFrames)
{
  double settled = 0.0;
  int drawn = 0;
  for (int frame = 0; frame < Frames; ++frame)
  {
    drawn += this->DrawFrame(frame) ? 1 : 0;
    ASSERT_FALSE(HasFailure()) << "frame " << frame;
    if (frame == Settled)
    {
      settled = MemoryUsed();
    }
  }
  this->Stage.reset();
  const double growth = MemoryUsed() - settled;
  std::cout << "grown by " << growth << " MiB in the last " << Frames - Settled << " frames, "
            << drawn << " of " << Frames << " frames drawn\n";
  EXPECT_AT_LEAST(drawn, 7 * Frames / 10, "frames drawn");
#ifndef __SANITIZE_ADDRESS__ // which keeps what was freed for a while
  // A leak of one picture a frame would be more.
  EXPECT_AT_MOST(growth, 8.0, "growth of the memory, MiB");
#endif
}

// Two windows that stay: what the mapper made in them is gone when it has released it, whatever was
// drawn. VTK's cache keeps the programs of a window until the window goes; a second round needs no
// other ones.
TEST_F(Endurance, NoObjectIsLeftBehind)
{
  this->DrawFrame(0);
  const auto held = CountOpenGLObjects();
  const auto released = [&]
  {
    this->Mapper->ReleaseGraphicsResources(this->Stage->GetWindow());
    this->Stage->Draw(nullptr);
    return CountOpenGLObjects();
  };
  const auto before = released();
  EXPECT_LT(before.at("textures"), held.at("textures")) << "the mapper's textures are not counted";
  EXPECT_LT(before.at("vertex arrays"), held.at("vertex arrays"));
  std::vector<std::map<std::string, int>> rounds;
  for (int round = 0; round < 2; ++round)
  {
    for (int frame = 1; frame < FramesOfRound; ++frame)
    {
      this->DrawFrame(frame % 50 == 0 ? 1 : frame); // multiples of 50 would open a window
    }
    this->DrawFrame(1); // in the first window again
    rounds.push_back(released());
  }
  for (const auto& [kind, first] : rounds[0])
  {
    const int second = rounds[1].at(kind);
    std::cout << kind << ": " << held.at(kind) << " while drawing, " << before.at(kind)
              << " released, " << first << " after a round, " << second << " after two\n";
    EXPECT_EQ(second, first) << kind;
    if (kind != "programs" && kind != "shaders")
    {
      EXPECT_EQ(first, before.at(kind)) << kind;
    }
  }
}
