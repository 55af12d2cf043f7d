// SPDX-License-Identifier: BSD-3-Clause
// Times of the core's kernels on synthetic files of KLSX, which are simulated once, in memory.
// Usage: BenchmarkCore [options of Google Benchmark, for example --benchmark_filter=Decode]
#include "TestData.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Codec/ThesisStream.h"
#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Level2/Messages/VolumeHeader.h"
#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/Quality/EchoClassification.h"
#include "nexrad/Simulation/SimulatedDay.h"
#include "nexrad/System/RangeLoop.h"
#include "nexrad/Thesis/ThesisMerge.h"
#include "nexrad/Velocity/Dealiasing.h"

#include <benchmark/benchmark.h>

namespace
{

using namespace nexrad;
using Bytes = std::vector<std::uint8_t>;

// Two consecutive volumes in a container.
struct Files
{
  explicit Files(Level2Container container)
  {
    SimulatedDayOptions options;
    options.begin = *ParseIso8601("2006-03-12T18:00");
    options.length = std::chrono::minutes(15);
    options.sites = {{"KLSX", 11}};
    options.container = container;
    const StormField field(options.seed);
    const auto plan = PlanSimulatedDay(options);
    before = SimulateFile(field, plan.at(0), options);
    after = SimulateFile(field, plan.at(1), options);
  }

  Bytes before;
  Bytes after;
};

const Files& LdmFiles()
{
  static const Files files(Level2Container::LdmBzip2);
  return files;
}

const Bytes& FileIn(Level2Container container)
{
  static const Bytes bare = Files(Level2Container::Bare).before;
  static const Bytes gzip = Files(Level2Container::Gzip).before;
  return container == Level2Container::LdmBzip2 ? LdmFiles().before
         : container == Level2Container::Gzip   ? gzip
                                                : bare;
}

GridSpecification GridOf(int columns)
{
  GridRequest request;
  request.dimensions = {columns, columns, columns / 2};
  const RadarVolume volume = DecodeLevel2(LdmFiles().before, "KLSX");
  return MakeGrid(request, {volume.site.position.value()});
}

// A merged volume half way between the two.
GriddedVolume MergedVolume(int columns)
{
  const PolarVolume before =
    MakePolarVolume(DecodeLevel2(LdmFiles().before, "KLSX"), MomentName::REF);
  const PolarVolume after =
    MakePolarVolume(DecodeLevel2(LdmFiles().after, "KLSX"), MomentName::REF);
  return *MergeThesis(
    {{&before, &after}}, GridOf(columns), before.start + (after.start - before.start) / 2);
}

void SetBytes(benchmark::State& state, std::size_t bytes)
{
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
}

// All moments of a file that is in memory; the bytes are those of the file as it is stored.
void Decode(benchmark::State& state, Level2Container container)
{
  const Bytes& file = FileIn(container);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(DecodeLevel2(file, "KLSX"));
  }
  SetBytes(state, file.size());
}
BENCHMARK_CAPTURE(Decode, Bare, Level2Container::Bare)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Decode, Gzip, Level2Container::Gzip)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Decode, Ldm, Level2Container::LdmBzip2)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

void UnpackGzip(benchmark::State& state)
{
  const Bytes& file = FileIn(Level2Container::Gzip);
  for (auto _ : state)
  {
    std::vector<Damage> damage;
    DecodingBudget budget(std::size_t(1) << 30);
    budget.AddStored(file.size());
    benchmark::DoNotOptimize(OpenContainer(file, budget, damage));
  }
  SetBytes(state, file.size());
}
BENCHMARK(UnpackGzip)->Unit(benchmark::kMillisecond);

void UnpackRecords(benchmark::State& state)
{
  const Bytes& file = FileIn(Level2Container::LdmBzip2);
  const auto records = FindLdmRecords(
    {file.data(), file.size()}, VolumeHeader::bytes, [](std::size_t, const std::string&) {});
  for (auto _ : state)
  {
    BunzipInParallel(records, std::size_t(64) << 20,
      [](std::size_t, Unpacked&& content) { benchmark::DoNotOptimize(content.bytes.data()); });
  }
  SetBytes(state, file.size());
}
BENCHMARK(UnpackRecords)->Unit(benchmark::kMillisecond)->UseRealTime();

void ConvertToPolar(benchmark::State& state)
{
  const RadarVolume volume = DecodeLevel2(LdmFiles().before, "KLSX");
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(MakePolarVolume(volume, MomentName::REF));
  }
}
BENCHMARK(ConvertToPolar)->Unit(benchmark::kMillisecond);

// The velocities of a real volume on two threads; without the test data there is nothing to
// measure.
void DealiasVolume(benchmark::State& state, const char* name)
{
  const auto folder = testing::TestDataFolder();
  if (!folder)
  {
    state.SkipWithError("real radar files not found: set NEXRAD_TEST_DATA");
    return;
  }
  const VelocityVolume folded =
    MakeVelocityVolume(MakePolarVolume(ReadLevel2(*folder / "level2" / name), MomentName::VEL));
  DealiasOptions options;
  options.loop = ThreadLoop(2);
  for (auto _ : state)
  {
    VelocityVolume volume = folded;
    benchmark::DoNotOptimize(Dealias(volume, options));
  }
}
BENCHMARK_CAPTURE(DealiasVolume, KTLX1999, "legacy/KTLX19990503_235621.gz")
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();
BENCHMARK_CAPTURE(DealiasVolume, KMLB1998, "quality/KMLB19980707_220118.gz")
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();
BENCHMARK_CAPTURE(DealiasVolume, KENX2010, "multisite-20100911/KENX20100911_011108_V03.gz")
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();
BENCHMARK_CAPTURE(DealiasVolume, KBLX2009, "superres/KBLX20090603_004417_V03.gz")
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();

// What the echo of a real volume comes from, on one thread, as a merge of several volumes finds it,
// and on two. The polar volumes that it needs are part of it, other than that of reflectivity,
// which a merge makes in any case.
void ClassifyVolume(benchmark::State& state, const char* name)
{
  const auto folder = testing::TestDataFolder();
  if (!folder)
  {
    state.SkipWithError("real radar files not found: set NEXRAD_TEST_DATA");
    return;
  }
  const RadarVolume volume = ReadLevel2(*folder / "level2" / name);
  const PolarVolume reflectivity = MakePolarVolume(volume, MomentName::REF);
  const auto measured = [&volume](MomentName moment, const WantedRange& wanted)
  { return MakePolarVolume(volume, moment, wanted); };
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(
      ClassifyEcho(reflectivity, measured, ThreadLoop(static_cast<unsigned>(state.range(0)))));
  }
}
BENCHMARK_CAPTURE(ClassifyVolume, KMLB1998, "quality/KMLB19980707_220118.gz")
  ->DenseRange(1, 2)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK_CAPTURE(ClassifyVolume, KBGM2005, "run-kbgm-20050821/KBGM20050821_024323.gz")
  ->DenseRange(1, 2)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK_CAPTURE(ClassifyVolume, KBLX2009, "superres/KBLX20090603_004417_V03.gz")
  ->DenseRange(1, 2)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK_CAPTURE(ClassifyVolume, KTLX2019, "superres/KTLX20190715_120037_V06")
  ->DenseRange(1, 2)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

// One site, columns × columns × columns / 2 voxels.
void MergeAsTheThesis(benchmark::State& state)
{
  const PolarVolume before =
    MakePolarVolume(DecodeLevel2(LdmFiles().before, "KLSX"), MomentName::REF);
  const PolarVolume after =
    MakePolarVolume(DecodeLevel2(LdmFiles().after, "KLSX"), MomentName::REF);
  const GridSpecification grid = GridOf(static_cast<int>(state.range(0)));
  const Time time = before.start + (after.start - before.start) / 2;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(MergeThesis({{&before, &after}}, grid, time));
  }
}
BENCHMARK(MergeAsTheThesis)->Arg(128)->Arg(256)->Unit(benchmark::kMillisecond);

void EncodeRuns(benchmark::State& state)
{
  const Bytes codes = ThesisCode::EncodeAll(MergedVolume(256));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(EncodeRunLength(codes));
  }
  SetBytes(state, codes.size());
}
BENCHMARK(EncodeRuns)->Unit(benchmark::kMillisecond);

void DecodeRuns(benchmark::State& state)
{
  Bytes codes = ThesisCode::EncodeAll(MergedVolume(256));
  const Bytes stream = EncodeRunLength(codes);
  for (auto _ : state)
  {
    DecodeRunLength(stream.data(), stream.size(), codes.data(), codes.size());
    benchmark::ClobberMemory();
  }
  SetBytes(state, codes.size());
}
BENCHMARK(DecodeRuns)->Unit(benchmark::kMillisecond);

void WriteVolumeFile(benchmark::State& state)
{
  const GriddedVolume volume = MergedVolume(256);
  const testing::TemporaryFolder folder;
  for (auto _ : state)
  {
    WriteNxv(folder.Path() / "volume.nxv", volume);
  }
}
BENCHMARK(WriteVolumeFile)->Unit(benchmark::kMillisecond)->UseRealTime();

void ReadVolumeFile(benchmark::State& state)
{
  const testing::TemporaryFolder folder;
  const auto path = folder.Path() / "volume.nxv";
  WriteNxv(path, MergedVolume(256));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(ReadNxv(path));
  }
}
BENCHMARK(ReadVolumeFile)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
