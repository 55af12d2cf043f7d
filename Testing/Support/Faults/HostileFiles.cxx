// SPDX-License-Identifier: BSD-3-Clause
#include "HostileFiles.h"

#include "Faults/HostileRays.h"

#include <zlib.h>

#include <stdexcept>

namespace nexrad::testing
{

namespace
{

constexpr std::size_t mebibyte = std::size_t(1) << 20;
// More than any of these files may give.
constexpr std::size_t contentBytes = 80 * mebibyte;

// So many repetitions that they have `contentBytes` together.
Bytes Fill(const Bytes& start, const Bytes& repeated, std::size_t bytes = contentBytes)
{
  const std::size_t pieces = std::max<std::size_t>(1, mebibyte / repeated.size());
  Bytes piece;
  for (std::size_t i = 0; i < pieces; ++i)
  {
    piece.insert(piece.end(), repeated.begin(), repeated.end());
  }
  // Gzip members may be joined end to end.
  return Join({Gzip(start), GzipOfRepeated(piece, bytes / piece.size() + 1)});
}

// What stands between compressed streams and messages.
std::vector<HostileFile> MakeContainers()
{
  const Bytes header = MakeVolumeHeader();
  const Bytes emptyStream =
    BlockWriter(14).Text(0, "BZh9").U32(4, 0x17724538).U16(8, 0x5090).Take();
  const Bytes emptyRecord = BlockWriter(14).U32(0, 10).Text(4, "BZh91AY&SY").Take();
  return {{"zeros", [=] { return Fill(header, Bytes(mebibyte)); }},
    {"zeros-bzip2", [=] { return Bzip2(Bytes(contentBytes)); }},
    {"bytes-that-are-no-message",
      [=] {
        return Fill(header, {0x01, 0x10});
      }},
    {"volume-headers", [=] { return Fill(header, header); }},
    {"gzip-members", [=] { return Fill({}, Gzip({})); }},
    {"bzip2-streams", [=] { return Fill(emptyStream, emptyStream); }},
    {"bzip2-streams-of-a-byte", [=] { return Fill({}, Bzip2({0}, 9)); }},
    {"broken-records", [=] { return Fill(header, emptyRecord); }},
    {"small-records", [=] { return Fill(header, MakeLdmRecord({0})); }},
    {"records-of-zeros",
      [=] {
        return Join({header, Repeat(MakeLdmRecord(Bytes(63 * mebibyte)), 32)});
      }},
    {"metadata-records",
      [=] { return Fill(header, MakeLdmRecord(MakeMessage5(21, std::vector<double>(32, 0.5)))); }},
    {"records-of-a-ray", [=] { return Fill(header, MakeLdmRecord(MakeMessage31(RayPlan()))); }}};
}

// Messages without content, as short as they can be: the types that are decoded, those without
// frames, the first and the last, and one that is passed over.
std::vector<HostileFile> MakeMessages()
{
  std::vector<HostileFile> files;
  for (const unsigned type : {0U, 1U, 2U, 5U, 15U, 29U, 31U, 33U})
  {
    const bool variable = type == 29 || type == 31;
    files.push_back({"messages-" + std::to_string(type),
      [=] { return Fill(MakeVolumeHeader(), MakeFrame(type, Bytes(variable ? 0 : 1000))); }});
  }
  return files;
}

} // namespace

Bytes Repeat(const Bytes& content, std::size_t count)
{
  Bytes bytes;
  bytes.reserve(content.size() * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    bytes.insert(bytes.end(), content.begin(), content.end());
  }
  return bytes;
}

Bytes GzipOfRepeated(const Bytes& content, std::size_t count)
{
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
  Bytes input = content;
  Bytes piece(deflateBound(&stream, static_cast<uLong>(input.size())) + 32);
  stream.next_in = input.data();
  stream.avail_in = static_cast<unsigned>(input.size());
  stream.next_out = piece.data();
  stream.avail_out = static_cast<unsigned>(piece.size());
  // A piece that ends so refers to nothing before it, and pieces can be joined.
  const int status = deflate(&stream, Z_FULL_FLUSH);
  piece.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_OK)
  {
    throw std::runtime_error("gzip failed");
  }
  const uLong ofOne = crc32_z(0, content.data(), content.size());
  uLong checkSum = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    checkSum = crc32_combine(checkSum, ofOne, static_cast<z_off_t>(content.size()));
  }
  const auto size = static_cast<std::uint32_t>(content.size() * count);
  Bytes end = {3, 0}; // a last block without content
  for (const auto number : {static_cast<std::uint32_t>(checkSum), size})
  {
    for (unsigned shift = 0; shift < 32; shift += 8)
    {
      end.push_back(static_cast<std::uint8_t>(number >> shift));
    }
  }
  return Join({{0x1F, 0x8B, 8, 0, 0, 0, 0, 0, 2, 3}, Repeat(piece, count), end});
}

std::vector<HostileFile> MakeHostileFiles()
{
  std::vector<HostileFile> files = MakeContainers();
  for (const std::vector<HostileFile>& more : {MakeMessages(), MakeHostileRays()})
  {
    files.insert(files.end(), more.begin(), more.end());
  }
  // The same once more inside gzip: the smallest files of all.
  for (HostileFile& file : files)
  {
    file.make = [make = file.make] { return Gzip(make()); };
  }
  return files;
}

} // namespace nexrad::testing
