// SPDX-License-Identifier: BSD-3-Clause
#include "HandMadeVolume.h"
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"
#include "VolumeMaker.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Products/ColumnProducts.h"

#include "vtk_tiff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

constexpr float noValue = -9999.0F;

// The bands of a GeoTIFF, with the rows from the south, and its tags of place.
struct Raster
{
  std::vector<float> values;
  std::vector<float> states;
  std::vector<double> scale;
  std::vector<double> tiepoint;
  std::vector<double> parameters;
  std::string description;
  std::vector<std::array<unsigned char, 4>> colours; // of the second page
};

std::vector<double> NumbersOf(TIFF* tiff, std::uint32_t tag)
{
  std::uint32_t count = 0;
  double* numbers = nullptr;
  if (TIFFGetField(tiff, tag, &count, &numbers) != 1)
  {
    return {};
  }
  return {numbers, numbers + count};
}

Raster ReadRaster(const fs::path& path, std::size_t width, std::size_t height)
{
  TIFFSetWarningHandler(nullptr);
  Raster raster;
  const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(path.c_str(), "r"), &TIFFClose);
  if (!tiff)
  {
    return raster;
  }
  for (std::uint16_t band = 0; band < 2; ++band)
  {
    std::vector<float>& values = band == 0 ? raster.values : raster.states;
    values.resize(width * height);
    for (std::size_t y = 0; y < height; ++y)
    {
      float* const row = values.data() + (height - 1 - y) * width;
      EXPECT_EQ(TIFFReadScanline(tiff.get(), row, static_cast<std::uint32_t>(y), band), 1);
    }
  }
  raster.scale = NumbersOf(tiff.get(), 33550);
  raster.tiepoint = NumbersOf(tiff.get(), 33922);
  raster.parameters = NumbersOf(tiff.get(), 34736);
  char* text = nullptr;
  raster.description =
    TIFFGetField(tiff.get(), TIFFTAG_IMAGEDESCRIPTION, &text) == 1 ? text : std::string();
  EXPECT_EQ(TIFFReadDirectory(tiff.get()), 1);
  EXPECT_EQ(NumbersOf(tiff.get(), 33922), raster.tiepoint);
  raster.colours.resize(width * height);
  for (std::size_t y = 0; y < height; ++y)
  {
    auto* const row = raster.colours.data() + (height - 1 - y) * width;
    EXPECT_EQ(TIFFReadScanline(tiff.get(), row, static_cast<std::uint32_t>(y), 0), 1);
  }
  return raster;
}

// Columns of rising echo, some without echo, and one that was not scanned.
GriddedVolume MakeColumns()
{
  GriddedVolume volume = MakeGriddedVolume({6, 5, 4});
  volume.synthetic = true;
  for (std::size_t i = 0; i < volume.grid.VoxelCount(); ++i)
  {
    const std::size_t column = i % 30;
    volume.states[i] = column == 0  ? VoxelState::NotScanned
                       : column < 4 ? VoxelState::NoEcho
                                    : VoxelState::Echo;
    const auto number = static_cast<float>(column) * 2.0F - 6.0F * static_cast<float>(i / 30);
    volume.values[i] = volume.states[i] == VoxelState::Echo ? number : volume.fill;
  }
  return volume;
}

} // namespace

TEST(GeoTiff, ProductsAreThoseOfTheCore)
{
  const TemporaryFolder folder;
  const GriddedVolume volume = MakeColumns();
  const fs::path input = folder.Path() / "volume.nxv";
  WriteNxv(input, volume, NxvEncoding::Float);
  unsetenv("DISPLAY"); // none is needed
  const VoxelLines lines = LinesOf(volume);
  const ColumnProduct tops = MakeEchoTops(lines, 25.0);
  const ColumnProduct liquid = MakeIntegratedLiquid(lines);
  const ColumnProduct density = MakeLiquidDensity(lines, 25.0);
  ColumnProduct composite = liquid;
  std::copy_n(volume.values.begin(), 30, composite.values.begin()); // they fall with height
  const std::pair<const char*, const ColumnProduct*> products[] = {{"composite", &composite},
    {"echo-top:25", &tops}, {"vil", &liquid}, {"vil-density:25", &density}};
  for (const auto& [name, product] : products)
  {
    const fs::path output = folder.Path() / "map.tif";
    const ProgramRun run = RunNexrad3d({"render", input, "-o", output, "--map", name});
    ASSERT_EQ(run.status, 0) << run.errors;
    const Raster raster = ReadRaster(output, 6, 5);
    ASSERT_EQ(raster.values.size(), 30);
    for (std::size_t i = 0; i < 30; ++i)
    {
      const bool has = product->states[i] == VoxelState::Echo;
      EXPECT_EQ(raster.values[i], has ? product->values[i] : noValue) << name << i;
      EXPECT_EQ(raster.states[i], static_cast<float>(product->states[i])) << name << i;
    }
    EXPECT_EQ(raster.description.find("SYNTHETIC: "), 0);
    EXPECT_NE(raster.description.find("2006-03-12T18:05:00.250Z"), std::string::npos);
  }
}

// The north-western corner of the north-western pixel, the size of a pixel, and the projection.
TEST(GeoTiff, PlaceIsThatOfTheGrid)
{
  const TemporaryFolder folder;
  const GriddedVolume volume = MakeColumns();
  const fs::path input = folder.Path() / "volume.nxv";
  const fs::path output = folder.Path() / "map.tif";
  WriteNxv(input, volume);
  ASSERT_EQ(RunNexrad3d({"render", input, "-o", output, "--map", "composite"}).status, 0);
  const Raster raster = ReadRaster(output, 6, 5);
  EXPECT_EQ(raster.scale, (std::vector<double>{1800.25, 1700.0, 0.0}));
  const double west = -1000.5 - 0.5 * 1800.25;
  const double north = 250.0 + 4.5 * 1700.0;
  EXPECT_EQ(raster.tiepoint, (std::vector<double>{0.0, 0.0, 0.0, west, north, 0.0}));
  EXPECT_EQ(raster.parameters, (std::vector<double>{0.0, 0.0, -91.7, 39.21}));
}

TEST(GeoTiff, TheSecondPageHasTheColoursOfTheMoment)
{
  using Colour = std::array<unsigned char, 4>;
  const TemporaryFolder folder;
  GriddedVolume volume = MakeColumns();
  const auto draw = [&](const std::vector<std::string>& more)
  {
    const fs::path input = folder.Path() / "volume.nxv";
    WriteNxv(input, volume);
    std::vector<std::string> arguments = {
      "render", input, "-o", folder.Path() / "map.tif", "--map", "composite"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 0) << run.errors;
    return ReadRaster(folder.Path() / "map.tif", 6, 5).colours;
  };
  const auto reflectivity = draw({});
  EXPECT_EQ(reflectivity[0], (Colour{0, 0, 0, 0})) << "not scanned";
  EXPECT_EQ(reflectivity[1], (Colour{0, 0, 0, 0})) << "no echo";
  EXPECT_EQ(reflectivity[11], (Colour{0x02, 0xfd, 0x02, 255})) << "22 dBZ";
  volume.moment = MomentName::VEL;
  const auto velocity = draw({});
  EXPECT_GT(velocity[11][0], velocity[11][1]) << "22 m/s away from the radar are red";
  const fs::path table = folder.Path() / "my.pal";
  std::ofstream(table) << "Scale: 2\nUnits: x\nColor: 0 0 0 0\nColor: 88 0 0 255\n";
  EXPECT_EQ(draw({"--colours", table})[11], (Colour{0, 0, 128, 255}));
}

// Three tilts, the middle one the strongest everywhere: the deconvolution raises it. A map of radar
// files shows what the radar measured; of a volume, what the volume has.
TEST(GeoTiff, AMapOfRadarFilesIsOfMeasuredReflectivity)
{
  const TemporaryFolder folder;
  HandMadeVolume storm;
  storm.start = *ParseIso8601("2006-03-12T18:00Z");
  for (const auto& [elevation, value] : {std::pair(1.0F, 20.0), {2.0F, 40.0}, {3.0F, 20.0}})
  {
    HandMadeSweep sweep = ConstantVolume(storm.site, storm.start, value).sweeps.front();
    sweep.elevation = elevation;
    storm.sweeps.push_back(sweep);
  }
  const std::string file = WriteLevel2(folder.Path() / "radar", {storm}).string();
  const std::vector<std::string> grid{
    "--dims", "60x60x80", "--range", "80km", "--height", "0,8km", "--quality", "off"};
  const auto largestOf = [&](const std::string& input, const std::vector<std::string>& options)
  {
    const std::string output = folder.Path() / "map.tif";
    std::vector<std::string> command{"render", input, "-o", output, "--map", "composite"};
    command.insert(command.end(), options.begin(), options.end());
    const ProgramRun run = RunNexrad3d(command);
    EXPECT_EQ(run.status, 0) << run.errors;
    const Raster raster = ReadRaster(output, 60, 60);
    return *std::max_element(raster.values.begin(), raster.values.end());
  };
  EXPECT_WITHIN(largestOf(file, grid), 40.0F, 0.01F, "composite of measured 40 dBZ, dBZ");
  const std::string volumes = folder.Path() / "volumes";
  std::vector<std::string> make{"grid", file, "-o", volumes};
  make.insert(make.end(), grid.begin(), grid.end());
  ASSERT_EQ(RunNexrad3d(make).status, 0);
  EXPECT_GT(largestOf(volumes, {}), 41.0F);
}

TEST(GeoTiff, FailuresAreOneLine)
{
  const TemporaryFolder folder;
  const fs::path input = folder.Path() / "volume.nxv";
  WriteNxv(input, MakeColumns());
  const ProgramRun volume = RunNexrad3d({"render", input, "-o", folder.Path() / "map.tif"});
  EXPECT_EQ(volume.status, 2);
  EXPECT_NE(volume.errors.find("--map composite"), std::string::npos) << volume.errors;
  const ProgramRun nowhere =
    RunNexrad3d({"render", input, "-o", folder.Path() / "no" / "map.tif", "--map", "vil"});
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_NE(nowhere.errors.find("cannot be written"), std::string::npos) << nowhere.errors;
}
