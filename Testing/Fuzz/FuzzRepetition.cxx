// SPDX-License-Identifier: BSD-3-Clause
// Repeats a part of the input until it fills a file that compresses to next to nothing, and decodes
// the file as `nexrad3d info` does: what costs memory or time a thousand times is found so. The
// first byte of the input chooses the container, the second how much is repeated.
#include "FuzzTarget.h"

#include "Faults/HostileFiles.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Quality/EchoClassification.h"

#include <algorithm>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr std::size_t filledBytes = std::size_t(48) << 20;
constexpr std::size_t pieceBytes = std::size_t(1) << 18;
constexpr std::size_t headBytes = 2;

// Containers of the content and of the bytes before it.
Bytes Wrap(unsigned container, const Bytes& start, const Bytes& repeated)
{
  const Bytes piece = Repeat(repeated, std::max<std::size_t>(1, pieceBytes / repeated.size()));
  const std::size_t count = filledBytes / piece.size();
  switch (container % 4)
  {
  case 0:
    return Join({Gzip(start), GzipOfRepeated(piece, count)});
  case 1:
    return Gzip(Join({Gzip(start), GzipOfRepeated(piece, count)}));
  case 2:
  {
    // A record cannot be repeated within: as many records as bytes of the file are wanted. They are
    // compressed together, because what a file may cost grows with its stored bytes.
    const Bytes record = MakeLdmRecord(piece);
    return Gzip(Join({start, Repeat(record, filledBytes / 4 / record.size())}));
  }
  default:
    return Join({start, Repeat(MakeLdmRecord(piece), 60)});
  }
}

} // namespace

namespace nexrad::testing
{

std::vector<Bytes> FuzzSeeds()
{
  std::vector<Bytes> seeds;
  for (std::uint8_t container = 0; container < 4; ++container)
  {
    RayPlan narrow;
    RayPlan wide;
    wide.status = 3;
    wide.moments[0].gates = 2'000;
    wide.moments[0].words = Bytes(2'000, 130);
    for (const Bytes& repeated : {MakeVolumeHeader(), MakeMessage31(narrow), MakeMessage31(wide),
           MakeMessage1(narrow), MakeFrame(31, {}), MakeMessage5(21, {0.5, 1.5}),
           MakeSweepBytes(31, narrow, 12, 4), MakeLdmRecord({0}), Gzip({}), Bzip2({})})
    {
      seeds.push_back(Join({{container, 255}, repeated}));
    }
  }
  return seeds;
}

} // namespace nexrad::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size <= headBytes)
  {
    return 0;
  }
  // The bytes in front stand once, before the volume's header or in its place.
  const std::size_t once = (size - headBytes) * (255U - data[1]) / 256;
  const Bytes start =
    once == 0 ? MakeVolumeHeader() : Bytes(data + headBytes, data + headBytes + once);
  const Bytes repeated(data + headBytes + once, data + size);
  Level2Options options;
  options.threads = 1;
  const RadarVolume volume = DecodeLevel2(Wrap(data[0], start, repeated), "KTLX", options);
  ClassifyEcho(volume);
  SplitCycles(volume);
  return 0;
}
