// SPDX-License-Identifier: BSD-3-Clause
#include "Scans/SyntheticScans.h"

#include "nexrad/Level2/Encoding/Level2Encoder.h"
#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/Simulation/SimulatedDay.h"

#include <fstream>

namespace nexrad::testing
{

std::vector<std::filesystem::path> WriteSyntheticScans(
  const std::filesystem::path& folder, const std::string& site, Time begin, Duration length)
{
  SimulatedDayOptions day;
  day.begin = begin;
  day.length = length;
  const StormField field(day.seed);
  std::vector<std::filesystem::path> paths;
  for (const SimulatedVolume& volume : PlanSimulatedDay(day))
  {
    if (volume.site.name == site)
    {
      const std::vector<std::uint8_t> bytes =
        EncodeLevel2(ScanVolume(field, volume.site, volume.coveragePattern, volume.start));
      paths.push_back(folder / volume.fileName);
      std::ofstream(paths.back(), std::ios::binary)
        .write(
          reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
  }
  return paths;
}

} // namespace nexrad::testing
