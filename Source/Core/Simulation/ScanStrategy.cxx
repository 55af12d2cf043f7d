// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/ScanStrategy.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace nexrad
{

namespace
{

constexpr Waveform surveillance = Waveform::ContiguousSurveillance;
constexpr Waveform doppler = Waveform::ContiguousDoppler;
constexpr Waveform dopplerAlone = Waveform::ContiguousDopplerWithout;
constexpr Waveform batch = Waveform::Batch;
constexpr double surveillanceRange = 466.0; // km

using Strategy = std::vector<ScanCut>;

// A surveillance cut and a Doppler cut at one elevation: the Doppler cut's range is given.
void AddSplit(Strategy& cuts, double elevation, double surveillanceRate, double dopplerRate,
  double unambiguousRange)
{
  cuts.push_back({{elevation, surveillance, true, surveillanceRate}, surveillanceRange});
  cuts.push_back({{elevation, doppler, true, dopplerRate}, unambiguousRange});
}

void Add(Strategy& cuts, double elevation, Waveform waveform, double rate, double unambiguousRange)
{
  cuts.push_back({{elevation, waveform, false, rate}, unambiguousRange});
}

Strategy Pattern11()
{
  Strategy cuts;
  AddSplit(cuts, 0.483, 18.677, 19.226, 148);
  AddSplit(cuts, 1.450, 19.841, 19.226, 148);
  Add(cuts, 2.417, batch, 16.117, 148);
  Add(cuts, 3.384, batch, 17.897, 148);
  Add(cuts, 4.307, batch, 17.897, 148);
  Add(cuts, 5.317, batch, 17.457, 148);
  Add(cuts, 6.196, batch, 17.468, 148);
  Add(cuts, 7.515, dopplerAlone, 25.170, 137);
  Add(cuts, 8.701, dopplerAlone, 25.400, 127);
  Add(cuts, 10.020, dopplerAlone, 25.422, 127);
  Add(cuts, 11.997, dopplerAlone, 25.466, 127);
  Add(cuts, 14.019, dopplerAlone, 25.510, 127);
  Add(cuts, 16.699, dopplerAlone, 25.598, 127);
  Add(cuts, 19.512, dopplerAlone, 25.697, 127);
  return cuts;
}

// Patterns 12 and 212 differ in how fast the Doppler cuts turn.
Strategy Pattern12(double dopplerRate, double splitRange)
{
  Strategy cuts;
  for (const double elevation : {0.483, 0.879, 1.318})
  {
    AddSplit(cuts, elevation, 21.149, dopplerRate, splitRange);
  }
  Add(cuts, 1.802, batch, 24.642, 148);
  Add(cuts, 2.417, batch, 26.400, 148);
  Add(cuts, 3.120, batch, 26.400, 148);
  Add(cuts, 3.999, batch, 26.400, 148);
  Add(cuts, 5.098, batch, 28.004, 148);
  Add(cuts, 6.416, batch, 28.004, 148);
  Add(cuts, 7.998, dopplerAlone, 28.400, 137);
  Add(cuts, 10.020, dopplerAlone, 28.883, 127);
  Add(cuts, 12.480, dopplerAlone, 28.740, 117);
  Add(cuts, 15.601, dopplerAlone, 28.740, 117);
  Add(cuts, 19.512, dopplerAlone, 28.740, 117);
  return cuts;
}

Strategy Pattern21()
{
  Strategy cuts;
  AddSplit(cuts, 0.483, 11.338, 11.360, 148);
  AddSplit(cuts, 1.450, 11.338, 11.360, 148);
  for (const double elevation : {2.417, 3.384, 4.307, 6.021})
  {
    Add(cuts, elevation, batch, 11.184, 148);
  }
  Add(cuts, 9.888, dopplerAlone, 14.260, 127);
  Add(cuts, 14.590, dopplerAlone, 14.326, 127);
  Add(cuts, 19.512, dopplerAlone, 14.414, 127);
  return cuts;
}

Strategy Pattern31()
{
  Strategy cuts;
  for (const double elevation : {0.483, 1.494, 2.505})
  {
    AddSplit(cuts, elevation, 5.043, 5.065, 336);
  }
  Add(cuts, 3.516, dopplerAlone, 5.065, 336);
  Add(cuts, 4.482, dopplerAlone, 5.065, 336);
  return cuts;
}

Strategy Pattern32()
{
  Strategy cuts;
  AddSplit(cuts, 0.483, 4.966, 4.548, 117);
  AddSplit(cuts, 1.494, 4.966, 4.548, 117);
  for (const double elevation : {2.505, 3.516, 4.482})
  {
    Add(cuts, elevation, batch, 4.065, 117);
  }
  return cuts;
}

Strategy Pattern35()
{
  Strategy cuts;
  AddSplit(cuts, 0.483, 4.966, 14.458, 162);
  AddSplit(cuts, 0.879, 4.966, 14.458, 162);
  AddSplit(cuts, 1.318, 5.471, 14.458, 162);
  Add(cuts, 1.802, batch, 15.491, 162);
  Add(cuts, 2.417, batch, 17.754, 162);
  Add(cuts, 3.120, batch, 16.930, 162);
  Add(cuts, 3.999, batch, 18.073, 162);
  Add(cuts, 5.098, batch, 18.073, 162);
  Add(cuts, 6.416, batch, 18.073, 162);
  return cuts;
}

// Velocity is measured with three pulse rates at each of the low elevations.
Strategy Pattern121()
{
  Strategy cuts;
  for (const double elevation : {0.483, 1.450})
  {
    AddSplit(cuts, elevation, elevation < 1.0 ? 18.677 : 19.841, 19.753, 117);
    cuts.push_back({{elevation, doppler, true, 27.400}, 137});
    cuts.push_back({{elevation, doppler, true, 21.401}, 175});
  }
  for (const double elevation : {2.417, 3.384})
  {
    Add(cuts, elevation, batch, elevation < 3.0 ? 19.204 : 21.599, 117);
    Add(cuts, elevation, dopplerAlone, 27.400, 137);
    Add(cuts, elevation, dopplerAlone, 21.401, 175);
  }
  Add(cuts, 4.307, batch, 16.304, 175);
  Add(cuts, 4.307, dopplerAlone, 29.498, 127);
  Add(cuts, 6.021, batch, 20.204, 148);
  Add(cuts, 9.888, dopplerAlone, 29.498, 127);
  Add(cuts, 14.590, dopplerAlone, 29.795, 127);
  Add(cuts, 19.512, dopplerAlone, 29.795, 127);
  return cuts;
}

Strategy Pattern215()
{
  Strategy cuts;
  AddSplit(cuts, 0.483, 11.470, 15.831, 137);
  AddSplit(cuts, 0.879, 13.370, 15.831, 137);
  AddSplit(cuts, 1.318, 15.919, 15.831, 137);
  Add(cuts, 1.802, batch, 16.776, 148);
  Add(cuts, 2.417, batch, 20.654, 148);
  Add(cuts, 3.120, batch, 19.534, 148);
  Add(cuts, 3.999, batch, 20.237, 148);
  Add(cuts, 5.098, batch, 20.237, 148);
  Add(cuts, 6.416, batch, 20.237, 148);
  Add(cuts, 7.998, dopplerAlone, 24.862, 137);
  Add(cuts, 10.020, dopplerAlone, 25.642, 127);
  for (const double elevation : {11.997, 14.019, 16.699, 19.512})
  {
    Add(cuts, elevation, dopplerAlone, 25.642, 117);
  }
  return cuts;
}

const std::map<int, Strategy>& Strategies()
{
  static const std::map<int, Strategy> strategies = {{11, Pattern11()},
    {12, Pattern12(24.994, 148)}, {21, Pattern21()}, {31, Pattern31()}, {32, Pattern32()},
    {35, Pattern35()}, {121, Pattern121()}, {212, Pattern12(16.897, 137)}, {215, Pattern215()}};
  return strategies;
}

// Message 1: gates of cuts below an elevation, as real files have them.
struct LegacyLimit
{
  double elevation; // degrees
  int gates;        // of 1 km, reflectivity
  int dopplerGates; // of 250 m, velocity
};

LegacyLimit FindLegacyLimit(double elevation)
{
  constexpr LegacyLimit limits[] = {{1.4, 460, 920}, {2.0, 356, 920}, {2.8, 336, 920},
    {4.15, 268, 920}, {5.6, 216, 860}, {7.0, 176, 700}, {8.2, 137, 548}, {9.2, 127, 508},
    {11.0, 110, 440}, {13.0, 100, 400}, {14.3, 90, 360}, {15.0, 85, 340}, {18.0, 80, 320}};
  for (const LegacyLimit& limit : limits)
  {
    if (elevation < limit.elevation)
    {
      return limit;
    }
  }
  return {90.0, 70, 280};
}

// Message 31: gates of 250 m up to where the beam leaves 21 km above the antenna.
int FineGates(double elevation)
{
  constexpr double height = 21'000.0;
  constexpr double radius = 6'371'000.0 * 4.0 / 3.0;
  const double rise = radius * std::sin(elevation * RadiansPerDegree);
  const double range = std::sqrt(rise * rise + height * (2.0 * radius + height)) - rise;
  return std::min(1832, static_cast<int>((range - 2'125.0) / 250.0) + 1);
}

CutLayout LayOutFine(const ScanCut& cut)
{
  constexpr int firstGate = 2'125;
  constexpr int spacing = 250;
  constexpr int mostDopplerGates = 1'192;
  const int gates = FineGates(cut.cut.elevation);
  CutLayout layout;
  layout.echo = {gates, firstGate, spacing};
  layout.reflectivity = layout.echo;
  layout.rays = cut.cut.superResolution ? 720 : 360;
  layout.raySpacing = cut.cut.superResolution ? 0.5 : 1.0;
  if (cut.cut.waveform != surveillance)
  {
    layout.doppler = {std::min(gates, mostDopplerGates), firstGate, spacing};
  }
  if (cut.cut.waveform == dopplerAlone)
  {
    // What comes back from beyond is not told from what is near: real files end there.
    const int within = static_cast<int>((cut.unambiguousRange * 1000.0 - firstGate) / spacing) + 1;
    layout.doppler.gates = std::min(layout.doppler.gates, within);
  }
  if (cut.cut.waveform == doppler || cut.cut.waveform == dopplerAlone)
  {
    layout.reflectivity = layout.doppler;
  }
  return layout;
}

CutLayout LayOutLegacy(const ScanCut& cut)
{
  const Waveform waveform = cut.cut.waveform;
  LegacyLimit limit = FindLegacyLimit(cut.cut.elevation);
  CutLayout layout;
  layout.echo = {limit.gates, 0, 1'000};
  if (waveform == dopplerAlone)
  {
    const auto range = static_cast<int>(cut.unambiguousRange);
    limit.gates = std::min(limit.gates, range);
    limit.dopplerGates = std::min(limit.dopplerGates, 4 * range);
  }
  if (waveform != doppler)
  {
    layout.reflectivity = {limit.gates, 0, 1'000};
  }
  if (waveform != surveillance)
  {
    layout.doppler = {limit.dopplerGates, -375, 250};
  }
  // Slow cuts overlap their beginning by some rays, fast and steep ones by fewer.
  layout.rays = 367 - static_cast<int>(cut.cut.elevation / 4.0);
  layout.raySpacing = 0.987;
  return layout;
}

} // namespace

const std::vector<ScanCut>* FindScanStrategy(int pattern)
{
  const auto found = Strategies().find(pattern);
  return found == Strategies().end() ? nullptr : &found->second;
}

CutLayout LayOut(const ScanCut& cut, bool superResolution)
{
  return superResolution ? LayOutFine(cut) : LayOutLegacy(cut);
}

double NyquistVelocity(double unambiguousRange)
{
  constexpr double lightSpeed = 299'792.458; // km/s
  constexpr double wavelength = 0.104;       // m
  return wavelength / 4.0 * lightSpeed / (2.0 * unambiguousRange);
}

double FoldVelocity(double velocity, double nyquist)
{
  return velocity - 2.0 * nyquist * std::floor(velocity / (2.0 * nyquist) + 0.5);
}

std::vector<int> KnownCoveragePatterns()
{
  std::vector<int> numbers;
  for (const auto& entry : Strategies())
  {
    numbers.push_back(entry.first);
  }
  return numbers;
}

} // namespace nexrad
