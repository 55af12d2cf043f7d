// SPDX-License-Identifier: BSD-3-Clause
#include "Options/ThreadOptions.h"

#include "Options/UnitOptions.h"
#include "vtkNexradThreads.h"

namespace nexrad::application
{
namespace
{

constexpr char name[] = "--threads";

} // namespace

void AddThreadsOption(CLI::App& command)
{
  const auto threads =
    NumberValue(1, 1024, "is no number of threads; write a whole number from 1 to 1024");
  AddTextOption(
    command, name,
    [parse = threads.parse](const std::string& text)
    { vtkNexradSetThreadCount(static_cast<unsigned>(parse(text))); },
    threads.unit,
    "Threads that decode files, and as many that merge; at most one for each core (default: as "
    "VTK_SMP_MAX_THREADS says, else one for each core)")
    ->group("Memory and threads");
}

std::vector<std::string> GivenThreads(const CLI::App& command)
{
  return command.count(name) > 0
           ? std::vector<std::string>{name, command.get_option(name)->as<std::string>()}
           : std::vector<std::string>();
}

} // namespace nexrad::application
