// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Grid/RadarView.h"
#include "vtkNexradNetCDFInput.h"
#include "vtkNexradVolumeReader.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtk_netcdf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

const std::vector<std::string> files = {
  "KBGM20100911_012056_V03.gz", "KENX20100911_011108_V03.gz", "KTYX20100911_012210_V04.gz"};

// Radars of New York, at 01:15 UTC.
ProgramRun GridRadars(const fs::path& data, const std::vector<std::string>& names,
  const fs::path& output, const std::vector<std::string>& options)
{
  std::vector<std::string> arguments = {"grid"};
  for (const std::string& name : names)
  {
    arguments.push_back(data / "level2" / "multisite-20100911" / name);
  }
  arguments.insert(arguments.end(),
    {"-o", output, "--begin", "2010-09-11T01:15", "--end", "2010-09-11T01:15", "--dims", "48x40x16",
      "--bounds", "-79,41,-73,45", "--moment", "REF,VEL", "--quiet"});
  arguments.insert(arguments.end(), options.begin(), options.end());
  return RunNexrad3d(arguments);
}

} // namespace

// Each radar's volume is the one that its file alone makes, in .nxv and in .nc.
TEST(GridPerRadar, VolumesAreThoseOfEachRadarAlone)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const fs::path nxv = folder.Path() / "nxv";
  const fs::path nc = folder.Path() / "nc";
  ASSERT_EQ(GridRadars(data, files, nxv, {"--per-radar", "--code", "exact"}).status, 0);
  ASSERT_EQ(GridRadars(data, files, nc, {"--per-radar", "--format", "nc", "--one-file"}).status, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(nxv), {}), 6);
  EXPECT_EQ(std::distance(fs::directory_iterator(nc), {}), 3);
  for (const std::string& file : files)
  {
    const std::string radar = file.substr(0, 4);
    const fs::path own = folder.Path() / radar;
    ASSERT_EQ(GridRadars(data, {file}, own, {"--ancillary", "--code", "exact"}).status, 0);
    const GriddedVolume alone = ReadNxv(own / "20100911T011500Z.nxv");
    EXPECT_EQ(ReadNxvSeries(nxv / (radar + ".nxv.series")).size(), 1);
    for (const GriddedVolume& volume :
      {ReadNxv(nxv / (radar + "_20100911T011500Z.nxv")), vtkNexradReadNetCDF(nc / (radar + ".nc"))})
    {
      EXPECT_TRUE(volume.ofOneRadar);
      EXPECT_EQ(volume.sites, std::vector<std::string>{radar});
      EXPECT_EQ(volume.sitePositions, alone.sitePositions);
      EXPECT_EQ(volume.grid, alone.grid);
      EXPECT_EQ(volume.values, alone.values);
      EXPECT_EQ(volume.states, alone.states);
      EXPECT_EQ(volume.ancillary.age, alone.ancillary.age);
      ASSERT_EQ(volume.further.size(), 1);
      EXPECT_EQ(volume.further.front().values, alone.further.front().values);
    }
  }
}

// The reader of .nxv gives the view exactly; a NetCDF file has it packed, for other programs.
TEST(GridPerRadar, FilesHaveTheRadarsView)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  ASSERT_EQ(GridRadars(data, files, folder.Path(), {"--per-radar"}).status, 0);
  ASSERT_EQ(GridRadars(data, files, folder.Path(), {"--per-radar", "--format", "nc"}).status, 0);
  const fs::path path = folder.Path() / "KENX_20100911T011500Z.nxv";
  const GriddedVolume header = ReadNxvHeader(path);
  const RadarView view = MakeRadarView(header.grid, header.sitePositions.front());
  vtkNew<vtkNexradVolumeReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  int file = -1;
  ASSERT_EQ(nc_open(fs::path(path).replace_extension(".nc").c_str(), NC_NOWRITE, &file), NC_NOERR);
  const auto compare = [&](const std::string& name, const std::vector<float>& expected)
  {
    vtkDataArray* array = reader->GetOutput()->GetPointData()->GetArray(name.c_str());
    ASSERT_NE(array, nullptr) << name;
    std::vector<double> packed(expected.size());
    int variable = -1;
    double terms[2] = {};
    ASSERT_EQ(nc_inq_varid(file, name.c_str(), &variable), NC_NOERR);
    ASSERT_EQ(nc_get_var_double(file, variable, packed.data()), NC_NOERR);
    nc_get_att_double(file, variable, "scale_factor", &terms[0]);
    nc_get_att_double(file, variable, "add_offset", &terms[1]);
    double largest = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      EXPECT_EQ(
        array->GetComponent(static_cast<vtkIdType>(i), 0), static_cast<double>(expected[i]));
      largest = std::max(
        largest, std::abs(terms[1] + terms[0] * packed[i] - static_cast<double>(expected[i])));
    }
    // Half a step of a code.
    EXPECT_AT_MOST(largest, name == "slant_range" ? 10.001 : 0.0051,
      "Largest error of " + name + " in a NetCDF file, degrees or m");
  };
  ForEachArray(view, compare);
  nc_close(file);
}
