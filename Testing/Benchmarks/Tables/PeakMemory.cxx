// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/PeakMemory.h"

#include <fstream>
#include <string>

namespace nexrad::application
{

void RestartPeakMemory()
{
  std::ofstream("/proc/self/clear_refs") << "5"; // proc(5): resets VmHWM
}

std::optional<double> PeakMemory()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    double kibibytes = 0.0;
    if (word == "VmHWM:" && status >> kibibytes)
    {
      return kibibytes * 1024.0;
    }
  }
  return std::nullopt;
}

} // namespace nexrad::application
