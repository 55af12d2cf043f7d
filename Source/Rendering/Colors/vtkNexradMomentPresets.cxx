// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradMomentPresets.h"

namespace
{

using Preset = vtkNexradMomentPreset;

vtkNexradColorMap::Color ColorOf(unsigned code)
{
  const auto part = [code](unsigned shift) { return (code >> shift & 0xFFU) / 255.0; };
  return {part(16), part(8), part(0)};
}

// Towards the radar green, away from it red, grey about zero; brighter where faster, and beyond
// 32 m/s, which few radars can tell, in colours of their own. The fast is opaque.
Preset Velocity()
{
  return {"velocity", "VEL",
    {{-50.0, 0x3F9CF0}, {-40.0, 0x5FD4F0}, {-32.0, 0x8FF5D0}, {-26.0, 0x66F55C}, {-20.0, 0x27DD35},
      {-15.0, 0x17B52C}, {-10.0, 0x138F24}, {-5.0, 0x126B1E}, {-1.0, 0x8C8C8C}, {1.0, 0x7A1216},
      {5.0, 0xA0171B}, {10.0, 0xC81D20}, {15.0, 0xEE2B2B}, {20.0, 0xFF5A4A}, {26.0, 0xFF8A78},
      {32.0, 0xFFA860}, {40.0, 0xFFC860}, {50.0, 0xFFF09A}},
    60.0,
    {{-50.0, 0.8}, {-32.0, 0.6}, {-20.0, 0.3}, {-10.0, 0.1}, {-5.0, 0.04}, {-2.0, 0.012},
      {0.0, 0.008}, {2.0, 0.012}, {5.0, 0.04}, {10.0, 0.1}, {20.0, 0.3}, {32.0, 0.6}, {50.0, 0.8}}};
}

// Widths of 4 m/s and more mean shear or turbulence.
Preset SpectrumWidth()
{
  return {"spectrum width", "SW",
    {{0.0, 0x5A5A5A}, {1.0, 0x7D7D7D}, {2.0, 0x3F6FB0}, {3.0, 0x3A93D0}, {4.0, 0x2DB08C},
      {5.0, 0x38B83C}, {6.0, 0x9ACB2E}, {8.0, 0xF2E033}, {10.0, 0xF5A623}, {12.0, 0xEC5A24},
      {15.0, 0xD0202A}, {20.0, 0xE65BD8}},
    25.0,
    {{0.0, 0.004}, {1.0, 0.006}, {2.0, 0.02}, {4.0, 0.08}, {6.0, 0.2}, {8.0, 0.4}, {12.0, 0.7},
      {20.0, 0.85}}};
}

// Drizzle, hail and dry snow lie about 0 dB (grey), rain above; violet below.
Preset DifferentialReflectivity()
{
  return {"differential reflectivity", "ZDR",
    {{-4.0, 0x3D2B56}, {-2.0, 0x55407A}, {-1.0, 0x6F6390}, {-0.5, 0x8A86A0}, {0.0, 0xB4B4B4},
      {0.25, 0x8FA8C8}, {0.5, 0x4F8FDC}, {1.0, 0x2BB0C0}, {1.5, 0x20B070}, {2.0, 0x3CC83C},
      {2.5, 0xA5DC32}, {3.0, 0xF5E632}, {4.0, 0xF8B028}, {5.0, 0xF0641E}, {6.0, 0xDC1E28},
      {8.0, 0xFA8CD2}},
    10.0,
    {{-4.0, 0.3}, {-1.0, 0.08}, {0.0, 0.01}, {0.5, 0.012}, {1.0, 0.03}, {2.0, 0.1}, {3.0, 0.25},
      {4.0, 0.45}, {6.0, 0.7}, {8.0, 0.8}}};
}

// Once round in twelve colours.
Preset DifferentialPhase()
{
  return {"differential phase", "PHI",
    {{0.0, 0x5B2D86}, {30.0, 0x3F3FB0}, {60.0, 0x2F74D0}, {90.0, 0x28A8D8}, {120.0, 0x25B89A},
      {150.0, 0x3CB84A}, {180.0, 0x9ACB2E}, {210.0, 0xECE132}, {240.0, 0xF5B028}, {270.0, 0xF0741E},
      {300.0, 0xDC2A28}, {330.0, 0xE66AB4}},
    360.0,
    {{0.0, 0.01}, {60.0, 0.015}, {120.0, 0.05}, {180.0, 0.12}, {270.0, 0.25}, {360.0, 0.35}}};
}

// Rain and snow lie above 0.95, in steps of 0.01; what is no weather far below, and is opaque.
Preset CorrelationCoefficient()
{
  return {"correlation coefficient", "RHO",
    {{0.2, 0x3C3C3C}, {0.45, 0x5A5A6E}, {0.65, 0x39398A}, {0.75, 0x2F5FD0}, {0.8, 0x2F9FE0},
      {0.85, 0x28B8A0}, {0.9, 0x3CB83C}, {0.93, 0x9AD02E}, {0.95, 0xF2E632}, {0.96, 0xF5B428},
      {0.97, 0xF0781E}, {0.98, 0xDC2323}, {0.99, 0xA01428}, {1.0, 0xC878C8}},
    1.06,
    {{0.2, 0.5}, {0.5, 0.4}, {0.7, 0.3}, {0.8, 0.2}, {0.9, 0.1}, {0.95, 0.03}, {0.98, 0.012},
      {1.0, 0.008}, {1.05, 0.008}}};
}

Preset ClutterPower()
{
  return {"clutter power", "CFP",
    {{0.0, 0x5A5A5A}, {2.0, 0x4A6A9A}, {5.0, 0x3A93D0}, {10.0, 0x2DB08C}, {15.0, 0x38B83C},
      {20.0, 0x9ACB2E}, {25.0, 0xF2E033}, {30.0, 0xF5A623}, {40.0, 0xEC5A24}, {50.0, 0xD0202A},
      {60.0, 0xE65BD8}},
    75.0,
    {{0.0, 0.006}, {5.0, 0.02}, {10.0, 0.06}, {20.0, 0.2}, {30.0, 0.4}, {50.0, 0.7}, {60.0, 0.8}}};
}

} // namespace

const std::vector<vtkNexradMomentPreset>& vtkNexradMomentPresets()
{
  static const std::vector<Preset> presets = {Velocity(), SpectrumWidth(),
    DifferentialReflectivity(), DifferentialPhase(), CorrelationCoefficient(), ClutterPower()};
  return presets;
}

vtkNexradColorMap vtkNexradMakeColorMap(const vtkNexradMomentPreset& preset)
{
  vtkNexradColorMap map;
  map.Name = preset.Name;
  map.Array = preset.Array;
  for (std::size_t i = 0; i < preset.Steps.size(); ++i)
  {
    const double end = i + 1 < preset.Steps.size() ? preset.Steps[i + 1].From : preset.End;
    const vtkNexradColorMap::Color color = ColorOf(preset.Steps[i].Color);
    map.Bins.push_back({preset.Steps[i].From, end, color, color});
  }
  map.MakeColorNodesFromBins();
  map.Channels[3] = preset.Opacity;
  return map;
}
