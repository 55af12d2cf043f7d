// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/NetCDFContent.h"
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Grid/SiteGeometry.h"
#include "vtkNexradVolumeReader.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

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
    const GriddedVolume volume = ReadNxv(nxv / (radar + "_20100911T011500Z.nxv"));
    EXPECT_TRUE(volume.ofOneRadar);
    EXPECT_EQ(volume.sites, std::vector<std::string>{radar});
    EXPECT_EQ(volume.sitePositions, alone.sitePositions);
    EXPECT_EQ(volume.grid, alone.grid);
    EXPECT_EQ(volume.values, alone.values);
    EXPECT_EQ(volume.states, alone.states);
    EXPECT_EQ(volume.ancillary.age, alone.ancillary.age);
    ASSERT_EQ(volume.further.size(), 1);
    EXPECT_EQ(volume.further.front().values, alone.further.front().values);
    ExpectVolume(NetCDFContent(nc / (radar + ".nc")), 0, volume);
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
  const NetCDFContent file(fs::path(path).replace_extension(".nc"));
  const auto compare = [&](const std::string& name, const std::vector<float>& expected)
  {
    vtkDataArray* array = reader->GetOutput()->GetPointData()->GetArray(name.c_str());
    ASSERT_NE(array, nullptr) << name;
    const std::vector<double> packed = file.Numbers(name);
    const double terms[2] = {file.Number(name, "scale_factor"), file.Number(name, "add_offset")};
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
}
