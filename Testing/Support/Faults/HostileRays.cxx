// SPDX-License-Identifier: BSD-3-Clause
#include "Faults/HostileRays.h"

#include <random>

namespace nexrad::testing
{

namespace
{

constexpr unsigned differentRays = 10'000;
constexpr std::size_t filledBytes = std::size_t(80) << 20;

// Rays that `change` makes different, repeated until they fill a file.
HostileFile RaysOf(const std::string& name, const std::function<void(RayPlan&, unsigned)>& change,
  unsigned type = 31, unsigned different = differentRays)
{
  return {name, [=]
    {
      Bytes rays;
      for (unsigned i = 0; i < different; ++i)
      {
        RayPlan ray;
        ray.number = i % 720 + 1;
        ray.azimuth = 0.5 * (i % 720);
        change(ray, i);
        const Bytes message = type == 1 ? MakeMessage1(ray) : MakeMessage31(ray);
        rays.insert(rays.end(), message.begin(), message.end());
      }
      return Join({Gzip(MakeVolumeHeader()), GzipOfRepeated(rays, filledBytes / rays.size() + 1)});
    }};
}

// A body whose data blocks are all the one at its end: `gates` words of each moment.
Bytes MakeSharedGates(unsigned gates)
{
  RayPlan ray;
  ray.moments.clear();
  for (const char* name : {"REF", "VEL", "SW ", "ZDR", "PHI", "RHO", "CFP"})
  {
    MomentPlan moment;
    moment.name = name;
    moment.words.clear();
    moment.gates = gates;
    ray.moments.push_back(moment);
  }
  Bytes message = MakeMessage31(ray);
  message.resize(message.size() + gates + gates % 2, 130);
  const std::size_t halfwords = (message.size() - 12) / 2;
  message[12] = static_cast<std::uint8_t>(halfwords >> 8);
  message[13] = static_cast<std::uint8_t>(halfwords);
  return message;
}

std::vector<MomentPlan> AllMomentPlans(unsigned gates)
{
  std::vector<MomentPlan> moments;
  for (const char* name : {"REF", "VEL", "SW ", "ZDR", "PHI", "RHO", "CFP"})
  {
    MomentPlan moment;
    moment.name = name;
    moment.gates = gates;
    moment.words = Bytes(gates, 130);
    moments.push_back(moment);
  }
  return moments;
}

// Rays without gates, and rays that begin something.
std::vector<HostileFile> MakeEmptyRays()
{
  return {RaysOf("rays-without-moments", [](RayPlan& ray, unsigned) { ray.moments.clear(); }),
    RaysOf("rays-without-gates",
      [](RayPlan& ray, unsigned)
      {
        ray.moments[0].gates = 0;
        ray.moments[0].words.clear();
      }),
    RaysOf(
      "message-1-without-moments",
      [](RayPlan& ray, unsigned)
      {
        ray.ref.clear();
        ray.vel.clear();
        ray.width.clear();
      },
      1, 720),
    RaysOf(
      "message-1-of-a-gate", [](RayPlan& ray, unsigned) { ray.ref = {66}; }, 1, 720),
    RaysOf("sweep-a-ray", [](RayPlan& ray, unsigned i) { ray.cut = i % 2 + 1; }),
    RaysOf("cut-a-ray", [](RayPlan& ray, unsigned i) { ray.cut = i % 32 + 1; }),
    RaysOf("start-of-cut-a-ray", [](RayPlan& ray, unsigned) { ray.status = 0; }),
    RaysOf("cycle-a-ray",
      [](RayPlan& ray, unsigned i)
      {
        ray.status = 3;
        ray.milliseconds += i;
      }),
    RaysOf("empty-cycle-a-ray",
      [](RayPlan& ray, unsigned i)
      {
        ray.status = 3;
        ray.milliseconds += i;
        ray.moments.clear();
      }),
    RaysOf(
      "cycle-a-ray-of-all-moments",
      [](RayPlan& ray, unsigned i)
      {
        ray.status = 3;
        ray.milliseconds += 1000 * i;
        ray.moments = AllMomentPlans(100);
      },
      31, 3000),
    RaysOf("turn-in-three-rays",
      [](RayPlan& ray, unsigned i) { ray.azimuth = 170.0 * i - 360.0 * int(170.0 * i / 360.0); })};
}

// Rays that disagree with each other.
std::vector<HostileFile> MakeDisagreeingRays()
{
  return {RaysOf("position-a-ray",
            [](RayPlan& ray, unsigned i) { ray.latitude = 30.0F + 0.001F * float(i); }),
    RaysOf("name-a-ray",
      [](RayPlan& ray, unsigned i)
      {
        for (char& letter : ray.site)
        {
          letter = char('A' + i % 26);
          i /= 26;
        }
      }),
    RaysOf("geometry-a-ray", [](RayPlan& ray, unsigned i) { ray.moments[0].spacing = i + 1; }),
    RaysOf("first-gate-a-ray",
      [](RayPlan& ray, unsigned i) { ray.moments[0].firstGate = int(i) - 5'000; }),
    RaysOf("coding-a-ray",
      [](RayPlan& ray, unsigned i) { ray.moments[0].offset = 60.0F + 0.0001F * float(i); }),
    RaysOf("impossible-coding-a-ray",
      [](RayPlan& ray, unsigned i) { ray.moments[0].scale = 1000.0F + float(i); }),
    RaysOf("all-codings-a-ray",
      [](RayPlan& ray, unsigned i)
      {
        ray.moments = AllMomentPlans(1);
        for (MomentPlan& moment : ray.moments)
        {
          moment.scale = 1000.0F + float(i);
        }
      }),
    RaysOf("damage-a-ray",
      [](RayPlan& ray, unsigned i) { ray.moments[0].wordBits = i % 2 == 0 ? 7 : 9; }),
    RaysOf("all-damage-a-ray",
      [](RayPlan& ray, unsigned)
      {
        ray.moments = AllMomentPlans(1);
        for (MomentPlan& moment : ray.moments)
        {
          moment.spacing = 0;
        }
      }),
    RaysOf("azimuth-out-of-range", [](RayPlan& ray, unsigned) { ray.azimuth = 400.0; }),
    RaysOf("elevation-a-ray",
      [](RayPlan& ray, unsigned i) { ray.elevation = 0.003 * (i * 7919 % differentRays); }),
    RaysOf("time-a-ray",
      [](RayPlan& ray, unsigned i)
      {
        ray.day = 1 + i;
        ray.milliseconds = 1000 * (i % 86'400);
      }),
    RaysOf("number-a-ray", [](RayPlan& ray, unsigned i) { ray.number = i % 2 == 0 ? 1 : 65'535; }),
    RaysOf("nyquist-a-ray", [](RayPlan& ray, unsigned i) { ray.nyquist = i; })};
}

// Words without any order: regions of one gate, for whoever looks for regions.
MomentPlan MakeNoise(const std::string& name, unsigned gates)
{
  std::minstd_rand random(1);
  MomentPlan moment;
  moment.name = name;
  moment.gates = gates;
  moment.words = Bytes(gates);
  for (std::uint8_t& word : moment.words)
  {
    word = static_cast<std::uint8_t>(random() % 254 + 2);
  }
  return moment;
}

// Rays of many gates, or of few among such.
std::vector<HostileFile> MakeWideRays()
{
  const auto wide = [](unsigned gates)
  {
    MomentPlan moment;
    moment.gates = gates;
    moment.words = Bytes(gates, 130);
    return std::vector<MomentPlan>{moment};
  };
  const auto shared = [](unsigned gates)
  {
    return HostileFile{"shared-gates-" + std::to_string(gates), [=]
      {
        const Bytes rays = Repeat(MakeSharedGates(gates), 20);
        return Join(
          {Gzip(MakeVolumeHeader()), GzipOfRepeated(rays, filledBytes / rays.size() + 1)});
      }};
  };
  return {shared(1'000), shared(65'000),
    RaysOf(
      "wide-rays", [=](RayPlan& ray, unsigned) { ray.moments = wide(65'535); }, 31, 200),
    RaysOf("a-wide-ray-among-narrow",
      [=](RayPlan& ray, unsigned i) { ray.moments = wide(i % 1000 == 0 ? 65'535 : 1); }),
    RaysOf(
      "a-wide-ray-a-sweep",
      [=](RayPlan& ray, unsigned i)
      {
        ray.cut = i / 8 % 2 + 1;
        ray.moments = wide(i % 8 == 0 ? 65'535 : 1);
      },
      31, 1000),
    RaysOf(
      "far-gates",
      [](RayPlan& ray, unsigned)
      {
        ray.moments = AllMomentPlans(1'000);
        for (MomentPlan& moment : ray.moments)
        {
          moment.spacing = 65'535;
        }
      },
      31, 720),
    RaysOf(
      "near-gates",
      [](RayPlan& ray, unsigned)
      {
        ray.moments = AllMomentPlans(1'000);
        for (MomentPlan& moment : ray.moments)
        {
          moment.spacing = 1;
        }
      },
      31, 720),
    RaysOf(
      "noise", [](RayPlan& ray, unsigned) { ray.moments = {MakeNoise("REF", 1'800)}; }, 31, 720),
    RaysOf(
      "noise-of-velocity", [](RayPlan& ray, unsigned) { ray.moments = {MakeNoise("VEL", 1'800)}; },
      31, 720),
    RaysOf("a-moment-after-the-other",
      [](RayPlan& ray, unsigned i)
      {
        ray.moments = AllMomentPlans(200);
        ray.moments = {ray.moments[i % 7]};
      })};
}

} // namespace

std::vector<HostileFile> MakeHostileRays()
{
  std::vector<HostileFile> files = MakeEmptyRays();
  for (const std::vector<HostileFile>& more : {MakeDisagreeingRays(), MakeWideRays()})
  {
    files.insert(files.end(), more.begin(), more.end());
  }
  return files;
}

} // namespace nexrad::testing
