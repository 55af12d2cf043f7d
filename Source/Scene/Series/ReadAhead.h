// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Series/VolumeSeries.h"

#include <functional>
#include <memory>

namespace nexrad::scene
{

struct ReadAheadOptions
{
  /// Indices of the volumes in the order in which they are expected to be asked for, the first
  /// after the last.
  std::vector<std::size_t> order;
  /// Bytes that the volumes loaded ahead may take together; but one is always held.
  std::size_t memory = std::size_t(256) << 20;
  /// Done with each volume on the thread that loaded it, and with the one before it in the order,
  /// if that was loaded before it (else nullptr); never by two threads at once. May be empty.
  std::function<void(vtkImageData* volume, vtkImageData* before)> prepare;
  /// Called on the other thread each time it has loaded all that there is room for, before it
  /// waits. It must not use the series. May be empty.
  std::function<void()> full;
};

/// The same series, of which the volumes that follow the one asked for last are loaded ahead on
/// another thread, so that a series that plays on waits for nothing. Whoever asks for one of those
/// gets it, and waits for it when it is being loaded; any other one is loaded at once, in place of
/// those. A failure is told when its volume is asked for. A series that cannot be loaded ahead, or
/// has nothing to be loaded ahead, comes back as it is.
std::unique_ptr<VolumeSeries> ReadAhead(
  std::unique_ptr<VolumeSeries> series, ReadAheadOptions options);

} // namespace nexrad::scene
