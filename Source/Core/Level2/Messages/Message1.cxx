// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Messages/Message1.h"

namespace nexrad
{

namespace
{

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

float DecodeElevation(unsigned code)
{
  const double angle = code * degreesPerCode;
  return static_cast<float>(angle > 180.0 ? angle - 360.0 : angle);
}

} // namespace

DecodedRay DecodeMessage1(ByteView body)
{
  DecodedRay decoded;
  Ray& ray = decoded.ray;
  ray.time = CheckedTime(body.U16(4), body.U32(0));
  ray.unambiguousRange = body.U16(6) * RangePerCode;
  ray.azimuth = static_cast<float>(body.U16(8) * degreesPerCode);
  decoded.azimuthNumber = body.U16(10);
  ray.elevation = DecodeElevation(body.U16(14));
  const unsigned status = body.U16(12);
  const unsigned elevationNumber = body.U16(16);
  // Saturated, so that a number too large for a byte fails its check.
  ray.radialStatus = static_cast<std::uint8_t>(status > 255 ? 255 : status);
  ray.elevationNumber = static_cast<std::uint8_t>(elevationNumber > 255 ? 255 : elevationNumber);
  CheckRay(ray);
  decoded.coveragePatternNumber = body.U16(44);
  ray.nyquist = static_cast<float>(body.U16(60) * NyquistPerCode);
  for (const MomentLayout& layout : layouts)
  {
    DecodeMoment(layout, body, decoded);
  }
  return decoded;
}

} // namespace nexrad
