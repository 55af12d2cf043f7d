// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Tables/BareDecompression.h"

#include <filesystem>
#include <vector>

namespace nexrad::application
{

/// The bare decompression of many files: each from the disk (or what the system keeps of it) on one
/// thread, as many files at a time as there are threads, so that no thread waits for another and
/// the memory is that of few files.
class BareSeries
{
public:
  /// Looks the files through once. Throws Error, naming the file, when one of them cannot be
  /// compared with.
  BareSeries(const std::vector<std::filesystem::path>& files, unsigned threads);

  void Run();

  double StoredBytes() const;

private:
  std::vector<BareDecompression> streams;
  unsigned threads;
};

} // namespace nexrad::application
