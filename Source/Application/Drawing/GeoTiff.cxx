// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/GeoTiff.h"

#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Plan/PlanLayer.h"
#include "Scene/Plan/PlanView.h"
#include "Scene/VolumeAppearance.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"
#include "vtkNexradThreads.h"
#include "vtkNexradTransferFunction.h"
#include "vtk_tiff.h"

#include <vtkImageData.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace nexrad::scene
{
namespace
{

// A map of one value a column, for other programs.
struct GeoMap
{
  GridSpecification grid; // of the volume; its columns are the pixels
  PlanView view;
  // Red, green, blue and opacity of each column, as a picture of the map shows it.
  std::vector<std::array<unsigned char, 4>> colours;
  std::string title; // what the values are: "Echo top at 18 dBZ"
  std::string unit;  // "m"; may be empty
  Time time{};
  bool synthetic = false; // made from simulated files
};

// The number that pixels without a value have.
constexpr float GeoMapNoValue = -9999.0F;

// Tags of GeoTIFF (OGC 19-008, annex F), and those by which GDAL names bands and the number for no
// value.
constexpr std::uint32_t PixelScaleTag = 33550;
constexpr std::uint32_t TiepointTag = 33922;
constexpr std::uint32_t GeoKeysTag = 34735;
constexpr std::uint32_t GeoDoublesTag = 34736;
constexpr std::uint32_t GeoTextsTag = 34737;
constexpr std::uint32_t GdalMetadataTag = 42112;
constexpr std::uint32_t GdalNoValueTag = 42113;

// Makes them known to libtiff.
void AddTags(TIFF* tiff)
{
  char names[][20] = {"ModelPixelScale", "ModelTiepoint", "GeoKeyDirectory", "GeoDoubleParams",
    "GeoAsciiParams", "GDALMetadata", "GDALNoDataValue"};
  const TIFFFieldInfo fields[] = {
    {PixelScaleTag, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, names[0]},
    {TiepointTag, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, names[1]},
    {GeoKeysTag, -1, -1, TIFF_SHORT, FIELD_CUSTOM, 1, 1, names[2]},
    {GeoDoublesTag, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, names[3]},
    {GeoTextsTag, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, names[4]},
    {GdalMetadataTag, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, names[5]},
    {GdalNoValueTag, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, names[6]}};
  TIFFMergeFieldInfo(tiff, fields, std::size(fields));
}

// The keys that say which projection the pixels are in.
class GeoKeys
{
public:
  void Add(std::uint16_t key, std::uint16_t value) { this->Append(key, 0, 1, value); }
  void Add(std::uint16_t key, double value)
  {
    this->Append(key, GeoDoublesTag, 1, static_cast<std::uint16_t>(doubles.size()));
    doubles.push_back(value);
  }
  void Add(std::uint16_t key, const std::string& text)
  {
    this->Append(key, GeoTextsTag, static_cast<std::uint16_t>(text.size() + 1),
      static_cast<std::uint16_t>(texts.size()));
    texts += text + '|';
  }

  void Set(TIFF* tiff)
  {
    keys[3] = static_cast<std::uint16_t>(keys.size() / 4 - 1);
    TIFFSetField(tiff, GeoKeysTag, static_cast<int>(keys.size()), keys.data());
    if (!doubles.empty())
    {
      TIFFSetField(tiff, GeoDoublesTag, static_cast<int>(doubles.size()), doubles.data());
    }
    TIFFSetField(tiff, GeoTextsTag, texts.c_str());
  }

private:
  void Append(std::uint16_t key, std::uint32_t tag, std::uint16_t count, std::uint16_t value)
  {
    keys.insert(keys.end(), {key, static_cast<std::uint16_t>(tag), count, value});
  }

  std::vector<std::uint16_t> keys = {1, 1, 0, 0}; // version 1.0, and the number of keys
  std::vector<double> doubles;
  std::string texts;
};

// Keys in ascending order (OGC 19-008, annex C).
GeoKeys KeysOf(const GridSpecification& grid)
{
  constexpr std::uint16_t projected = 1;
  constexpr std::uint16_t geographic = 2;
  constexpr std::uint16_t pixelIsArea = 1;
  constexpr std::uint16_t wgs84 = 4326;
  constexpr std::uint16_t degree = 9102;
  constexpr std::uint16_t metre = 9001;
  constexpr std::uint16_t userDefined = 32767;
  constexpr std::uint16_t azimuthalEquidistant = 12;
  const bool isProjected = grid.axes == GridAxes::Projected;
  GeoKeys keys;
  keys.Add(1024, isProjected ? projected : geographic);
  keys.Add(1025, pixelIsArea);
  keys.Add(2048, wgs84);
  keys.Add(2049, std::string("WGS 84"));
  keys.Add(2054, degree);
  if (isProjected)
  {
    keys.Add(3072, userDefined);
    keys.Add(3073, std::string("Azimuthal equidistant about the centre of the grid"));
    keys.Add(3074, userDefined);
    keys.Add(3075, azimuthalEquidistant);
    keys.Add(3076, metre);
    keys.Add(3082, 0.0); // false easting
    keys.Add(3083, 0.0);
    keys.Add(3088, grid.centreLongitude);
    keys.Add(3089, grid.centreLatitude);
  }
  return keys;
}

void SetPlace(TIFF* tiff, const GridSpecification& grid)
{
  const std::array<double, 3> scale = {grid.spacing[0], grid.spacing[1], 0.0};
  const double left = grid.origin[0] - 0.5 * grid.spacing[0];
  const double top = grid.origin[1] + (grid.dimensions[1] - 0.5) * grid.spacing[1];
  const std::array<double, 6> tiepoint = {0.0, 0.0, 0.0, left, top, 0.0};
  TIFFSetField(tiff, PixelScaleTag, 3, scale.data());
  TIFFSetField(tiff, TiepointTag, 6, tiepoint.data());
  KeysOf(grid).Set(tiff);
}

std::string Item(const char* name, int band, const char* role, const std::string& text)
{
  return "<Item name=\"" + std::string(name) + "\" sample=\"" + std::to_string(band) +
         "\" role=\"" + role + "\">" + text + "</Item>";
}

void Describe(TIFF* tiff, const GeoMap& map)
{
  const std::string title = (map.synthetic ? "SYNTHETIC: " : "") + map.title;
  const std::string iso = FormatIso8601(map.time);
  // "2006:03:12 18:05:00", as TIFF has it.
  const std::string date =
    iso.substr(0, 4) + ":" + iso.substr(5, 2) + ":" + iso.substr(8, 2) + " " + iso.substr(11, 8);
  const std::string bands =
    "<GDALMetadata>" + Item("DESCRIPTION", 0, "description", title) +
    (map.unit.empty() ? "" : Item("UNITTYPE", 0, "unittype", map.unit)) +
    Item("DESCRIPTION", 1, "description",
      "State: 0 value, 1 no echo, 2 range folded, 3 not scanned, 4 filtered") +
    "<Item name=\"TIME_UTC\">" + iso + "</Item></GDALMetadata>";
  TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, (title + ", " + iso + " UTC").c_str());
  TIFFSetField(tiff, TIFFTAG_SOFTWARE, "vtk-nexrad");
  TIFFSetField(tiff, TIFFTAG_DATETIME, date.c_str());
  TIFFSetField(tiff, GdalMetadataTag, bands.c_str());
  TIFFSetField(tiff, GdalNoValueTag, std::to_string(static_cast<int>(GeoMapNoValue)).c_str());
}

// What the pixels of a page hold: `numbers` of `bits` each, the last of them of the kind `extra`.
void SetPixels(
  TIFF* tiff, const GridSpecification& grid, int numbers, int bits, std::uint16_t extra)
{
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(grid.dimensions[0]));
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(grid.dimensions[1]));
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, numbers);
  TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &extra);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  SetPlace(tiff, grid);
}

void SetLayout(TIFF* tiff, const GridSpecification& grid)
{
  constexpr int rowsPerStrip = 64;
  SetPixels(tiff, grid, 2, 32, EXTRASAMPLE_UNSPECIFIED);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_SEPARATE);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, rowsPerStrip);
}

// The rows of both bands from the north. False when the disk is full.
bool WriteRows(TIFF* tiff, const GeoMap& map)
{
  const auto width = static_cast<std::size_t>(map.grid.dimensions[0]);
  const auto height = static_cast<std::size_t>(map.grid.dimensions[1]);
  std::vector<float> row(width);
  for (std::uint16_t band = 0; band < 2; ++band)
  {
    for (std::size_t y = 0; y < height; ++y)
    {
      const std::size_t first = (height - 1 - y) * width;
      for (std::size_t x = 0; x < width; ++x)
      {
        const VoxelState state = map.view.states[first + x];
        const float value = state == VoxelState::Echo ? map.view.values[first + x] : GeoMapNoValue;
        row[x] = band == 0 ? value : static_cast<float>(state);
      }
      if (TIFFWriteScanline(tiff, row.data(), static_cast<std::uint32_t>(y), band) != 1)
      {
        return false;
      }
    }
  }
  return TIFFWriteDirectory(tiff) == 1;
}

// A page of its own with the colours, which programs show as they are. False when the disk is full.
bool WriteColours(TIFF* tiff, const GeoMap& map)
{
  constexpr int channels = 4;
  const auto width = static_cast<std::size_t>(map.grid.dimensions[0]);
  const auto height = static_cast<std::size_t>(map.grid.dimensions[1]);
  AddTags(tiff); // a page knows none of the one before
  SetPixels(tiff, map.grid, channels, 8, EXTRASAMPLE_UNASSALPHA);
  TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, FILETYPE_PAGE);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
  std::vector<unsigned char> row(channels * width);
  for (std::size_t y = 0; y < height; ++y)
  {
    auto out = row.begin();
    for (std::size_t x = 0; x < width; ++x)
    {
      const auto& colour = map.colours[(height - 1 - y) * width + x];
      out = std::copy(colour.begin(), colour.end(), out);
    }
    if (TIFFWriteScanline(tiff, row.data(), static_cast<std::uint32_t>(y), 0) != 1)
    {
      return false;
    }
  }
  return TIFFFlush(tiff) == 1;
}

// What the values of a map are, and their unit.
std::pair<std::string, std::string> TermsOf(
  const PlanOptions& plan, const PlanView& view, MomentName moment)
{
  std::ostringstream threshold;
  threshold << plan.threshold << " dBZ";
  if (plan.level == PlanLevel::EchoTop)
  {
    return {"Echo top above mean sea level, " + threshold.str(), "m"};
  }
  if (plan.level == PlanLevel::LiquidDensity)
  {
    return {"VIL density: vertically integrated liquid through the height of the echo top, " +
              threshold.str(),
      "g/m^3"};
  }
  if (plan.level == PlanLevel::Liquid)
  {
    return {"Vertically integrated liquid", "kg/m^2"};
  }
  const std::string array = plan.array.empty() ? ToString(moment) : plan.array;
  const bool ofMoment = array == ToString(moment);
  const std::string title = ofMoment ? TitleOf(moment) : array;
  const std::string unit = ofMoment                                     ? UnitOf(moment)
                           : array == AncillaryArrayName(moment, "age") ? "s"
                                                                        : "";
  return {title + ". " + view.where, unit};
}

// The colours of a picture of the map. What has no value is transparent, but for range folding.
std::vector<std::array<unsigned char, 4>> ColoursOf(
  const PlanView& view, const ColourScale& scale, const Theme& theme)
{
  std::vector<std::array<unsigned char, 4>> colours(view.values.size());
  for (std::size_t i = 0; i < colours.size(); ++i)
  {
    std::optional<Colour> colour;
    if (view.states[i] == VoxelState::Echo)
    {
      colour = ColourAt(scale, static_cast<double>(view.values[i]));
    }
    else if (view.states[i] == VoxelState::RangeFolded)
    {
      colour = scale.rangeFolded.value_or(theme.rangeFolded);
    }
    if (colour)
    {
      std::transform(colour->begin(), colour->end(), colours[i].begin(), ToByte);
      colours[i][3] = 255;
    }
  }
  return colours;
}

GeoMap MapOf(vtkImageData* volume, const SceneOptions& options)
{
  const PlanOptions& plan = options.plan.value();
  const PlanSource source = SourceOf(volume);
  const VolumeInformation information = ReadVolumeInformation(volume);
  GeoMap map;
  map.grid = source.voxels.grid;
  map.view = MakePlanView(source, plan, vtkNexradRangeLoop());
  std::tie(map.title, map.unit) = TermsOf(plan, map.view, source.voxels.moment);
  map.time = information.time.value_or(Time());
  map.synthetic = information.synthetic;
  const std::string array = ToString(source.voxels.moment);
  const ColourScale moment = ScaleOf(array, MakeTransferFunction(options, array));
  map.colours = ColoursOf(
    map.view, ScaleFor(map.view, plan, information.sites, moment), ThemeOf(options.theme));
  return map;
}

} // namespace

void WriteGeoTiff(
  const std::filesystem::path& path, vtkImageData* volume, const SceneOptions& options)
{
  const GeoMap map = MapOf(volume, options);
  AtomicFile file(path);
  TIFFSetErrorHandler(nullptr); // what fails is told here, in one line
  const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(
    TIFFOpen(file.TemporaryPath().c_str(), "w"), &TIFFClose);
  if (!tiff)
  {
    throw Error(path.string() + ": cannot be written");
  }
  AddTags(tiff.get());
  SetLayout(tiff.get(), map.grid);
  Describe(tiff.get(), map);
  if (!WriteRows(tiff.get(), map) || !WriteColours(tiff.get(), map))
  {
    throw Error(path.string() + ": cannot be written: the disk may be full");
  }
  file.Commit();
}

} // namespace nexrad::scene
