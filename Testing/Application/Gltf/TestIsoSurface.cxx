// SPDX-License-Identifier: BSD-3-Clause
#include "Gltf/IsoSurface.h"

#include "Tolerance.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "vtkNexradImageConversion.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <utility>
#include <vector>

using namespace nexrad;
using namespace nexrad::scene;
using namespace nexrad::testing;

namespace
{

constexpr double exaggeration = 4.0;
constexpr double centreHeight = 8'000.0; // m, of the ball
constexpr double radius = 12.0;          // km along the ground, of the surface of 30 dBZ

// Distance from the centre of a ball in the stretched scene, km.
double DistanceInScene(const std::array<double, 3>& metres)
{
  return std::hypot(
    metres[0] / 1000.0, metres[1] / 1000.0, exaggeration * (metres[2] - centreHeight) / 1000.0);
}

using StateAt = std::function<VoxelState(const std::array<double, 3>& metres)>;

VoxelState EchoEverywhere(const std::array<double, 3>&)
{
  return VoxelState::Echo;
}

// A ball of echo in the stretched scene that falls by 2.5 dB each km from 60 dBZ at its centre, on
// voxels of 1 km × 1 km × 250 m.
vtkSmartPointer<vtkImageData> MakeBall(
  const StateAt& state, MomentName moment = MomentName::REF, double atCentre = 60.0)
{
  GriddedVolume volume;
  volume.moment = moment;
  volume.grid.dimensions = {41, 41, 64};
  volume.grid.origin = {-20'000.0, -20'000.0, 125.0};
  volume.grid.spacing = {1'000.0, 1'000.0, 250.0};
  volume.method = "beam";
  for (std::size_t i = 0; i < volume.grid.VoxelCount(); ++i)
  {
    const auto at = [&](int axis, std::size_t index)
    { return volume.grid.Coordinate(axis, static_cast<int>(index)); };
    const std::array<double, 3> place = {at(0, i % 41), at(1, i / 41 % 41), at(2, i / (41 * 41))};
    const VoxelState known = state(place);
    volume.states.push_back(known);
    volume.values.push_back(known == VoxelState::Echo
                              ? static_cast<float>(atCentre - 2.5 * DistanceInScene(place))
                              : volume.fill);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  vtkNexradVolumeToImage(volume, image);
  return image;
}

vtkSmartPointer<vtkPolyData> SurfaceOf(
  vtkImageData* volume, double value, vtkPlaneCollection* planes = nullptr)
{
  vtkNew<vtkPlaneCollection> none;
  const SceneFrame frame(volume, exaggeration);
  return MakeSurface(MakeCounting(volume, frame), value, planes != nullptr ? planes : none.Get());
}

std::array<double, 3> FromCentre(const double* point)
{
  return {point[0], point[1], point[2] - exaggeration * centreHeight / 1000.0};
}

double LengthOf(const std::array<double, 3>& vector)
{
  return std::hypot(vector[0], vector[1], vector[2]);
}

// How far the corners are from a ball, km.
double LargestDistance(vtkPolyData* surface)
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double off = LengthOf(FromCentre(surface->GetPoint(i))) - radius;
    largest = std::max(largest, std::abs(off));
  }
  return largest;
}

template <class Visit>
void ForEachTriangle(vtkPolyData* surface, const Visit& visit)
{
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  vtkCellArray* cells = surface->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(size, corners) != 0;)
  {
    ASSERT_EQ(size, 3);
    visit(std::array<vtkIdType, 3>{corners[0], corners[1], corners[2]});
  }
}

// Edges that belong to one triangle alone.
std::size_t OpenEdges(vtkPolyData* surface)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  ForEachTriangle(surface,
    [&](const auto& corners)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        ++edges[std::minmax(corners[i], corners[(i + 1) % 3])];
      }
    });
  return static_cast<std::size_t>(
    std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 1; }));
}

double HighestPoint(vtkPolyData* surface, int axis)
{
  return surface->GetBounds()[2 * axis + 1];
}

} // namespace

TEST(IsoSurface, ABallIsWhereItIs)
{
  const auto surface = SurfaceOf(MakeBall(EchoEverywhere), 30.0);
  ASSERT_GT(surface->GetNumberOfCells(), 3000);
  EXPECT_AT_MOST(1000.0 * LargestDistance(surface), 19.0,
    "farthest corner of the surface of a ball of 12 km in voxels of 1 km, m");
  EXPECT_EQ(OpenEdges(surface), 0);
}

// The angle between a normal and the direction from the centre, and between the normal and the side
// from which the corners of its triangles run anticlockwise.
TEST(IsoSurface, NormalsAndTrianglesFaceOutwards)
{
  const auto surface = SurfaceOf(MakeBall(EchoEverywhere), 30.0);
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  double largest = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const std::array<double, 3> outwards = FromCentre(surface->GetPoint(i));
    const double angle = vtkMath::AngleBetweenVectors(outwards.data(), normals->GetTuple3(i));
    largest = std::max(largest, vtkMath::DegreesFromRadians(angle));
  }
  EXPECT_AT_MOST(largest, 6.0, "largest angle between a normal and that of the ball, degrees");
  ForEachTriangle(surface,
    [&](const auto& corners)
    {
      std::array<std::array<double, 3>, 3> at{};
      for (std::size_t i = 0; i < 3; ++i)
      {
        surface->GetPoint(corners[i], at[i].data());
      }
      std::array<double, 3> first{};
      std::array<double, 3> second{};
      std::array<double, 3> face{};
      vtkMath::Subtract(at[1], at[0], first);
      vtkMath::Subtract(at[2], at[0], second);
      vtkMath::Cross(first.data(), second.data(), face.data());
      EXPECT_GT(vtkMath::Dot(face.data(), FromCentre(at[0].data()).data()), 0.0);
    });
}

// The western half was not scanned: the surface ends there. A wall would have corners beside it
// that are far from the ball.
TEST(IsoSurface, ThereIsNoWallBesideWhatDoesNotCount)
{
  for (const VoxelState state :
    {VoxelState::NotScanned, VoxelState::RangeFolded, VoxelState::Filtered})
  {
    const auto west = [state](const std::array<double, 3>& place)
    { return place[0] < -500.0 ? state : VoxelState::Echo; };
    const auto surface = SurfaceOf(MakeBall(west), 30.0);
    EXPECT_AT_MOST(
      1000.0 * LargestDistance(surface), 19.0, "farthest corner of the surface of half a ball, m");
    EXPECT_GE(surface->GetBounds()[0], 0.0);
    EXPECT_GT(OpenEdges(surface), 50);
    EXPECT_NEAR(HighestPoint(surface, 0), radius, 0.02);
  }
}

// An echo that ends at 50 dBZ has a surface of 30 dBZ round it, a part of a voxel from its last
// voxel. Another moment has no value where no echo is, and no surface there.
TEST(IsoSurface, NoEchoClosesReflectivityAlone)
{
  const auto core = [](const std::array<double, 3>& place)
  { return DistanceInScene(place) < 4.0 ? VoxelState::Echo : VoxelState::NoEcho; };
  const auto surface = SurfaceOf(MakeBall(core), 30.0);
  ASSERT_GT(surface->GetNumberOfCells(), 0);
  EXPECT_EQ(OpenEdges(surface), 0);
  const double bounds = HighestPoint(surface, 0);
  EXPECT_GT(bounds, 3.0);
  EXPECT_LT(bounds, 4.0);
  EXPECT_EQ(SurfaceOf(MakeBall(core, MomentName::VEL), 30.0)->GetNumberOfCells(), 0);
  EXPECT_GT(SurfaceOf(MakeBall(core, MomentName::VEL), 55.0)->GetNumberOfCells(), 0);
}

// Whole numbers of voxels from the centre have the value of the surface itself.
TEST(IsoSurface, AVoxelWithTheValueGivesNoTriangleWithoutArea)
{
  const auto surface = SurfaceOf(MakeBall(EchoEverywhere), 35.0); // 10 km from the centre
  EXPECT_EQ(OpenEdges(surface), 0);
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    EXPECT_NEAR(vtkMath::Norm(normals->GetTuple3(i)), 1.0, 1e-5);
  }
  ForEachTriangle(surface,
    [](const auto& corners) {
      EXPECT_TRUE(corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]);
    });
}

// Values of 20, 30 and 40 dBZ without order, and voxels that do not count: some have the value of
// the surface alone, others side by side, and give points without a triangle and sheets.
TEST(IsoSurface, EachPointHasATriangleAndANormal)
{
  std::minstd_rand random(1);
  const auto speckled = MakeBall([&random](const auto&)
    { return random() % 8 == 0 ? VoxelState::NotScanned : VoxelState::Echo; });
  vtkDataArray* values = speckled->GetPointData()->GetArray("REF");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetTuple1(i, 20.0 + 10.0 * static_cast<double>(random() % 16 / 14 + random() % 2));
  }
  const auto surface = SurfaceOf(speckled, 30.0);
  ASSERT_GT(surface->GetNumberOfCells(), 1000);
  std::vector<bool> used(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  ForEachTriangle(surface,
    [&used](const auto& corners)
    {
      for (const vtkIdType corner : corners)
      {
        used[static_cast<std::size_t>(corner)] = true;
      }
    });
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    EXPECT_NEAR(vtkMath::Norm(normals->GetTuple3(i)), 1.0, 1e-5);
  }
}

TEST(IsoSurface, PlanesCutIt)
{
  vtkNew<vtkPlaneCollection> planes;
  vtkNew<vtkPlane> east; // of which the eastern part is left
  east->SetOrigin(3.25, 0.0, 0.0);
  east->SetNormal(1.0, 0.0, 0.0);
  planes->AddItem(east);
  const auto volume = MakeBall(EchoEverywhere);
  const auto part = SurfaceOf(volume, 30.0, planes);
  ASSERT_GT(part->GetNumberOfCells(), 0);
  EXPECT_LT(part->GetNumberOfCells(), SurfaceOf(volume, 30.0)->GetNumberOfCells());
  EXPECT_NEAR(part->GetBounds()[0], 3.25, 1e-5);
  EXPECT_NEAR(part->GetBounds()[1], radius, 0.02);
  ASSERT_NE(part->GetPointData()->GetNormals(), nullptr);
}

TEST(IsoSurface, AValueThatNothingReachesHasNoTriangles)
{
  const auto surface = SurfaceOf(MakeBall(EchoEverywhere), 70.0);
  EXPECT_EQ(surface->GetNumberOfPoints(), 0);
  EXPECT_EQ(surface->GetNumberOfCells(), 0);
}
