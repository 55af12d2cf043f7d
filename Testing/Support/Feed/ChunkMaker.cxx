// SPDX-License-Identifier: BSD-3-Clause
#include "Feed/ChunkMaker.h"

#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Level2/Encoding/Level2Encoder.h"
#include "nexrad/Level2/Messages/VolumeHeader.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace nexrad::testing
{

RadarVolume VolumeOfSweeps(const Site& site, Time start, int sweeps, double reflectivity)
{
  HandMadeVolume made;
  made.site = site;
  made.start = start;
  for (int i = 0; i < sweeps; ++i)
  {
    HandMadeSweep sweep;
    sweep.elevation = 0.5F + static_cast<float>(i);
    HandMadeMoment moment;
    moment.gates = 100;
    moment.firstGate = 500;
    moment.gateSpacing = 1000;
    moment.word = [value = reflectivity + i](int, int) { return ReflectivityWord(value); };
    sweep.moments.push_back(moment);
    made.sweeps.push_back(sweep);
  }
  RadarVolume volume = MakeRadarVolume(made);
  constexpr auto length = std::chrono::minutes(4);
  std::size_t ray = 0;
  for (Sweep& sweep : volume.sweeps)
  {
    for (Ray& each : sweep.rays)
    {
      each.time = start + Duration(Duration(length).count() * static_cast<std::int64_t>(ray++) /
                                   static_cast<std::int64_t>(volume.RayCount()));
    }
    sweep.rays.back().radialStatus =
      &sweep == &volume.sweeps.back() ? RadialStatus::EndOfVolume : RadialStatus::EndOfCut;
  }
  return volume;
}

std::vector<MadeChunk> CutIntoChunks(const RadarVolume& volume)
{
  Level2EncoderOptions options;
  options.messageType = 31;
  options.container = Level2Container::LdmBzip2;
  const std::vector<std::uint8_t> file = EncodeLevel2(volume, options);
  const std::vector<LdmRecord> records =
    FindLdmRecords(ByteView(file.data(), file.size()), VolumeHeader::bytes,
      [](std::size_t, const std::string& what) { throw std::runtime_error(what); });
  const std::string time = FormatForFileName(*volume.Start());
  std::vector<MadeChunk> chunks;
  for (std::size_t i = 0; i < records.size(); ++i)
  {
    constexpr std::size_t lengthBytes = 4;
    MadeChunk chunk;
    chunk.number = static_cast<int>(i) + 1;
    chunk.kind = i == 0 ? 'S' : i + 1 == records.size() ? 'E' : 'I';
    char number[16];
    std::snprintf(number, sizeof number, "%03d", chunk.number);
    chunk.name = time.substr(0, 8) + '-' + time.substr(9, 6) + '-' + number + '-' + chunk.kind;
    const auto begin = file.begin() + static_cast<std::ptrdiff_t>(i == 0 ? 0 : records[i].offset);
    const auto end = file.begin() + static_cast<std::ptrdiff_t>(records[i].offset + lengthBytes +
                                                                records[i].compressed.Size());
    chunk.bytes.assign(begin, end);
    chunks.push_back(std::move(chunk));
  }
  return chunks;
}

void WriteChunks(const std::filesystem::path& folder, const std::vector<MadeChunk>& chunks)
{
  std::filesystem::create_directories(folder);
  for (const MadeChunk& chunk : chunks)
  {
    std::ofstream(folder / chunk.name, std::ios::binary)
      .write(reinterpret_cast<const char*>(chunk.bytes.data()),
        static_cast<std::streamsize>(chunk.bytes.size()));
  }
}

} // namespace nexrad::testing
