// SPDX-License-Identifier: BSD-3-Clause
#include "HandMadeVolume.h"

#include "nexrad/Level2/Encoding/Level2Encoder.h"

#include <cmath>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace nexrad::testing
{

namespace
{

void AddMoment(RadarVolume& volume, Ray& ray, const HandMadeMoment& moment, int rayIndex)
{
  auto words = std::make_shared<std::vector<std::uint8_t>>();
  for (int gate = 0; gate < moment.gates; ++gate)
  {
    words->push_back(moment.word(rayIndex, gate));
  }
  MomentRow& row = ray.Row(moment.name);
  row.words = words->data();
  row.gates = static_cast<std::uint16_t>(moment.gates);
  row.firstValue = moment.name == MomentName::CFP ? 8 : 2;
  row.firstGate = moment.firstGate;
  row.gateSpacing = moment.gateSpacing;
  row.scale = 2.0F;
  row.offset = 66.0F;
  volume.buffers.push_back(words);
}

Sweep MakeSweep(RadarVolume& volume, const HandMadeSweep& source, int number, Time start)
{
  Sweep sweep;
  sweep.elevationNumber = number;
  for (int index = 0; index < source.rays; ++index)
  {
    Ray ray;
    ray.time = start + Duration(20 * index);
    ray.azimuth =
      static_cast<float>(std::fmod(source.firstAzimuth + source.turn * index / source.rays, 360.0));
    ray.elevation = source.elevation;
    ray.nyquist = source.nyquist;
    ray.elevationNumber = static_cast<std::uint8_t>(number);
    for (const HandMadeMoment& moment : source.moments)
    {
      AddMoment(volume, ray, moment, index);
    }
    sweep.rays.push_back(ray);
  }
  sweep.rays.front().radialStatus =
    number == 1 ? RadialStatus::StartOfVolume : RadialStatus::StartOfCut;
  return sweep;
}

} // namespace

std::uint8_t ReflectivityWord(double value)
{
  return static_cast<std::uint8_t>(std::lround(2.0 * value + 66.0));
}

HandMadeVolume ConstantVolume(const Site& site, Time start, double reflectivity)
{
  const std::uint8_t word = ReflectivityWord(reflectivity);
  HandMadeSweep sweep;
  sweep.moments = {{MomentName::REF, 100, 0, 1000, [word](int, int) { return word; }}};
  HandMadeVolume volume;
  volume.site = site;
  volume.start = start;
  volume.sweeps = {sweep};
  return volume;
}

RadarVolume MakeRadarVolume(const HandMadeVolume& source)
{
  RadarVolume volume;
  volume.site = source.site;
  volume.coveragePatternNumber = 21;
  volume.messageType = 31;
  volume.headerTime = source.start;
  volume.complete = source.complete;
  volume.synthetic = source.synthetic;
  Time time = source.start;
  for (const HandMadeSweep& sweep : source.sweeps)
  {
    volume.sweeps.push_back(
      MakeSweep(volume, sweep, static_cast<int>(volume.sweeps.size()) + 1, time));
    time = volume.sweeps.back().rays.back().time + Duration(20);
  }
  if (source.complete)
  {
    volume.sweeps.back().rays.back().radialStatus = RadialStatus::EndOfVolume;
  }
  return volume;
}

std::filesystem::path WriteLevel2(
  const std::filesystem::path& path, const std::vector<HandMadeVolume>& cycles)
{
  RadarVolume whole = MakeRadarVolume(cycles.front());
  for (std::size_t i = 1; i < cycles.size(); ++i)
  {
    const RadarVolume next = MakeRadarVolume(cycles[i]);
    whole.sweeps.insert(whole.sweeps.end(), next.sweeps.begin(), next.sweeps.end());
    whole.buffers.insert(whole.buffers.end(), next.buffers.begin(), next.buffers.end());
  }
  Level2EncoderOptions options;
  options.messageType = 31;
  options.container = Level2Container::Bare;
  const std::vector<std::uint8_t> bytes = EncodeLevel2(whole, options);
  std::ofstream file(path, std::ios::binary);
  for (const std::uint8_t byte : bytes)
  {
    file.put(static_cast<char>(byte));
  }
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + path.string());
  }
  return path;
}

void SetHeaderTime(const std::filesystem::path& path, Time time)
{
  using namespace std::chrono_literals;
  constexpr std::streamoff place = 12;
  const auto sinceEpoch = time.time_since_epoch();
  const auto days = static_cast<std::uint32_t>(sinceEpoch / 24h);
  const auto rest = static_cast<std::uint32_t>((sinceEpoch - days * 24h) / 1ms);
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(place);
  for (const std::uint32_t word : {days + 1, rest}) // day 1 is the first of January 1970
  {
    for (const int shift : {24, 16, 8, 0})
    {
      file.put(static_cast<char>(word >> shift));
    }
  }
}

void BlankHeaderName(const std::filesystem::path& path)
{
  constexpr std::streamoff place = 20;
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(place);
  file << std::string(4, '\0');
}

} // namespace nexrad::testing
