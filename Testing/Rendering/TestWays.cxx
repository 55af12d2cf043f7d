// SPDX-License-Identifier: BSD-3-Clause
// Fragments, compute shaders and polygons draw the same picture.
#include "RayCasterComparison.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <thread>

namespace
{

using namespace nexrad::testing;
using Mapper = vtkOpenGLTextureSliceVolumeMapper;

/// The environment variable that overrides the way; it is put back.
class WayVariable
{
public:
  /// @param value nullptr: it is not set
  explicit WayVariable(const char* value)
  {
    if (const char* before = std::getenv(Name))
    {
      this->Before = before;
    }
    Set(value);
  }
  ~WayVariable() { Set(this->Before ? this->Before->c_str() : nullptr); }
  WayVariable(const WayVariable&) = delete;
  WayVariable& operator=(const WayVariable&) = delete;

private:
  static constexpr const char* Name = "VTK_TEXTURE_SLICE_WAY";

  static void Set(const char* value) { value != nullptr ? setenv(Name, value, 1) : unsetenv(Name); }

  std::optional<std::string> Before;
};

/// The light volumes of two mappers differ, by no more than that, and something is dark in them.
void ExpectSameLight(Mapper* expected, Mapper* actual, double bound)
{
  vtkDataArray* lights = expected->GetLightVolume()->GetPointData()->GetScalars();
  vtkDataArray* others = actual->GetLightVolume()->GetPointData()->GetScalars();
  for (int component = 0; component < 2; ++component) // the light and the sky
  {
    double worst = 0.0;
    double darkest = 1.0;
    for (vtkIdType id = 0; id < lights->GetNumberOfTuples(); ++id)
    {
      const double light = lights->GetComponent(id, component);
      worst = std::max(worst, std::abs(others->GetComponent(id, component) - light));
      darkest = std::min(darkest, light);
    }
    std::cout << (component == 0 ? "the light" : ", the sky") << " differs by " << worst
              << ", the darkest is " << darkest << (component == 0 ? "" : "\n");
    EXPECT_GT(worst, 0.0);
    EXPECT_LT(worst, bound);
    EXPECT_LT(darkest, 0.8);
  }
}

class Ways : public StormAgainstRayCaster
{
protected:
  Picture DrawIn(int way)
  {
    this->Slices->SetWay(way);
    return this->Stage->Draw(this->Configure(this->Slices));
  }

  /// The pictures of all ways that the context has. @param byPolygons whether polygons can draw it
  void ExpectSame(const std::string& name, bool byPolygons = true)
  {
    const Picture background = this->Stage->Draw(nullptr);
    const Picture fragments = this->DrawIn(Mapper::FRAGMENTS);
    EXPECT_EQ(this->Slices->GetDrawnWay(), Mapper::FRAGMENTS);
    EXPECT_GT(Compare(fragments, background, background).Worst, 60.0) << name << ": too faint";
    const Picture compute = this->DrawIn(Mapper::COMPUTE);
    if (this->Slices->GetDrawnWay() == Mapper::COMPUTE)
    {
      this->Expect(name + ", compute", compute, fragments, background);
    }
    else
    {
      EXPECT_NE(this->TakeMessages().find("no compute shaders"), std::string::npos);
    }
    const Picture polygons = this->DrawIn(Mapper::POLYGONS);
    EXPECT_EQ(this->Slices->GetDrawnWay() == Mapper::POLYGONS, byPolygons);
    this->Expect(name + ", polygons", polygons, fragments, background);
  }

  /// Odd and even columns of voxels have labels 1 and 2, the first third none.
  vtkSmartPointer<vtkImageData> MakeMask()
  {
    auto mask = vtkSmartPointer<vtkImageData>::New();
    mask->CopyStructure(this->Input);
    vtkNew<vtkUnsignedCharArray> values;
    const vtkIdType points = mask->GetNumberOfPoints();
    const int columns = mask->GetDimensions()[0];
    for (vtkIdType id = 0; id < points; ++id)
    {
      const auto column = static_cast<int>(id % columns);
      values->InsertNextValue(
        static_cast<unsigned char>(column < columns / 3 ? 0 : 1 + column % 2));
    }
    mask->GetPointData()->SetScalars(values);
    return mask;
  }

private:
  const WayVariable Unset{nullptr};

  void Expect(const std::string& name, const Picture& picture, const Picture& fragments,
    const Picture& background)
  {
    const Difference difference = Compare(picture, fragments, background);
    std::cout << name << ": differs by at most " << difference.Worst << " of 255, mean "
              << difference.LargestMean() << '\n';
    EXPECT_LE(difference.Worst, 1.0) << name;
    if (difference.Worst > 1.0)
    {
      WritePicture(picture, "ways-" + name);
      WritePicture(fragments, "ways-" + name + "-fragments");
      WritePicture(DifferencePicture(picture, fragments), "ways-" + name + "-difference");
    }
  }
};

} // namespace

TEST_F(Ways, Views)
{
  this->ExpectSame("perspective");
  this->Slices->SetImageSampleDistance(2.5f);
  this->ExpectSame("coarse");
  this->Slices->SetImageSampleDistance(1.0f);
  this->Stage->GetProperty()->SetInterpolationTypeToNearest();
  this->ExpectSame("nearest");
  this->Stage->GetProperty()->SetInterpolationTypeToLinear();
  this->AimCamera(true);
  this->ExpectSame("parallel");
  this->AimCamera(false);
  vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
  camera->SetPosition(10.0, -20.0, 6.0);
  camera->SetFocalPoint(-12.0, -12.0, 8.0);
  this->Stage->GetRenderer()->ResetCameraClippingRange(-80, 80, -80, 80, -80, 80);
  this->ExpectSame("inside");
}

TEST_F(Ways, Cuts)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(-12.0, -12.0, 8.0);
  plane->SetNormal(0.3, 1.0, 0.2);
  this->Slices->AddClippingPlane(plane);
  this->ExpectSame("clipped");
  this->Slices->RemoveAllClippingPlanes();
  this->Slices->CroppingOn();
  this->Slices->SetCroppingRegionPlanes(-12.0, 10.0, -12.0, 10.0, 2.0, 9.0);
  this->Slices->SetCroppingRegionFlagsToInvertedCross();
  this->ExpectSame("cropped");
}

TEST_F(Ways, Geometry)
{
  this->AddSphere(-12.0, -14.0, 8.0, 8.0, 1.0);
  this->ExpectSame("geometry in front");
}

TEST_F(Ways, PeeledGeometry)
{
  this->AddSphere(-12.0, -14.0, 8.0, 8.0, 0.4);
  this->Stage->GetWindow()->SetAlphaBitPlanes(1);
  this->Stage->GetRenderer()->SetUseDepthPeeling(1);
  this->Stage->GetRenderer()->SetUseDepthPeelingForVolumes(true);
  this->ExpectSame("peeled");
}

TEST_F(Ways, LightAndMask)
{
  this->Stage->GetProperty()->ShadeOn();
  this->ExpectSame("lit");
  this->Slices->SetShadowStrength(0.7);
  this->ExpectSame("in shadow");
  this->Slices->SetMaskInput(this->MakeMask());
  this->Slices->SetMaskTypeToBinary();
  this->ExpectSame("masked");
}

// The processor approximates the exponential function within 0.01 %, so that lights which are equal
// to the last bit come from one and the same.
TEST_F(Ways, ComputeFollowsTheLightAsTheProcessorDoes)
{
  constexpr double bound = 7.8e-5; // measured: 3.9e-5
  vtkContourValues* surfaces = this->Stage->GetProperty()->GetIsoSurfaceValues();
  surfaces->SetValue(0, 20.0);
  surfaces->SetValue(1, 40.0);
  vtkNew<Mapper> byProcessor;
  vtkNew<Mapper> byCompute;
  byProcessor->SetWay(Mapper::FRAGMENTS);
  byCompute->SetWay(Mapper::COMPUTE);
  for (const int blendMode : {vtkVolumeMapper::COMPOSITE_BLEND, vtkVolumeMapper::ISOSURFACE_BLEND})
  {
    for (const auto& [x, y, z] : std::initializer_list<std::array<double, 3>>{
           {0.0, 0.0, 1.0}, {1.0, 0.3, -0.2}, {-0.4, 1.0, 0.7}, {0.5, 0.5, 0.5}, {-0.2, -0.9, 0.1}})
    {
      for (Mapper* mapper : {byProcessor.Get(), byCompute.Get()})
      {
        mapper->SetBlendMode(blendMode);
        mapper->SetShadowStrength(0.7);
        mapper->SetOcclusionStrength(0.5);
        mapper->SetLightDirection(x, y, z);
        this->Stage->Draw(this->Configure(mapper));
      }
      if (byCompute->GetDrawnWay() != Mapper::COMPUTE)
      {
        EXPECT_NE(this->TakeMessages().find("no compute shaders"), std::string::npos);
        return;
      }
      ExpectSameLight(byProcessor, byCompute, bound);
    }
  }
}

TEST_F(Ways, Modes)
{
  this->Slices->UseDepthPassOn();
  this->Slices->GetDepthPassContourValues()->SetValue(0, 30.0);
  this->ExpectSame("behind a contour", false);
  this->Slices->UseDepthPassOff();
  this->Slices->PreIntegrationOn();
  this->ExpectSame("integrated", false);
  this->Slices->SetBlendModeToMaximumIntensity();
  this->ExpectSame("maximum", false);
  this->Slices->SetBlendModeToIsoSurface();
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 40.0);
  this->ExpectSame("isosurface", false);
}

// Rays through edges and corners of the cube are shorter than the distance of two planes.
TEST_F(Ways, ACubeThatIsVisibleEverywhere)
{
  this->Input = MakeUniformCube(17, 1.0f);
  SetUniformFunctions(this->Stage->GetProperty(), 0.05); // of a unit
  this->Slices->SetNumberOfSlices(64);
  this->Stage->GetRenderer()->ResetCamera(this->Input->GetBounds());
  this->ExpectSame("everywhere");
}

TEST_F(Ways, TheEnvironmentTakesPrecedence)
{
  EXPECT_EQ(this->Slices->GetDrawnWay(), Mapper::AUTOMATIC);
  const WayVariable variable("polygons");
  this->DrawIn(Mapper::FRAGMENTS);
  EXPECT_EQ(this->Slices->GetDrawnWay(), Mapper::POLYGONS);
}

TEST_F(Ways, AnUnknownNameIsSaidOnce)
{
  const WayVariable variable("polygon");
  this->DrawIn(Mapper::FRAGMENTS);
  this->DrawIn(Mapper::FRAGMENTS);
  EXPECT_EQ(this->Slices->GetDrawnWay(), Mapper::FRAGMENTS);
  const std::string messages = this->TakeMessages();
  const std::size_t first = messages.find("VTK_TEXTURE_SLICE_WAY is \"polygon\"");
  EXPECT_NE(first, std::string::npos) << messages;
  EXPECT_EQ(messages.find("VTK_TEXTURE_SLICE_WAY", first + 1), std::string::npos) << messages;
}

TEST_F(Ways, TheFasterOneIsChosenAfterTheSecondFrame)
{
  const WayVariable variable("automatic"); // also in software
  const Picture background = this->Stage->Draw(nullptr);
  const Picture first = this->DrawIn(Mapper::AUTOMATIC);
  const Picture second = this->DrawIn(Mapper::AUTOMATIC);
  EXPECT_EQ(Compare(second, first, background).Worst, 0.0) << "the trial leaves nothing behind";
  this->DrawIn(Mapper::AUTOMATIC);
  const int chosen = this->Slices->GetDrawnWay();
  std::cout << "chosen: " << (chosen == Mapper::COMPUTE ? "compute" : "fragments") << '\n';
  EXPECT_TRUE(chosen == Mapper::FRAGMENTS || chosen == Mapper::COMPUTE) << chosen;
  this->DrawIn(Mapper::AUTOMATIC);
  EXPECT_EQ(this->Slices->GetDrawnWay(), chosen);
}

// What is left of the volume lies below the picture.
TEST_F(Ways, ATrialBesideThePictureIsNoError)
{
  const WayVariable variable("automatic"); // also in software
  std::thread another(                     // which had no trial yet
    []
    {
      Scene scene(64, 64);
      vtkNew<Mapper> mapper;
      mapper->SetInputData(MakeUniformCube(17, 1.0f));
      mapper->SetWay(Mapper::AUTOMATIC);
      SetUniformFunctions(scene.GetProperty(), 0.5);
      const double* bounds = mapper->GetBounds();
      mapper->CroppingOn();
      mapper->SetCroppingRegionFlagsToSubVolume();
      mapper->SetCroppingRegionPlanes(
        bounds[0], bounds[1], bounds[2], bounds[2] + 1.0, bounds[4], bounds[5]);
      scene.GetRenderer()->ResetCamera(bounds);
      vtkCamera* camera = scene.GetRenderer()->GetActiveCamera();
      camera->Zoom(6.0);
      scene.GetRenderer()->ResetCameraClippingRange(bounds);
      for (int frame = 0; frame < 3; ++frame)
      {
        scene.Draw(mapper);
        EXPECT_NE(mapper->GetDrawnWay(), Mapper::AUTOMATIC);
      }
      EXPECT_EQ(scene.GetMessages().Take(), "");
    });
  another.join();
}
