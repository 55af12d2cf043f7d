// SPDX-License-Identifier: BSD-3-Clause
#include "RayCasterComparison.h"

#include "Scenes.h"
#include "Tolerance.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkVersionMacros.h"
#include "vtkVolume.h"

#include <algorithm>
#include <iostream>

namespace nexrad::testing
{

AgainstRayCaster::AgainstRayCaster()
{
  this->Slices->SetNumberOfSlices(0);
}

void AgainstRayCaster::SetUp()
{
  RenderingTest::SetUp();
  if (!IsSkipped() && !HasFatalFailure())
  {
    this->Stage = std::make_unique<Scene>(PictureSize, PictureSize);
  }
}

void StormAgainstRayCaster::SetUp()
{
  AgainstRayCaster::SetUp();
  if (this->Stage != nullptr)
  {
    this->UseStorm(VTK_FLOAT);
    this->AimCamera(false);
  }
}

void AgainstRayCaster::TearDown()
{
  this->Stage.reset();
  RenderingTest::TearDown();
}

void AgainstRayCaster::UseStorm(int scalarType, int size)
{
  this->Input = MakeStorm(size, scalarType);
  SetStormFunctions(this->Stage->GetProperty(), scalarType);
}

void AgainstRayCaster::AimCamera(bool parallel)
{
  vtkRenderer* renderer = this->Stage->GetRenderer();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetParallelProjection(parallel);
  camera->SetFocalPoint(0.0, 0.0, 12.0);
  camera->SetPosition(50.0, -90.0, 70.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetParallelScale(36.0);
  camera->SetViewAngle(36.0);
  renderer->ResetCameraClippingRange(-80, 80, -80, 80, -80, 80);
}

double Allowed(double bound)
{
  const bool measured = VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0);
  return measured ? bound : std::max(bound, Bar);
}

void AgainstRayCaster::ForBoth(const std::function<void(vtkGPUVolumeRayCastMapper*)>& set)
{
  set(this->RayCaster);
  set(this->Slices);
}

Picture AgainstRayCaster::ExpectSamePicture(
  const std::string& name, double tolerance, double visible)
{
  const Picture background = this->Stage->Draw(nullptr);
  const Picture expected = this->Stage->Draw(this->Configure(this->RayCaster));
  const Picture actual = this->Stage->Draw(this->Configure(this->Slices));
  WritePicture(expected, name + "-rays");
  WritePicture(actual, name + "-slices");
  WritePicture(DifferencePicture(actual, expected), name + "-difference");
  const Difference difference = Compare(actual, expected, background);
  const double brightest = Compare(actual, background, background).Worst;
  std::cout << name << ": mean difference " << difference.Mean[0] << ' ' << difference.Mean[1]
            << ' ' << difference.Mean[2] << " of 255, worst " << difference.Worst << ", over "
            << difference.Pixels << " pixels, brightest " << brightest << ", "
            << this->Slices->GetNumberOfDrawnSlices() << " slices\n";
  EXPECT_GT(difference.Pixels, 800) << "the volume covers too little to compare";
  EXPECT_GT(brightest, visible) << "too little of the volume can be seen";
  EXPECT_AT_MOST(difference.LargestMean(), Allowed(tolerance),
    name + ": mean difference to the ray caster, of 255");
  this->ExpectSameWhenIntegrated(name, actual, background);
  return actual;
}

void AgainstRayCaster::ExpectSameWhenIntegrated(
  const std::string& name, const Picture& sampled, const Picture& background)
{
  this->Slices->PreIntegrationOn();
  const Picture integrated = this->Stage->Draw(this->Configure(this->Slices));
  this->Slices->PreIntegrationOff();
  WritePicture(integrated, name + "-integrated");
  const Difference difference = Compare(integrated, sampled, background);
  std::cout << name << ": integrated slabs differ from samples by " << difference.LargestMean()
            << " of 255, worst " << difference.Worst << '\n';
  EXPECT_LE(difference.LargestMean(), this->IntegratedTolerance) << "integrated slabs";
}

void AgainstRayCaster::ExpectSamePictureAndBaseline(
  const std::string& name, const std::string& baseline, double tolerance)
{
  ExpectBaseline(this->ExpectSamePicture(name, tolerance), baseline);
}

vtkGPUVolumeRayCastMapper* AgainstRayCaster::Configure(vtkGPUVolumeRayCastMapper* mapper)
{
  mapper->SetInputData(this->Input);
  mapper->AutoAdjustSampleDistancesOff();
  const double samples = mapper == this->RayCaster.Get() ? this->RaySamples : 1.0;
  mapper->SetSampleDistance(static_cast<float>(this->SampleDistance / samples));
  return mapper;
}

double AgainstRayCaster::RayCasterCut(double x, int axis)
{
  const double* bounds = this->Input->GetBounds();
  const double middle = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
  const double points = this->Input->GetDimensions()[axis];
  return middle + (x - middle) * (points - 1.0) / points;
}

void AgainstRayCaster::Crop(const std::array<double, 6>& planes, int flags)
{
  std::array<double, 6> rayCasterPlanes;
  for (int i = 0; i < 6; ++i)
  {
    const auto index = static_cast<std::size_t>(i);
    rayCasterPlanes[index] = this->RayCasterCut(planes[index], i / 2);
  }
  this->RayCaster->CroppingOn();
  this->RayCaster->SetCroppingRegionPlanes(rayCasterPlanes.data());
  this->RayCaster->SetCroppingRegionFlags(flags);
  this->Slices->CroppingOn();
  this->Slices->SetCroppingRegionPlanes(planes.data());
  this->Slices->SetCroppingRegionFlags(flags);
}

void StormAgainstRayCaster::AddSphere(double x, double y, double z, double radius, double opacity)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(x, y, z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  actor->GetProperty()->SetOpacity(opacity);
  this->Stage->GetRenderer()->AddActor(actor);
}

} // namespace nexrad::testing
