// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Compression/Container.h"
#include "nexrad/Compression/DamageList.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace nexrad
{

/// One bzip2 stream behind its length, as the Local Data Manager sends Level II.
struct LdmRecord
{
  std::size_t offset = 0; ///< of the length, in the bytes that were searched
  ByteView compressed;    ///< the stream without the length
};

/// True when a length and the beginning of a bzip2 stream stand at the offset.
bool IsLdmRecord(ByteView bytes, std::size_t offset);

/// Offset of the first record from `from` on; the size of the bytes when there is none.
std::size_t FindLdmRecord(ByteView bytes, std::size_t from);

/// The records from `start` on. The length of a record is the magnitude of a signed number (the
/// last record's is negative). Where a length cannot be right, or bytes are no record, the search
/// goes on at the next bzip2 stream, and `report` takes the damage with its offset in `bytes`. At
/// most MostLdmRecords; what is behind them is damage.
std::vector<LdmRecord> FindLdmRecords(
  ByteView bytes, std::size_t start, const DamageReceiver& report);

/// A thousand times as many as volumes have. Without a limit a small compressed file of empty
/// records takes minutes.
constexpr std::size_t MostLdmRecords = 100'000;

/// Takes what a record holds.
using RecordReceiver = std::function<void(std::size_t index, Unpacked&& content)>;

/// Decompresses records that do not depend on each other, on `threads` threads, this one among them
/// (0: as many as the machine has cores), and hands them to `receive` on this thread, in their
/// order, each as soon as it and those before it are there. At most sixteen records are in memory
/// before they are received. A record gives at most `maximumRecordBytes`, and no more than 4 MiB
/// and a hundred times its stored bytes. What `receive` throws, or a decompressor for want of
/// memory, ends the work and is thrown here.
void BunzipInParallel(const std::vector<LdmRecord>& records, std::size_t maximumRecordBytes,
  const RecordReceiver& receive, unsigned threads = 0);

} // namespace nexrad
