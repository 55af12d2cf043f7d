// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Level2/FileDecoder.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/RadarVolume.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace nexrad
{

/// Whether all bytes of a file that is being written have arrived.
enum class ChunkExtent
{
  Whole,  ///< the lengths in it say so
  Cut,    ///< the lengths in it say that more follows
  Unknown ///< nothing in it says how long it is
};

/// What the lengths of the compressed records of a chunk say of its stored bytes.
ChunkExtent ExtentOfChunk(ByteView stored);

/// The same of a file of a whole volume. The length of its last record is negative; without one it
/// is Cut or Unknown.
ChunkExtent ExtentOfFile(ByteView stored);

/// What has become of one sweep of a volume that is arriving.
struct SweepArrival
{
  int elevationNumber = 0; ///< number of the cut in the coverage pattern, from 1
  double elevation = 0.0;  ///< degrees, median of its rays
  Time begin{};            ///< first ray
  Time end{};              ///< last ray so far
  std::size_t rays = 0;
  bool complete = false; ///< its last ray came, or a ray of the next sweep
};

/// The sweeps of a volume that is arriving, in the order scanned.
std::vector<SweepArrival> ArrivedSweeps(const RadarVolume& volume);

/// Takes the last sweep out of a volume that is arriving, unless it is complete.
void DropSweepInProgress(RadarVolume& volume);

/// One volume of the real-time feed, whose chunks arrive in any order, late, repeatedly or not at
/// all. Chunks are decoded in the order of their numbers, as far as none is missing; what follows a
/// missing one waits until it comes or SkipMissing says that it will not. What has been decoded is
/// kept, so that each chunk is decoded once while they arrive in order.
///
/// When all that arrives has arrived, Volume returns what ReadLevel2 returns for the folder of the
/// chunks.
class ChunkedVolume
{
public:
  /// A chunk's place in the volume.
  struct Place
  {
    int number = 0;  ///< from 1
    char kind = 'I'; ///< S, I or E

    bool operator<(const Place& other) const
    {
      return number != other.number ? number < other.number : kind < other.kind;
    }
  };

  enum class Arrival
  {
    New,      ///< in the order of the numbers, or after one that is missing
    Late,     ///< one with a higher number was decoded before: the volume is decoded again
    Repeated, ///< the same bytes as before; nothing changes
    Replaced, ///< other bytes than before: the volume is decoded again
    Closed    ///< the volume is closed, and this chunk is none of those it had: begin a new object
  };

  /// `name` is the path of the chunks' folder.
  ChunkedVolume(std::string name, const Level2Options& options);

  /// Takes the stored bytes of a chunk; `file` is its file's name.
  Arrival Add(Place place, const std::string& file, std::vector<std::uint8_t> stored);

  /// Numbers below the highest that came which did not come, ascending.
  std::vector<int> Missing() const;
  /// The chunk that ends the volume came.
  bool HasEnd() const;
  /// Chunks that came.
  std::size_t Count() const { return chunks.size(); }
  /// Chunks that are decoded; the others wait for a missing one.
  std::size_t DecodedCount() const { return decoded; }

  /// The numbers that are missing now are waited for no longer. When they come after all, the
  /// volume is decoded again.
  void SkipMissing();

  /// The volume of all chunks that are decoded.
  RadarVolume Volume() const;

  /// Nothing more is expected: gives up the memory of the chunks. Only Add may be called
  /// afterwards.
  void Close();
  bool IsClosed() const { return closed; }

private:
  struct Chunk
  {
    std::string file;
    std::vector<std::uint8_t> stored; ///< empty once it is closed
    std::size_t size = 0;
    std::uint32_t crc32 = 0;
  };

  void Decode();

  const std::string name;
  const Level2Options options;
  std::map<Place, Chunk> chunks;
  std::set<int> skipped;
  std::unique_ptr<ChunkDecoder> decoder;
  std::optional<Place> last; ///< that was decoded
  std::size_t decoded = 0;
  bool closed = false;
};

} // namespace nexrad
