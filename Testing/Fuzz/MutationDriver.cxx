// SPDX-License-Identifier: BSD-3-Clause
// Runs the fuzz target on damaged copies of small volumes: the same copies in every run, so that a
// failure can be found again. Arguments: how many copies of each volume, and a seed.
#include "Level2Bytes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>

using namespace nexrad::testing;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

std::vector<Bytes> MakeSeeds()
{
  std::vector<Bytes> seeds;
  for (const unsigned type : {1U, 31U})
  {
    const Bytes bare = MakeSmallVolume(type);
    const Bytes rest(bare.begin() + 24, bare.end());
    const auto middle = rest.begin() + (type == 1 ? 12 : 2) * 2432; // whole messages
    const Bytes records = Join({MakeVolumeHeader(), MakeLdmRecord({rest.begin(), middle}),
      MakeLdmRecord({middle, rest.end()}, true)});
    seeds.insert(seeds.end(), {bare, Gzip(bare), Bzip2(bare), Compress(bare), records});
  }
  return seeds;
}

using Random = std::minstd_rand;

std::size_t Below(Random& random, std::size_t limit)
{
  return limit == 0 ? 0 : random() % limit;
}

// One of the ways in which files go wrong in the world: bits, bytes, a lost or doubled piece, a
// cut.
void Damage(Bytes& bytes, Random& random)
{
  const std::size_t place = Below(random, bytes.size());
  const std::size_t length = Below(random, std::min<std::size_t>(bytes.size() - place, 3000));
  const auto start = bytes.begin() + static_cast<std::ptrdiff_t>(place);
  const auto end = start + static_cast<std::ptrdiff_t>(length);
  switch (Below(random, 6))
  {
  case 0:
    bytes.erase(start, end);
    break;
  case 1:
  {
    const Bytes piece(start, end);
    bytes.insert(start, piece.begin(), piece.end());
    break;
  }
  case 2:
    bytes.resize(place);
    break;
  case 3:
    std::fill(start, end, static_cast<std::uint8_t>(random()));
    break;
  default:
    for (std::size_t count = Below(random, 8) + 1; count > 0 && !bytes.empty(); --count)
    {
      bytes[Below(random, bytes.size())] ^= static_cast<std::uint8_t>(1U << Below(random, 8));
    }
    break;
  }
}

void Run(const Bytes& bytes)
{
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

} // namespace

int main(int argc, char** argv)
{
  const int copies = argc > 1 ? std::atoi(argv[1]) : 100;
  Random random(argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1U);
  std::size_t runs = 0;
  for (const Bytes& seed : MakeSeeds())
  {
    // Every length near the start, where the headers are, and some of the rest.
    for (std::size_t length = 0; length < seed.size(); length += length < 300 ? 1 : 997)
    {
      Run({seed.begin(), seed.begin() + static_cast<std::ptrdiff_t>(length)});
      ++runs;
    }
    for (int copy = 0; copy < copies; ++copy)
    {
      Bytes bytes = seed;
      for (std::size_t count = Below(random, 4) + 1; count > 0; --count)
      {
        Damage(bytes, random);
      }
      Run(bytes);
      ++runs;
    }
  }
  std::printf("%zu inputs decoded\n", runs);
  return 0;
}
