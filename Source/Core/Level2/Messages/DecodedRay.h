// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace nexrad
{

/// What a code of messages 1 and 31 stands for: m/s of the Nyquist velocity, m of a range.
constexpr double NyquistPerCode = 0.01;
constexpr float RangePerCode = 100.0F;

/// Why a message gives no ray: one line without the place.
class MessageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Where a radar stands, as the volume block of message 31 has it.
struct StoredPosition
{
  double latitude = 0.0;  ///< degrees; TDWR may write thousandths of a degree
  double longitude = 0.0; ///< the same, east positive
  int siteHeight = 0;     ///< m above mean sea level
  int feedhornHeight = 0; ///< m above the ground; TDWR repeats the site height here
};

/// A ray with what its message says besides.
struct DecodedRay
{
  Ray ray;                                ///< its words lie in the message
  unsigned azimuthNumber = 0;             ///< number of the ray in its cut, from 1
  int coveragePatternNumber = 0;          ///< VCP; 0 when the message has none
  std::string siteName;                   ///< "" in message 1
  std::optional<StoredPosition> position; ///< message 31
  std::vector<std::string> problems;      ///< what is wrong with moments that were left out
};

/// Checks what every ray must have; throws MessageError when the angles are not finite or outside
/// their ranges (Ray), the cut's number is not 1…32, or the radial status is unknown.
void CheckRay(const Ray& ray);

/// The instant of a ray. Throws MessageError when the day or the time of day cannot be.
Time CheckedTime(std::uint32_t day, std::uint32_t milliseconds);

/// What rays cost of a DecodingBudget beside RayCost, told from a ray and the one decoded before.
class RayCosts
{
public:
  /// The cost of the next ray: that of a sweep where it can begin one; of its gates
  /// that quality control or dealiasing judges; of its damage; and the bytes of its words that
  /// exceed the `newBytes` of its message, because moments share them, or because they belong to
  /// another message too.
  std::size_t Of(const DecodedRay& decoded, std::size_t newBytes);

private:
  bool MayBeginSweep(const Ray& ray);

  unsigned elevationNumber = 0; ///< of the ray before
  double azimuth = 0.0;         ///< degrees, of the ray before
  double turned = 0.0;          ///< degrees to and fro since the last sweep began, at least
};

} // namespace nexrad
