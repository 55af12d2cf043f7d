// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/NetCDFContent.h"
#include "EventCounter.h"
#include "TestData.h"
#include "Tolerance.h"
#include "VolumeMaker.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradNetCDFOutput.h"
#include "vtkNexradNetCDFWriter.h"
#include "vtkNexradVolumeReader.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkNetCDFCFReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <GeographicLib/Geodesic.hpp>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace
{

using nexrad::GriddedVolume;
using nexrad::VoxelState;
using nexrad::testing::AddAncillary;
using nexrad::testing::EventCounter;
using nexrad::testing::ExpectVolume;
using nexrad::testing::MakeGriddedVolume;
using nexrad::testing::NetCDFContent;
using nexrad::testing::TemporaryFolder;

/// Every state, ancillary arrays, a second moment, positions of the radars.
GriddedVolume MakeVolume(std::chrono::minutes later = {})
{
  GriddedVolume volume = MakeGriddedVolume();
  volume.time += later;
  volume.states[1] = VoxelState::RangeFolded;
  volume.states[4] = VoxelState::Filtered;
  volume.synthetic = true;
  AddAncillary(volume);
  GriddedVolume velocity = volume;
  velocity.moment = nexrad::MomentName::VEL;
  velocity.states[7] = VoxelState::Echo;
  velocity.values[7] = -12.5F;
  volume = nexrad::JoinMoments({volume, velocity});
  volume.sitePositions = {{38.810, -94.264, 303.0}, {38.699, -90.683, 185.5}};
  volume.further.front().sitePositions = volume.sitePositions;
  return volume;
}

TEST(NetCDFFiles, HaveValuesStatesAndAncillaryArrays)
{
  const TemporaryFolder folder;
  const auto path = folder.Path() / "volume.nc";
  const GriddedVolume volume = MakeVolume();
  vtkNexradWriteNetCDF(path, volume, "a test");
  ExpectVolume(NetCDFContent(path), 0, volume);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.Path()), {}), 1);
}

TEST(NetCDFFiles, HaveGeographicAxes)
{
  const TemporaryFolder folder;
  const auto path = folder.Path() / "volume.nc";
  GriddedVolume volume = MakeGriddedVolume();
  volume.grid.axes = nexrad::GridAxes::Geographic;
  volume.grid.origin = {-95.25, 37.5, 100.0};
  volume.grid.spacing = {0.05, 0.04, 250.0};
  vtkNexradWriteNetCDF(path, volume, "a test");
  const NetCDFContent file(path);
  ExpectVolume(file, 0, volume);
  const char* const names[3] = {"longitude", "latitude", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<double> centres = file.Numbers(names[axis]);
    EXPECT_EQ(centres.size(), static_cast<std::size_t>(volume.grid.dimensions[axis]));
    EXPECT_EQ(centres[0], volume.grid.origin[axis]);
    EXPECT_EQ(file.Number(names[axis], "spacing"), volume.grid.spacing[axis]);
  }
  // Not given with the volume, and of radars that the table of sites has.
  EXPECT_TRUE(std::isfinite(file.Numbers("radar_latitude").at(1)));
}

// A radar that takes part at the second time alone changes the places of the others.
TEST(NetCDFFiles, SeveralTimesInOneFileKeepTheirRadars)
{
  const TemporaryFolder folder;
  const auto path = folder.Path() / "volumes.nc";
  GriddedVolume first = MakeVolume();
  first.sites = {"KLSX", "KEAX"};
  std::swap(first.sitePositions[0], first.sitePositions[1]);
  first.further.clear();
  GriddedVolume second = MakeVolume(std::chrono::minutes(5));
  second.sites = {"KILX", "KEAX"};
  second.sitePositions = {{40.151, -89.338, 177.0}, first.sitePositions[1]};
  second.further.clear();
  vtkNexradNetCDFOutput output(path, "a test");
  output.Add(first);
  output.Add(second);
  EXPECT_THROW(output.Add(first), nexrad::Error); // times must ascend
  output.Commit();
  const NetCDFContent file(path);
  EXPECT_EQ(file.Numbers("time").size(), 2);
  EXPECT_EQ(file.RadarNames(), (std::vector<std::string>{"KLSX", "KEAX", "KILX"}));
  EXPECT_FALSE(file.Has("VEL"));
  ExpectVolume(file, 0, first);
  ExpectVolume(file, 1, second);
}

// Latitudes and longitudes of a grid as large as any, against geodesics from the grid's centre,
// which an azimuthal equidistant projection has as straight lines of their true length.
TEST(NetCDFFiles, PositionsAreRight)
{
  const TemporaryFolder folder;
  const auto path = folder.Path() / "volume.nc";
  GriddedVolume volume = MakeGriddedVolume({41, 31, 2});
  volume.grid.origin = {-800'000.0, -600'000.0, 0.0};
  volume.grid.spacing = {40'000.0, 40'000.0, 500.0};
  vtkNexradWriteNetCDF(path, volume, "a test");
  const NetCDFContent file(path);
  const std::vector<double> latitudes = file.Numbers("latitude");
  const std::vector<double> longitudes = file.Numbers("longitude");
  const std::vector<double> x = file.Numbers("x");
  const std::vector<double> y = file.Numbers("y");
  const double centre[2] = {file.Number("projection", "latitude_of_projection_origin"),
    file.Number("projection", "longitude_of_projection_origin")};
  double largest = 0.0;
  for (std::size_t i = 0; i < latitudes.size(); ++i)
  {
    const double east = x[i % 41];
    const double north = y[i / 41];
    double place[2] = {};
    GeographicLib::Geodesic::WGS84().Direct(centre[0], centre[1],
      std::atan2(east, north) / nexrad::RadiansPerDegree, std::hypot(east, north), place[0],
      place[1]);
    double away = 0.0;
    GeographicLib::Geodesic::WGS84().Inverse(latitudes[i], longitudes[i], place[0], place[1], away);
    largest = std::max(largest, away);
  }
  EXPECT_AT_MOST(largest, 0.75, "Largest error of a position in a NetCDF file, m");
}

TEST(NetCDFFiles, TheWriterWritesAllTimesOrOne)
{
  const TemporaryFolder folder;
  const GriddedVolume volumes[2] = {MakeVolume(), MakeVolume(std::chrono::minutes(5))};
  nexrad::NxvSeries index;
  for (const GriddedVolume& volume : volumes)
  {
    index.emplace_back(nexrad::FormatForFileName(volume.time), nexrad::ToSeconds(volume.time));
    nexrad::WriteNxv(folder.Path() / index.back().first, volume, nexrad::NxvEncoding::Float);
  }
  nexrad::WriteNxvSeries(folder.Path() / "volumes.nxv.series", index);
  vtkNew<vtkNexradVolumeReader> reader;
  reader->SetFileName((folder.Path() / "volumes.nxv.series").c_str());
  vtkNew<vtkNexradNetCDFWriter> writer;
  writer->SetInputConnection(reader->GetOutputPort());
  writer->SetFileName((folder.Path() / "all.nc").c_str());
  ASSERT_EQ(writer->Write(), 1);
  EXPECT_EQ(writer->GetWrittenFile(0), (folder.Path() / "all.nc").string());
  for (std::size_t i = 0; i < 2; ++i)
  {
    ExpectVolume(NetCDFContent(folder.Path() / "all.nc"), i, volumes[i]);
  }
  writer->SetFileName((folder.Path() / "volumes.nc.series").c_str());
  ASSERT_EQ(writer->Write(), 1);
  ASSERT_EQ(writer->GetNumberOfWrittenFiles(), 3);
  EXPECT_EQ(nexrad::ReadNxvSeries(writer->GetWrittenFile(2)).size(), 2);
  ExpectVolume(NetCDFContent(writer->GetWrittenFile(1)), 0, volumes[1]);
  writer->SetFileName((folder.Path() / "one.nc").c_str());
  writer->AllTimeStepsOff();
  ASSERT_EQ(writer->Write(), 1);
  EXPECT_EQ(NetCDFContent(folder.Path() / "one.nc").Numbers("time").size(), 1);
}

// What ParaView opens .nc files with: dimensions, values, and no values where there is no echo.
TEST(NetCDFFiles, ReaderOfVTKForTheConventionsOpensThem)
{
  const TemporaryFolder folder;
  const auto path = folder.Path() / "volume.nc";
  const GriddedVolume volume = MakeVolume();
  vtkNexradWriteNetCDF(path, volume, "a test");
  ASSERT_EQ(vtkNetCDFCFReader::CanReadFile(path.c_str()), 1);
  vtkNew<vtkNetCDFCFReader> reader;
  reader->SetFileName(path.c_str());
  reader->SphericalCoordinatesOff();
  reader->UpdateInformation();
  reader->SetDimensions("(z, y, x)");
  reader->SetOutputTypeToImage();
  reader->UpdateTimeStep(nexrad::ToSeconds(volume.time));
  auto* image = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  ASSERT_NE(image, nullptr);
  const vtkIdType points = image->GetNumberOfPoints();
  ASSERT_EQ(points, static_cast<vtkIdType>(volume.values.size()));
  vtkDataArray* values = image->GetPointData()->GetArray("REF");
  vtkDataArray* states = image->GetPointData()->GetArray("REF_state");
  ASSERT_NE(values, nullptr);
  ASSERT_NE(states, nullptr);
  for (vtkIdType i = 0; i < points; ++i)
  {
    const auto voxel = static_cast<std::size_t>(i);
    const bool echo = volume.states[voxel] == VoxelState::Echo;
    EXPECT_EQ(states->GetComponent(i, 0), static_cast<double>(volume.states[voxel]));
    EXPECT_EQ(std::isnan(values->GetComponent(i, 0)), !echo);
    EXPECT_TRUE(!echo || values->GetComponent(i, 0) == static_cast<double>(volume.values[voxel]));
  }
  EXPECT_NEAR(image->GetOrigin()[0], volume.grid.origin[0], 1e-6);
  EXPECT_NEAR(image->GetSpacing()[2], volume.grid.spacing[2], 1e-6);
}

TEST(NetCDFFiles, TheWriterSaysWhatIsWrong)
{
  const TemporaryFolder folder;
  vtkNew<EventCounter> events;
  vtkNew<vtkNexradNetCDFWriter> writer;
  events->Observe(writer);
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(MakeVolume(), image);
  writer->SetInputData(image);
  writer->SetFileName((folder.Path() / "no" / "such" / "folder.nc").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::CannotOpenFileError));
  image->GetPointData()->RemoveArray("REF_state");
  writer->SetFileName((folder.Path() / "volume.nc").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_TRUE(std::filesystem::is_empty(folder.Path()));
}

} // namespace
