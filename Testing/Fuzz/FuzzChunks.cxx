// SPDX-License-Identifier: BSD-3-Clause
// Feeds chunks of the real-time feed, as they arrive, to what follows a feed, and the folder of the
// same chunks to what reads one: both give the same volume.
//
// An input is a list of pieces: number (16 bits, little-endian), kind, length (16 bits) and bytes
// of each.
#include "FuzzTarget.h"

#include "nexrad/Level2/Level2File.h"
#include "nexrad/Live/ChunkedVolume.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr std::size_t mostPieces = 12;
constexpr std::size_t pieceStart = 5; // bytes before those of the chunk
constexpr unsigned numbers = 1'000;   // that a name of a chunk can have
constexpr char kinds[] = "SIE";

struct Piece
{
  ChunkedVolume::Place place;
  std::string name;
  Bytes bytes;
};

std::string NameOf(const ChunkedVolume::Place& place)
{
  char name[32];
  std::snprintf(name, sizeof name, "20060312-180000-%03d-%c", place.number, place.kind);
  return name;
}

std::vector<Piece> PiecesOf(const std::uint8_t* data, std::size_t size)
{
  std::vector<Piece> pieces;
  while (size >= pieceStart && pieces.size() < mostPieces)
  {
    const auto number = static_cast<int>((data[0] | unsigned(data[1]) << 8) % numbers);
    const char kind = kinds[data[2] % 3];
    const std::size_t stated = data[3] | std::size_t(data[4]) << 8;
    const std::size_t length = std::min(stated, size - pieceStart);
    const ChunkedVolume::Place place = {number, kind};
    const std::uint8_t* const from = data + pieceStart;
    pieces.push_back({place, NameOf(place), Bytes(from, from + length)});
    data += pieceStart + length;
    size -= pieceStart + length;
  }
  return pieces;
}

Level2Options Caps()
{
  Level2Options options;
  if (IsSanitised)
  {
    options.maximumRecordBytes = std::size_t(1) << 20;
    options.maximumFileBytes = std::size_t(2) << 20;
  }
  options.threads = 1;
  return options;
}

bool AreRowsEqual(const MomentRow& a, const MomentRow& b)
{
  return a.gates == b.gates && a.wordBits == b.wordBits && a.firstGate == b.firstGate &&
         a.gateSpacing == b.gateSpacing &&
         (a.gates == 0 || std::memcmp(a.words, b.words, a.gates * (a.wordBits / 8U)) == 0);
}

void RequireSameRays(const Sweep& a, const Sweep& b)
{
  Require(a.elevationNumber == b.elevationNumber && a.rays.size() == b.rays.size(),
    "the live volume has the sweeps of the folder");
  for (std::size_t i = 0; i < a.rays.size(); ++i)
  {
    Require(a.rays[i].time == b.rays[i].time && a.rays[i].azimuth == b.rays[i].azimuth,
      "the live volume has the rays of the folder");
    for (const MomentName moment : AllMoments)
    {
      Require(AreRowsEqual(a.rays[i].Row(moment), b.rays[i].Row(moment)),
        "the live volume has the gates of the folder");
    }
  }
}

void RequireSame(const RadarVolume& a, const RadarVolume& b)
{
  Require(a.sweeps.size() == b.sweeps.size(), "the live volume has as many sweeps as the folder");
  for (std::size_t i = 0; i < a.sweeps.size(); ++i)
  {
    RequireSameRays(a.sweeps[i], b.sweeps[i]);
  }
  const auto isSame = [](const nexrad::Damage& first, const nexrad::Damage& second)
  { return first.offset == second.offset && first.what == second.what; };
  Require(std::equal(a.damage.begin(), a.damage.end(), b.damage.begin(), b.damage.end(), isSame),
    "the live volume has the damage of the folder");
  Require(a.complete == b.complete && a.notes == b.notes && a.site.name == b.site.name,
    "the live volume has the notes of the folder");
}

void LookAtExtent(const Bytes& bytes)
{
  const ByteView all(bytes.data(), bytes.size());
  const ChunkExtent extent = ExtentOfChunk(all);
  ExtentOfFile(all);
  Require(
    extent != ChunkExtent::Whole || ExtentOfChunk(all.Sub(0, all.Size() - 1)) != ChunkExtent::Whole,
    "a whole chunk without its last byte is not whole");
}

void LookAtSoFar(const ChunkedVolume& live)
{
  RadarVolume volume = live.Volume();
  const std::vector<SweepArrival> arrivals = ArrivedSweeps(volume);
  Require(arrivals.size() == volume.sweeps.size(), "each sweep arrives");
  const std::size_t complete = static_cast<std::size_t>(std::count_if(
    arrivals.begin(), arrivals.end(), [](const SweepArrival& each) { return each.complete; }));
  DropSweepInProgress(volume);
  Require(volume.sweeps.size() == complete, "the sweeps that stay are complete");
}

void Feed(ChunkedVolume& live, const std::vector<Piece>& pieces)
{
  std::map<ChunkedVolume::Place, Bytes> known;
  for (const Piece& piece : pieces)
  {
    const auto found = known.find(piece.place);
    const bool repeated = found != known.end() && found->second == piece.bytes;
    const auto arrival = live.Add(piece.place, piece.name, piece.bytes);
    Require((arrival == ChunkedVolume::Arrival::Repeated) == repeated,
      "a chunk is repeated when its bytes were there");
    known[piece.place] = piece.bytes;
    Require(live.Count() == known.size(), "each chunk is counted once");
  }
}

/// The folder of the chunks, which is emptied afterwards.
class ChunksOnDisk
{
public:
  explicit ChunksOnDisk(const std::vector<Piece>& pieces)
  {
    std::map<std::string, const Piece*> last;
    for (const Piece& piece : pieces)
    {
      last[piece.name] = &piece;
    }
    for (const auto& [name, piece] : last)
    {
      paths.push_back(Folder() / name);
      std::FILE* const file = std::fopen(paths.back().c_str(), "wb");
      Require(file != nullptr, "the temporary folder can be written to");
      const std::size_t size = piece->bytes.size(); // no bytes may have no address
      Require(size == 0 || std::fwrite(piece->bytes.data(), 1, size, file) == size,
        "the temporary folder has room");
      std::fclose(file);
    }
  }
  ~ChunksOnDisk()
  {
    for (const auto& path : paths)
    {
      std::filesystem::remove(path);
    }
  }
  ChunksOnDisk(const ChunksOnDisk&) = delete;
  ChunksOnDisk& operator=(const ChunksOnDisk&) = delete;

  static const std::filesystem::path& Folder()
  {
    static const TemporaryFolder folder;
    return folder.Path();
  }

private:
  std::vector<std::filesystem::path> paths;
};

Bytes PieceBytes(unsigned number, unsigned kind, const Bytes& bytes)
{
  const auto low = [](std::size_t value) { return static_cast<std::uint8_t>(value & 255U); };
  const Bytes start = {
    low(number), low(number >> 8), low(kind), low(bytes.size()), low(bytes.size() >> 8)};
  return Join({start, bytes});
}

} // namespace

namespace nexrad::testing
{

std::vector<Bytes> FuzzSeeds()
{
  constexpr unsigned start = 0;
  constexpr unsigned middle = 1;
  constexpr unsigned end = 2;
  constexpr int level = 1; // the smallest blocks: decompressors take little memory
  RayPlan first;
  first.status = 3;
  RayPlan second;
  second.cut = 2;
  second.status = 0;
  const Bytes metadata = Join({MakeVolumeHeader(),
    MakeLdmRecord(Join({MakeMessage2(21, 190), MakeMessage5(21, {0.5, 1.5})}), false, level)});
  const Bytes one = MakeLdmRecord(MakeSweepBytes(31, first, 6, 2), false, level);
  const Bytes two = MakeLdmRecord(MakeSweepBytes(31, second, 6, 4), true, level);
  const Bytes a = PieceBytes(1, start, metadata);
  const Bytes b = PieceBytes(2, middle, one);
  const Bytes c = PieceBytes(3, end, two);
  const Bytes bare = PieceBytes(2, middle, MakeSweepBytes(31, first, 4, 2));
  return {Join({a, b, c}), Join({c, a, b, b}), Join({a, PieceBytes(5, middle, one), c}),
    Join({a, bare, c}), Join({b, PieceBytes(2, middle, two), PieceBytes(999, end, metadata)})};
}

} // namespace nexrad::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::vector<Piece> pieces = PiecesOf(data, size);
  if (pieces.empty())
  {
    return 0;
  }
  for (const Piece& piece : pieces)
  {
    LookAtExtent(piece.bytes);
  }
  ChunkedVolume live(ChunksOnDisk::Folder().string(), Caps());
  Feed(live, pieces);
  LookAtSoFar(live);
  live.SkipMissing();
  Require(live.DecodedCount() == live.Count(), "nothing waits when nothing is waited for");
  const ChunksOnDisk disk(pieces);
  RequireSame(live.Volume(), ReadLevel2(ChunksOnDisk::Folder(), Caps()));
  live.Close();
  Require(live.Add(pieces.back().place, pieces.back().name, pieces.back().bytes) ==
            ChunkedVolume::Arrival::Repeated,
    "a closed volume knows its chunks");
  return 0;
}
