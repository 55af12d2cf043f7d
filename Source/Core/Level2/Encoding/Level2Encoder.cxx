// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Encoding/Level2Encoder.h"

#include "nexrad/Level2/Encoding/MessageWriter.h"
#include "nexrad/Level2/Encoding/RadialWriter.h"
#include "nexrad/Level2/Messages/MetadataMessages.h"
#include "nexrad/System/Error.h"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <string>

namespace nexrad
{

namespace
{

constexpr std::size_t metadataFrames = 134;
constexpr double angleUnit = 180.0 / 32768.0;      // degrees
constexpr double angularRateUnit = 22.5 / 16384.0; // degrees a second

// The three low bits of an angle are not used (ICD 2620002, table XI).
unsigned CodeAngle(double degrees)
{
  return static_cast<unsigned>(std::lround(degrees / angleUnit / 8.0) * 8) & 0xffffU;
}

// Message 5 (ICD 2620002, table XI): what the model keeps of a cut; thresholds and sectors are 0.
void PutCut(BigEndianWriter& body, const CoverageCut& cut)
{
  constexpr unsigned halfDegreeAzimuths = 1;
  constexpr unsigned fineReflectivity = 2;
  constexpr unsigned longDoppler = 4;
  constexpr std::size_t restOfCut = 36;
  body.Put16(CodeAngle(cut.elevation));
  body.Put8(0);
  body.Put8(static_cast<unsigned>(cut.waveform));
  body.Put8(cut.superResolution ? halfDegreeAzimuths | fineReflectivity | longDoppler : 0U);
  body.Put8(0);
  body.Put16(0);
  body.PutSigned16(static_cast<int>(std::lround(cut.azimuthRate / angularRateUnit)));
  body.PutZeros(restOfCut);
}

std::vector<std::uint8_t> PatternBody(const CoveragePattern& pattern)
{
  constexpr std::size_t headerBytes = 22;
  constexpr std::size_t cutBytes = 46;
  constexpr unsigned constantElevation = 2;
  constexpr unsigned halfMetreResolution = 2;
  constexpr unsigned shortPulse = 2;
  constexpr std::size_t mostCuts = 51; // of one frame
  if (pattern.cuts.size() > mostCuts)
  {
    throw Error("Level II encoder: coverage pattern " + std::to_string(pattern.number) + " has " +
                std::to_string(pattern.cuts.size()) + " cuts; message 5 holds at most 51");
  }
  BigEndianWriter body;
  body.Put16(static_cast<unsigned>((headerBytes + cutBytes * pattern.cuts.size()) / 2));
  body.Put16(constantElevation);
  body.Put16(static_cast<unsigned>(pattern.number));
  body.Put16(static_cast<unsigned>(pattern.cuts.size()));
  body.Put16(1);
  body.Put8(halfMetreResolution);
  body.Put8(shortPulse);
  body.PadTo(headerBytes);
  for (const CoverageCut& cut : pattern.cuts)
  {
    PutCut(body, cut);
  }
  return body.Take();
}

// Message 2 (ICD 2620002, table IV): a radar that operates normally.
std::vector<std::uint8_t> StatusBody(const RadarVolume& volume)
{
  constexpr unsigned operate = 16;
  constexpr unsigned online = 2;
  constexpr unsigned remoteControl = 4;
  constexpr unsigned utilityPower = 2;
  constexpr unsigned allMomentsEnabled = 28;
  constexpr std::size_t statusBytes = 80;
  BigEndianWriter body;
  body.Put16(operate);
  body.Put16(online);
  body.Put16(remoteControl);
  body.Put16(utilityPower);
  body.Put16(0);
  body.Put16(0);
  body.Put16(allMomentsEnabled);
  body.Put16(static_cast<unsigned>(volume.coveragePatternNumber.value_or(0)) & 0xffffU);
  body.PadTo(statusBytes);
  return body.Take();
}

std::vector<std::uint8_t> MarkBody()
{
  BigEndianWriter body;
  body.Put16(static_cast<unsigned>(SyntheticMarkText.size()));
  body.PutText(SyntheticMarkText, SyntheticMarkText.size());
  return body.Take();
}

} // namespace

std::vector<MessageBytes> WriteMetadata(const RadarVolume& volume, Time start)
{
  constexpr int status = 2;
  constexpr int pattern = 5;
  std::vector<MessageBytes> last;
  if (volume.synthetic)
  {
    last.push_back(WrapMessage(SyntheticMarkMessageType, 0, start, MarkBody(), true));
  }
  if (volume.coveragePattern)
  {
    last.push_back(WrapMessage(pattern, 0, start, PatternBody(*volume.coveragePattern), true));
  }
  last.push_back(WrapMessage(status, 0, start, StatusBody(volume), true));
  // Real files fill the frames before with clutter maps, which the model does not keep.
  std::vector<MessageBytes> frames(
    metadataFrames - last.size(), MessageBytes(MessageFrameBytes, std::uint8_t(0)));
  std::move(last.begin(), last.end(), std::back_inserter(frames));
  return frames;
}

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

Bytes CompressGzip(Bytes& plain)
{
  constexpr int gzipWindow = 15 + 16; // the largest window, with a gzip header
  constexpr int memoryLevel = 8;
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzipWindow, memoryLevel,
        Z_DEFAULT_STRATEGY) != Z_OK)
  {
    throw Error("Level II encoder: zlib cannot start");
  }
  Bytes packed(deflateBound(&stream, plain.size()));
  stream.next_in = plain.data();
  stream.avail_in = static_cast<uInt>(plain.size());
  stream.next_out = packed.data();
  stream.avail_out = static_cast<uInt>(packed.size());
  const int status = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END)
  {
    throw Error("Level II encoder: gzip failed with status " + std::to_string(status));
  }
  return packed;
}

// Gathers messages into compressed records, each behind its length.
class RecordWriter
{
public:
  RecordWriter(Bytes& file, std::size_t messages)
    : bytes(file)
    , perRecord(messages)
  {
  }

  void Put(const Bytes& message)
  {
    Append(record, message);
    if (++count == perRecord)
    {
      this->Flush();
    }
  }

  void Flush()
  {
    if (!record.empty())
    {
      const Bytes packed = CompressBzip2(record);
      lastLength = bytes.size();
      this->PutLength(static_cast<std::int32_t>(packed.size()));
      Append(bytes, packed);
      record.clear();
    }
    count = 0;
  }

  // The length of the volume's last record is negative.
  void Finish()
  {
    this->Flush();
    std::uint32_t length = 0;
    for (std::size_t byte = 0; byte < 4; ++byte)
    {
      length = length << 8 | bytes[lastLength + byte];
    }
    length = 0U - length;
    for (std::size_t byte = 0; byte < 4; ++byte)
    {
      bytes[lastLength + byte] = static_cast<std::uint8_t>(length >> (24 - 8 * byte));
    }
  }

private:
  Bytes& bytes;
  std::size_t perRecord;
  Bytes record;
  std::size_t count = 0;
  std::size_t lastLength = 0; // where the length of the last record stands

  void PutLength(std::int32_t length)
  {
    BigEndianWriter writer;
    writer.Put32(static_cast<std::uint32_t>(length));
    Append(bytes, writer.Bytes());
  }
};

Bytes EncodePlain(const RadarVolume& volume, const Level2EncoderOptions& options, Time start)
{
  Bytes bytes = VolumeHeader(volume, options, start);
  for (const MessageBytes& frame : WriteMetadata(volume, start))
  {
    Append(bytes, frame);
  }
  WriteRays(
    volume, options.messageType, [&bytes](const MessageBytes& message) { Append(bytes, message); });
  return bytes;
}

Bytes EncodeRecords(const RadarVolume& volume, const Level2EncoderOptions& options, Time start)
{
  constexpr std::size_t message1Rays = 100;
  constexpr std::size_t message31Rays = 120;
  Bytes bytes = VolumeHeader(volume, options, start);
  const std::vector<MessageBytes> metadata = WriteMetadata(volume, start);
  RecordWriter first(bytes, metadata.size());
  for (const MessageBytes& frame : metadata)
  {
    first.Put(frame);
  }
  if (volume.sweeps.empty())
  {
    first.Finish();
    return bytes;
  }
  RecordWriter records(bytes, options.messageType == 1 ? message1Rays : message31Rays);
  WriteRays(
    volume, options.messageType, [&records](const MessageBytes& message) { records.Put(message); });
  records.Finish();
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
  return options.container == Level2Container::Gzip ? CompressGzip(bytes) : bytes;
}

} // namespace nexrad
