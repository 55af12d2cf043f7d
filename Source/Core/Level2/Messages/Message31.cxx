// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Messages/Message31.h"

#include "nexrad/Level2/Messages/VolumeHeader.h"

#include <cmath>

namespace nexrad
{

namespace
{

constexpr std::size_t pointersPlace = 32;
constexpr unsigned mostBlocks = 16; // the format has ten; room for new ones
constexpr std::size_t momentHeaderBytes = 28;
constexpr std::size_t volumeBlockBytes = 42; // up to and with the coverage pattern
constexpr std::size_t radialBlockBytes = 18; // up to and with the Nyquist velocity

std::string BlockName(ByteView block)
{
  std::string name;
  for (std::size_t place = 1; place < 4 && block.U8(place) != ' '; ++place)
  {
    name += static_cast<char>(block.U8(place));
  }
  return name;
}

void DecodeVolumeBlock(ByteView block, DecodedRay& decoded)
{
  StoredPosition position;
  position.latitude = block.F32(8);
  position.longitude = block.F32(12);
  position.siteHeight = block.I16(16);
  position.feedhornHeight = block.U16(18);
  decoded.position = position;
  decoded.coveragePatternNumber = block.U16(40);
}

// What is wrong with a moment's header, or nullptr.
const char* FindMomentFault(ByteView block)
{
  const unsigned wordBits = block.U8(19);
  const float scale = block.F32(20);
  if (wordBits != 8 && wordBits != 16)
  {
    return "has words of neither 8 nor 16 bits";
  }
  if (!block.Has(momentHeaderBytes, std::size_t(block.U16(8)) * wordBits / 8))
  {
    return "does not lie within its message";
  }
  if (block.U16(12) == 0)
  {
    return "has gates of no length";
  }
  return std::isfinite(scale) && scale != 0.0F && std::isfinite(block.F32(24))
           ? nullptr
           : "has a scale or an offset that cannot be";
}

void DecodeMoment(MomentName name, ByteView block, DecodedRay& decoded)
{
  if (block.Size() < momentHeaderBytes)
  {
    decoded.problems.push_back(std::string(ToString(name)) + " does not lie within its message");
    return;
  }
  const unsigned gates = block.U16(8);
  if (gates == 0)
  {
    return;
  }
  if (const char* fault = FindMomentFault(block))
  {
    decoded.problems.push_back(std::string(ToString(name)) + ' ' + fault);
    return;
  }
  constexpr std::uint8_t firstClutterPower = 8; // below are codes that say what the filter did
  MomentRow& row = decoded.ray.Row(name);
  row.words = block.Data() + momentHeaderBytes;
  row.gates = static_cast<std::uint16_t>(gates);
  row.wordBits = block.U8(19);
  row.firstValue = name == MomentName::CFP ? firstClutterPower : row.firstValue;
  row.firstGate = block.I16(10);
  row.gateSpacing = block.U16(12);
  row.scale = block.F32(20);
  row.offset = block.F32(24);
}

void DecodeBlock(ByteView block, DecodedRay& decoded)
{
  const std::string name = BlockName(block);
  if (block.U8(0) == 'D')
  {
    const auto moment = ParseMomentName(name);
    if (moment && IsMeasured(*moment))
    {
      DecodeMoment(*moment, block, decoded);
    }
  }
  else if (name == "VOL" && block.Has(0, volumeBlockBytes))
  {
    DecodeVolumeBlock(block, decoded);
  }
  else if (name == "RAD" && block.Has(0, radialBlockBytes))
  {
    decoded.ray.unambiguousRange = block.U16(6) * RangePerCode;
    decoded.ray.nyquist = static_cast<float>(block.U16(16) * NyquistPerCode);
  }
}

void DecodeBlocks(ByteView body, DecodedRay& decoded)
{
  const unsigned blocks = body.U16(30);
  if (blocks > mostBlocks)
  {
    throw MessageError("a ray of more data blocks than the format has");
  }
  for (unsigned index = 0; index < blocks; ++index)
  {
    const std::size_t place = pointersPlace + std::size_t(4) * index;
    const std::uint32_t pointer = body.Has(place, 4) ? body.U32(place) : UINT32_MAX;
    if (pointer == 0)
    {
      continue;
    }
    if (body.Has(pointer, 4))
    {
      DecodeBlock(body.Sub(pointer), decoded);
    }
    else
    {
      decoded.problems.push_back("a data block does not lie within its message");
    }
  }
}

} // namespace

DecodedRay DecodeMessage31(ByteView body)
{
  DecodedRay decoded;
  Ray& ray = decoded.ray;
  decoded.siteName = ParseSiteName(body, 0);
  ray.time = CheckedTime(body.U16(8), body.U32(4));
  decoded.azimuthNumber = body.U16(10);
  ray.azimuth = body.F32(12);
  const unsigned compression = body.U8(16);
  // The upper half of the status marks rays that the radar itself holds to be poor; they count.
  ray.radialStatus = body.U8(21) & 0x0F;
  ray.elevationNumber = body.U8(22);
  ray.elevation = body.F32(24);
  CheckRay(ray);
  if (compression != 0)
  {
    throw MessageError("a ray that is compressed within its message, which no radar sends");
  }
  DecodeBlocks(body, decoded);
  return decoded;
}

} // namespace nexrad
