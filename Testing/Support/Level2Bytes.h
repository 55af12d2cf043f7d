// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Compression/DamageList.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Level II files made byte by byte, for tests of the decoder. They are written from the tables of
/// the format, apart from the encoder of the simulation, so that the two do not share a mistake.
namespace nexrad::testing
{

using Bytes = std::vector<std::uint8_t>;

inline ByteView View(const Bytes& bytes)
{
  return {bytes.data(), bytes.size()};
}

/// A receiver that keeps all in a list, which must outlive it.
inline DamageReceiver KeepIn(std::vector<Damage>& list)
{
  return [&list](std::size_t offset, const std::string& what) { list.push_back({offset, what}); };
}

Bytes Join(const std::vector<Bytes>& parts);

/// Big-endian numbers at places of a block that grows as needed.
class BlockWriter
{
public:
  explicit BlockWriter(std::size_t size)
    : bytes(size)
  {
  }
  BlockWriter& U8(std::size_t place, unsigned value);
  BlockWriter& U16(std::size_t place, unsigned value);
  BlockWriter& U32(std::size_t place, std::uint32_t value);
  BlockWriter& F32(std::size_t place, float value);
  BlockWriter& Text(std::size_t place, const std::string& text);
  BlockWriter& Put(std::size_t place, const Bytes& content);
  Bytes Take() { return std::move(bytes); }

private:
  void Reach(std::size_t end);
  Bytes bytes;
};

/// One moment of a message 31 ray.
struct MomentPlan
{
  std::string name = "REF";
  Bytes words = {0, 1, 2, 66, 255};
  unsigned gates = 5;
  unsigned wordBits = 8;
  int firstGate = 2125; // m
  unsigned spacing = 250;
  float scale = 2.0F;
  float offset = 66.0F;
};

/// A ray, as messages 1 and 31 have it.
struct RayPlan
{
  std::uint32_t day = 13017; // 2005-08-21
  std::uint32_t milliseconds = 9'799'671;
  double azimuth = 45.0;
  double elevation = 0.5;
  unsigned number = 1;
  unsigned status = 1;
  unsigned cut = 1;
  unsigned pattern = 21;
  unsigned nyquist = 2612;                          // 0.01 m/s
  unsigned range = 1480;                            // 0.1 km, unambiguous
  Bytes ref = {0, 1, 2, 66, 255};                   // message 1
  Bytes vel = {0, 1, 2, 129, 255, 131};             // message 1
  Bytes width = {0, 1, 129, 130, 131, 132};         // message 1
  unsigned velocityResolution = 2;                  // message 1: 2 is 0.5 m/s, 4 is 1 m/s
  std::vector<MomentPlan> moments = {MomentPlan{}}; // message 31
  std::string site = "KTLX";                        // message 31
  float latitude = 35.33F;                          // message 31
  float longitude = -97.28F;
  int siteHeight = 370;
  unsigned feedhornHeight = 20;
};

Bytes MakeVolumeHeader(const std::string& version = "AR2V0006", const std::string& site = "KTLX",
  std::uint32_t day = 13017, std::uint32_t milliseconds = 9'799'000);
Bytes MakeMessage1(const RayPlan& ray);
Bytes MakeMessage2(int pattern, unsigned build);
/// A message of that type in its frame: 2432 bytes, or as long as needed for 29 and 31.
Bytes MakeFrame(unsigned type, const Bytes& body);
Bytes MakeMessage31(const RayPlan& ray);
/// Message 5 with cuts at these angles, degrees; all contiguous surveillance.
Bytes MakeMessage5(unsigned pattern, const std::vector<double>& angles);

/// A sweep of rays one degree apart: the first with the status, the last with `lastStatus`.
Bytes MakeSweepBytes(unsigned messageType, RayPlan first, unsigned rays, unsigned lastStatus);

/// A whole volume of two sweeps of 12 rays behind a header: bare.
Bytes MakeSmallVolume(unsigned messageType);

/// A bzip2 stream of blocks of `level` × 100 kB: a decompressor takes its memory by that.
Bytes Bzip2(const Bytes& content, int level = 9);
Bytes Gzip(const Bytes& content);
/// A bzip2 stream behind its length, negative for the last one.
Bytes MakeLdmRecord(const Bytes& content, bool last = false, int level = 9);
/// The Unix program compress, with codes of 9 to `maximumWidth` (10 to 16) bits; clears its table
/// when full.
Bytes Compress(const Bytes& content, unsigned maximumWidth = 16);

/// What a zlib stream holds; nothing when it is damaged, or does not end where the bytes do.
std::optional<Bytes> InflateStream(const Bytes& stream);

} // namespace nexrad::testing
