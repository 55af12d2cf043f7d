// SPDX-License-Identifier: BSD-3-Clause
#include "Options/ThreadOptions.h"

#include "Options/UnitOptions.h"
#include "nexrad/System/Error.h"
#include "vtkNexradThreads.h"

namespace nexrad::application
{
namespace
{

constexpr char name[] = "--threads";

unsigned ParseThreads(const std::string& text)
{
  constexpr double most = 1024.0;
  const std::vector<double> numbers = FindNumbers(text);
  const double count = numbers.size() == 1 ? numbers.front() : 0.0;
  if (!(count >= 1.0 && count <= most) || count != static_cast<unsigned>(count))
  {
    throw Error("'" + text + "' is no number of threads; write a whole number from 1 to 1024");
  }
  return static_cast<unsigned>(count);
}

} // namespace

void AddThreadsOption(CLI::App& command)
{
  AddTextOption(
    command, name, [](const std::string& text) { vtkNexradSetThreadCount(ParseThreads(text)); },
    "NUMBER",
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
