// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/FileDecoder.h"

#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Level2/Messages/VolumeHeader.h"
#include "nexrad/System/MessageText.h"

#include <algorithm>
#include <cmath>
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

std::size_t RayCosts::Of(const DecodedRay& decoded, std::size_t newBytes)
{
  std::size_t words = 0;
  for (const MomentRow& row : decoded.ray.moments)
  {
    words += row.gates * std::size_t(row.wordBits) / 8;
  }
  return (words > newBytes ? words - newBytes : 0) +
         DecodingBudget::JudgedGateCost * std::max(decoded.ray.Row(MomentName::REF).gates,
                                            decoded.ray.Row(MomentName::VEL).gates) +
         (this->MayBeginSweep(decoded.ray) ? DecodingBudget::SweepCost : 0) +
         DecodingBudget::DamageCost * decoded.problems.size();
}

bool RayCosts::MayBeginSweep(const Ray& ray)
{
  constexpr double longestTurn = 360.0; // less than that of a sweep
  turned += std::abs(std::remainder(static_cast<double>(ray.azimuth) - azimuth, 360.0));
  azimuth = static_cast<double>(ray.azimuth);
  const bool begins =
    ray.elevationNumber != elevationNumber || StartsCut(ray) || turned > longestTurn;
  elevationNumber = ray.elevationNumber;
  turned = begins ? 0.0 : turned;
  return begins;
}

FileDecoder::FileDecoder(VolumeAssembler& target, const Level2Options& theOptions)
  : assembler(target)
  , options(theOptions)
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
  if (stored.size() >= options.maximumFileBytes)
  {
    assembler.AddDamage(stored.size(), "the file is larger than its cap of " +
                                         std::to_string(options.maximumFileBytes) +
                                         " bytes; the rest is left");
  }
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
  const auto receive = [&](std::size_t index, Unpacked&& content)
  {
    const std::uint64_t offset = offsets.ToStored(records[index].offset);
    const std::size_t compressed = records[index].compressed.Size();
    this->Spend(DecodingBudget::StreamCost + DecodingBudget::CompressedByteCost * compressed +
                  content.bytes.size(),
      offset);
    this->DecodeRecord(std::move(content), offset);
  };
  BunzipInParallel(records, options.maximumRecordBytes, receive, options.threads);
}

void FileDecoder::DecodeRecord(Unpacked&& content, std::uint64_t storedOffset)
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
  bool isKept = false;
  const std::uint8_t* farthest = buffer->data(); // a message may be found within the one before
  while (const auto message = stream.Next())
  {
    const std::uint8_t* end = message->body.Data() + message->body.Size();
    const auto beyond = static_cast<std::size_t>(std::max(end, farthest) - farthest);
    this->DecodeMessage(
      *message, std::min(beyond, message->body.Size()), storedOffset(message->offset));
    farthest = std::max(end, farthest);
    if (!isKept && assembler.RayCount() > before)
    {
      assembler.AddBuffer(buffer);
      isKept = true;
    }
  }
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
    if (IsSyntheticMark(message.body))
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
  : assembler(theOptions)
  , decoder(assembler, theOptions)
{
}

void ChunkDecoder::Begin(int number, const std::string& name)
{
  assembler.BeginPiece(name);
  if (number > expected)
  {
    const auto missing = static_cast<std::size_t>(number - expected);
    assembler.AddDamage(0, CountText(missing, "chunk") + " missing before this one");
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
  decoder.Decode(std::move(stored));
}

RadarVolume ChunkDecoder::VolumeSoFar(const std::string& name) const
{
  VolumeAssembler copy = assembler;
  return copy.Finish(name, size);
}

} // namespace nexrad
