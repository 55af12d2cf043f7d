// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Encoding/MetadataWriter.h"

#include "nexrad/Level2/Encoding/BigEndianWriter.h"
#include "nexrad/Level2/Messages/SyntheticMark.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
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

} // namespace nexrad
