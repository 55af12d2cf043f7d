// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::application
{

/// The compressed bytes of one Level II file, and nothing but their decompression: what a decoder's
/// time is held against. zlib and libbz2 write into memory that is already there, and what comes
/// out is thrown away.
class BareDecompression
{
public:
  /// Reads the file and finds its streams: gzip or bzip2 round the whole file, bzip2 records in it.
  /// Throws Error for a file that cannot be read or is damaged; a stream that is not whole has no
  /// time to compare with.
  explicit BareDecompression(const std::filesystem::path& path);

  /// Decompresses everything once. Records go to `threads` threads; 0: as many as the machine has
  /// cores, which is what ReadLevel2 does. A stream round the file has one thread.
  void Run(unsigned threads = 0);

  /// Gives the memory of the file back, or reads it again. Load throws Error when the file changed.
  void Unload();
  void Load();

  /// True when there is something to decompress.
  bool IsCompressed() const { return wrapper != Wrapper::None || !records.empty(); }
  /// Number of bzip2 records.
  std::size_t RecordCount() const { return records.size(); }
  /// "gzip", "37 records", "gzip, 45 records", "bzip2", "none".
  std::string Describe() const;
  std::size_t StoredBytes() const { return storedBytes; }

private:
  enum class Wrapper
  {
    None,
    Gzip,
    Bzip2
  };
  using Bytes = std::vector<std::uint8_t>;
  struct Record
  {
    std::size_t offset; ///< in the file without its wrapper
    std::size_t length;
  };

  void OpenWrapper();
  void FindRecords();
  void InflateWrapper();
  void RunRecords(unsigned threads) const;

  std::filesystem::path path;
  std::size_t storedBytes = 0;
  Bytes stored;
  Wrapper wrapper = Wrapper::None;
  Bytes unwrapped;                ///< empty without a wrapper
  std::size_t unwrappedBytes = 0; ///< while nothing is loaded
  std::vector<Record> records;
  std::size_t largestRecord = 0; ///< decompressed bytes
};

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
