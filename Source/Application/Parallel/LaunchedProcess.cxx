// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel/LaunchedProcess.h"

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <unistd.h>

namespace nexrad::application
{
namespace
{

struct Variables
{
  const char* rank;
  const char* count;
};

// Of Open MPI, and of the launchers that speak PMI (MPICH, Intel MPI).
constexpr Variables launchers[] = {
  {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"}, {"PMI_RANK", "PMI_SIZE"}};

std::optional<int> NumberIn(const char* variable)
{
  const char* text = std::getenv(variable);
  const std::string_view digits = text != nullptr ? text : "";
  int number = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool whole = !digits.empty() && end == digits.data() + digits.size();
  return failure == std::errc() && whole ? std::optional(number) : std::nullopt;
}

// Whether the parent process had a variable when it was started.
bool ParentHas(const std::string& variable)
{
  std::ifstream file("/proc/" + std::to_string(getppid()) + "/environ", std::ios::binary);
  const std::string all{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return ('\0' + all).find('\0' + variable + '=') != std::string::npos;
}

} // namespace

LaunchedProcess FindLaunchedProcess()
{
  for (const Variables& names : launchers)
  {
    const std::optional<int> rank = NumberIn(names.rank);
    const std::optional<int> count = NumberIn(names.count);
    if (rank && count && *rank >= 0 && *rank < *count)
    {
      return {*rank, *count, ParentHas(names.rank)};
    }
  }
  return {};
}

void ForgetLauncher()
{
  for (const Variables& names : launchers)
  {
    unsetenv(names.rank);
    unsetenv(names.count);
  }
}

} // namespace nexrad::application
