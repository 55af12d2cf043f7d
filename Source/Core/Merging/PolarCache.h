// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Level2File.h"
#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/Quality/Despeckling.h"
#include "nexrad/Series/SiteSeries.h"

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>

namespace nexrad
{

/// Volumes as gridding needs them, kept up to a limit of memory. What is not in memory is decoded
/// again from its file. Safe to call from several threads.
class PolarCache
{
public:
  /// `limit` in bytes; 0 keeps nothing. Volumes in use by a caller live on beside it.
  PolarCache(MomentName moment, std::size_t limit, Level2Options options = {},
    const QualityOptions& quality = {});

  /// Keeps the volume when there is room for it without dropping another: during a scan the
  /// earliest volumes stay, which are those that a run through the day asks for first.
  void Offer(const SeriesVolume& key, const RadarVolume& volume);

  /// The volume, from memory or from its file; then the volumes longest unused make room for it.
  /// Throws Error when the file cannot be read again.
  std::shared_ptr<const PolarVolume> Get(const SeriesVolume& key);

  /// Bytes in memory now, at most the limit.
  std::size_t Used() const;

  /// The moment of the volumes.
  MomentName Moment() const { return moment; }

  /// How many times Get decoded a file.
  std::size_t DecodedFiles() const;

private:
  using Volume = std::shared_ptr<const PolarVolume>;
  struct Entry
  {
    std::filesystem::path file;
    std::size_t cycle;
    std::size_t bytes;
    Volume volume;
  };

  Volume Find(const SeriesVolume& key);
  void Insert(const SeriesVolume& key, Volume volume, bool makeRoom);

  const MomentName moment;
  const std::size_t limit;
  const Level2Options options;
  const QualityOptions quality;
  mutable std::mutex mutex;
  std::list<Entry> entries; ///< the one used last stands first
  std::size_t decodedFiles = 0;
  std::size_t usedBytes = 0;
};

} // namespace nexrad
