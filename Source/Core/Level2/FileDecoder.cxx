// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/FileDecoder.h"

#include "nexrad/Compression/ParallelBunzip.h"
#include "nexrad/Level2/Messages/Message1.h"
#include "nexrad/Level2/Messages/Message2.h"
#include "nexrad/Level2/Messages/Message31.h"
#include "nexrad/Level2/Messages/Message5.h"
#include "nexrad/Level2/Messages/SyntheticMark.h"
#include "nexrad/Level2/Messages/VolumeHeader.h"

#include <algorithm>
#include <stdexcept>

namespace nexrad
{

std::string FileCapText(const Level2Options& options)
{
  return "the file is larger than its cap of " + std::to_string(options.maximumFileBytes) +
         " bytes; the rest is left";
}

FileDecoder::FileDecoder(VolumeAssembler& target, const Level2Options& options)
  : assembler(target)
  , maximumRecordBytes(options.maximumRecordBytes)
  , threads(options.threads)
  , budget(options.maximumFileBytes)
{
}

bool FileDecoder::Spend(std::size_t bytes)
{
  const bool fits = bytes <= budget;
  budget -= fits ? bytes : budget;
  return fits;
}

void FileDecoder::Decode(std::vector<std::uint8_t> stored)
{
  if (stored.empty())
  {
    assembler.AddDamage(0, "the file is empty");
    return;
  }
  std::vector<Damage> damage;
  PlainFile file = OpenContainer(std::move(stored), budget, damage);
  for (const Damage& entry : damage)
  {
    assembler.AddDamage(entry.offset, entry.what);
  }
  const auto buffer = std::make_shared<const std::vector<std::uint8_t>>(std::move(file.bytes));
  const ByteView plain(buffer->data(), buffer->size());
  const auto header = ParseVolumeHeader(plain);
  if (header)
  {
    assembler.AddHeader(*header);
  }
  const std::size_t start = header ? VolumeHeader::bytes : 0;
  if (!MessageStream::IsMessage(plain, start) && FindLdmRecord(plain, start) < plain.Size())
  {
    this->DecodeRecords(plain, start, file.offsets);
    return;
  }
  this->Spend(plain.Size());
  const std::size_t before = assembler.RayCount();
  MessageStream stream(plain.Sub(start), [&](std::size_t offset, const std::string& what)
    { assembler.AddDamage(file.offsets.ToStored(start + offset), what); });
  while (const auto message = stream.Next())
  {
    this->DecodeMessage(*message, file.offsets.ToStored(start + message->offset));
  }
  if (assembler.RayCount() > before)
  {
    assembler.AddBuffer(buffer);
  }
}

void FileDecoder::DecodeRecords(ByteView plain, std::size_t start, const OffsetMap& offsets)
{
  const std::vector<LdmRecord> records = FindLdmRecords(plain, start,
    [&](std::size_t offset, const std::string& what)
    { assembler.AddDamage(offsets.ToStored(offset), what); });
  const auto receive = [&](std::size_t index, Bunzipped&& content)
  {
    const std::uint64_t offset = offsets.ToStored(records[index].offset);
    if (!this->Spend(content.bytes.size()))
    {
      assembler.AddDamage(offset, "the file is larger than its cap when decompressed; the rest "
                                  "is left");
      return false;
    }
    this->DecodeRecord(std::move(content), offset);
    return true;
  };
  BunzipInParallel(records, maximumRecordBytes, receive, threads);
}

void FileDecoder::DecodeRecord(Bunzipped&& content, std::uint64_t storedOffset)
{
  if (!content.problem.empty())
  {
    assembler.AddDamage(storedOffset, "compressed record: " + content.problem);
  }
  const auto buffer = std::make_shared<const std::vector<std::uint8_t>>(std::move(content.bytes));
  const std::size_t before = assembler.RayCount();
  MessageStream stream(ByteView(buffer->data(), buffer->size()),
    [&](std::size_t offset, const std::string& what)
    {
      assembler.AddDamage(
        storedOffset, "compressed record, its byte " + std::to_string(offset) + ": " + what);
    });
  while (const auto message = stream.Next())
  {
    this->DecodeMessage(*message, storedOffset);
  }
  if (assembler.RayCount() > before)
  {
    assembler.AddBuffer(buffer);
  }
}

void FileDecoder::DecodeMessage(const Message& message, std::uint64_t storedOffset)
{
  if (message.type == 1 || message.type == 31)
  {
    this->DecodeRay(message, storedOffset);
    return;
  }
  assembler.AddMetadata(message.type);
  if (message.cut)
  {
    assembler.AddDamage(storedOffset,
      "the stream ends in the middle of a message of type " + std::to_string(message.type));
  }
  switch (message.type)
  {
  case 2:
    if (const auto status = DecodeMessage2(message.body))
    {
      assembler.AddStatus(*status);
    }
    break;
  case 5:
    if (auto pattern = DecodeMessage5(message.body))
    {
      assembler.AddPattern(std::move(*pattern));
    }
    break;
  case SyntheticMarkMessageType:
    if (IsSyntheticMark(message.type, message.body.Data(), message.body.Size()))
    {
      assembler.AddSyntheticMark();
    }
    break;
  default:
    break; // maintenance data, clutter maps, …
  }
}

void FileDecoder::DecodeRay(const Message& message, std::uint64_t storedOffset)
{
  try
  {
    if (message.cut)
    {
      assembler.AddDamage(storedOffset, "the stream ends in the middle of a ray's message");
    }
    DecodedRay ray =
      message.type == 1 ? DecodeMessage1(message.body) : DecodeMessage31(message.body);
    assembler.AddRay(std::move(ray), static_cast<int>(message.type), storedOffset);
  }
  catch (const MessageError& error)
  {
    assembler.AddDamage(storedOffset, error.what());
  }
  catch (const std::out_of_range&)
  {
    assembler.AddDamage(storedOffset, "a ray's message is too short");
  }
}

} // namespace nexrad
