// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Compression/DamageList.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace nexrad
{

/// One message of the interface between radar and product generator (ICD 2620002, table II).
struct Message
{
  unsigned type = 0;
  ByteView body;          ///< what follows the message header, cut where the stream ends
  std::size_t offset = 0; ///< of the frame, in the stream
  bool cut = false;       ///< the stream ends before the message does
};

/// Cuts a stream into messages. Each stands behind twelve bytes of the old communication header, in
/// frames of 2432 bytes; messages 29 and 31 are as long as they say. Bytes that are no message are
/// passed over up to the next place where a message can begin, and reported with their offset in
/// the stream.
class MessageStream
{
public:
  MessageStream(ByteView bytes, DamageReceiver receiver);

  /// The next message; empty at the end.
  std::optional<Message> Next();

  /// True when a message header that makes sense stands at the offset.
  static bool IsMessage(ByteView bytes, std::size_t offset);

private:
  void SkipToNextMessage();
  Message TakeMessage();

  ByteView stream;
  std::size_t position = 0;
  std::size_t searchFrom = 0; ///< a message whose frame is cut short may be followed from here
  std::size_t tries = 0;      ///< to go on behind bytes that are no message
  DamageReceiver report;
};

} // namespace nexrad
