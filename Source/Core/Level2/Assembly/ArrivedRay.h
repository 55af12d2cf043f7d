// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Messages/MessageBodies.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace nexrad
{

/// A ray as it was read, and where its message is.
struct ArrivedRay : DecodedRay
{
  int messageType = 0;      ///< 1 or 31
  std::uint64_t offset = 0; ///< of the message in the stored file
  std::size_t piece = 0;    ///< of the stored files, the one that has the message
};

/// Rays in some order; somebody else owns them. Never nullptr.
using RayList = std::vector<ArrivedRay*>;

/// Takes what is wrong at a ray: one line.
using ArrivedDamage = std::function<void(const ArrivedRay& at, const std::string& what)>;

/// The longest time between two rays that are said to follow each other. No cut takes longer than
/// that, and between two cuts the antenna needs a few seconds.
constexpr Duration LongestStep = std::chrono::seconds(60);

/// True for the first ray of a cut (radial status 0, 3 or 5).
bool StartsCut(const Ray& ray);

/// True when `after` is the very next ray by its numbers: of the same cut with the next azimuth
/// number, or the first of the next cut.
bool IsNext(const ArrivedRay& before, const ArrivedRay& after);

/// True when `after` may follow by its numbers although rays between them are lost: its azimuth
/// number is higher in the same cut, its cut is a later one, or it starts a cut.
bool MayFollow(const ArrivedRay& before, const ArrivedRay& after);

/// True when the rays from `first` to `last` belong between two others by cut and azimuth number,
/// and at least one of the two is of their cut. Either of the two may be nullptr: then the rays
/// must be next to the other one.
bool BelongsBetween(const ArrivedRay* before, const ArrivedRay& first, const ArrivedRay& last,
  const ArrivedRay* after);

/// The order scanned: by time, cut and azimuth number. Some radars have times of whole seconds.
bool IsScannedBefore(const ArrivedRay& a, const ArrivedRay& b);

} // namespace nexrad
