// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/FileDecoder.h"

#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Level2/Messages/MetadataMessages.h"
#include "nexrad/Level2/Messages/RadialMessages.h"
#include "nexrad/Level2/Messages/VolumeHeader.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace nexrad
{

namespace
{

// Thrown where a file costs more than its budget.
struct OverBudget
{
  std::uint64_t storedOffset; // of what there is no budget for
};

} // namespace

std::string FileCapText(const Level2Options& options)
{
  return "the file is larger than its cap of " + std::to_string(options.maximumFileBytes) +
         " bytes; the rest is left";
}

FileDecoder::FileDecoder(VolumeAssembler& target, const Level2Options& options)
  : assembler(target)
  , maximumRecordBytes(options.maximumRecordBytes)
  , threads(options.threads)
  , budget(options.maximumFileBytes, options.freeBytes)
{
}

// Ends the decoding of a file that costs too much.
void FileDecoder::Spend(std::size_t cost, std::uint64_t storedOffset)
{
  if (!budget.Spend(cost))
  {
    throw OverBudget{storedOffset};
  }
}

void FileDecoder::AddDamage(std::uint64_t storedOffset, const std::string& what)
{
  this->Spend(DecodingBudget::DamageCost, storedOffset);
  assembler.AddDamage(storedOffset, what);
}

void FileDecoder::Decode(std::vector<std::uint8_t> stored)
{
  if (stored.empty())
  {
    assembler.AddDamage(0, "the file is empty");
    return;
  }
  budget.AddStored(stored.size());
  std::vector<Damage> damage;
  PlainFile file = OpenContainer(std::move(stored), budget, damage);
  for (const Damage& entry : damage)
  {
    assembler.AddDamage(entry.offset, entry.what);
  }
  try
  {
    this->DecodePlain(
      std::make_shared<const std::vector<std::uint8_t>>(std::move(file.bytes)), file.offsets);
  }
  catch (const OverBudget& over)
  {
    assembler.AddDamage(over.storedOffset, budget.Explain());
  }
}

void FileDecoder::DecodePlain(const Buffer& buffer, const OffsetMap& offsets)
{
  const ByteView plain(buffer->data(), buffer->size());
  const auto header = ParseVolumeHeader(plain);
  if (header)
  {
    assembler.AddHeader(*header);
  }
  const std::size_t start = header ? VolumeHeader::bytes : 0;
  if (!MessageStream::IsMessage(plain, start) && FindLdmRecord(plain, start) < plain.Size())
  {
    this->DecodeRecords(plain, start, offsets);
    return;
  }
  const OffsetFinder storedOffset = [&](std::size_t offset)
  { return offsets.ToStored(start + offset); };
  MessageStream stream(plain.Sub(start), [&](std::size_t offset, const std::string& what)
    { this->AddDamage(storedOffset(offset), what); });
  this->DecodeMessages(stream, buffer, storedOffset);
}

void FileDecoder::DecodeRecords(ByteView plain, std::size_t start, const OffsetMap& offsets)
{
  const std::vector<LdmRecord> records = FindLdmRecords(plain, start,
    [&](std::size_t offset, const std::string& what)
    { this->AddDamage(offsets.ToStored(offset), what); });
  const auto receive = [&](std::size_t index, Bunzipped&& content)
  {
    const std::uint64_t offset = offsets.ToStored(records[index].offset);
    const std::size_t compressed = records[index].compressed.Size();
    this->Spend(DecodingBudget::StreamCost + DecodingBudget::CompressedByteCost * compressed +
                  content.bytes.size(),
      offset);
    this->DecodeRecord(std::move(content), offset);
    return true;
  };
  BunzipInParallel(records, maximumRecordBytes, receive, threads);
}

void FileDecoder::DecodeRecord(Bunzipped&& content, std::uint64_t storedOffset)
{
  if (!content.problem.empty())
  {
    this->AddDamage(storedOffset, "compressed record: " + content.problem);
  }
  const auto buffer = std::make_shared<const std::vector<std::uint8_t>>(std::move(content.bytes));
  MessageStream stream(ByteView(buffer->data(), buffer->size()),
    [&](std::size_t offset, const std::string& what)
    {
      this->AddDamage(
        storedOffset, "compressed record, its byte " + std::to_string(offset) + ": " + what);
    });
  this->DecodeMessages(stream, buffer, [storedOffset](std::size_t) { return storedOffset; });
}

void FileDecoder::DecodeMessages(
  MessageStream& stream, const Buffer& buffer, const OffsetFinder& storedOffset)
{
  const std::size_t before = assembler.RayCount();
  const auto keepBytesOfRays = [&]
  {
    if (assembler.RayCount() > before)
    {
      assembler.AddBuffer(buffer);
    }
  };
  try
  {
    const std::uint8_t* farthest = buffer->data(); // a message may be found within the one before
    while (const auto message = stream.Next())
    {
      const std::uint8_t* end = message->body.Data() + message->body.Size();
      const auto beyond = static_cast<std::size_t>(std::max(end, farthest) - farthest);
      this->DecodeMessage(
        *message, std::min(beyond, message->body.Size()), storedOffset(message->offset));
      farthest = std::max(end, farthest);
    }
  }
  catch (const OverBudget&)
  {
    keepBytesOfRays();
    throw;
  }
  keepBytesOfRays();
}

// `newBytes`: of the message, those that no message before has.
void FileDecoder::DecodeMessage(
  const Message& message, std::size_t newBytes, std::uint64_t storedOffset)
{
  if (message.type == 1 || message.type == 31)
  {
    this->DecodeRay(message, newBytes, storedOffset);
    return;
  }
  assembler.AddMetadata(message.type);
  if (message.cut)
  {
    this->AddDamage(storedOffset,
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

void FileDecoder::DecodeRay(
  const Message& message, std::size_t newBytes, std::uint64_t storedOffset)
{
  this->Spend(DecodingBudget::RayCost, storedOffset);
  try
  {
    if (message.cut)
    {
      this->AddDamage(storedOffset, "the stream ends in the middle of a ray's message");
    }
    DecodedRay ray =
      message.type == 1 ? DecodeMessage1(message.body) : DecodeMessage31(message.body);
    this->Spend(rayCosts.Of(ray, newBytes), storedOffset);
    assembler.AddRay(std::move(ray), static_cast<int>(message.type), storedOffset);
  }
  catch (const MessageError& error)
  {
    this->AddDamage(storedOffset, error.what());
  }
  catch (const std::out_of_range&)
  {
    this->AddDamage(storedOffset, "a ray's message is too short");
  }
}

ChunkDecoder::ChunkDecoder(const Level2Options& theOptions)
  : options(theOptions)
  , assembler(theOptions)
  , decoder(assembler, theOptions)
{
}

void ChunkDecoder::Begin(int number, const std::string& name)
{
  assembler.BeginPiece(name);
  if (number > expected)
  {
    const int missing = number - expected;
    assembler.AddDamage(0,
      std::to_string(missing) + (missing == 1 ? " chunk" : " chunks") + " missing before this one");
  }
  expected = number + 1;
}

void ChunkDecoder::AddOther(const std::string& name)
{
  assembler.BeginPiece(name);
  assembler.AddDamage(0, "a chunk of another volume, left out");
}

void ChunkDecoder::Decode(std::vector<std::uint8_t> stored)
{
  size = stored.size();
  if (stored.size() >= options.maximumFileBytes)
  {
    assembler.AddDamage(stored.size(), FileCapText(options));
  }
  decoder.Decode(std::move(stored));
}

RadarVolume ChunkDecoder::VolumeSoFar(const std::string& name) const
{
  VolumeAssembler copy = assembler;
  return copy.Finish(name, size);
}

} // namespace nexrad
