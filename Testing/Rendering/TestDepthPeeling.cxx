// SPDX-License-Identifier: BSD-3-Clause
// Volumes that VTK's dual depth peeling draws among translucent geometry, beside VTK's GPU ray
// caster.
#include "RayCasterComparison.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <string>

namespace
{

using namespace nexrad::testing;

class DepthPeeling : public StormAgainstRayCaster
{
protected:
  void SetUp() override
  {
    StormAgainstRayCaster::SetUp();
    if (this->Stage != nullptr)
    {
      this->AddSphere(15.0, 30.0, 8.0, 10.0, 1.0);
      this->Stage->GetWindow()->SetAlphaBitPlanes(1);
      this->Stage->GetRenderer()->SetUseDepthPeeling(1);
      this->Stage->GetRenderer()->SetUseDepthPeelingForVolumes(true);
    }
  }

  /// Two that overlap in the tall tower, one in front of the storm.
  void AddGlass()
  {
    this->AddSphere(-12.0, -12.0, 8.0, 8.0, 0.4);
    this->AddSphere(-4.0, -16.0, 8.0, 8.0, 0.4);
    this->AddSphere(10.0, -30.0, 12.0, 8.0, 0.4);
  }
  Picture DrawTwo(vtkGPUVolumeRayCastMapper* first, vtkGPUVolumeRayCastMapper* second)
  {
    this->Configure(second);
    vtkNew<vtkVolume> other;
    other->SetMapper(second);
    other->SetProperty(this->Stage->GetProperty());
    other->SetPosition(70.0, 70.0, 0.0);
    this->Stage->GetRenderer()->AddVolume(other);
    Picture picture = this->Stage->Draw(this->Configure(first));
    this->Stage->GetRenderer()->RemoveVolume(other);
    return picture;
  }
};

/// Peels as no pass of VTK does.
class UnknownPass : public vtkOpenGLRenderPass
{
public:
  static UnknownPass* New();
  void Render(const vtkRenderState*) override {}
  bool PreReplaceShaderValues(
    std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*) override
  {
    vtkShaderProgram::Substitute(
      fragmentShader, "//VTK::DepthPeeling::Dec", "uniform sampler2D someTexture;");
    return true;
  }
};
vtkStandardNewMacro(UnknownPass);

} // namespace

// The storm is seen in front of the glass balls, in them and through them, in the order of depth.
TEST_F(DepthPeeling, GlassBalls)
{
  this->AddGlass();
  this->ExpectSamePictureAndBaseline("peeled", "PeeledVolume", 0.4);
}

// The volume among opaque geometry alone.
TEST_F(DepthPeeling, NothingTranslucent)
{
  this->ExpectSamePicture("peeled-opaque", 0.2);
}

// More walls than peels: the pass draws what is left of the volume in one piece.
TEST_F(DepthPeeling, FewPeels)
{
  this->AddGlass();
  this->Stage->GetRenderer()->SetMaximumNumberOfPeels(1);
  this->ExpectSamePicture("peeled-few", 0.48);
}

// In projections, each part of the volume between two walls is projected alone. With as many
// samples as there are slices, the ray caster counts a sample too many or too few in each part: its
// sums differ from those of sixteen times as many samples by 0.4 of 255, its means by 0.5.
TEST_F(DepthPeeling, OtherBlendModes)
{
  this->AddGlass();
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendModeToMaximumIntensity(); });
  this->ExpectSamePicture("peeled-maximum", 0.23);
  this->RaySamples = 16.0;
  this->ForBoth([](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendModeToAdditive(); });
  this->ExpectSamePicture("peeled-additive", 0.1);
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendModeToAverageIntensity(); });
  this->ExpectSamePicture("peeled-average", 0.08);
  this->RaySamples = 1.0;
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 20.0);
  this->ForBoth([](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendModeToIsoSurface(); });
  this->ExpectSamePicture("peeled-isosurface", 0.14, 20.0);
}

// Two storms with mappers of their own; one of them drawn by the ray caster.
TEST_F(DepthPeeling, TwoVolumes)
{
  this->AddGlass();
  this->Stage->GetRenderer()->GetActiveCamera()->SetViewAngle(60.0);
  this->Stage->GetRenderer()->ResetCameraClippingRange(-80, 180, -80, 180, -80, 80);
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> otherRays;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> otherSlices;
  otherSlices->SetNumberOfSlices(0);
  const Picture background = this->Stage->Draw(nullptr);
  const Picture expected = this->DrawTwo(this->RayCaster, otherRays);
  EXPECT_AT_MOST(
    Compare(this->DrawTwo(this->Slices, otherSlices), expected, background).LargestMean(),
    Allowed(0.38), "two peeled volumes: mean difference to the ray caster, of 255");
  EXPECT_AT_MOST(
    Compare(this->DrawTwo(this->Slices, otherRays), expected, background).LargestMean(),
    Allowed(0.35), "one by slices, one by rays: mean difference to the ray caster, of 255");
}

// Away from the window's corner the picture is the same; VTK 9.1's ray caster cuts its picture
// there.
TEST_F(DepthPeeling, Viewport)
{
  this->AddGlass();
  this->Stage->GetRenderer()->SetViewport(0.0, 0.0, 0.75, 0.75);
  const Picture corner = this->Stage->Draw(this->Configure(this->Slices));
  this->Stage->GetRenderer()->SetViewport(0.25, 0.125, 1.0, 0.875);
  const Picture moved = this->Stage->Draw(this->Slices);
  int different = 0;
  for (int y = 0; y < 96; ++y)
  {
    for (int x = 0; x < 96; ++x)
    {
      different += PixelAt(corner, x, y) != PixelAt(moved, x + 32, y + 16) ? 1 : 0;
    }
  }
  EXPECT_EQ(different, 0);
}

// A picture of half the size is hidden by the same geometry.
TEST_F(DepthPeeling, ImageSampleDistance)
{
  this->AddGlass();
  const Picture background = this->Stage->Draw(nullptr);
  const Picture fine = this->Stage->Draw(this->Configure(this->Slices));
  this->Slices->SetImageSampleDistance(2.0);
  EXPECT_AT_MOST(Compare(this->Stage->Draw(this->Slices), fine, background).LargestMean(), 1.4,
    "peeled, image sample distance 2: mean difference to distance 1, of 255");
}

// Passes that do not peel volumes leave them alone.
TEST_F(DepthPeeling, OtherPasses)
{
  this->Stage->GetRenderer()->SetUseDepthPeeling(0);
  this->AddGlass();
  this->Stage->GetRenderer()->UseSSAOOn();
  this->ExpectSamePicture("ambient-occlusion-of-geometry", 0.22);
}

// VTK's pass draws nothing translucent there, and OpenGL refuses its copy of the depth.
TEST_F(DepthPeeling, MultisamplesAreRefusedOnce)
{
  constexpr int multisamples = 4;
  Scene scene(PictureSize, PictureSize, multisamples, false);
  SetStormFunctions(scene.GetProperty(), VTK_FLOAT);
  scene.GetRenderer()->SetActiveCamera(this->Stage->GetRenderer()->GetActiveCamera());
  this->AddGlass();
  scene.GetRenderer()->AddActor(this->Stage->GetRenderer()->GetActors()->GetLastActor());
  scene.GetWindow()->SetAlphaBitPlanes(1);
  scene.GetRenderer()->SetUseDepthPeeling(1);
  scene.GetRenderer()->SetUseDepthPeelingForVolumes(true);
  scene.GetVolume()->SetMapper(this->Configure(this->Slices));
  scene.GetWindow()->Render();
  EXPECT_NE(this->TakeMessages().find("SetMultiSamples(0)"), std::string::npos);
  scene.GetWindow()->Render();
  EXPECT_EQ(this->TakeMessages(), "");
}

TEST_F(DepthPeeling, UnknownPassesAreRefusedOnce)
{
  vtkNew<UnknownPass> pass;
  vtkNew<vtkInformation> keys;
  vtkOpenGLRenderPass::RenderPasses()->Append(keys, pass);
  this->Stage->GetRenderer()->SetUseDepthPeeling(0);
  this->Stage->GetVolume()->SetPropertyKeys(keys);
  this->Configure(this->Slices);
  this->Stage->Draw(this->Slices);
  EXPECT_NE(this->TakeMessages().find("SetUseDepthPeelingForVolumes(false)"), std::string::npos);
  this->Stage->Draw(this->Slices);
  EXPECT_EQ(this->TakeMessages(), "");
}
