// SPDX-License-Identifier: BSD-3-Clause
// Runs a fuzz target with any compiler, on damaged copies of its seeds: the same copies in every
// run, so that a failure can be found again.
//
//   TARGET COPIES SEED   COPIES damaged copies of each of its inputs
//   TARGET FILE...       these inputs as they are, such as a finding of libFuzzer
#include "FuzzTarget.h"

#include "Faults/AllocationPeak.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

using namespace nexrad::testing;

namespace
{

using Random = std::minstd_rand;

std::size_t Below(Random& random, std::size_t limit)
{
  return limit == 0 ? 0 : random() % limit;
}

void FlipBits(Bytes& bytes, Random& random)
{
  for (std::size_t count = Below(random, 8) + 1; count > 0 && !bytes.empty(); --count)
  {
    bytes[Below(random, bytes.size())] ^= static_cast<std::uint8_t>(1U << Below(random, 8));
  }
}

// Puts a number that texts rarely hold in the place of one that stands there.
void ReplaceNumber(Bytes& bytes, Random& random)
{
  const std::array<const char*, 10> numbers = {"0", "-1", "1e308", "-1e308", "1e-320",
    "9223372036854775807", "4294967296", "0.1", "null", "\"\""};
  const auto isDigit = [](std::uint8_t letter) { return std::isdigit(letter) != 0; };
  const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(Below(random, bytes.size()));
  const auto begin = std::find_if(from, bytes.end(), isDigit);
  const auto end = std::find_if_not(begin, bytes.end(), isDigit);
  const std::string number = numbers[Below(random, numbers.size())];
  const auto place = bytes.erase(begin, end);
  bytes.insert(place, number.begin(), number.end());
}

// One of the ways in which files go wrong in the world: bits, bytes, a lost or doubled piece, a
// cut.
void Damage(Bytes& bytes, Random& random)
{
  const std::size_t place = Below(random, bytes.size());
  const std::size_t length = Below(random, std::min<std::size_t>(bytes.size() - place, 3000));
  const auto start = bytes.begin() + static_cast<std::ptrdiff_t>(place);
  const auto end = start + static_cast<std::ptrdiff_t>(length);
  switch (Below(random, 7))
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
  case 4:
    ReplaceNumber(bytes, random);
    break;
  default:
    FlipBits(bytes, random);
    break;
  }
}

/// Hands inputs to the target, and counts them and what they allocate.
class Runs
{
public:
  void Run(const Bytes& bytes)
  {
    constexpr std::size_t mostBytes = 300'000'000;
    const AllocationPeak peak;
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    Require(peak.Bytes() <= mostBytes, "an input takes at most 300 MB");
    ++count;
  }
  std::size_t Count() const { return count; }

private:
  std::size_t count = 0;
};

void RunCopies(const Bytes& seed, int copies, Random& random, Runs& runs)
{
  for (int copy = 0; copy < copies; ++copy)
  {
    Bytes bytes = seed;
    for (std::size_t count = Below(random, 4) + 1; count > 0; --count)
    {
      Damage(bytes, random);
    }
    runs.Run(bytes);
  }
}

// Every length near the start, where headers are, and some of the rest.
void RunCuts(const Bytes& seed, Runs& runs)
{
  for (std::size_t length = 0; length < seed.size(); length += length < 300 ? 1 : 997)
  {
    runs.Run({seed.begin(), seed.begin() + static_cast<std::ptrdiff_t>(length)});
  }
}

int RunFiles(int count, char** paths)
{
  for (int i = 0; i < count; ++i)
  {
    const std::string content = FileContent(paths[i]);
    std::printf("%s: %zu bytes\n", paths[i], content.size());
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(content.data()), content.size());
  }
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc > 1 && std::isdigit(static_cast<unsigned char>(argv[1][0])) == 0)
  {
    return RunFiles(argc - 1, argv + 1);
  }
  const int copies = argc > 1 ? std::atoi(argv[1]) : 100;
  Random random(argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1U);
  Runs runs;
  for (const Bytes& seed : FuzzSeeds())
  {
    runs.Run(seed);
    RunCuts(seed, runs);
    RunCopies(seed, copies, random, runs);
  }
  std::printf("%zu inputs\n", runs.Count());
  return 0;
}
