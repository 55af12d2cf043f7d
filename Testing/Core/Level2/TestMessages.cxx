// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Messages/MessageBodies.h"
#include "nexrad/Level2/Messages/MessageStream.h"

#include "Level2Bytes.h"
#include "Tolerance.h"

#include <gtest/gtest.h>

#include <limits>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr std::size_t headerBytes = 28;

// The body of a frame; the frame must outlive it.
ByteView BodyOf(const Bytes& frame)
{
  return View(frame).Sub(headerBytes);
}

std::vector<unsigned> Words(const MomentRow& row)
{
  std::vector<unsigned> words;
  for (std::size_t gate = 0; gate < row.gates; ++gate)
  {
    words.push_back(row.Raw(gate));
  }
  return words;
}

std::vector<unsigned> TypesOf(const Bytes& bytes, std::vector<Damage>* problems = nullptr)
{
  std::vector<Damage> found;
  MessageStream stream(View(bytes), KeepIn(found));
  std::vector<unsigned> types;
  while (const auto message = stream.Next())
  {
    types.push_back(message->type);
  }
  if (problems != nullptr)
  {
    *problems = found;
  }
  return types;
}

} // namespace

TEST(Message1, ReadsARay)
{
  RayPlan plan;
  plan.azimuth = 359.5;
  plan.elevation = -0.5;
  plan.number = 365;
  plan.cut = 4;
  const Bytes frame = MakeMessage1(plan);
  const DecodedRay decoded = DecodeMessage1(BodyOf(frame));
  const Ray& ray = decoded.ray;
  EXPECT_EQ(FormatIso8601(ray.time), "2005-08-21T02:43:19.671Z");
  EXPECT_WITHIN(ray.azimuth, 359.5, 0.05, "azimuth of message 1, degrees");
  EXPECT_WITHIN(ray.elevation, -0.5, 0.05, "elevation of message 1, degrees");
  EXPECT_FLOAT_EQ(ray.nyquist, 26.12F);
  EXPECT_EQ(ray.unambiguousRange, 148'000.0F);
  EXPECT_EQ(ray.radialStatus, 1);
  EXPECT_EQ(ray.elevationNumber, 4);
  EXPECT_EQ(decoded.azimuthNumber, 365U);
  EXPECT_EQ(decoded.coveragePatternNumber, 21);
  EXPECT_TRUE(decoded.problems.empty());
}

TEST(Message1, GivesEveryMomentItsGatesAndScale)
{
  const Bytes frame = MakeMessage1({});
  const DecodedRay decoded = DecodeMessage1(BodyOf(frame));
  const MomentRow& ref = decoded.ray.Row(MomentName::REF);
  EXPECT_EQ(Words(ref), (std::vector<unsigned>{0, 1, 2, 66, 255}));
  EXPECT_EQ(ref.firstGate, 0);
  EXPECT_EQ(ref.gateSpacing, 1000);
  EXPECT_EQ(ref.Value(4), 94.5F);
  const MomentRow& vel = decoded.ray.Row(MomentName::VEL);
  EXPECT_EQ(vel.firstGate, -375);
  EXPECT_EQ(vel.gateSpacing, 250);
  EXPECT_EQ(vel.Value(2), -63.5F);
  EXPECT_EQ(vel.Value(3), 0.0F);
  EXPECT_EQ(vel.State(1), GateState::RangeFolded);
  EXPECT_EQ(decoded.ray.Row(MomentName::SW).Value(5), 1.5F);
  EXPECT_EQ(decoded.ray.Row(MomentName::ZDR).gates, 0);
}

TEST(Message1, ReadsVelocityInWholeMetresASecond)
{
  RayPlan plan;
  plan.velocityResolution = 4;
  const Bytes frame = MakeMessage1(plan);
  const DecodedRay decoded = DecodeMessage1(BodyOf(frame));
  EXPECT_EQ(decoded.ray.Row(MomentName::VEL).Value(5), 2.0F);
  EXPECT_EQ(decoded.ray.Row(MomentName::SW).Value(5), 1.5F);
}

TEST(Message1, LacksAMomentWithoutBinsOrPointer)
{
  RayPlan plan;
  plan.vel.clear();
  plan.width.clear();
  const Bytes frame = MakeMessage1(plan);
  const DecodedRay decoded = DecodeMessage1(BodyOf(frame));
  EXPECT_EQ(decoded.ray.Row(MomentName::VEL).gates, 0);
  EXPECT_TRUE(decoded.problems.empty());
}

TEST(Message1, NamesAMomentThatDoesNotLieInItsMessage)
{
  const Bytes frame = MakeMessage1({});
  const ByteView body = BodyOf(frame).Sub(0, 113); // up to the middle of the width
  const DecodedRay decoded = DecodeMessage1(body);
  EXPECT_EQ(decoded.ray.Row(MomentName::VEL).gates, 6);
  EXPECT_EQ(decoded.ray.Row(MomentName::SW).gates, 0);
  ASSERT_EQ(decoded.problems.size(), 1U);
  EXPECT_EQ(decoded.problems[0], "SW does not lie within its message");
}

TEST(Message1, RefusesWhatIsNoRay)
{
  const auto decode = [](RayPlan plan)
  {
    const Bytes frame = MakeMessage1(plan);
    return DecodeMessage1(BodyOf(frame));
  };
  RayPlan plan;
  plan.elevation = -10.1;
  EXPECT_THROW(decode(plan), MessageError);
  plan.elevation = 91.0;
  EXPECT_THROW(decode(plan), MessageError);
  plan = {};
  plan.cut = 256 + 1; // not 1
  EXPECT_THROW(decode(plan), MessageError);
  plan = {};
  plan.status = 6;
  EXPECT_THROW(decode(plan), MessageError);
  plan = {};
  plan.milliseconds = 86'401'000;
  EXPECT_THROW(decode(plan), MessageError);
  plan = {};
  plan.day = 0;
  EXPECT_THROW(decode(plan), MessageError);
}

TEST(Message31, ReadsARayAndItsSite)
{
  RayPlan plan;
  plan.azimuth = 123.25;
  plan.elevation = 19.5;
  plan.status = 0x83; // the radar holds the ray to be poor; it starts a volume all the same
  const Bytes frame = MakeMessage31(plan);
  const DecodedRay decoded = DecodeMessage31(BodyOf(frame));
  EXPECT_EQ(decoded.ray.azimuth, 123.25F);
  EXPECT_EQ(decoded.ray.elevation, 19.5F);
  EXPECT_EQ(decoded.ray.radialStatus, 3);
  EXPECT_FLOAT_EQ(decoded.ray.nyquist, 26.12F);
  EXPECT_EQ(decoded.ray.unambiguousRange, 148'000.0F);
  EXPECT_EQ(decoded.siteName, "KTLX");
  EXPECT_EQ(decoded.coveragePatternNumber, 21);
  ASSERT_TRUE(decoded.position);
  EXPECT_FLOAT_EQ(static_cast<float>(decoded.position->latitude), 35.33F);
  EXPECT_EQ(decoded.position->siteHeight, 370);
  EXPECT_EQ(decoded.position->feedhornHeight, 20);
}

TEST(Message31, ReadsEveryMomentIn8And16Bits)
{
  RayPlan plan;
  plan.moments.clear();
  for (const MomentName name : AllMoments)
  {
    MomentPlan narrow;
    narrow.name = ToString(name);
    plan.moments.push_back(narrow);
  }
  plan.moments[4].wordBits = 16; // PHI
  plan.moments[4].gates = 2;
  plan.moments[4].words = {0, 1, 3, 0xFF};
  plan.moments[4].scale = 2.8361F;
  plan.moments[4].offset = 2.0F;
  plan.moments[4].firstGate = -375;
  const Bytes frame = MakeMessage31(plan);
  const DecodedRay decoded = DecodeMessage31(BodyOf(frame));
  EXPECT_TRUE(decoded.problems.empty());
  for (const MomentName name : AllMoments)
  {
    EXPECT_EQ(decoded.ray.Row(name).gates, name == MomentName::PHI ? 2 : 5) << ToString(name);
  }
  const MomentRow& phi = decoded.ray.Row(MomentName::PHI);
  EXPECT_EQ(Words(phi), (std::vector<unsigned>{1, 1023}));
  EXPECT_EQ(phi.State(0), GateState::RangeFolded);
  EXPECT_FLOAT_EQ(phi.Value(1), 1021.0F / 2.8361F);
  EXPECT_EQ(phi.firstGate, -375);
}

TEST(Message31, KeepsTheClutterFiltersCodesApart)
{
  RayPlan plan;
  plan.moments[0].name = "CFP";
  plan.moments[0].words = {0, 1, 7, 8, 20};
  plan.moments[0].scale = 1.0F;
  plan.moments[0].offset = 8.0F;
  const Bytes frame = MakeMessage31(plan);
  const DecodedRay decoded = DecodeMessage31(BodyOf(frame));
  const MomentRow& row = decoded.ray.Row(MomentName::CFP);
  EXPECT_EQ(row.State(1), GateState::BelowThreshold); // a code, not a folded gate
  EXPECT_EQ(row.State(2), GateState::BelowThreshold);
  EXPECT_EQ(row.State(3), GateState::Valid);
  EXPECT_EQ(row.Value(3), 0.0F);
}

TEST(Message31, PassesOverMomentsOfOtherNames)
{
  RayPlan plan;
  plan.moments.push_back({});
  plan.moments[0].name = "XYZ";
  const Bytes frame = MakeMessage31(plan);
  const DecodedRay decoded = DecodeMessage31(BodyOf(frame));
  EXPECT_EQ(decoded.ray.Row(MomentName::REF).gates, 5);
  EXPECT_TRUE(decoded.problems.empty());
}

TEST(Message31, NamesMomentsThatMakeNoSense)
{
  const auto problemOf = [](auto change)
  {
    RayPlan plan;
    change(plan.moments[0]);
    const Bytes frame = MakeMessage31(plan);
    const DecodedRay decoded = DecodeMessage31(BodyOf(frame));
    EXPECT_EQ(decoded.ray.Row(MomentName::REF).gates, 0);
    return decoded.problems.empty() ? std::string() : decoded.problems.front();
  };
  EXPECT_EQ(problemOf([](MomentPlan& moment) { moment.wordBits = 12; }),
    "REF has words of neither 8 nor 16 bits");
  EXPECT_EQ(
    problemOf([](MomentPlan& moment) { moment.gates = 7; }), "REF does not lie within its message");
  EXPECT_EQ(
    problemOf([](MomentPlan& moment) { moment.spacing = 0; }), "REF has gates of no length");
  EXPECT_EQ(problemOf([](MomentPlan& moment) { moment.scale = 0.0F; }),
    "REF has a scale or an offset that cannot be");
  EXPECT_EQ(problemOf([](MomentPlan& moment) { moment.gates = 0; }), "");
}

TEST(Message31, RefusesWhatIsNoRay)
{
  const auto decode = [](const RayPlan& plan)
  {
    const Bytes frame = MakeMessage31(plan);
    return DecodeMessage31(BodyOf(frame));
  };
  for (const double angle : {std::numeric_limits<double>::quiet_NaN(), -1.0, 360.5, 1e30})
  {
    RayPlan plan;
    plan.azimuth = angle;
    EXPECT_THROW(decode(plan), MessageError) << angle;
  }
  RayPlan plan;
  plan.elevation = -10.1;
  EXPECT_THROW(decode(plan), MessageError);
  EXPECT_THROW(DecodeMessage31(View(Bytes(20))), std::exception);
}

TEST(Message5, ReadsACoveragePattern)
{
  const Bytes frame = MakeMessage5(212, {0.48, 19.51, 359.5});
  const auto pattern = DecodeMessage5(BodyOf(frame));
  ASSERT_TRUE(pattern);
  EXPECT_EQ(pattern->number, 212);
  ASSERT_EQ(pattern->cuts.size(), 3U);
  EXPECT_WITHIN(pattern->cuts[0].elevation, 0.48, 0.05, "elevation of the first cut, degrees");
  EXPECT_WITHIN(pattern->cuts[2].elevation, -0.5, 0.05, "elevation of the third cut, degrees");
  EXPECT_EQ(pattern->cuts[1].waveform, Waveform::ContiguousSurveillance);
  EXPECT_TRUE(pattern->cuts[1].superResolution);
  EXPECT_DOUBLE_EQ(pattern->cuts[1].azimuthRate, 11.25);
}

TEST(Message5, HoldsNothingWhenFilledWithZerosOrCut)
{
  EXPECT_FALSE(DecodeMessage5(View(Bytes(2404))));
  const Bytes frame = MakeMessage5(21, {0.5, 1.5});
  EXPECT_FALSE(DecodeMessage5(BodyOf(frame).Sub(0, 100)));
  EXPECT_FALSE(DecodeMessage5(ByteView()));
}

TEST(Message2, ReadsPatternAndBuild)
{
  EXPECT_EQ(DecodeMessage2(BodyOf(MakeMessage2(-21, 1910)))->coveragePatternNumber, 21);
  EXPECT_DOUBLE_EQ(DecodeMessage2(BodyOf(MakeMessage2(21, 1910)))->softwareBuild, 19.1);
  EXPECT_DOUBLE_EQ(DecodeMessage2(BodyOf(MakeMessage2(21, 103)))->softwareBuild, 10.3);
  EXPECT_FALSE(DecodeMessage2(ByteView()));
}

TEST(MessageStream, CutsFramesOfBothKinds)
{
  const Bytes stream = Join({MakeMessage2(21, 1900), Bytes(2432), MakeMessage31({}),
    MakeMessage1({}), MakeFrame(18, {}), MakeMessage31({})});
  std::vector<Damage> problems;
  EXPECT_EQ(TypesOf(stream, &problems), (std::vector<unsigned>{2, 31, 1, 18, 31}));
  EXPECT_TRUE(problems.empty());
}

TEST(MessageStream, GoesOnBehindGarbage)
{
  const Bytes stream =
    Join({MakeMessage1({}), Bytes(1001, 0x55), MakeMessage1({}), MakeMessage1({})});
  std::vector<Damage> problems;
  EXPECT_EQ(TypesOf(stream, &problems), (std::vector<unsigned>{1, 1, 1}));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].offset, 2432U);
  EXPECT_EQ(problems[0].what, "1001 bytes that are no message");
}

TEST(MessageStream, GoesOnBehindAMessageThatIsCutShort)
{
  Bytes shorter = MakeMessage1({});
  shorter.resize(1500);
  std::vector<Damage> problems;
  const Bytes stream = Join({MakeMessage1({}), shorter, MakeMessage1({}), MakeMessage1({})});
  EXPECT_EQ(TypesOf(stream, &problems).size(), 4U);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].offset, 2432U + 1500U);
}

TEST(MessageStream, GoesOnBehindAnotherVolumeHeader)
{
  std::vector<Damage> problems;
  EXPECT_EQ(TypesOf(Join({MakeMessage1({}), MakeVolumeHeader(), MakeMessage1({})}), &problems),
    (std::vector<unsigned>{1, 1}));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].offset, 2432U);
}

TEST(MessageStream, ReadsTheLengthOfAVeryLongMessage)
{
  // A length of 65535 halfwords says that the segment fields hold the bytes.
  Bytes body(140'000);
  Bytes frame = MakeFrame(29, body);
  frame = BlockWriter(0)
            .Put(0, frame)
            .U16(12, 65535)
            .U16(24, static_cast<unsigned>((body.size() + 16) >> 16))
            .U16(26, (body.size() + 16) & 0xFFFF)
            .Take();
  EXPECT_EQ(TypesOf(Join({frame, MakeMessage1({})})), (std::vector<unsigned>{29, 1}));
}
