// SPDX-License-Identifier: BSD-3-Clause
#include "Bench/Machine.h"

#include <algorithm>
#include <fstream>
#include <thread>

namespace nexrad::application
{
namespace
{

// Linux tells it in a list of "key : value", once a core.
std::string FindProcessorName()
{
  std::ifstream list("/proc/cpuinfo");
  for (std::string line; std::getline(list, line);)
  {
    const std::size_t colon = line.find(": ");
    if (line.compare(0, 10, "model name") == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

} // namespace

Machine DescribeMachine()
{
  Machine machine;
  machine.processor = FindProcessorName();
  machine.cores = std::max(1U, std::thread::hardware_concurrency());
  machine.build = "nexrad3d " NEXRAD_VERSION ", " NEXRAD_BUILD_TYPE ", " NEXRAD_COMPILER;
  return machine;
}

} // namespace nexrad::application
