// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Messages/MessageStream.h"

#include "nexrad/Level2/Messages/VolumeHeader.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

namespace nexrad
{

namespace
{

constexpr std::size_t communicationBytes = 12;
constexpr std::size_t headerBytes = 28; // both headers
constexpr std::size_t frameBytes = 2432;
constexpr unsigned lastKnownType = 33;
constexpr unsigned longestFramedHalfwords = frameBytes / 2; // some count their whole frame
constexpr unsigned lengthElsewhere = 65535; // then the segment fields hold a length in bytes
constexpr std::size_t longestMessageBytes = std::size_t(1) << 20;
// Among bytes that are no message, less than one in a thousand looks as if a message began there.
constexpr std::size_t bytesForATry = 32;
constexpr std::size_t fewestTries = 1000;
constexpr std::uint32_t dayMilliseconds = 86'400'000;
constexpr std::uint32_t leapSecond = 1000;
constexpr unsigned lastDay = 40'000; // in the year 2079

// The fields of a message header (ICD 2620002, table II).
struct Header
{
  Header(ByteView bytes, std::size_t offset)
    : halfwords(bytes.U16(offset + 12))
    , channel(bytes.U8(offset + 14))
    , type(bytes.U8(offset + 15))
    , day(bytes.U16(offset + 18))
    , milliseconds(bytes.U32(offset + 20))
    , segments(bytes.U16(offset + 24))
    , segment(bytes.U16(offset + 26))
  {
  }

  bool IsVariable() const { return type == 29 || type == 31; }
  std::size_t MessageBytes() const
  {
    return IsVariable() && halfwords == lengthElsewhere
             ? static_cast<std::size_t>(segments) << 16 | segment
             : std::size_t(2) * halfwords;
  }
  std::size_t FrameBytes() const
  {
    return IsVariable() ? communicationBytes + MessageBytes() : frameBytes;
  }
  // The metadata at the start of a volume may have no time at all.
  bool TimeMakesSense() const
  {
    const bool isRay = type == 1 || type == 31;
    return milliseconds < dayMilliseconds + leapSecond && day <= lastDay &&
           (day >= 1 || (!isRay && milliseconds == 0));
  }
  bool LengthMakesSense() const
  {
    const std::size_t bytes = this->MessageBytes();
    return bytes >= headerBytes - communicationBytes &&
           (IsVariable() ? bytes <= longestMessageBytes : halfwords <= longestFramedHalfwords);
  }
  // Redundant channels are numbered 0 to 2; the open radar data acquisition adds 8.
  bool ChannelMakesSense() const { return (channel & ~8U) <= 2; }
  bool SegmentsMakeSense() const
  {
    return (IsVariable() && halfwords == lengthElsewhere) || (segment >= 1 && segment <= segments);
  }

  unsigned halfwords;
  unsigned channel;
  unsigned type;
  unsigned day;
  std::uint32_t milliseconds;
  unsigned segments;
  unsigned segment;
};

// All are 0 when the first is, and each is as the one before it.
bool IsZero(ByteView bytes)
{
  return bytes.Size() == 0 ||
         (bytes.U8(0) == 0 && std::memcmp(bytes.Data(), bytes.Data() + 1, bytes.Size() - 1) == 0);
}

// A frame of zeros, or of type 0, fills up the metadata at the start of a volume. Some radars leave
// the old header in it, with a segment number beyond the number of segments.
bool IsFiller(ByteView bytes, std::size_t offset)
{
  if (IsZero(bytes.Sub(offset, frameBytes)))
  {
    return true;
  }
  if (!bytes.Has(offset, headerBytes))
  {
    return false;
  }
  const Header header(bytes, offset);
  return header.type == 0 && header.day >= 1 && header.LengthMakesSense() &&
         header.TimeMakesSense() && header.ChannelMakesSense() && header.segments <= 255 &&
         header.segment <= 255;
}

bool IsBoundary(ByteView bytes, std::size_t offset)
{
  return offset >= bytes.Size() || MessageStream::IsMessage(bytes, offset) ||
         IsFiller(bytes, offset) || IsVolumeHeader(bytes, offset);
}

// A place to go on reading after bytes that are no message. Here, unlike at a frame's end, nothing
// but the bytes themselves speaks for it, so it needs a date, and what follows the message must
// make sense too. `tries` is how often a whole frame may still be looked at for that.
std::size_t FindMessage(ByteView bytes, std::size_t from, std::size_t& tries)
{
  for (std::size_t offset = from; bytes.Has(offset, headerBytes) && tries > 0; ++offset)
  {
    if (IsVolumeHeader(bytes, offset))
    {
      return offset;
    }
    if (MessageStream::IsMessage(bytes, offset) && Header(bytes, offset).day >= 1)
    {
      --tries;
      if (IsBoundary(bytes, offset + Header(bytes, offset).FrameBytes()))
      {
        return offset;
      }
    }
  }
  return bytes.Size();
}

} // namespace

bool MessageStream::IsMessage(ByteView bytes, std::size_t offset)
{
  if (!bytes.Has(offset, headerBytes))
  {
    return false;
  }
  const Header header(bytes, offset);
  return header.type >= 1 && header.type <= lastKnownType && header.LengthMakesSense() &&
         header.TimeMakesSense() && header.ChannelMakesSense() && header.SegmentsMakeSense();
}

MessageStream::MessageStream(ByteView bytes, DamageReceiver receiver)
  : stream(bytes)
  , tries(fewestTries + bytes.Size() / bytesForATry)
  , report(std::move(receiver))
{
}

std::optional<Message> MessageStream::Next()
{
  while (position < stream.Size())
  {
    if (IsMessage(stream, position))
    {
      return this->TakeMessage();
    }
    if (IsVolumeHeader(stream, position))
    {
      report(position, "another volume header in the middle of the volume");
      position += VolumeHeader::bytes;
      searchFrom = position;
    }
    else if (IsFiller(stream, position))
    {
      searchFrom = position + 1;
      position = std::min(position + frameBytes, stream.Size());
    }
    else
    {
      this->SkipToNextMessage();
    }
  }
  return std::nullopt;
}

Message MessageStream::TakeMessage()
{
  const Header header(stream, position);
  Message message;
  message.type = header.type;
  message.offset = position;
  const std::size_t bodyBytes = header.MessageBytes() - (headerBytes - communicationBytes);
  message.body = stream.Sub(position + headerBytes, bodyBytes);
  message.cut = message.body.Size() < bodyBytes;
  searchFrom = position + headerBytes;
  position = std::min(position + header.FrameBytes(), stream.Size());
  return message;
}

void MessageStream::SkipToNextMessage()
{
  const std::size_t next = FindMessage(stream, searchFrom, tries);
  if (next < position)
  {
    report(next, "bytes are missing: the message before this one is cut short");
  }
  else if (!IsZero(stream.Sub(position, next - position)))
  {
    report(position, std::to_string(next - position) + " bytes that are no message");
  }
  position = next;
  searchFrom = next;
}

} // namespace nexrad
