// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorMessage.h"
#include "Tolerance.h"
#include "nexrad/Level2/Encoding/Level2Encoder.h"
#include "nexrad/Level2/Level2File.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace nexrad;
using nexrad::testing::MessageOf;

namespace
{

struct Gates
{
  MomentName name;
  int gates;
  int first;
  int spacing;
  int bits;
  float scale;
  float offset;
};

// A moment of every word from 0 up, in turn.
void AddMoment(RadarVolume& volume, Ray& ray, const Gates& gates)
{
  const std::size_t bytes = static_cast<std::size_t>(gates.gates * gates.bits / 8);
  auto words = std::make_shared<std::vector<std::uint8_t>>(bytes);
  for (std::size_t index = 0; index < bytes; ++index)
  {
    (*words)[index] = static_cast<std::uint8_t>(index * 7 + volume.buffers.size());
  }
  MomentRow& row = ray.Row(gates.name);
  row.words = words->data();
  row.gates = static_cast<std::uint16_t>(gates.gates);
  row.wordBits = static_cast<std::uint8_t>(gates.bits);
  row.firstValue = gates.name == MomentName::CFP ? 8 : 2;
  row.firstGate = gates.first;
  row.gateSpacing = gates.spacing;
  row.scale = gates.scale;
  row.offset = gates.offset;
  volume.buffers.push_back(words);
}

// Two cuts of `rays` rays each, with the moments that a function adds to a ray of a cut.
template <typename AddMoments>
RadarVolume MakeVolume(int messageType, int rays, const AddMoments& addMoments)
{
  RadarVolume volume;
  volume.site = {"KLSX", Position{38.698686, -90.682877, 220.1}};
  volume.coveragePatternNumber = 21;
  volume.coveragePattern =
    CoveragePattern{21, {{0.483, Waveform::ContiguousSurveillance, messageType == 31, 11.338},
                          {0.483, Waveform::ContiguousDoppler, messageType == 31, 11.36}}};
  volume.messageType = messageType;
  const Time start = *ParseIso8601("2006-03-12T23:59:50.125Z");
  volume.headerTime = start;
  for (int cut = 0; cut < 2; ++cut)
  {
    Sweep sweep;
    sweep.elevationNumber = cut + 1;
    for (int index = 0; index < rays; ++index)
    {
      Ray ray;
      ray.time = start + Duration(88 * (cut * rays + index));
      ray.azimuth = static_cast<float>(std::fmod(350.03 + index * 360.0 / rays, 360.0));
      ray.elevation = 0.47F + 0.001F * static_cast<float>(index % 20);
      ray.nyquist = cut == 1 ? 26.33F : 0.0F;
      ray.unambiguousRange = cut == 1 ? 148'000.0F : 466'000.0F;
      ray.elevationNumber = static_cast<std::uint8_t>(cut + 1);
      addMoments(volume, ray, cut);
      sweep.rays.push_back(ray);
    }
    sweep.rays.front().radialStatus = cut == 0 ? 3 : 0;
    sweep.rays.back().radialStatus = cut == 1 ? 4 : 2;
    volume.sweeps.push_back(sweep);
  }
  return volume;
}

RadarVolume MakeMessage1Volume(int rays = 130)
{
  return MakeVolume(1, rays,
    [](RadarVolume& volume, Ray& ray, int cut)
    {
      if (cut == 0)
      {
        AddMoment(volume, ray, {MomentName::REF, 460, 0, 1000, 8, 2.0F, 66.0F});
      }
      else
      {
        AddMoment(volume, ray, {MomentName::VEL, 920, -375, 250, 8, 2.0F, 129.0F});
        AddMoment(volume, ray, {MomentName::SW, 920, -375, 250, 8, 2.0F, 129.0F});
      }
    });
}

RadarVolume MakeMessage31Volume()
{
  return MakeVolume(31, 130,
    [](RadarVolume& volume, Ray& ray, int cut)
    {
      AddMoment(volume, ray, {MomentName::REF, 1832, 2125, 250, 8, 2.0F, 66.0F});
      if (cut == 0)
      {
        AddMoment(volume, ray, {MomentName::ZDR, 1191, 2125, 250, 16, 32.0F, 418.0F});
        AddMoment(volume, ray, {MomentName::PHI, 1192, 2125, 250, 16, 2.8361F, 2.0F});
        AddMoment(volume, ray, {MomentName::RHO, 1191, 2125, 250, 8, 300.0F, -60.5F});
        AddMoment(volume, ray, {MomentName::CFP, 1832, 2125, 250, 8, 1.0F, 8.0F});
      }
      else
      {
        AddMoment(volume, ray, {MomentName::VEL, 1192, -375, 250, 8, 2.0F, 129.0F});
        AddMoment(volume, ray, {MomentName::SW, 1192, -375, 250, 8, 2.0F, 129.0F});
      }
    });
}

void ExpectSameRow(const MomentRow& row, const MomentRow& expected, const std::string& where)
{
  ASSERT_EQ(row.gates, expected.gates) << where;
  if (row.gates == 0)
  {
    return;
  }
  EXPECT_EQ(row.wordBits, expected.wordBits) << where;
  EXPECT_EQ(row.firstValue, expected.firstValue) << where;
  EXPECT_EQ(row.firstGate, expected.firstGate) << where;
  EXPECT_EQ(row.gateSpacing, expected.gateSpacing) << where;
  EXPECT_FLOAT_EQ(row.scale, expected.scale) << where;
  EXPECT_FLOAT_EQ(row.offset, expected.offset) << where;
  const std::size_t bytes = static_cast<std::size_t>(row.gates) * row.wordBits / 8;
  EXPECT_TRUE(std::equal(row.words, row.words + bytes, expected.words)) << where;
}

void ExpectSameRays(const RadarVolume& volume, const RadarVolume& expected, double angleError)
{
  ASSERT_EQ(volume.sweeps.size(), expected.sweeps.size());
  for (std::size_t cut = 0; cut < volume.sweeps.size(); ++cut)
  {
    ASSERT_EQ(volume.sweeps[cut].rays.size(), expected.sweeps[cut].rays.size());
    for (std::size_t index = 0; index < volume.sweeps[cut].rays.size(); ++index)
    {
      const Ray& ray = volume.sweeps[cut].rays[index];
      const Ray& truth = expected.sweeps[cut].rays[index];
      const std::string where = "cut " + std::to_string(cut) + " ray " + std::to_string(index);
      EXPECT_EQ(ray.time, truth.time) << where;
      EXPECT_NEAR(std::remainder(ray.azimuth - truth.azimuth, 360.0), 0.0, angleError) << where;
      EXPECT_NEAR(ray.elevation, truth.elevation, angleError) << where;
      EXPECT_NEAR(ray.nyquist, truth.nyquist, 0.005) << where;
      EXPECT_EQ(ray.unambiguousRange, truth.unambiguousRange) << where;
      EXPECT_EQ(ray.radialStatus, truth.radialStatus) << where;
      EXPECT_EQ(ray.elevationNumber, truth.elevationNumber) << where;
      for (const MomentName name : AllMoments)
      {
        ExpectSameRow(ray.Row(name), truth.Row(name), where + " " + ToString(name));
      }
    }
  }
}

RadarVolume RoundTrip(const RadarVolume& volume, int messageType, Level2Container container)
{
  return DecodeLevel2(EncodeLevel2(volume, {messageType, container, 7}), "KLSX20060312_235950");
}

std::string EncodingError(const RadarVolume& volume, const Level2EncoderOptions& options)
{
  return MessageOf([&] { EncodeLevel2(volume, options); });
}

constexpr Level2Container allContainers[] = {
  Level2Container::Bare, Level2Container::Gzip, Level2Container::LdmBzip2};

constexpr double message1AngleError = 360.0 / 8192.0 / 2.0 + 1e-4; // half a step

} // namespace

TEST(Level2Encoder, Message1ComesBackFromEveryContainer)
{
  const RadarVolume volume = MakeMessage1Volume();
  for (const Level2Container container : allContainers)
  {
    const RadarVolume decoded = RoundTrip(volume, 1, container);
    EXPECT_TRUE(decoded.damage.empty()) << decoded.damage.front().what;
    EXPECT_TRUE(decoded.complete);
    EXPECT_EQ(decoded.messageType, 1);
    EXPECT_EQ(decoded.site.name, "KLSX");
    EXPECT_EQ(decoded.headerTime, volume.headerTime);
    EXPECT_EQ(decoded.coveragePatternNumber, 21);
    ExpectSameRays(decoded, volume, message1AngleError);
  }
}

TEST(Level2Encoder, Message31ComesBackFromEveryContainer)
{
  const RadarVolume volume = MakeMessage31Volume();
  for (const Level2Container container : allContainers)
  {
    const RadarVolume decoded = RoundTrip(volume, 31, container);
    EXPECT_TRUE(decoded.damage.empty()) << decoded.damage.front().what;
    EXPECT_TRUE(decoded.complete);
    EXPECT_EQ(decoded.messageType, 31);
    ASSERT_TRUE(decoded.site.position);
    EXPECT_NEAR(decoded.site.position->latitude, 38.698686, 1e-5);
    EXPECT_NEAR(decoded.site.position->longitude, -90.682877, 1e-5);
    EXPECT_WITHIN(decoded.site.position->altitude, 220.1, 0.2, "altitude that comes back, m");
    ExpectSameRays(decoded, volume, 1e-6);
  }
}

TEST(Level2Encoder, CoveragePatternComesBack)
{
  const RadarVolume volume = MakeMessage31Volume();
  const RadarVolume decoded = RoundTrip(volume, 31, Level2Container::Bare);
  ASSERT_TRUE(decoded.coveragePattern);
  EXPECT_EQ(decoded.coveragePattern->number, 21);
  ASSERT_EQ(decoded.coveragePattern->cuts.size(), 2U);
  for (std::size_t index = 0; index < 2; ++index)
  {
    const CoverageCut& cut = decoded.coveragePattern->cuts[index];
    const CoverageCut& truth = volume.coveragePattern->cuts[index];
    EXPECT_WITHIN(
      cut.elevation, truth.elevation, 0.00075, "elevation of a cut that comes back, degrees");
    EXPECT_EQ(cut.waveform, truth.waveform);
    EXPECT_TRUE(cut.superResolution);
    EXPECT_NEAR(cut.azimuthRate, truth.azimuthRate, 0.001);
  }
}

TEST(Level2Encoder, OnlyASyntheticVolumeIsMarkedSo)
{
  RadarVolume volume = MakeMessage1Volume(5);
  EXPECT_FALSE(RoundTrip(volume, 1, Level2Container::Bare).synthetic);
  volume.synthetic = true;
  EXPECT_TRUE(RoundTrip(volume, 1, Level2Container::Bare).synthetic);
  EXPECT_TRUE(RoundTrip(volume, 1, Level2Container::LdmBzip2).synthetic);
}

// The bytes as ICD 2620002 and 2620010 lay them out, worked out by hand.
TEST(Level2Encoder, BytesStandWhereTheDocumentsSay)
{
  const std::vector<std::uint8_t> bytes =
    EncodeLevel2(MakeMessage1Volume(), {1, Level2Container::Bare, 42});
  EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 12), "AR2V0001.042");
  const auto word = [&bytes](std::size_t offset)
  { return static_cast<unsigned>(bytes[offset] << 8 | bytes[offset + 1]); };
  EXPECT_EQ(word(12) << 16 | word(14), 13220U);    // 2006-03-12
  EXPECT_EQ(word(16) << 16 | word(18), 86390125U); // 23:59:50.125
  EXPECT_EQ(std::string(bytes.begin() + 20, bytes.begin() + 24), "KLSX");
  EXPECT_EQ(bytes.size(), 24U + (134U + 260U) * 2432U);
  const std::size_t header = 24 + 134 * 2432 + 12;
  EXPECT_EQ(word(header), 1208U);
  EXPECT_EQ(bytes[header + 3], 1U);
  const std::size_t body = header + 16;
  EXPECT_EQ(word(body + 6), 4660U);      // 466.0 km
  EXPECT_EQ(word(body + 8), 7965U * 8U); // 350.03 degrees in steps of 180/4096
  EXPECT_EQ(word(body + 12), 3U);        // start of volume
  EXPECT_EQ(word(body + 26), 460U);
  EXPECT_EQ(word(body + 36), 100U);
  EXPECT_EQ(word(body + 44), 21U);
}

TEST(Level2Encoder, RecordsHoldAHundredRaysAndTheLastLengthIsNegative)
{
  const std::vector<std::uint8_t> bytes = EncodeLevel2(MakeMessage1Volume());
  std::vector<std::int32_t> lengths;
  std::size_t offset = 24;
  while (offset + 4 <= bytes.size())
  {
    std::uint32_t length = 0;
    for (std::size_t byte = 0; byte < 4; ++byte)
    {
      length = length << 8 | bytes[offset + byte];
    }
    lengths.push_back(static_cast<std::int32_t>(length));
    EXPECT_EQ(std::string(bytes.begin() + static_cast<long>(offset) + 4,
                bytes.begin() + static_cast<long>(offset) + 7),
      "BZh");
    offset += 4 + static_cast<std::size_t>(std::abs(lengths.back()));
  }
  EXPECT_EQ(offset, bytes.size());
  ASSERT_EQ(lengths.size(), 4U); // metadata, 100 rays, 100 rays, 60 rays
  EXPECT_TRUE(std::all_of(lengths.begin(), lengths.end() - 1, [](auto size) { return size > 0; }));
  EXPECT_LT(lengths.back(), 0);
}

TEST(Level2Encoder, RefusesWhatTheMessageCannotHold)
{
  EXPECT_NE(EncodingError(MakeMessage31Volume(), {1}).find("1832 gates of REF"), std::string::npos);
  RadarVolume volume = MakeMessage1Volume(3);
  volume.sweeps[0].rays[1].Row(MomentName::ZDR) = volume.sweeps[0].rays[1].Row(MomentName::REF);
  EXPECT_NE(EncodingError(volume, {1}).find("ZDR"), std::string::npos);

  volume = MakeMessage1Volume(3);
  volume.sweeps[1].rays[2].Row(MomentName::SW).gates = 919;
  EXPECT_NE(EncodingError(volume, {1}).find("VEL and SW"), std::string::npos);

  volume = MakeMessage1Volume(3);
  volume.sweeps[0].rays[0].Row(MomentName::REF).offset = 64.0F;
  EXPECT_NE(EncodingError(volume, {1}).find("offset"), std::string::npos);

  volume = MakeMessage31Volume();
  volume.site.position.reset();
  EXPECT_NE(EncodingError(volume, {31}).find("position"), std::string::npos);

  volume = MakeMessage1Volume(3);
  volume.sweeps[0].rays[0].time = *ParseIso8601("1969-12-31");
  EXPECT_NE(EncodingError(volume, {1}).find("1970-01-01"), std::string::npos);
}

TEST(Level2Encoder, RefusesWrongOptions)
{
  const RadarVolume volume = MakeMessage1Volume(3);
  EXPECT_NE(EncodingError(volume, {2}).find("1 or 31"), std::string::npos);
  EXPECT_NE(
    EncodingError(volume, {1, Level2Container::Bare, 1000}).find("1 to 999"), std::string::npos);
}

TEST(Level2Encoder, AVolumeWithoutRaysIsAFileOfMetadata)
{
  RadarVolume volume;
  volume.site.name = "KLSX";
  for (const Level2Container container : allContainers)
  {
    const RadarVolume decoded = RoundTrip(volume, 1, container);
    EXPECT_TRUE(decoded.sweeps.empty());
    EXPECT_EQ(decoded.site.name, "KLSX");
  }
}
