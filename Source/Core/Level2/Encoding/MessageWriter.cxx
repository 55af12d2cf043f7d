// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Encoding/MessageWriter.h"

#include "nexrad/Level2/Messages/MessageBodies.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace nexrad
{

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

namespace
{

constexpr std::size_t communicationsHeaderBytes = 12; // CTM, without content
constexpr std::size_t messageHeaderBytes = 16;
constexpr std::size_t frameBytes = 2432; // of every message except 31

// Puts the 12 bytes of the CTM header and the message header (ICD 2620002, table II) before a
// body. All messages but 31 are padded to their frame, which the size field of message 1 counts.
MessageBytes WrapMessage(
  int type, unsigned sequence, Time time, const std::vector<std::uint8_t>& body)
{
  constexpr int message1 = 1;
  constexpr int message31 = 31;
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
  message.PadTo(type == message31 ? communicationsHeaderBytes + 2 * halfwords : frameBytes);
  return message.Take();
}

constexpr std::size_t metadataFrames = 134;
constexpr double angleUnit = 180.0 / 32768.0;      // degrees
constexpr double angularRateUnit = 22.5 / 16384.0; // degrees a second

// The three low bits of an angle are not used (ICD 2620002, tables III and XI).
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

MessageBytes WriteMetadata(const RadarVolume& volume, Time start)
{
  constexpr int status = 2;
  constexpr int pattern = 5;
  MessageBytes last;
  const auto put = [&](int type, const std::vector<std::uint8_t>& body)
  {
    const MessageBytes message = WrapMessage(type, 0, start, body);
    last.insert(last.end(), message.begin(), message.end());
  };
  if (volume.synthetic)
  {
    put(SyntheticMarkMessageType, MarkBody());
  }
  if (volume.coveragePattern)
  {
    put(pattern, PatternBody(*volume.coveragePattern));
  }
  put(status, StatusBody(volume));
  // Real files fill the frames before with clutter maps, which the model does not keep.
  MessageBytes frames(metadataFrames * frameBytes - last.size());
  frames.insert(frames.end(), last.begin(), last.end());
  return frames;
}

namespace
{

constexpr double wavelength = 0.104;       // m, of a WSR-88D
constexpr double lightSpeed = 299'792'458; // m/s
constexpr unsigned overlayThreshold = 50;  // 0.1 dB

// What does not fit, in one line.
[[noreturn]] void Refuse(int messageType, const std::string& what)
{
  throw Error("Level II encoder: message " + std::to_string(messageType) + " cannot hold " + what);
}

// In 0.1 km. Where the ray has none it follows from the Nyquist velocity; a surveillance cut's, 466
// km, where there is neither that nor velocity.
unsigned UnambiguousRange(const Ray& ray)
{
  constexpr unsigned surveillance = 4660;
  if (ray.unambiguousRange > 0.0F)
  {
    return static_cast<unsigned>(std::min(std::lround(ray.unambiguousRange / 100.0F), 65535L));
  }
  const bool doppler = ray.Row(MomentName::VEL).gates > 0 || ray.Row(MomentName::SW).gates > 0;
  if (!doppler || !(ray.nyquist > 0.0F))
  {
    return surveillance;
  }
  const double metres = wavelength * lightSpeed / (8.0 * static_cast<double>(ray.nyquist));
  return static_cast<unsigned>(std::min(std::lround(metres / 100.0), 65535L));
}

unsigned NyquistCode(const Ray& ray)
{
  return static_cast<unsigned>(std::lround(ray.nyquist * 100.0F)) & 0xffffU;
}

// Message 1 has fixed numbers of gates and fixed codes.
void CheckMessage1Row(const MomentRow& row, MomentName name)
{
  constexpr unsigned mostReflectivityGates = 460;
  constexpr unsigned mostDopplerGates = 920;
  const std::string text = ToString(name);
  if (row.gates == 0)
  {
    return;
  }
  if (name != MomentName::REF && name != MomentName::VEL && name != MomentName::SW)
  {
    Refuse(1, text + "; use message 31");
  }
  const unsigned most = name == MomentName::REF ? mostReflectivityGates : mostDopplerGates;
  if (row.gates > most)
  {
    Refuse(1, std::to_string(row.gates) + " gates of " + text + "; at most " +
                std::to_string(most) + " fit");
  }
  const bool coarseVelocity = name == MomentName::VEL && row.scale == 1.0F;
  const float offset = name == MomentName::REF ? 66.0F : 129.0F;
  if (row.wordBits != 8 || row.offset != offset || !(row.scale == 2.0F || coarseVelocity))
  {
    Refuse(1, text + " in " + std::to_string(row.wordBits) + " bits with scale " +
                std::to_string(row.scale) + " and offset " + std::to_string(row.offset));
  }
}

void CheckMessage1(const Ray& ray)
{
  for (const MomentName name : AllMoments)
  {
    CheckMessage1Row(ray.Row(name), name);
  }
  const MomentRow& velocity = ray.Row(MomentName::VEL);
  const MomentRow& width = ray.Row(MomentName::SW);
  if (velocity.gates > 0 && width.gates > 0 && !velocity.HasGatesOf(width))
  {
    Refuse(1, "different gates of VEL and SW");
  }
}

void PutWords(BigEndianWriter& body, const MomentRow& row)
{
  body.PutBytes(row.words, static_cast<std::size_t>(row.gates) * row.wordBits / 8);
}

// Where the words of a moment begin, from the start of the message's body; 0: it has none.
unsigned Pointer(const MomentRow& row, std::size_t& end)
{
  const std::size_t begin = end;
  end += row.gates;
  return row.gates > 0 ? static_cast<unsigned>(begin) : 0U;
}

constexpr std::size_t dataHeaderBytes = 68; // with nine pointers, as builds up to 17 have it
constexpr unsigned volumeBlockBytes = 44;
constexpr unsigned elevationBlockBytes = 12;
constexpr unsigned radialBlockBytes = 20;

void PutVolumeBlock(BigEndianWriter& body, const RadarVolume& volume)
{
  constexpr long feedhornHeight = 30; // m; the model keeps the antenna's height alone
  if (!volume.site.position)
  {
    Refuse(31, "a site without a position");
  }
  const Position& position = *volume.site.position;
  body.PutText("RVOL", 4);
  body.Put16(volumeBlockBytes);
  body.Put8(1);
  body.Put8(0);
  body.PutFloat(static_cast<float>(position.latitude));
  body.PutFloat(static_cast<float>(position.longitude));
  body.PutSigned16(static_cast<int>(std::lround(position.altitude) - feedhornHeight));
  body.Put16(feedhornHeight);
  body.PutZeros(20);
  body.Put16(static_cast<unsigned>(volume.coveragePatternNumber.value_or(0)) & 0xffffU);
  body.Put16(0);
}

void PutRadialConstants(BigEndianWriter& body, const Ray& ray)
{
  constexpr int attenuation = -12; // 0.001 dB a km
  body.PutText("RELV", 4);
  body.Put16(elevationBlockBytes);
  body.PutSigned16(attenuation);
  body.PutFloat(0.0F);
  body.PutText("RRAD", 4);
  body.Put16(radialBlockBytes);
  body.Put16(UnambiguousRange(ray));
  body.PutFloat(0.0F);
  body.PutFloat(0.0F);
  body.Put16(NyquistCode(ray));
  body.Put16(0);
}

void PutMomentBlock(BigEndianWriter& body, const MomentRow& row, MomentName name)
{
  constexpr unsigned signalThreshold = 16; // 0.125 dB
  if (row.firstGate < -32768 || row.firstGate > 32767 || row.gateSpacing < 0 ||
      row.gateSpacing > 65535)
  {
    Refuse(31, std::string("gates of ") + ToString(name) + " that begin at " +
                 std::to_string(row.firstGate) + " m and step by " +
                 std::to_string(row.gateSpacing) + " m");
  }
  body.PutText(std::string("D") + ToString(name), 4);
  body.Put32(0);
  body.Put16(row.gates);
  body.PutSigned16(row.firstGate);
  body.Put16(static_cast<unsigned>(row.gateSpacing));
  body.Put16(overlayThreshold);
  body.Put16(signalThreshold);
  body.Put8(0);
  body.Put8(row.wordBits);
  body.PutFloat(row.scale);
  body.PutFloat(row.offset);
  PutWords(body, row);
}

// Message 31's data header (ICD 2620002, table XVII-A), with the pointers to the blocks.
std::vector<std::uint8_t> DataHeader(const RadarVolume& volume, const Sweep& sweep, unsigned index,
  const std::vector<std::size_t>& pointers, std::size_t length)
{
  constexpr std::size_t superResolutionRays = 480; // in a turn: half-degree rays from here on
  const Ray& ray = sweep.rays[index];
  const bool halfDegree = sweep.rays.size() > superResolutionRays;
  const Level2Date date = ToLevel2Date(ray.time);
  BigEndianWriter header;
  header.PutText(volume.site.name, 4);
  header.Put32(date.milliseconds);
  header.Put16(date.days);
  header.Put16(index + 1);
  header.PutFloat(ray.azimuth);
  header.Put8(0);
  header.Put8(0);
  header.Put16(static_cast<unsigned>(length));
  header.Put8(halfDegree ? 1 : 2);
  header.Put8(ray.radialStatus);
  header.Put8(ray.elevationNumber);
  header.Put8(1);
  header.PutFloat(ray.elevation);
  header.Put8(0);
  header.Put8(halfDegree ? 25 : 50);
  header.Put16(static_cast<unsigned>(pointers.size()));
  for (const std::size_t pointer : pointers)
  {
    header.Put32(static_cast<std::uint32_t>(pointer));
  }
  header.PadTo(dataHeaderBytes);
  return header.Take();
}

} // namespace

MessageBytes WriteMessage1(
  const RadarVolume& volume, const Ray& ray, unsigned index, unsigned sequence)
{
  constexpr std::size_t headerBytes = 100;
  constexpr unsigned halfMetre = 2;
  constexpr unsigned oneMetre = 4;
  CheckMessage1(ray);
  const MomentRow& reflectivity = ray.Row(MomentName::REF);
  const MomentRow& velocity = ray.Row(MomentName::VEL);
  const MomentRow& width = ray.Row(MomentName::SW);
  const MomentRow& doppler = velocity.gates > 0 ? velocity : width;
  const Level2Date date = ToLevel2Date(ray.time);
  std::size_t end = headerBytes;
  const unsigned pointers[] = {
    Pointer(reflectivity, end), Pointer(velocity, end), Pointer(width, end)};

  BigEndianWriter body;
  body.Put32(date.milliseconds);
  body.Put16(date.days);
  body.Put16(UnambiguousRange(ray));
  body.Put16(CodeAngle(static_cast<double>(ray.azimuth)));
  body.Put16(index + 1);
  body.Put16(ray.radialStatus);
  body.Put16(CodeAngle(static_cast<double>(ray.elevation)));
  body.Put16(ray.elevationNumber);
  body.PutSigned16(reflectivity.firstGate);
  body.PutSigned16(doppler.firstGate);
  body.Put16(static_cast<unsigned>(reflectivity.gateSpacing));
  body.Put16(static_cast<unsigned>(doppler.gateSpacing));
  body.Put16(reflectivity.gates);
  body.Put16(doppler.gates);
  body.Put16(1);
  body.PutFloat(0.0F);
  for (const unsigned pointer : pointers)
  {
    body.Put16(pointer);
  }
  body.Put16(velocity.gates == 0 ? 0 : velocity.scale == 1.0F ? oneMetre : halfMetre);
  body.Put16(static_cast<unsigned>(volume.coveragePatternNumber.value_or(0)) & 0xffffU);
  body.PutZeros(14);
  body.Put16(NyquistCode(ray));
  body.Put16(0);
  body.Put16(overlayThreshold);
  body.PadTo(headerBytes);
  PutWords(body, reflectivity);
  PutWords(body, velocity);
  PutWords(body, width);
  return WrapMessage(1, sequence, ray.time, body.Bytes());
}

MessageBytes WriteMessage31(
  const RadarVolume& volume, const Sweep& sweep, unsigned index, unsigned sequence)
{
  constexpr std::size_t mostBlocks = 9;
  const Ray& ray = sweep.rays[index];
  BigEndianWriter blocks;
  std::vector<std::size_t> pointers = {dataHeaderBytes, dataHeaderBytes + volumeBlockBytes,
    dataHeaderBytes + volumeBlockBytes + elevationBlockBytes};
  PutVolumeBlock(blocks, volume);
  PutRadialConstants(blocks, ray);
  for (const MomentName name : AllMoments)
  {
    if (ray.Row(name).gates > 0)
    {
      pointers.push_back(dataHeaderBytes + blocks.Size());
      PutMomentBlock(blocks, ray.Row(name), name);
    }
  }
  if (pointers.size() > mostBlocks)
  {
    Refuse(31, "more than six moments in one ray");
  }
  const std::size_t length = dataHeaderBytes + blocks.Size();
  std::vector<std::uint8_t> body = DataHeader(volume, sweep, index, pointers, length);
  body.insert(body.end(), blocks.Bytes().begin(), blocks.Bytes().end());
  return WrapMessage(31, sequence, ray.time, body);
}

} // namespace nexrad
