// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel/LaunchedProcess.h"

#include <cstdlib>

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

} // namespace

LaunchedProcess FindLaunchedProcess()
{
  for (const Variables& names : launchers)
  {
    const char* rank = std::getenv(names.rank);
    const char* count = std::getenv(names.count);
    if (rank != nullptr && count != nullptr)
    {
      return {std::atoi(rank), std::atoi(count)};
    }
  }
  return {};
}

} // namespace nexrad::application
