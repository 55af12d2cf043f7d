// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Encoding/Level2Encoder.h"

#include "nexrad/Compression/Deflate.h"
#include "nexrad/Level2/Encoding/MessageWriter.h"
#include "nexrad/System/Error.h"

#include <bzlib.h>

#include <array>
#include <cstdio>
#include <string>

namespace nexrad
{

namespace
{

using Bytes = std::vector<std::uint8_t>;

void CheckOptions(const RadarVolume& volume, const Level2EncoderOptions& options)
{
  if (options.messageType != 1 && options.messageType != 31)
  {
    throw Error("Level II encoder: message type " + std::to_string(options.messageType) +
                " is unknown; it must be 1 or 31");
  }
  if (options.volumeNumber < 1 || options.volumeNumber > 999)
  {
    throw Error("Level II encoder: volume number " + std::to_string(options.volumeNumber) +
                " is out of range; it must be 1 to 999");
  }
  if (volume.site.name.size() > 4)
  {
    throw Error("Level II encoder: site '" + volume.site.name +
                "' is too long; its name must have at most four letters");
  }
}

// The 24 bytes that begin a file (ICD 2620010): tape name, number, date, time, site.
Bytes VolumeHeader(const RadarVolume& volume, const Level2EncoderOptions& options, Time start)
{
  std::array<char, 16> tape{};
  std::snprintf(tape.data(), tape.size(), "AR2V00%02d.%03d", options.messageType == 1 ? 1 : 6,
    options.volumeNumber);
  const Level2Date date = ToLevel2Date(start);
  BigEndianWriter header;
  header.PutText(tape.data(), 12);
  header.Put32(date.days);
  header.Put32(date.milliseconds);
  header.PutText(volume.site.name, 4);
  return header.Take();
}

// Calls `write` with each ray's message, in the order scanned.
template <typename Write>
void WriteRays(const RadarVolume& volume, int messageType, const Write& write)
{
  unsigned sequence = 0;
  for (const Sweep& sweep : volume.sweeps)
  {
    for (unsigned index = 0; index < sweep.rays.size(); ++index)
    {
      ++sequence;
      write(messageType == 1 ? WriteMessage1(volume, sweep.rays[index], index, sequence)
                             : WriteMessage31(volume, sweep, index, sequence));
    }
  }
}

void Append(Bytes& bytes, const Bytes& more)
{
  bytes.insert(bytes.end(), more.begin(), more.end());
}

// Bytes of a bzip2 stream, as large as libbz2 asks for at worst.
Bytes CompressBzip2(Bytes& plain)
{
  constexpr int blockSize = 9; // 100 kB
  Bytes packed(plain.size() + plain.size() / 100 + 600);
  auto length = static_cast<unsigned>(packed.size());
  const int status = BZ2_bzBuffToBuffCompress(reinterpret_cast<char*>(packed.data()), &length,
    reinterpret_cast<char*>(plain.data()), static_cast<unsigned>(plain.size()), blockSize, 0, 0);
  if (status != BZ_OK)
  {
    throw Error("Level II encoder: bzip2 failed with status " + std::to_string(status));
  }
  packed.resize(length);
  return packed;
}

// Appends messages as a compressed record behind its length, which is negative for the last one.
void PutRecord(Bytes& file, Bytes& messages, bool isLast)
{
  const Bytes packed = CompressBzip2(messages);
  const auto length = static_cast<std::uint32_t>(packed.size());
  BigEndianWriter writer;
  writer.Put32(isLast ? 0U - length : length);
  Append(file, writer.Bytes());
  Append(file, packed);
  messages.clear();
}

Bytes EncodePlain(const RadarVolume& volume, const Level2EncoderOptions& options, Time start)
{
  Bytes bytes = VolumeHeader(volume, options, start);
  Append(bytes, WriteMetadata(volume, start));
  WriteRays(
    volume, options.messageType, [&bytes](const MessageBytes& message) { Append(bytes, message); });
  return bytes;
}

Bytes EncodeRecords(const RadarVolume& volume, const Level2EncoderOptions& options, Time start)
{
  constexpr std::size_t message1Rays = 100;
  constexpr std::size_t message31Rays = 120;
  Bytes bytes = VolumeHeader(volume, options, start);
  Bytes messages = WriteMetadata(volume, start);
  PutRecord(bytes, messages, volume.RayCount() == 0);
  const std::size_t mostRays = options.messageType == 1 ? message1Rays : message31Rays;
  std::size_t rays = 0; // in the record in hand
  std::size_t raysLeft = volume.RayCount();
  WriteRays(volume, options.messageType,
    [&](const MessageBytes& message)
    {
      Append(messages, message);
      --raysLeft;
      if (++rays == mostRays || raysLeft == 0)
      {
        PutRecord(bytes, messages, raysLeft == 0);
        rays = 0;
      }
    });
  return bytes;
}

} // namespace

std::vector<std::uint8_t> EncodeLevel2(
  const RadarVolume& volume, const Level2EncoderOptions& options)
{
  CheckOptions(volume, options);
  const Time start = volume.headerTime.value_or(volume.Start().value_or(Time{}));
  if (options.container == Level2Container::LdmBzip2)
  {
    return EncodeRecords(volume, options, start);
  }
  Bytes bytes = EncodePlain(volume, options, start);
  return options.container == Level2Container::Gzip ? GzipBytes(bytes.data(), bytes.size()) : bytes;
}

} // namespace nexrad
