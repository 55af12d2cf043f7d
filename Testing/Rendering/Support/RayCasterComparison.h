// SPDX-License-Identifier: BSD-3-Clause
// A scene that both mappers draw: the slices and VTK's own GPU ray caster, at equal sampling.
#pragma once

#include "RenderingTest.h"

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include <array>
#include <functional>
#include <memory>
#include <string>

namespace nexrad::testing
{

/// What a mean channel may differ by, of 255, over the pixels that either picture changes. The bar
/// that the mapper must meet is 1.5; where both compute the same, far less is the rule.
constexpr double Bar = 1.5;
constexpr double Tolerance = 0.5;
/// The bound of a scene, measured with VTK 9.1. With the ray caster of another version it is the
/// bar.
double Allowed(double bound);
/// Pixels of the picture along each side.
constexpr int PictureSize = 128;

class AgainstRayCaster : public RenderingTest
{
protected:
  AgainstRayCaster();
  void SetUp() override;
  void TearDown() override;

  /// A storm of that many points along x and y, with its functions.
  void UseStorm(int scalarType, int size = 48);
  /// A view of the storm from above one corner.
  void AimCamera(bool parallel);
  /// The same setting for both mappers.
  void ForBoth(const std::function<void(vtkGPUVolumeRayCastMapper*)>& set);

  /**
   * Draws with both mappers, writes the pictures and their difference, and compares them. Fails if
   * fewer than 800 pixels are covered, or none is brighter than @a visible of 255. The functions of
   * these scenes are smooth: the slices draw the same picture with pre-integrated classification,
   * too.
   * @return what the slices drew
   */
  Picture ExpectSamePicture(
    const std::string& name, double tolerance = Tolerance, double visible = 60.0);

  /// The same, and compares the slices' picture with the baseline of that name too; the same
  /// picture moved by one pixel must be refused.
  void ExpectSamePictureAndBaseline(
    const std::string& name, const std::string& baseline, double tolerance = Tolerance);

  /// Hands a mapper the input and the sample distance.
  vtkGPUVolumeRayCastMapper* Configure(vtkGPUVolumeRayCastMapper* mapper);

  /**
   * Where the ray caster must be told to cut so that it cuts at x. VTK 9.1 takes its texture
   * coordinates, which have half a texel beyond the outermost points, for fractions of the box
   * there: its cuts are displaced as if the volume were (n - 1)/n as large about its middle. The
   * slices cut in the right place (AnalyticPictures.CutsAreExact).
   */
  double RayCasterCut(double x, int axis);
  /// Cropping planes and regions, displaced for the ray caster.
  void Crop(const std::array<double, 6>& planes, int flags);

  /// Draws the slices with pre-integrated classification and compares them with their samples.
  void ExpectSameWhenIntegrated(
    const std::string& name, const Picture& sampled, const Picture& background);

  std::unique_ptr<Scene> Stage;
  vtkSmartPointer<vtkImageData> Input;
  double SampleDistance = 0.3;
  double RaySamples = 1.0; ///< of the ray caster, for each of the slices
  /// What a mean channel of integrated slabs may differ by from samples. Measured: 0.54.
  double IntegratedTolerance = 1.08;
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> RayCaster;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Slices;
};

/// The storm of floats, in perspective from above one corner.
class StormAgainstRayCaster : public AgainstRayCaster
{
protected:
  void SetUp() override;

  /// A white ball beside the storm.
  void AddSphere(double x, double y, double z, double radius, double opacity);
};

} // namespace nexrad::testing
