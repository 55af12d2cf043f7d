// SPDX-License-Identifier: BSD-3-Clause
// The volume among surfaces, other volumes, renderers and factories, beside VTK's GPU ray caster.
#include "RayCasterComparison.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAAPass.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkTextureSliceObjectFactory.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <iostream>

namespace
{

using namespace nexrad::testing;

class GeometryBeside : public StormAgainstRayCaster
{
};

} // namespace

// Two white balls, one half sunk into the tall tower, one behind the storm.
TEST_F(GeometryBeside, OpaqueSpheres)
{
  this->AddSphere(-12.0, -12.0, 8.0, 8.0, 1.0);
  this->AddSphere(15.0, 30.0, 8.0, 10.0, 1.0);
  this->ExpectSamePictureAndBaseline("spheres-opaque", "OpaqueSpheres", 0.26);
}

// Glass balls in front of the storm and in it: the volume is drawn over both.
TEST_F(GeometryBeside, TranslucentSpheres)
{
  this->AddSphere(-12.0, -12.0, 8.0, 8.0, 0.4);
  this->AddSphere(10.0, -30.0, 12.0, 8.0, 0.4);
  this->ExpectSamePictureAndBaseline("spheres-translucent", "TranslucentSpheres", 0.22);
}

// The same with the balls peeled, and the volume left out of the peeling, as is VTK's default.
TEST_F(GeometryBeside, TranslucentSpheresPeeled)
{
  this->AddSphere(-12.0, -12.0, 8.0, 8.0, 0.4);
  this->AddSphere(10.0, -30.0, 12.0, 8.0, 0.4);
  this->Stage->GetWindow()->SetAlphaBitPlanes(1);
  this->Stage->GetRenderer()->SetUseDepthPeeling(1);
  this->ExpectSamePicture("spheres-peeled", 0.21);
}

// The volume in two viewports of one window, seen from the front and from above.
TEST_F(GeometryBeside, TwoViewports)
{
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  this->Stage->GetRenderer()->SetViewport(0.0, 0.0, 0.5, 1.0);
  this->Stage->GetWindow()->AddRenderer(right);
  right->AddVolume(this->Stage->GetVolume());
  vtkCamera* camera = right->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 12.0);
  camera->SetPosition(0.0, 0.0, 150.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  right->ResetCameraClippingRange(-80, 80, -80, 80, -80, 80);
  this->ExpectSamePictureAndBaseline("two-viewports", "TwoViewports", 0.23);
}

// A second storm beside the first, each with a mapper of its own.
TEST_F(GeometryBeside, TwoVolumes)
{
  const auto draw = [&](vtkGPUVolumeRayCastMapper* first, vtkGPUVolumeRayCastMapper* second)
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
  };
  this->Stage->GetRenderer()->GetActiveCamera()->SetViewAngle(60.0);
  this->Stage->GetRenderer()->ResetCameraClippingRange(-80, 180, -80, 180, -80, 80);
  const Picture background = this->Stage->Draw(nullptr);
  const Picture single = this->Stage->Draw(this->Configure(this->Slices));
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> otherRays;
  const Picture expected = draw(this->RayCaster, otherRays);
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> otherSlices;
  otherSlices->SetNumberOfSlices(0);
  const Picture actual = draw(this->Slices, otherSlices);
  EXPECT_AT_MOST(Compare(actual, expected, background).LargestMean(), Allowed(0.21),
    "mean difference to the ray caster, of 255");
  EXPECT_GT(Compare(actual, single, background).Pixels, Compare(single, single, background).Pixels);
}

// A pass that draws into a picture four times as wide and high, and averages: the storm stands
// where it stands without it, hidden by the same ball.
TEST_F(GeometryBeside, PassWithALargerPicture)
{
  this->AddSphere(-12.0, -12.0, 8.0, 8.0, 1.0);
  this->Configure(this->Slices);
  const auto draw = [&](bool larger)
  {
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkSSAAPass> pass;
    pass->SetDelegatePass(steps);
    this->Stage->GetRenderer()->SetPass(larger ? pass.Get() : nullptr);
    Picture picture = this->Stage->Draw(this->Slices);
    pass->ReleaseGraphicsResources(this->Stage->GetWindow());
    this->Stage->GetRenderer()->SetPass(nullptr);
    return picture;
  };
  for (const bool coarse : {false, true})
  {
    this->Slices->SetImageSampleDistance(coarse ? 2.0f : 1.0f);
    this->Slices->SetPreIntegration(coarse);
    const Picture background = this->Stage->Draw(nullptr);
    const Picture plain = draw(false);
    const Picture larger = draw(true);
    WritePicture(larger, "pass-larger");
    const double difference = Compare(larger, plain, background).LargestMean();
    const double moved = Compare(larger, MovedPicture(plain), background).LargestMean();
    std::cout << (coarse ? "coarse slabs" : "samples") << ": mean difference " << difference
              << ", moved by a pixel " << moved << '\n';
    EXPECT_AT_MOST(difference, 2.0, "a pass with a larger picture: mean difference, of 255");
    EXPECT_AT_LEAST(moved, 2.0 * difference, "mean difference to the picture moved by a pixel");
  }
}

// A selection finds the storm where it can be seen, the ball before it, and nothing in the corner.
TEST_F(GeometryBeside, HardwareSelection)
{
  this->AddSphere(10.0, -30.0, 12.0, 6.0, 1.0);
  this->Stage->Draw(this->Configure(this->Slices));
  vtkActor* sphere = this->Stage->GetRenderer()->GetActors()->GetLastActor();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(this->Stage->GetRenderer());
  selector->SetArea(0, 0, PictureSize - 1, PictureSize - 1);
  ASSERT_TRUE(selector->CaptureBuffers());
  const auto propAt = [&](double x, double y, double z)
  {
    this->Stage->GetRenderer()->SetWorldPoint(x, y, z, 1.0);
    this->Stage->GetRenderer()->WorldToDisplay();
    const double* display = this->Stage->GetRenderer()->GetDisplayPoint();
    const unsigned int pixel[2] = {
      static_cast<unsigned int>(display[0]), static_cast<unsigned int>(display[1])};
    return selector->GetPixelInformation(pixel).Prop;
  };
  EXPECT_EQ(propAt(-10.0, -6.0, 8.0), this->Stage->GetVolume()) << "the tall tower";
  EXPECT_EQ(propAt(10.0, -30.0, 12.0), sphere);
  EXPECT_EQ(propAt(-31.0, 31.0, 23.0), nullptr) << "clear air within the volume's box";
  selector->ClearBuffers();
}

// VTK's own choice of a mapper becomes the slices, and VTK's ray caster again.
TEST_F(GeometryBeside, ObjectFactory)
{
  const Picture background = this->Stage->Draw(nullptr);
  this->Slices->SetInputData(this->Input);
  this->Slices->SetNumberOfSlices(256);
  const Picture expected = this->Stage->Draw(this->Slices);

  vtkTextureSliceObjectFactory::Activate();
  vtkTextureSliceObjectFactory::Activate();
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  EXPECT_TRUE(mapper->IsA("vtkOpenGLTextureSliceVolumeMapper"));
  vtkNew<vtkSmartVolumeMapper> smart;
  smart->SetInputData(this->Input);
  smart->SetRequestedRenderModeToGPU();
  const Picture picture = this->Stage->Draw(smart);
  EXPECT_EQ(smart->GetLastUsedRenderMode(), vtkSmartVolumeMapper::GPURenderMode);
  EXPECT_EQ(Compare(picture, expected, background).LargestMean(), 0.0);

  vtkTextureSliceObjectFactory::Deactivate();
  vtkNew<vtkGPUVolumeRayCastMapper> own;
  EXPECT_TRUE(own->IsA("vtkOpenGLGPUVolumeRayCastMapper"));
}
