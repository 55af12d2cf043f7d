// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace nexrad
{

/// What DeflateBytes looks for in the bytes.
enum class DeflateSearch
{
  Repeats, ///< any that come again; level 6
  Runs     ///< runs of one byte alone: for codes of voxels in half the time, and no larger
};

/// Compresses bytes into one zlib stream (RFC 1950).
std::vector<std::uint8_t> DeflateBytes(
  const std::uint8_t* data, std::size_t size, DeflateSearch search = DeflateSearch::Repeats);

/// Decompresses a zlib stream piece by piece, so that what comes out is checked before more is
/// made: the receiver throws when it has had enough.
class Inflater
{
public:
  using Receiver = std::function<void(const std::uint8_t*, std::size_t)>;

  explicit Inflater(Receiver receiver);
  ~Inflater();

  /// Throws Error when the bytes are no zlib stream or go on after its end.
  void Feed(const std::uint8_t* data, std::size_t size);
  /// Throws Error when the stream has not ended.
  void Finish() const;

private:
  struct Stream;
  std::unique_ptr<Stream> stream;
  Receiver receive;
};

/// CRC-32 (that of zlib and PNG) of bytes, or of more bytes after those that gave `before`.
std::uint32_t Crc32(const std::uint8_t* data, std::size_t size, std::uint32_t before = 0);

} // namespace nexrad
