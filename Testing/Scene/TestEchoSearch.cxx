// SPDX-License-Identifier: BSD-3-Clause
// Which echo a ray shows, in volumes whose answer is known.
#include "Scene/EchoSearch.h"
#include "Scene/Frame/PictureLayout.h"

#include "StormVolume.h"
#include "TestData.h"
#include "Tolerance.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradTransferFunction.h"
#include "vtkNexradVolumeReader.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

using namespace nexrad;
using namespace nexrad::scene;
using namespace nexrad::testing;

namespace
{

// 64 × 64 × 32 km, voxels of 1 km, whose values follow from the place in km.
template <typename Values>
vtkSmartPointer<vtkImageData> MakeVolume(const Values& valueAt)
{
  GriddedVolume volume;
  volume.grid.dimensions = {64, 64, 32};
  volume.grid.spacing = {1000.0, 1000.0, 1000.0};
  volume.grid.origin = {-31'500.0, -31'500.0, 500.0};
  for (int z = 0; z < 32; ++z)
  {
    for (int y = 0; y < 64; ++y)
    {
      for (int x = 0; x < 64; ++x)
      {
        const double value = valueAt(x - 31.5, y - 31.5, z + 0.5);
        volume.values.push_back(static_cast<float>(value));
        volume.states.push_back(value > -33.0 ? VoxelState::Echo : VoxelState::NoEcho);
      }
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  vtkNexradVolumeToImage(volume, image);
  return image;
}

// The same opacity for all values above -33 dBZ.
vtkSmartPointer<vtkNexradTransferFunction> MakeOpacity(double opacity)
{
  auto function = vtkSmartPointer<vtkNexradTransferFunction>::New();
  function->RemoveAllNodes(vtkNexradTransferFunction::OPACITY);
  function->AddNode(vtkNexradTransferFunction::OPACITY, -32.0, 0.0);
  function->AddNode(vtkNexradTransferFunction::OPACITY, -31.9, opacity);
  function->AddNode(vtkNexradTransferFunction::OPACITY, 80.0, opacity);
  return function;
}

constexpr ViewRay eastward = {{-100.0, 0.25, 10.25}, {1.0, 0.0, 0.0}};

std::optional<SeenEcho> Find(
  vtkImageData* volume, vtkNexradTransferFunction* function, const ViewRay& ray)
{
  return FindEcho(VoxelReader(volume), nullptr, SceneFrame(volume, 1.0), function, ray);
}

} // namespace

// A slab of echo whose voxels end at x = -10 and 10 km; with the way to the voxels beside it, it is
// 21 km thick: half of its opacity 1 - (1 - o)^(21/5) is reached after
// 5 ln(1 - half) / ln(1 - o) km.
TEST(EchoSearch, FindsTheMiddleOfWhatIsSeen)
{
  const auto volume =
    MakeVolume([](double x, double, double) { return std::abs(x) < 10.0 ? 30.0 : -33.0; });
  for (const double opacity : {0.05, 0.2, 0.5})
  {
    const auto found = Find(volume, MakeOpacity(opacity), eastward);
    ASSERT_TRUE(found.has_value()) << opacity;
    const double half = 0.5 * (1.0 - std::pow(1.0 - opacity, 21.0 / OpacityUnitDistance));
    const double depth = OpacityUnitDistance * std::log(1.0 - half) / std::log(1.0 - opacity);
    EXPECT_WITHIN(found->distance - 100.0, depth - 10.5, 0.5,
      "distance of the echo seen in a slab from the analytic one, voxels");
    EXPECT_WITHIN(found->value, 30.0, 1e-4, "value of the echo seen in a slab, dBZ");
  }
}

TEST(EchoSearch, FindsNothingWhereNothingIsSeen)
{
  const auto thin =
    MakeVolume([](double x, double, double) { return std::abs(x) < 10.0 ? 30.0 : -33.0; });
  EXPECT_FALSE(Find(thin, MakeOpacity(0.02), eastward).has_value());
  EXPECT_TRUE(Find(thin, MakeOpacity(0.03), eastward).has_value());
  const ViewRay above = {{-100.0, 0.0, 40.0}, {1.0, 0.0, 0.0}};
  EXPECT_FALSE(Find(thin, MakeOpacity(0.5), above).has_value());
}

// A ball of 60 dBZ in its centre that loses 2 dB a km: its surface of 40 dBZ has a radius of 10 km.
TEST(EchoSearch, FindsTheSurfaceOfAnIsoValue)
{
  const auto volume = MakeVolume([](double x, double y, double z)
    { return 60.0 - 2.0 * std::sqrt(x * x + y * y + (z - 10.0) * (z - 10.0)); });
  vtkNew<vtkNexradTransferFunction> function;
  const double isoValue = 40.0;
  function->SetOpacityToIsoValues(&isoValue, 1, 1.0);
  const auto found = Find(volume, function, eastward);
  ASSERT_TRUE(found.has_value());
  EXPECT_WITHIN(found->distance - 100.0, -10.0, 0.5, "place of an iso-surface, voxels");
  EXPECT_WITHIN(found->value, isoValue, 1.0, "value at an iso-surface, dBZ");
}

TEST(EchoSearch, FindsTheSameInCodesAsInValues)
{
  const TemporaryFolder folder;
  WriteStormFiles(folder.Path(), 1);
  const std::filesystem::path file = folder.Path() / "20060312T183000Z.nxv";
  std::array<std::optional<SeenEcho>, 2> found;
  for (const bool codes : {false, true})
  {
    vtkNew<vtkNexradVolumeReader> reader;
    reader->SetFileName(file.c_str());
    reader->SetScalarsAsCodes(codes);
    reader->Update();
    vtkNew<vtkNexradTransferFunction> function;
    const SceneFrame frame(reader->GetOutput(), 8.0);
    const ViewRay ray = {{-70.0, -500.0, 20.0}, {0.0, 1.0, 0.0}};
    found.at(codes ? 1 : 0) =
      FindEcho(VoxelReader(reader->GetOutput()), nullptr, frame, function, ray);
    ASSERT_TRUE(found.at(codes ? 1 : 0).has_value());
  }
  EXPECT_EQ(found[0]->distance, found[1]->distance);
  EXPECT_EQ(found[0]->value, found[1]->value);
}

TEST(ViewRay, PassesThePlaceThatTheCameraProjectsThere)
{
  constexpr std::array<int, 2> size = {640, 360};
  const ScenePoint point = {20.0, -30.0, 12.0};
  for (const bool parallel : {false, true})
  {
    vtkNew<vtkCamera> camera;
    PointCamera(camera, {130.0, 25.0, 3.0, parallel, {}}, {-50.0, 80.0, -90.0, 40.0, 0.0, 60.0},
      static_cast<double>(size[0]) / size[1], {});
    const ViewRay ray = RayThrough(camera, size, Projection(camera, size)(point));
    const auto distance = DistanceToHeight(ray, point[2]);
    ASSERT_TRUE(distance.has_value());
    const ScenePoint met = ray.At(*distance);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(met[axis], point[axis], 1e-6) << parallel;
    }
  }
}

// KTLX lies at 35.3331° N 97.2778° W; a hundredth of a degree of latitude is 1.11 km.
TEST(NearestRadar, TellsDistanceAndDirection)
{
  const auto place = FindNearestRadar({"KLSX", "KTLX", "unknown"}, 35.8331, -97.2778);
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ(place->site, "KTLX");
  EXPECT_WITHIN(place->distance, 55'470.0, 45.0, "distance from a radar, m");
  EXPECT_WITHIN(
    std::remainder(place->azimuth, 360.0), 0.0, 0.007, "direction from a radar, degrees");
  EXPECT_FALSE(FindNearestRadar({"unknown"}, 35.0, -97.0).has_value());
}
