// SPDX-License-Identifier: BSD-3-Clause
#include "Scans/TwoRadars.h"

#include "HandMadeVolume.h"

namespace nexrad::testing
{

namespace
{

HandMadeVolume RadarWith(const Site& site, double reflectivity)
{
  HandMadeVolume volume;
  volume.site = site;
  volume.start = *ParseIso8601("2006-03-12T18:00:00Z");
  for (const float elevation : {0.5F, 1.5F})
  {
    HandMadeSweep sweep;
    sweep.elevation = elevation;
    // Rays of one value would be a fault of the receiver.
    const std::uint8_t near = ReflectivityWord(reflectivity);
    const std::uint8_t far = ReflectivityWord(reflectivity - 1.0);
    sweep.moments = {{MomentName::REF, 150, 1000, 1000,
      [near, far](int, int gate) { return gate < 60 ? near : far; }}};
    volume.sweeps.push_back(sweep);
  }
  return volume;
}

} // namespace

std::vector<std::filesystem::path> WriteTwoRadars(
  const std::filesystem::path& folder, double one, double two)
{
  const Site first = {"KONE", Position{38.8, -94.0, 300.0}};
  const Site second = {"KTWO", Position{38.8, -91.93, 300.0}};
  return {WriteLevel2(folder / "KONE20060312_180000_V06", {RadarWith(first, one)}),
    WriteLevel2(folder / "KTWO20060312_180000_V06", {RadarWith(second, two)})};
}

} // namespace nexrad::testing
