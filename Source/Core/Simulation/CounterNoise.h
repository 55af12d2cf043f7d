// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace nexrad
{

/// A well-mixed 64-bit number of a 64-bit number (the SplitMix64 finaliser, Steele et al. 2014):
/// random numbers by counter, the same in any order and on any thread.
inline std::uint64_t Mix(std::uint64_t value)
{
  value += 0x9e3779b97f4a7c15U;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31);
}

/// Key of a stream of random numbers: of the parent stream and a number within it.
inline std::uint64_t Mix(std::uint64_t key, std::uint64_t number)
{
  return Mix(key ^ Mix(number));
}

/// Key of a name.
inline std::uint64_t KeyOf(const std::string& name)
{
  std::uint64_t key = 0;
  for (const char letter : name)
  {
    key = Mix(key, static_cast<unsigned char>(letter));
  }
  return key;
}

/// Uniform in 0…1 (1 excluded).
inline double Uniform(std::uint64_t key, std::uint64_t number)
{
  return static_cast<double>(Mix(key, number) >> 11) * 0x1p-53;
}

/// Nearly normal, mean 0, standard deviation 1: the scaled sum of four uniform numbers, which never
/// lies beyond ±3.47. A bound on the noise is worth more here than its tails.
inline double Normal(std::uint64_t key, std::uint64_t number)
{
  const std::uint64_t bits = Mix(key, number);
  const auto sum = static_cast<double>(
    (bits & 0xffffU) + (bits >> 16 & 0xffffU) + (bits >> 32 & 0xffffU) + (bits >> 48));
  constexpr double scale = 1.7320508075688772 / 65536.0; // sqrt(3): the sum's variance is 1/3
  return (sum - 2.0 * 65535.0) * scale;
}

} // namespace nexrad
