// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradColorMapSources.h"

#include "Scene/Shapes/Embedded.h"
#include "vtkNexradColorMapJSON.h"
#include "vtkNexradColorMapPalette.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <system_error>

std::string vtkNexradReadColorMap(const std::filesystem::path& path, vtkNexradColorMap& map)
{
  const std::string ending = path.extension().string();
  const auto parse = ending == ".json"  ? vtkNexradColorMapText::ParseJSON
                     : ending == ".pal" ? vtkNexradColorMapText::ParsePalette
                     : ending == ".csv" ? vtkNexradColorMapText::ParseTable
                                        : nullptr;
  if (parse == nullptr)
  {
    return "a colour map to read ends in .json, .pal or .csv";
  }
  std::error_code ignored;
  if (std::filesystem::is_other(path, ignored)) // opening a pipe would wait for a writer
  {
    return "neither a file nor a folder; name a file";
  }
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const std::string problem = stream ? parse(text, map) : "cannot be read";
  if (map.Name.empty())
  {
    map.Name = path.stem().string();
  }
  return problem;
}

namespace
{

using Nodes = std::vector<vtkNexradColorMap::Node>;

// A colour from a value on.
struct PresetStep
{
  double From;    // unit of the moment
  unsigned Color; // 0xRRGGBB
};

// Colours in steps up to the end of the last one, and opacities.
vtkNexradColorMap InSteps(const char* name, const char* array, const std::vector<PresetStep>& steps,
  double end, const Nodes& opacity)
{
  vtkNexradColorMap map;
  map.Name = name;
  map.Array = array;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const unsigned code = steps[i].Color;
    const auto part = [code](unsigned shift) { return (code >> shift & 0xFFU) / 255.0; };
    const vtkNexradColorMap::Color color = {part(16), part(8), part(0)};
    map.Bins.push_back(
      {steps[i].From, i + 1 < steps.size() ? steps[i + 1].From : end, color, color});
  }
  map.MakeColorNodesFromBins();
  map.Channels[3] = opacity;
  return map;
}

// Towards the radar green, away from it red, a light grey within 1 m/s of zero; from 32 m/s on,
// which few radars measure unfolded, blue and yellow. Steps of the same speed have the same
// lightness, and both sides become lighter from 1 m/s on, so that a couplet looks like one. The
// green is bluish, which those who do not tell red from green see. The steps are narrow at small
// speeds, where the wind relative to a storm lies. The fast is opaque.
vtkNexradColorMap RadialVelocity(const char* name, const char* array)
{
  return InSteps(name, array,
    {{-60.0, 0xD9EEFE}, {-50.0, 0x85E5FF}, {-40.0, 0x09DDDB}, {-32.0, 0x22CDA8}, {-25.0, 0x02B86F},
      {-20.0, 0x00A065}, {-15.0, 0x038857}, {-10.0, 0x00754C}, {-6.0, 0x006140}, {-3.0, 0x0A5136},
      {-1.0, 0x8C8C8C}, {1.0, 0x82252C}, {3.0, 0x9C2B33}, {6.0, 0xB9353A}, {10.0, 0xD73F41},
      {15.0, 0xF4534C}, {20.0, 0xFF7766}, {25.0, 0xFF9C83}, {32.0, 0xFFB781}, {40.0, 0xFFCF8C},
      {50.0, 0xFEEC8A}},
    60.0,
    {{-50.0, 0.8}, {-32.0, 0.6}, {-20.0, 0.3}, {-10.0, 0.1}, {-5.0, 0.04}, {-2.0, 0.012},
      {0.0, 0.008}, {2.0, 0.012}, {5.0, 0.04}, {10.0, 0.1}, {20.0, 0.3}, {32.0, 0.6}, {50.0, 0.8}});
}

// Widths of 4 m/s and more mean shear or turbulence.
vtkNexradColorMap SpectrumWidth()
{
  return InSteps("spectrum width", "SW",
    {{0.0, 0x4A4A4A}, {1.0, 0x666666}, {2.0, 0x3F6FB0}, {3.0, 0x3A93D0}, {4.0, 0x2DB08C},
      {5.0, 0x38B83C}, {6.0, 0x9ACB2E}, {8.0, 0xF2E033}, {10.0, 0xF5A623}, {12.0, 0xEC5A24},
      {15.0, 0xD0202A}, {20.0, 0xE65BD8}},
    25.0,
    {{0.0, 0.004}, {1.0, 0.006}, {2.0, 0.02}, {4.0, 0.08}, {6.0, 0.2}, {8.0, 0.4}, {12.0, 0.7},
      {20.0, 0.85}});
}

// Drizzle, hail and dry snow lie about 0 dB (grey), rain above; violet below.
vtkNexradColorMap DifferentialReflectivity()
{
  return InSteps("differential reflectivity", "ZDR",
    {{-4.0, 0x3D2B56}, {-2.0, 0x55407A}, {-1.0, 0x6F6390}, {-0.5, 0x8A86A0}, {0.0, 0xB4B4B4},
      {0.25, 0x8FA8C8}, {0.5, 0x4F8FDC}, {1.0, 0x2BB0C0}, {1.5, 0x20B070}, {2.0, 0x3CC83C},
      {2.5, 0xA5DC32}, {3.0, 0xF5E632}, {4.0, 0xF8B028}, {5.0, 0xF0641E}, {6.0, 0xDC1E28},
      {8.0, 0xFA8CD2}},
    10.0,
    {{-4.0, 0.3}, {-1.0, 0.08}, {0.0, 0.01}, {0.5, 0.012}, {1.0, 0.03}, {2.0, 0.1}, {3.0, 0.25},
      {4.0, 0.45}, {6.0, 0.7}, {8.0, 0.8}});
}

// Once round in twelve colours.
vtkNexradColorMap DifferentialPhase()
{
  return InSteps("differential phase", "PHI",
    {{0.0, 0x5B2D86}, {30.0, 0x3F3FB0}, {60.0, 0x2F74D0}, {90.0, 0x28A8D8}, {120.0, 0x25B89A},
      {150.0, 0x3CB84A}, {180.0, 0x9ACB2E}, {210.0, 0xECE132}, {240.0, 0xF5B028}, {270.0, 0xF0741E},
      {300.0, 0xDC2A28}, {330.0, 0xE66AB4}},
    360.0,
    {{0.0, 0.01}, {60.0, 0.015}, {120.0, 0.05}, {180.0, 0.12}, {270.0, 0.25}, {360.0, 0.35}});
}

// Rain and snow lie above 0.95, in steps of 0.01; what is no weather far below, and is opaque.
vtkNexradColorMap CorrelationCoefficient()
{
  return InSteps("correlation coefficient", "RHO",
    {{0.2, 0x3C3C3C}, {0.45, 0x5A5A6E}, {0.65, 0x39398A}, {0.75, 0x2F5FD0}, {0.8, 0x2F9FE0},
      {0.85, 0x28B8A0}, {0.9, 0x3CB83C}, {0.93, 0x9AD02E}, {0.95, 0xF2E632}, {0.96, 0xF5B428},
      {0.97, 0xF0781E}, {0.98, 0xDC2323}, {0.99, 0xA01428}, {1.0, 0xC878C8}},
    1.06,
    {{0.2, 0.5}, {0.5, 0.4}, {0.7, 0.3}, {0.8, 0.2}, {0.9, 0.1}, {0.95, 0.03}, {0.98, 0.012},
      {1.0, 0.008}, {1.05, 0.008}});
}

vtkNexradColorMap ClutterPower()
{
  return InSteps("clutter power", "CFP",
    {{0.0, 0x5A5A5A}, {2.0, 0x4A6A9A}, {5.0, 0x3A93D0}, {10.0, 0x2DB08C}, {15.0, 0x38B83C},
      {20.0, 0x9ACB2E}, {25.0, 0xF2E033}, {30.0, 0xF5A623}, {40.0, 0xEC5A24}, {50.0, 0xD0202A},
      {60.0, 0xE65BD8}},
    75.0,
    {{0.0, 0.006}, {5.0, 0.02}, {10.0, 0.06}, {20.0, 0.2}, {30.0, 0.4}, {50.0, 0.7}, {60.0, 0.8}});
}

// Anticlockwise shear from yellow through red to white, clockwise shear blue; a light grey below
// 0.002/s. What is below 0.004/s is the shear of the wind and noise, and nearly transparent;
// mesocyclones lie above 0.01/s.
vtkNexradColorMap AzimuthalShear()
{
  return InSteps("azimuthal shear", "AZSHEAR",
    {{-0.03, 0x9FE3FF}, {-0.02, 0x4FB4F0}, {-0.015, 0x2F86D8}, {-0.01, 0x2C5FB4},
      {-0.006, 0x35497F}, {-0.004, 0x4A5268}, {-0.002, 0x8C8C8C}, {0.002, 0x7A6A3C},
      {0.004, 0xA88A28}, {0.006, 0xE0C020}, {0.008, 0xF8A020}, {0.01, 0xF07018}, {0.015, 0xE03020},
      {0.02, 0xC01048}, {0.03, 0xE658C8}, {0.04, 0xFFD8F4}},
    0.05,
    {{-0.03, 0.5}, {-0.01, 0.12}, {-0.006, 0.02}, {-0.004, 0.0}, {0.004, 0.0}, {0.006, 0.03},
      {0.008, 0.12}, {0.01, 0.4}, {0.015, 0.75}, {0.03, 0.9}});
}

// Air that flows apart is warm, air that flows together cold.
vtkNexradColorMap RadialDivergence()
{
  return InSteps("radial divergence", "DIV",
    {{-0.03, 0xB0F0FF}, {-0.02, 0x50C8F0}, {-0.015, 0x2898DC}, {-0.01, 0x2868BC},
      {-0.006, 0x304C8C}, {-0.004, 0x46506E}, {-0.002, 0x8C8C8C}, {0.002, 0x76603C},
      {0.004, 0x986828}, {0.006, 0xC07820}, {0.01, 0xE89828}, {0.015, 0xF8C040}, {0.02, 0xFCE078}},
    0.03,
    {{-0.03, 0.8}, {-0.015, 0.5}, {-0.01, 0.25}, {-0.006, 0.06}, {-0.004, 0.006}, {0.0, 0.003},
      {0.004, 0.006}, {0.006, 0.06}, {0.01, 0.25}, {0.015, 0.5}, {0.03, 0.8}});
}

// Rain has about 0.3 degrees/km at 40 dBZ and 3 at 53 dBZ; drizzle, snow and dry hail have about 0.
vtkNexradColorMap SpecificPhase()
{
  return InSteps("specific differential phase", "KDP",
    {{-2.0, 0x4A4A5A}, {-1.0, 0x646478}, {-0.5, 0x8C8C8C}, {0.25, 0x5A78A8}, {0.5, 0x3A93D0},
      {1.0, 0x2DB08C}, {1.5, 0x38B83C}, {2.0, 0x9ACB2E}, {2.5, 0xF2E033}, {3.0, 0xF5A623},
      {4.0, 0xEC5A24}, {5.0, 0xD0202A}, {7.0, 0xE65BD8}},
    10.0,
    {{-2.0, 0.05}, {-1.0, 0.01}, {-0.5, 0.004}, {0.25, 0.004}, {0.5, 0.02}, {1.0, 0.1}, {2.0, 0.3},
      {3.0, 0.5}, {5.0, 0.8}});
}

// Opacities of 5 km of a scene whose heights are stretched eight times: 40 km of it (5 km of
// height) through rain of 20 dBZ hide four tenths of the map, through 30 dBZ half, and 10 km
// through a core of 50 dBZ look solid. Up to 45 dBZ opacity rises slowly, so that what lies about a
// core does not hide it.
Nodes AllEcho()
{
  return {{5.0, 0.0}, {10.0, 0.04}, {20.0, 0.07}, {30.0, 0.09}, {40.0, 0.13}, {45.0, 0.23},
    {50.0, 0.78}, {60.0, 0.94}, {75.0, 0.99}};
}

vtkNexradColorMap InWeatherServiceColors(const char* name, const Nodes& opacity)
{
  const std::string text(nexrad::embedded::reflectivityColours,
    nexrad::embedded::reflectivityColours + nexrad::embedded::reflectivityColoursSize);
  vtkNexradColorMap map;
  vtkNexradColorMapText::ParseTable(text, map);
  map.Name = name;
  map.Channels[3] = opacity;
  return map;
}

// What clear air returns lies below the weather service's colours: a ramp of greys that turns
// towards their first blue.
vtkNexradColorMap ClearAir()
{
  const vtkNexradColorMap::Color dark = {0.25, 0.25, 0.28};
  const vtkNexradColorMap::Color light = {0.78, 0.80, 0.80};
  const vtkNexradColorMap::Color pale = {0.55, 0.85, 0.90};
  vtkNexradColorMap map =
    InWeatherServiceColors("clear air", {{-25.0, 0.0}, {-20.0, 0.02}, {-10.0, 0.06}, {0.0, 0.12},
                                          {10.0, 0.2}, {20.0, 0.3}, {40.0, 0.5}});
  const double first = map.Bins.front().From;
  map.Bins.insert(map.Bins.begin(), {{-30.0, -5.0, dark, light}, {-5.0, first, light, pale}});
  map.MakeColorNodesFromBins();
  return map;
}

// Surfaces, the inner ones of which show through the outer.
vtkNexradColorMap IsoValues()
{
  constexpr double halfWidth = 2.0; // dBZ
  const std::vector<vtkNexradIsoShell> shells = {{20.0, 0.35}, {35.0, 0.55}, {50.0, 0.95}};
  vtkNexradColorMap map =
    InWeatherServiceColors("iso-values", vtkNexradIsoShells(shells, halfWidth));
  map.IsoValues = {20.0, 35.0, 50.0};
  return map;
}

// Steps of 5 dBZ from 5 dBZ on. Each is lighter than the one before by 4.9 in CIELAB, from a dark
// blue over violet and red to a pale yellow. The lightness was set; hue and chroma were searched
// for the largest difference of neighbours to eyes with all cones, without those for green
// (deuteranopia) and without those for red (protanopia).
vtkNexradColorMap EvenLightness()
{
  return InSteps("colour-blind safe", "REF",
    {{5.0, 0x003E77}, {10.0, 0x004698}, {15.0, 0x3648B9}, {20.0, 0x5952BA}, {25.0, 0x8158B9},
      {30.0, 0xB453AF}, {35.0, 0xD756A0}, {40.0, 0xFB567E}, {45.0, 0xFE736F}, {50.0, 0xFF8D65},
      {55.0, 0xFFA45E}, {60.0, 0xFFBB49}, {65.0, 0xF4D426}, {70.0, 0xEEE858}, {75.0, 0xF5F692}},
    80.0, AllEcho());
}

} // namespace

std::vector<vtkNexradColorMap::Node> vtkNexradIsoShells(
  std::vector<vtkNexradIsoShell> shells, double halfWidth)
{
  std::sort(shells.begin(), shells.end());
  Nodes nodes;
  for (const auto& [value, opacity] : shells)
  {
    if (!nodes.empty() && value - halfWidth <= nodes.back()[0])
    {
      nodes.pop_back();
    }
    else
    {
      nodes.push_back({value - halfWidth, 0.0});
    }
    nodes.push_back({value, opacity});
    nodes.push_back({value + halfWidth, 0.0});
  }
  return nodes;
}

const std::vector<vtkNexradColorMap>& vtkNexradTransferFunctionPresets()
{
  static const std::vector<vtkNexradColorMap> presets = {
    InWeatherServiceColors("all echo", AllEcho()),
    InWeatherServiceColors("storm cores", {{30.0, 0.0}, {35.0, 0.01}, {40.0, 0.05}, {45.0, 0.3},
                                            {50.0, 0.75}, {60.0, 0.95}, {75.0, 0.98}}),
    InWeatherServiceColors(
      "hail", {{45.0, 0.0}, {48.0, 0.01}, {50.0, 0.05}, {55.0, 0.5}, {60.0, 0.9}, {75.0, 0.98}}),
    ClearAir(), IsoValues(), EvenLightness(), RadialVelocity("velocity", "VEL"), SpectrumWidth(),
    DifferentialReflectivity(), DifferentialPhase(), CorrelationCoefficient(), ClutterPower(),
    RadialVelocity("storm-relative velocity", "SRV"), AzimuthalShear(), RadialDivergence(),
    SpecificPhase()};
  return presets;
}
