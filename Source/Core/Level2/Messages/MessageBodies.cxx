// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Messages/MessageBodies.h"

#include "nexrad/Level2/Messages/VolumeHeader.h"

#include <cmath>
#include <cstdlib>

namespace nexrad
{

namespace
{

// What a code of messages 1 and 31 stands for: m/s of the Nyquist velocity, m of a range.
constexpr double nyquistPerCode = 0.01;
constexpr float rangePerCode = 100.0F;
constexpr std::uint8_t lastRadialStatus = 5;
constexpr std::uint8_t lastElevationNumber = 32; // ICD 2620002, tables III and XVII-A

bool IsWithin(float angle, float lowest, float highest)
{
  return std::isfinite(angle) && angle >= lowest && angle <= highest;
}

// What every ray must have. Throws MessageError.
void CheckRay(const Ray& ray)
{
  if (!IsWithin(ray.azimuth, 0.0F, 360.0F))
  {
    throw MessageError("a ray whose azimuth is not within 0 to 360 degrees");
  }
  if (!IsWithin(ray.elevation, -10.0F, 90.0F))
  {
    throw MessageError("a ray whose elevation is not within -10 to 90 degrees");
  }
  if (ray.elevationNumber < 1 || ray.elevationNumber > lastElevationNumber)
  {
    throw MessageError("a ray whose elevation number is not within 1 to 32");
  }
  if (ray.radialStatus > lastRadialStatus)
  {
    throw MessageError("a ray whose radial status is not within 0 to 5");
  }
}

Time CheckedTime(std::uint32_t day, std::uint32_t milliseconds)
{
  constexpr std::uint32_t lastDay = 40'000;                // in the year 2079
  constexpr std::uint32_t longestDay = 86'400'000 + 1'000; // with a leap second
  if (day < 1 || day > lastDay || milliseconds >= longestDay)
  {
    throw MessageError("a ray whose date or time of day cannot be");
  }
  return FromLevel2Date(day, milliseconds);
}

constexpr double degreesPerCode = 180.0 / 32768.0;

struct MomentLayout
{
  MomentName name;
  std::size_t pointer;   // place of the moment's offset in the body
  std::size_t firstGate; // of the first gate's range, m, signed
  std::size_t spacing;   // of the distance between gates, m
  std::size_t count;     // of the number of gates
};

// Reflectivity has its own gates, velocity and spectrum width share theirs.
constexpr MomentLayout layouts[] = {{MomentName::REF, 36, 18, 22, 26},
  {MomentName::VEL, 38, 20, 24, 28}, {MomentName::SW, 40, 20, 24, 28}};

constexpr std::size_t velocityResolutionPlace = 42;
constexpr unsigned wholeMetresPerSecond = 4; // the code of 1 m/s; 2 is that of 0.5 m/s

void SetScale(MomentRow& row, MomentName name, ByteView body)
{
  const bool coarse =
    name == MomentName::VEL && body.U16(velocityResolutionPlace) == wholeMetresPerSecond;
  row.scale = coarse ? 1.0F : 2.0F;
  row.offset = name == MomentName::REF ? 66.0F : 129.0F;
}

void DecodeMoment(const MomentLayout& layout, ByteView body, DecodedRay& decoded)
{
  const std::size_t offset = body.U16(layout.pointer);
  const std::uint16_t gates = body.U16(layout.count);
  const int spacing = body.U16(layout.spacing);
  if (offset == 0 || gates == 0)
  {
    return;
  }
  if (!body.Has(offset, gates) || spacing == 0)
  {
    decoded.problems.push_back(
      std::string(ToString(layout.name)) +
      (spacing == 0 ? " has gates of no length" : " does not lie within its message"));
    return;
  }
  MomentRow& row = decoded.ray.Row(layout.name);
  row.words = body.Data() + offset;
  row.gates = gates;
  row.firstGate = body.I16(layout.firstGate);
  row.gateSpacing = spacing;
  SetScale(row, layout.name, body);
}

double DecodeElevation(unsigned code)
{
  const double angle = code * degreesPerCode;
  return angle > 180.0 ? angle - 360.0 : angle;
}

} // namespace

DecodedRay DecodeMessage1(ByteView body)
{
  DecodedRay decoded;
  Ray& ray = decoded.ray;
  ray.time = CheckedTime(body.U16(4), body.U32(0));
  ray.unambiguousRange = body.U16(6) * rangePerCode;
  ray.azimuth = static_cast<float>(body.U16(8) * degreesPerCode);
  decoded.azimuthNumber = body.U16(10);
  ray.elevation = static_cast<float>(DecodeElevation(body.U16(14)));
  const unsigned status = body.U16(12);
  const unsigned elevationNumber = body.U16(16);
  // Saturated, so that a number too large for a byte fails its check.
  ray.radialStatus = static_cast<std::uint8_t>(status > 255 ? 255 : status);
  ray.elevationNumber = static_cast<std::uint8_t>(elevationNumber > 255 ? 255 : elevationNumber);
  CheckRay(ray);
  decoded.coveragePatternNumber = body.U16(44);
  ray.nyquist = static_cast<float>(body.U16(60) * nyquistPerCode);
  for (const MomentLayout& layout : layouts)
  {
    DecodeMoment(layout, body, decoded);
  }
  return decoded;
}

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
    decoded.ray.unambiguousRange = block.U16(6) * rangePerCode;
    decoded.ray.nyquist = static_cast<float>(block.U16(16) * nyquistPerCode);
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

std::optional<RadarStatus> DecodeMessage2(ByteView body)
{
  constexpr std::size_t usedBytes = 20;
  if (!body.Has(0, usedBytes))
  {
    return std::nullopt;
  }
  RadarStatus status;
  // Negative when the pattern was chosen at the radar.
  status.coveragePatternNumber = std::abs(int(body.I16(14)));
  // Hundredths since build 11; tenths before, when that gives no build below 2.
  const double build = body.U16(18);
  status.softwareBuild = build / 100.0 > 2.0 ? build / 100.0 : build / 10.0;
  return status;
}

namespace
{

constexpr std::size_t patternHeaderBytes = 22;
constexpr std::size_t cutBytes = 46;
constexpr double rateOfHighestBit = 22.5; // degrees a second, bit 14; bit 15 is the sign
constexpr double ratePerCode = rateOfHighestBit / 16384.0;
constexpr unsigned halfDegreeAzimuths = 1;

CoverageCut DecodeCut(ByteView cut)
{
  CoverageCut result;
  result.elevation = DecodeElevation(cut.U16(0));
  const unsigned waveform = cut.U8(3);
  result.waveform = waveform <= static_cast<unsigned>(Waveform::StaggeredPulsePair)
                      ? static_cast<Waveform>(waveform)
                      : Waveform::Unknown;
  result.superResolution = (cut.U8(4) & halfDegreeAzimuths) != 0;
  result.azimuthRate = cut.I16(8) * ratePerCode;
  return result;
}

} // namespace

std::optional<CoveragePattern> DecodeMessage5(ByteView body)
{
  if (!body.Has(0, patternHeaderBytes))
  {
    return std::nullopt;
  }
  const unsigned cuts = body.U16(6);
  if (cuts == 0 || body.U16(4) == 0 || !body.Has(patternHeaderBytes, cutBytes * cuts) ||
      std::size_t(2) * body.U16(0) < patternHeaderBytes + cutBytes * cuts)
  {
    return std::nullopt;
  }
  CoveragePattern pattern;
  pattern.number = body.U16(4);
  for (unsigned index = 0; index < cuts; ++index)
  {
    pattern.cuts.push_back(DecodeCut(body.Sub(patternHeaderBytes + cutBytes * index, cutBytes)));
  }
  return pattern;
}

bool IsSyntheticMark(ByteView body)
{
  return body.Has(0, 2) && body.U16(0) >= SyntheticMarkText.size() &&
         body.StartsWith(SyntheticMarkText.data(), 2);
}

} // namespace nexrad
