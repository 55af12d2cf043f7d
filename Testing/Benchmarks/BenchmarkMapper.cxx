// SPDX-License-Identifier: BSD-3-Clause
// Frame times of the slices beside VTK's GPU ray caster: 796 x 532 pixels, 256 slices, and as many
// samples along the axis of the view. Usage: BenchmarkMapper [points along x, default 256]
#include "RenderingTest.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace
{

using namespace nexrad::testing;

constexpr int Slices = 256;
constexpr int Views = 12;

void AimCamera(vtkRenderer* renderer, int view)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double angle = vtkMath::RadiansFromDegrees(360.0 * view / Views);
  camera->SetFocalPoint(0.0, 0.0, 10.0);
  camera->SetPosition(110.0 * std::cos(angle), 110.0 * std::sin(angle), 60.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
}

double DrawFrame(Scene& scene)
{
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  scene.GetWindow()->Render();
  scene.GetWindow()->WaitForCompletion();
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Median of the frame times over all views, the first frame (uploads, shaders) left out.
double Measure(Scene& scene, vtkVolumeMapper* mapper)
{
  scene.Draw(mapper);
  std::vector<double> times;
  for (int view = 0; view < Views; ++view)
  {
    AimCamera(scene.GetRenderer(), view);
    times.push_back(DrawFrame(scene));
  }
  std::nth_element(times.begin(), times.begin() + Views / 2, times.end());
  return times[Views / 2];
}

double VisibleFraction(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const double nothing = scalars->GetRange()[0];
  vtkIdType visible = 0;
  for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
  {
    visible += scalars->GetComponent(id, 0) > nothing ? 1 : 0;
  }
  return double(visible) / double(scalars->GetNumberOfTuples());
}

void MeasureType(int size, int scalarType)
{
  const vtkSmartPointer<vtkImageData> storm = MakeStorm(size, scalarType);
  Scene scene(796, 532);
  SetStormFunctions(scene.GetProperty(), scalarType);

  vtkNew<vtkOpenGLTextureSliceVolumeMapper> slices;
  slices->SetInputData(storm);
  slices->SetNumberOfSlices(Slices);
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> rays;
  rays->SetInputData(storm);
  rays->AutoAdjustSampleDistancesOff();
  // The views see between 64 and 100 units of depth: 256 steps of the mean.
  rays->SetSampleDistance(82.0f / Slices);

  AimCamera(scene.GetRenderer(), 0);
  const double raysTime = Measure(scene, rays);
  const double slicesTime = Measure(scene, slices);
  std::printf("%dx%dx%d %s, %.0f %% visible: slices %.1f ms, ray caster %.1f ms, ratio %.2f\n",
    size, size, size / 2, storm->GetScalarTypeAsString(), 100.0 * VisibleFraction(storm),
    slicesTime, raysTime, slicesTime / raysTime);
}

} // namespace

int main(int argc, char* argv[])
{
  const int size = argc > 1 ? std::atoi(argv[1]) : 256;
  if (argc > 2 || size < 4 || size > 2048)
  {
    std::fprintf(stderr, "usage: BenchmarkMapper [points along x, 4 to 2048]\n");
    return 2;
  }
  std::printf("796 x 532 pixels, %d slices, median of %d views\n", Slices, Views);
  for (const int scalarType : {VTK_FLOAT, VTK_UNSIGNED_CHAR})
  {
    MeasureType(size, scalarType);
  }
  return 0;
}
