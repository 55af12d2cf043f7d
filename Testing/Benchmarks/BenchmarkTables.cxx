// SPDX-License-Identifier: BSD-3-Clause
// Measures decoding, merging and the sizes of volumes, and prints the tables 4.1 and 4.4 of the
// thesis with its figures beside. It has no rendering library in it, so that the memory of a day is
// that of the command grid.
#include "ProgramRun.h"
#include "Tables/BareDecompression.h"
#include "Tables/Benchmark.h"
#include "Tables/GridTable.h"
#include "Tables/SeriesTables.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/System/Error.h"

namespace
{

using namespace nexrad;
using namespace nexrad::application;

std::vector<BenchCell> MeasureFile(const std::filesystem::path& file, int runs)
{
  BareDecompression bare(file);
  if (!bare.IsCompressed())
  {
    throw Error(file.string() + ": is not compressed; there is nothing to compare decoding with");
  }
  if (ReadLevel2(file).sweeps.empty())
  {
    throw Error(file.string() + ": contains no ray, so its decoding time is not comparable");
  }
  const auto times = MeasureInTurn({[&] { bare.Run(); }, [&] { ReadLevel2(file); },
                                     [&] {
                                       testing::RunNexrad3d({"info", file});
                                     }},
    runs);
  const double whole = times[0].median;
  return {file.filename().string(), bare.Describe(), static_cast<double>(bare.StoredBytes()) / 1e6,
    times[0], times[1], times[1].median / whole, times[2], times[2].median / whole};
}

// For each file the time of decoding it whole, all moments, and that of the program's command info,
// beside that of the bare decompression of the same bytes on the same threads: medians of `runs`,
// turn by turn. A file that cannot be compared goes to `problems`.
BenchTable MakeDecodeTable(
  const std::vector<std::filesystem::path>& files, int runs, std::vector<std::string>& problems)
{
  BenchTable table;
  table.key = "decode";
  table.title = "Decoding a file, all moments, and nexrad3d info of it, beside bare decompression "
                "of the same bytes on the same threads";
  table.columns = {NameColumn("file", "file"), GivenColumn("container", "container"),
    GivenColumn("stored_mb", "MB", 1), {"bare_s", "bare, s", 4}, {"decode_s", "decode, s", 4},
    {"ratio", "decode ratio", 2}, {"info_s", "info, s", 4}, {"info_ratio", "info ratio", 2}};
  for (const std::filesystem::path& file : files)
  {
    try
    {
      table.rows.push_back(MeasureFile(file, runs));
    }
    catch (const Error& error)
    {
      problems.emplace_back(error.what());
    }
  }
  return table;
}

// A simulated series has many files alike; one of each site speaks for all.
void MeasureDecoding(const BenchRequest& request, BenchReport& report)
{
  std::vector<std::filesystem::path> files = request.files;
  if (request.synthetic)
  {
    files.clear();
    for (const SiteSeries& site : request.scan.sites)
    {
      files.push_back(site.volumes.front().file);
    }
  }
  report.tables.push_back(MakeDecodeTable(files, request.runs, report.problems));
}

void MeasureGrid(const BenchRequest& request, BenchReport& report)
{
  report.tables.push_back(MakeGridTable(request));
}

void MeasureWholeSeries(const BenchRequest& request, BenchReport& report)
{
  const SeriesMeasurement series = MeasureSeries(request);
  report.tables.push_back(MakeProcessingTable(request, series));
  report.tables.push_back(MakeSizeTable(series));
  report.tables.push_back(MakeSeriesTable(request, series));
}

} // namespace

int main(int argc, char** argv)
{
  return RunBenchmark(argc, argv,
    "Measures decoding and merging on this machine, beside bare decompression and the thesis's "
    "figures",
    {{"decode", MeasureDecoding}, {"grid", MeasureGrid}, {"series", MeasureWholeSeries}});
}
