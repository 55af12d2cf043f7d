// SPDX-License-Identifier: BSD-3-Clause
// Part of a libFuzzer target: TARGET --seeds=FOLDER writes the inputs to begin with.
#include "FuzzTarget.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace nexrad::testing;

namespace
{

void WriteSeeds(const std::filesystem::path& folder)
{
  std::filesystem::create_directories(folder);
  std::size_t number = 0;
  for (const Bytes& seed : FuzzSeeds())
  {
    const std::filesystem::path path = folder / ("seed-" + std::to_string(number++));
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    Require(file != nullptr, "the folder of seeds can be written to");
    Require(std::fwrite(seed.data(), 1, seed.size(), file) == seed.size(), "it has room");
    std::fclose(file);
  }
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments)
{
  constexpr char option[] = "--seeds=";
  for (int i = 1; i < *count; ++i)
  {
    const char* const argument = (*arguments)[i];
    if (std::strncmp(argument, option, sizeof option - 1) == 0)
    {
      WriteSeeds(argument + sizeof option - 1);
      std::exit(0);
    }
  }
  return 0;
}
