// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/VolumeComparison.h"
#include "EventCounter.h"
#include "TestData.h"
#include "Tolerance.h"
#include "VolumeMaker.h"

#include "nexrad/Codec/NxvSeries.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/Grid/VolumeMoments.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradNetCDFInput.h"
#include "vtkNexradNetCDFOutput.h"
#include "vtkNexradNetCDFReader.h"
#include "vtkNexradNetCDFWriter.h"

#include "vtkDataArray.h"
#include "vtkDataArraySelection.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNetCDFCFReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtk_netcdf.h"

#include <GeographicLib/Geodesic.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace
{

using nexrad::GriddedVolume;
using nexrad::VoxelState;
using nexrad::testing::AddAncillary;
using nexrad::testing::EventCounter;
using nexrad::testing::ExpectSameVolume;
using nexrad::testing::MakeGriddedVolume;
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

void ExpectSame(const GriddedVolume& volume, const GriddedVolume& expected)
{
  ExpectSameVolume(volume, expected);
  ASSERT_EQ(volume.further.size(), expected.further.size());
  for (std::size_t i = 0; i < volume.further.size(); ++i)
  {
    ExpectSameVolume(volume.further[i], expected.further[i]);
  }
}

std::string ErrorOf(const std::filesystem::path& path)
{
  try
  {
    vtkNexradReadNetCDF(path);
  }
  catch (const nexrad::Error& error)
  {
    return error.what();
  }
  return {};
}

/// Changes a file through the NetCDF library.
template <class Change>
void Alter(const std::filesystem::path& path, Change change)
{
  int file = -1;
  ASSERT_EQ(nc_open(path.c_str(), NC_WRITE, &file), NC_NOERR);
  change(file);
  ASSERT_EQ(nc_close(file), NC_NOERR);
}

int VariableOf(int file, const char* name)
{
  int variable = -1;
  EXPECT_EQ(nc_inq_varid(file, name, &variable), NC_NOERR) << name;
  return variable;
}

TEST(NetCDFFiles, ARoundTripKeepsValuesStatesAndAncillaryArrays)
{
  const TemporaryFolder folder;
  const auto path = folder.Path() / "volume.nc";
  const GriddedVolume volume = MakeVolume();
  vtkNexradWriteNetCDF(path, volume, "a test");
  ExpectSame(vtkNexradReadNetCDF(path), volume);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.Path()), {}), 1);
}

TEST(NetCDFFiles, GeographicAxesComeBack)
{
  const TemporaryFolder folder;
  const auto path = folder.Path() / "volume.nc";
  GriddedVolume volume = MakeGriddedVolume();
  volume.grid.axes = nexrad::GridAxes::Geographic;
  volume.grid.origin = {-95.25, 37.5, 100.0};
  volume.grid.spacing = {0.05, 0.04, 250.0};
  vtkNexradWriteNetCDF(path, volume, "a test");
  const GriddedVolume again = vtkNexradReadNetCDF(path);
  EXPECT_EQ(again.grid, volume.grid);
  EXPECT_EQ(again.values, volume.values);
  // Not written, and of radars that the table of sites has.
  EXPECT_EQ(again.sitePositions.size(), 2);
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
  second.further.clear();
  vtkNexradNetCDFOutput output(path, "a test");
  output.Add(first);
  output.Add(second);
  EXPECT_THROW(output.Add(first), nexrad::Error); // times must ascend
  output.Commit();
  const auto contents = vtkNexradReadNetCDFContents(path);
  EXPECT_EQ(contents.Times, (std::vector<nexrad::Time>{first.time, second.time}));
  EXPECT_EQ(contents.Moments, (std::vector<nexrad::MomentName>{nexrad::MomentName::REF}));
  ExpectSame(vtkNexradReadNetCDF(path), first);
  vtkNexradNetCDFRequest request;
  request.Time = 1;
  const GriddedVolume again = vtkNexradReadNetCDF(path, request);
  // The file's order of radars: KLSX, KEAX, KILX.
  EXPECT_EQ(again.sites, (std::vector<std::string>{"KEAX", "KILX"}));
  EXPECT_EQ(again.values, second.values);
  for (std::size_t i = 0; i < again.ancillary.nearestSite.size(); ++i)
  {
    const auto was = second.ancillary.nearestSite[i];
    const auto is = again.ancillary.nearestSite[i];
    EXPECT_EQ(is, was == nexrad::AncillaryArrays::NoSite ? was : 1 - was);
  }
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
  int file = -1;
  ASSERT_EQ(nc_open(path.c_str(), NC_NOWRITE, &file), NC_NOERR);
  const std::size_t columns = 41 * 31;
  std::vector<double> latitudes(columns);
  std::vector<double> longitudes(columns);
  std::vector<double> x(41);
  std::vector<double> y(31);
  EXPECT_EQ(nc_get_var_double(file, VariableOf(file, "latitude"), latitudes.data()), NC_NOERR);
  EXPECT_EQ(nc_get_var_double(file, VariableOf(file, "longitude"), longitudes.data()), NC_NOERR);
  EXPECT_EQ(nc_get_var_double(file, VariableOf(file, "x"), x.data()), NC_NOERR);
  EXPECT_EQ(nc_get_var_double(file, VariableOf(file, "y"), y.data()), NC_NOERR);
  double centre[2] = {};
  const int projection = VariableOf(file, "projection");
  nc_get_att_double(file, projection, "latitude_of_projection_origin", &centre[0]);
  nc_get_att_double(file, projection, "longitude_of_projection_origin", &centre[1]);
  nc_close(file);
  double largest = 0.0;
  for (std::size_t i = 0; i < columns; ++i)
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

TEST(NetCDFFiles, WriterAndReaderKeepAllTimes)
{
  const TemporaryFolder folder;
  const auto first = folder.Path() / "first.nc";
  vtkNexradNetCDFOutput output(first, "a test");
  output.Add(MakeVolume());
  output.Add(MakeVolume(std::chrono::minutes(5)));
  output.Commit();
  EXPECT_EQ(vtkNexradNetCDFReader::CanReadFile(first.c_str()), 1);
  vtkNew<vtkNexradNetCDFReader> reader;
  reader->SetFileName(first.c_str());
  vtkNew<vtkNexradNetCDFWriter> writer;
  writer->SetInputConnection(reader->GetOutputPort());
  for (const char* name : {"second.nc", "volumes.nc.series"})
  {
    const auto path = folder.Path() / name;
    writer->SetFileName(path.c_str());
    ASSERT_EQ(writer->Write(), 1);
    EXPECT_EQ(writer->GetWrittenFile(writer->GetNumberOfWrittenFiles() - 1), path.string());
    vtkNew<vtkNexradNetCDFReader> again;
    again->SetFileName(path.c_str());
    again->UpdateInformation();
    vtkInformation* info = again->GetOutputInformation(0);
    ASSERT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 2);
    const double time = info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[1];
    again->UpdateTimeStep(time);
    ExpectSame(vtkNexradImageToVolume(again->GetOutput()), MakeVolume(std::chrono::minutes(5)));
  }
  writer->SetFileName((folder.Path() / "one.nc").c_str());
  writer->AllTimeStepsOff();
  ASSERT_EQ(writer->Write(), 1);
  EXPECT_EQ(vtkNexradReadNetCDFContents(folder.Path() / "one.nc").Times.size(), 1);
}

TEST(NetCDFFiles, ReaderGivesABoxAndChosenArrays)
{
  const TemporaryFolder folder;
  const auto path = folder.Path() / "volume.nc";
  const GriddedVolume volume = MakeVolume();
  vtkNexradWriteNetCDF(path, volume, "a test");
  vtkNew<vtkNexradNetCDFReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetMoments("VEL");
  reader->UpdateInformation();
  reader->GetAncillaryArraySelection()->DisableArray("VEL_weight");
  const int extent[6] = {1, 3, 0, 2, 1, 2};
  reader->UpdateExtent(extent);
  vtkImageData* image = reader->GetOutput();
  EXPECT_TRUE(std::equal(extent, extent + 6, image->GetExtent()));
  EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "VEL");
  EXPECT_FALSE(image->GetPointData()->HasArray("REF"));
  EXPECT_FALSE(image->GetPointData()->HasArray("VEL_weight"));
  EXPECT_TRUE(image->GetPointData()->HasArray("VEL_age"));
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

TEST(NetCDFFiles, DamageIsOneClearLine)
{
  const TemporaryFolder folder;
  const auto path = folder.Path() / "volume.nc";
  const auto remake = [&path]
  {
    std::filesystem::remove(path);
    vtkNexradWriteNetCDF(path, MakeVolume(), "a test");
  };
  EXPECT_NE(ErrorOf(folder.Path() / "nothing.nc").find("cannot be read"), std::string::npos);
  std::ofstream(path) << "no NetCDF";
  EXPECT_NE(ErrorOf(path).find(path.string() + ": cannot be read as NetCDF"), std::string::npos);
  remake();
  Alter(path,
    [](int file)
    {
      const std::size_t start[4] = {0, 1, 1, 1};
      const signed char state = 9;
      nc_put_var1_schar(file, VariableOf(file, "REF_state"), start, &state);
    });
  EXPECT_NE(ErrorOf(path).find("REF_state: voxel 26: a state is 0 to 4"), std::string::npos);
  remake();
  Alter(path,
    [](int file)
    {
      const std::size_t start[4] = {0, 0, 0, 0};
      const float none = NAN;
      nc_put_var1_float(file, VariableOf(file, "REF"), start, &none);
    });
  EXPECT_NE(ErrorOf(path).find("its state is echo, and it has no value"), std::string::npos);
  remake();
  Alter(path,
    [](int file)
    {
      const std::size_t start[4] = {0, 0, 0, 0};
      const short radar = 7;
      nc_put_var1_short(file, VariableOf(file, "REF_site"), start, &radar);
    });
  EXPECT_NE(ErrorOf(path).find("REF_site: voxel 0: 7 is no radar of this time"), std::string::npos);
  remake();
  Alter(path, [](int file) { nc_del_att(file, NC_GLOBAL, "vtk_nexrad_netcdf_version"); });
  EXPECT_NE(ErrorOf(path).find("is no NetCDF file of merged volumes"), std::string::npos);
  EXPECT_EQ(vtkNexradNetCDFReader::CanReadFile(path.c_str()), 0);
}

// Changed bytes are not tested: HDF5 1.10.8 itself ends the program at some of them.
TEST(NetCDFFiles, ACutFileIsRefused)
{
  const TemporaryFolder folder;
  const auto path = folder.Path() / "volume.nc";
  const auto cut = folder.Path() / "cut.nc";
  vtkNexradWriteNetCDF(path, MakeVolume(), "a test");
  std::ifstream source(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(source)), {});
  for (std::size_t i = 0; i < bytes.size(); i += 499)
  {
    std::ofstream(cut, std::ios::binary) << bytes.substr(0, i);
    EXPECT_NE(ErrorOf(cut).find("cannot be read as NetCDF"), std::string::npos) << i;
  }
}

TEST(NetCDFFiles, ReaderAndWriterSayWhatIsWrong)
{
  const TemporaryFolder folder;
  vtkNew<vtkNexradNetCDFReader> reader;
  vtkNew<EventCounter> events;
  events->Observe(reader);
  events->Observe(reader->GetExecutive());
  reader->UpdateInformation();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoFileNameError));
  reader->SetFileName((folder.Path() / "nothing.nc").c_str());
  reader->UpdateInformation();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileNotFoundError));
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
