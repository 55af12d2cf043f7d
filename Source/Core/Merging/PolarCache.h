// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/Series/Catalogue.h"

#include <cstddef>
#include <filesystem>
#include <list>
#include <memory>
#include <mutex>

namespace nexrad
{

/// Moments of volumes that were decoded, kept up to a limit of memory for the times that may ask
/// for them again. Safe to call from several threads.
class PolarCache
{
public:
  using Volume = std::shared_ptr<const PolarVolume>;

  /// `limit` in bytes; 0 keeps nothing. Volumes in use by a caller live on beside it.
  explicit PolarCache(std::size_t limit);

  /// Keeps a volume when there is room for it without dropping another: during a scan the earliest
  /// volumes stay, which are those that a run through the day asks for first. False when there is
  /// none.
  bool Offer(const SeriesVolume& key, const Volume& volume);

  /// Keeps a volume; those that were not asked for longest make room for it.
  void Keep(const SeriesVolume& key, const Volume& volume);

  /// A moment of the volume, or nullptr when it is not kept.
  Volume Find(const SeriesVolume& key, MomentName moment);

  /// Bytes that the volumes take, at most the limit.
  std::size_t Used() const;

private:
  struct Entry
  {
    std::filesystem::path file;
    std::size_t cycle;
    Volume volume;
    std::size_t bytes;
  };

  std::list<Entry>::iterator Place(const SeriesVolume& key, MomentName moment);

  const std::size_t limit;
  mutable std::mutex mutex;
  std::list<Entry> entries; ///< the one asked for last stands first
  std::size_t used = 0;
};

} // namespace nexrad
