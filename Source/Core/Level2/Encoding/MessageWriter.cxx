// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Encoding/MessageWriter.h"

#include "nexrad/System/Error.h"

namespace nexrad
{

namespace
{

constexpr std::size_t communicationsHeaderBytes = 12; // CTM, without content
constexpr std::size_t messageHeaderBytes = 16;

} // namespace

Level2Date ToLevel2Date(Time time)
{
  constexpr std::int64_t dayLength = 86'400'000;
  constexpr std::int64_t mostDays = 65'535;
  const std::int64_t count = time.time_since_epoch().count();
  if (count < 0 || count / dayLength + 1 > mostDays)
  {
    throw Error("Level II encoder: " + FormatIso8601(time) +
                " is outside 1970-01-01 to 2149-06-05, the dates of Level II");
  }
  return {static_cast<std::uint32_t>(count / dayLength + 1),
    static_cast<std::uint32_t>(count % dayLength)};
}

MessageBytes WrapMessage(
  int type, unsigned sequence, Time time, const std::vector<std::uint8_t>& body, bool frame)
{
  constexpr int message1 = 1;
  constexpr unsigned message1Halfwords = 1208;
  const Level2Date date = ToLevel2Date(time);
  const std::size_t halfwords = (messageHeaderBytes + body.size() + 1) / 2;
  BigEndianWriter message;
  message.PutZeros(communicationsHeaderBytes);
  message.Put16(type == message1 ? message1Halfwords : static_cast<unsigned>(halfwords));
  message.Put8(0);
  message.Put8(static_cast<unsigned>(type));
  message.Put16(sequence & 0x7fffU);
  message.Put16(date.days);
  message.Put32(date.milliseconds);
  message.Put16(1);
  message.Put16(1);
  message.PutBytes(body.data(), body.size());
  message.PadTo(frame ? MessageFrameBytes : communicationsHeaderBytes + 2 * halfwords);
  return message.Take();
}

} // namespace nexrad
