// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradTransferFunctionPresets.h"

#include "vtkNexradColorMapPalette.h"
#include "vtkNexradMomentPresets.h"

#include <algorithm>
#include <cstddef>

namespace nexrad::embedded
{
extern const unsigned char reflectivityColours[];
extern const std::size_t reflectivityColoursSize;
} // namespace nexrad::embedded

namespace
{

using Nodes = std::vector<vtkNexradColorMap::Node>;

// Surfaces of the preset "iso-values" and their opacities: the inner ones show through the outer.
const std::vector<vtkNexradIsoShell> isoShells = {{20.0, 0.35}, {35.0, 0.55}, {50.0, 0.95}};
constexpr double shellHalfWidth = 2.0; // dBZ

enum class Colors
{
  WeatherService,
  ClearAir,
  EvenLightness
};

// Opacities of 5 km of a scene whose heights are stretched eight times. Of "all echo": 40 km of it
// (5 km of height) through rain of 20 dBZ hide four tenths of the map, through 30 dBZ half, and
// 10 km through a core of 50 dBZ look solid. Up to 45 dBZ opacity rises slowly, so that what lies
// about a core does not hide it.
struct Preset
{
  const char* Name;
  Nodes Opacity;
  Colors Table;
  std::vector<vtkNexradIsoShell> Shells;
};

Nodes AllEcho()
{
  return {{5.0, 0.0}, {10.0, 0.04}, {20.0, 0.07}, {30.0, 0.09}, {40.0, 0.13}, {45.0, 0.23},
    {50.0, 0.78}, {60.0, 0.94}, {75.0, 0.99}};
}

const std::vector<Preset>& Presets()
{
  static const std::vector<Preset> presets = {{"all echo", AllEcho(), Colors::WeatherService, {}},
    {"storm cores",
      {{30.0, 0.0}, {35.0, 0.01}, {40.0, 0.05}, {45.0, 0.3}, {50.0, 0.75}, {60.0, 0.95},
        {75.0, 0.98}},
      Colors::WeatherService, {}},
    {"hail", {{45.0, 0.0}, {48.0, 0.01}, {50.0, 0.05}, {55.0, 0.5}, {60.0, 0.9}, {75.0, 0.98}},
      Colors::WeatherService, {}},
    {"clear air",
      {{-25.0, 0.0}, {-20.0, 0.02}, {-10.0, 0.06}, {0.0, 0.12}, {10.0, 0.2}, {20.0, 0.3},
        {40.0, 0.5}},
      Colors::ClearAir, {}},
    {"iso-values", vtkNexradIsoShells(isoShells, shellHalfWidth), Colors::WeatherService,
      isoShells},
    {"colour-blind safe", AllEcho(), Colors::EvenLightness, {}}};
  return presets;
}

// What clear air returns lies below the weather service's colours: a ramp of greys that turns
// towards their first blue.
void AddClearAirColors(vtkNexradColorMap& map)
{
  const vtkNexradColorMap::Color dark = {0.25, 0.25, 0.28};
  const vtkNexradColorMap::Color light = {0.78, 0.80, 0.80};
  const vtkNexradColorMap::Color pale = {0.55, 0.85, 0.90};
  const double first = map.Bins.front().From;
  map.Bins.insert(map.Bins.begin(), {{-30.0, -5.0, dark, light}, {-5.0, first, light, pale}});
}

// Steps of 5 dBZ from 5 dBZ on. Each is lighter than the one before by 4.9 in CIELAB, from a dark
// blue over violet and red to a pale yellow. The lightness was set; hue and chroma were searched
// for the largest difference of neighbours to eyes with all cones, without those for green
// (deuteranopia) and without those for red (protanopia).
void LoadEvenColors(vtkNexradColorMap& map)
{
  constexpr unsigned codes[] = {0x003E77, 0x004698, 0x3648B9, 0x5952BA, 0x8158B9, 0xB453AF,
    0xD756A0, 0xFB567E, 0xFE736F, 0xFF8D65, 0xFFA45E, 0xFFBB49, 0xF4D426, 0xEEE858, 0xF5F692};
  constexpr double width = 5.0; // dBZ
  double from = 5.0;
  for (const unsigned code : codes)
  {
    const vtkNexradColorMap::Color color = vtkNexradColorOf(code);
    map.Bins.push_back({from, from + width, color, color});
    from += width;
  }
  map.MakeColorNodesFromBins();
}

void LoadWeatherServiceColors(vtkNexradColorMap& map)
{
  const std::string text(nexrad::embedded::reflectivityColours,
    nexrad::embedded::reflectivityColours + nexrad::embedded::reflectivityColoursSize);
  vtkNexradColorMapText::ParseTable(text, map);
  // A table of colours says nothing of opacity.
  map.Channels[3].clear();
}

void LoadColors(Colors table, vtkNexradColorMap& map)
{
  if (table == Colors::EvenLightness)
  {
    LoadEvenColors(map);
    return;
  }
  LoadWeatherServiceColors(map);
  if (table == Colors::ClearAir)
  {
    AddClearAirColors(map);
    map.MakeColorNodesFromBins();
  }
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

const std::vector<const char*>& vtkNexradTransferFunctionPresetNames()
{
  static const std::vector<const char*> names = []
  {
    std::vector<const char*> list;
    for (const Preset& preset : Presets())
    {
      list.push_back(preset.Name);
    }
    for (const vtkNexradMomentPreset& preset : vtkNexradMomentPresets())
    {
      list.push_back(preset.Name);
    }
    return list;
  }();
  return names;
}

const std::vector<const char*>& vtkNexradTransferFunctionPresetArrays()
{
  static const std::vector<const char*> arrays = []
  {
    std::vector<const char*> list(Presets().size(), "REF");
    for (const vtkNexradMomentPreset& preset : vtkNexradMomentPresets())
    {
      list.push_back(preset.Array);
    }
    return list;
  }();
  return arrays;
}

bool vtkNexradTransferFunctionPreset(const std::string& name, vtkNexradColorMap& map)
{
  for (const Preset& preset : Presets())
  {
    if (name == preset.Name)
    {
      map = vtkNexradColorMap();
      map.Name = name;
      LoadColors(preset.Table, map);
      map.Channels[3] = preset.Opacity;
      for (const vtkNexradIsoShell& shell : preset.Shells)
      {
        map.IsoValues.push_back(shell.first);
      }
      return true;
    }
  }
  for (const vtkNexradMomentPreset& preset : vtkNexradMomentPresets())
  {
    if (name == preset.Name)
    {
      map = vtkNexradMakeColorMap(preset);
      return true;
    }
  }
  return false;
}
