// SPDX-License-Identifier: BSD-3-Clause
#include "Level2Bytes.h"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>
#include <utility>

namespace nexrad::testing
{

namespace
{

constexpr std::size_t frameBytes = 2432;
constexpr std::size_t headerBytes = 28;

unsigned AngleCode(double degrees)
{
  return static_cast<unsigned>(std::lround(degrees * 32768.0 / 180.0)) & 0xFFF8;
}

Bytes MakeMomentBlock(const MomentPlan& plan)
{
  return BlockWriter(28)
    .Text(0, "D" + (plan.name + "  ").substr(0, 3))
    .U16(8, plan.gates)
    .U16(10, static_cast<unsigned>(plan.firstGate))
    .U16(12, plan.spacing)
    .U8(19, plan.wordBits)
    .F32(20, plan.scale)
    .F32(24, plan.offset)
    .Put(28, plan.words)
    .Take();
}

Bytes MakeVolumeBlock(const RayPlan& ray)
{
  return BlockWriter(44)
    .Text(0, "RVOL")
    .U16(4, 44)
    .F32(8, ray.latitude)
    .F32(12, ray.longitude)
    .U16(16, static_cast<unsigned>(ray.siteHeight))
    .U16(18, ray.feedhornHeight)
    .U16(40, ray.pattern)
    .Take();
}

// Codes of the compress format: lowest bit first, in groups of eight.
class CodeWriter
{
public:
  void Write(unsigned code)
  {
    for (unsigned place = 0; place < width; ++place, ++bits)
    {
      if (bits / 8 == bytes.size())
      {
        bytes.push_back(0);
      }
      bytes[bits / 8] =
        static_cast<std::uint8_t>(bytes[bits / 8] | (code >> place & 1U) << bits % 8);
    }
  }
  void SetWidth(unsigned next)
  {
    const std::size_t group = width;
    bytes.resize(start + (bytes.size() - start + group - 1) / group * group);
    start = bytes.size();
    bits = start * 8;
    width = next;
  }
  unsigned width = 9;
  Bytes bytes;

private:
  std::size_t bits = 0;
  std::size_t start = 0;
};

} // namespace

Bytes Join(const std::vector<Bytes>& parts)
{
  Bytes all;
  for (const Bytes& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

void BlockWriter::Reach(std::size_t end)
{
  bytes.resize(std::max(bytes.size(), end));
}

BlockWriter& BlockWriter::U8(std::size_t place, unsigned value)
{
  this->Reach(place + 1);
  bytes[place] = static_cast<std::uint8_t>(value & 0xFF);
  return *this;
}

BlockWriter& BlockWriter::U16(std::size_t place, unsigned value)
{
  return this->U8(place, value >> 8).U8(place + 1, value);
}

BlockWriter& BlockWriter::U32(std::size_t place, std::uint32_t value)
{
  return this->U16(place, value >> 16).U16(place + 2, value);
}

BlockWriter& BlockWriter::F32(std::size_t place, float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return this->U32(place, bits);
}

BlockWriter& BlockWriter::Text(std::size_t place, const std::string& text)
{
  return this->Put(place, Bytes(text.begin(), text.end()));
}

BlockWriter& BlockWriter::Put(std::size_t place, const Bytes& content)
{
  this->Reach(place + content.size());
  std::copy(content.begin(), content.end(), bytes.begin() + static_cast<std::ptrdiff_t>(place));
  return *this;
}

Bytes MakeVolumeHeader(const std::string& version, const std::string& site, std::uint32_t day,
  std::uint32_t milliseconds)
{
  return BlockWriter(24)
    .Text(0, version + ".001")
    .U32(12, day)
    .U32(16, milliseconds)
    .Text(20, site)
    .Take();
}

Bytes MakeFrame(unsigned type, const Bytes& body)
{
  const bool variable = type == 29 || type == 31;
  const std::size_t size = headerBytes + body.size();
  return BlockWriter(variable ? size + size % 2 : frameBytes)
    .U16(12, static_cast<unsigned>((size - 12 + 1) / 2))
    .U8(15, type)
    .U16(18, 13017)
    .U32(20, 9'799'671)
    .U16(24, 1)
    .U16(26, 1)
    .Put(headerBytes, body)
    .Take();
}

Bytes MakeMessage1(const RayPlan& ray)
{
  const std::size_t refPlace = 100;
  const std::size_t velPlace = refPlace + ray.ref.size();
  const std::size_t widthPlace = velPlace + ray.vel.size();
  return MakeFrame(1, BlockWriter(100)
                        .U32(0, ray.milliseconds)
                        .U16(4, ray.day)
                        .U16(6, 4660)
                        .U16(8, AngleCode(ray.azimuth))
                        .U16(10, ray.number)
                        .U16(12, ray.status)
                        .U16(14, AngleCode(ray.elevation))
                        .U16(16, ray.cut)
                        .U16(18, 0)
                        .U16(20, static_cast<unsigned>(-375))
                        .U16(22, 1000)
                        .U16(24, 250)
                        .U16(26, static_cast<unsigned>(ray.ref.size()))
                        .U16(28, static_cast<unsigned>(ray.vel.size()))
                        .U16(36, ray.ref.empty() ? 0 : static_cast<unsigned>(refPlace))
                        .U16(38, ray.vel.empty() ? 0 : static_cast<unsigned>(velPlace))
                        .U16(40, ray.width.empty() ? 0 : static_cast<unsigned>(widthPlace))
                        .U16(42, ray.velocityResolution)
                        .U16(44, ray.pattern)
                        .U16(6, ray.range)
                        .U16(60, ray.nyquist)
                        .Put(refPlace, ray.ref)
                        .Put(velPlace, ray.vel)
                        .Put(widthPlace, ray.width)
                        .Take());
}

Bytes MakeMessage2(int pattern, unsigned build)
{
  return MakeFrame(
    2, BlockWriter(80).U16(14, static_cast<unsigned>(pattern)).U16(18, build).Take());
}

Bytes MakeMessage31(const RayPlan& ray)
{
  std::vector<Bytes> blocks = {MakeVolumeBlock(ray),
    BlockWriter(20).Text(0, "RRAD").U16(6, ray.range).U16(16, ray.nyquist).Take()};
  for (const MomentPlan& moment : ray.moments)
  {
    blocks.push_back(MakeMomentBlock(moment));
  }
  BlockWriter body(72);
  body.Text(0, ray.site)
    .U32(4, ray.milliseconds)
    .U16(8, ray.day)
    .U16(10, ray.number)
    .F32(12, static_cast<float>(ray.azimuth))
    .U8(20, 2)
    .U8(21, ray.status)
    .U8(22, ray.cut)
    .F32(24, static_cast<float>(ray.elevation))
    .U16(30, static_cast<unsigned>(blocks.size()));
  std::size_t place = 72;
  for (std::size_t index = 0; index < blocks.size(); ++index)
  {
    body.U32(32 + 4 * index, static_cast<std::uint32_t>(place)).Put(place, blocks[index]);
    place += blocks[index].size();
  }
  return MakeFrame(31, body.Take());
}

Bytes MakeMessage5(unsigned pattern, const std::vector<double>& angles)
{
  const auto cuts = static_cast<unsigned>(angles.size());
  BlockWriter body(22);
  body.U16(0, 11 + 23 * cuts).U16(2, 2).U16(4, pattern).U16(6, cuts);
  for (std::size_t index = 0; index < angles.size(); ++index)
  {
    const std::size_t place = 22 + 46 * index;
    body.U16(place, AngleCode(angles[index])).U8(place + 3, 1).U8(place + 4, 1);
    body.U16(place + 8, 8192).U16(place + 44, 0); // 11.25 degrees a second
  }
  return MakeFrame(5, body.Take());
}

Bytes MakeSweepBytes(unsigned messageType, RayPlan first, unsigned rays, unsigned lastStatus)
{
  std::vector<Bytes> frames;
  const unsigned firstStatus = first.status;
  for (unsigned index = 0; index < rays; ++index)
  {
    first.number = index + 1;
    first.status = index == 0 ? firstStatus : index + 1 == rays ? lastStatus : 1;
    frames.push_back(messageType == 1 ? MakeMessage1(first) : MakeMessage31(first));
    first.azimuth = std::fmod(first.azimuth + 1.0, 360.0);
    first.milliseconds += 50;
  }
  return Join(frames);
}

Bytes MakeSmallVolume(unsigned messageType)
{
  RayPlan low;
  low.status = 3;
  RayPlan high;
  high.status = 0;
  high.cut = 2;
  high.elevation = 1.5;
  high.milliseconds += 1000;
  return Join({MakeVolumeHeader(), MakeMessage2(21, 1900), MakeMessage5(21, {0.5, 1.5}),
    MakeSweepBytes(messageType, low, 12, 2), MakeSweepBytes(messageType, high, 12, 4)});
}

Bytes Bzip2(const Bytes& content, int level)
{
  auto size = static_cast<unsigned>(content.size() + content.size() / 50 + 600);
  Bytes stored(size);
  Bytes input = content; // the interface takes it as non-const, and no null pointer
  input.push_back(0);
  if (BZ2_bzBuffToBuffCompress(reinterpret_cast<char*>(stored.data()), &size,
        reinterpret_cast<char*>(input.data()), static_cast<unsigned>(content.size()), level, 0,
        0) != BZ_OK)
  {
    throw std::runtime_error("bzip2 failed");
  }
  stored.resize(size);
  return stored;
}

Bytes Gzip(const Bytes& content)
{
  z_stream stream{};
  constexpr int gzipHeader = 16;
  deflateInit2(&stream, 6, Z_DEFLATED, MAX_WBITS + gzipHeader, 8, Z_DEFAULT_STRATEGY);
  Bytes input = content;
  Bytes stored(deflateBound(&stream, static_cast<uLong>(input.size())) + 32);
  stream.next_in = input.data();
  stream.avail_in = static_cast<unsigned>(input.size());
  stream.next_out = stored.data();
  stream.avail_out = static_cast<unsigned>(stored.size());
  const int status = deflate(&stream, Z_FINISH);
  stored.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END)
  {
    throw std::runtime_error("gzip failed");
  }
  return stored;
}

Bytes MakeLdmRecord(const Bytes& content, bool last, int level)
{
  const Bytes stream = Bzip2(content, level);
  const auto length = static_cast<std::int32_t>(stream.size());
  return BlockWriter(4)
    .U32(0, static_cast<std::uint32_t>(last ? -length : length))
    .Put(4, stream)
    .Take();
}

Bytes Compress(const Bytes& content, unsigned maximumWidth)
{
  constexpr unsigned clearCode = 256;
  CodeWriter codes;
  std::map<std::pair<unsigned, std::uint8_t>, unsigned> table; // a code and the byte behind it
  unsigned free = clearCode + 1;
  unsigned current = content.empty() ? 0 : content.front();
  for (std::size_t place = 1; place < content.size(); ++place)
  {
    const auto longer = std::pair(current, content[place]);
    if (const auto known = table.find(longer); known != table.end())
    {
      current = known->second;
      continue;
    }
    codes.Write(current);
    current = content[place];
    if (free == 1U << maximumWidth)
    {
      codes.Write(clearCode);
      codes.SetWidth(9);
      table.clear();
      free = clearCode + 1;
      continue;
    }
    table[longer] = free++;
    // The reader knows each entry one code later than the writer.
    if (free > 1U << codes.width && codes.width < maximumWidth)
    {
      codes.SetWidth(codes.width + 1);
    }
  }
  if (!content.empty())
  {
    codes.Write(current);
  }
  return Join({{0x1F, 0x9D, static_cast<std::uint8_t>(0x80 | maximumWidth)}, codes.bytes});
}

std::optional<Bytes> InflateStream(const Bytes& stream)
{
  Bytes bytes(1024);
  while (true)
  {
    auto size = static_cast<uLong>(bytes.size());
    auto used = static_cast<uLong>(stream.size());
    const int status = uncompress2(bytes.data(), &size, stream.data(), &used);
    if (status != Z_BUF_ERROR || size < bytes.size())
    {
      bytes.resize(size);
      return status == Z_OK && used == stream.size() ? std::optional(bytes) : std::nullopt;
    }
    bytes.resize(2 * bytes.size());
  }
}

} // namespace nexrad::testing
