// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/DecodeTable.h"

#include "Tables/BareDecompression.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/System/Error.h"

namespace nexrad::application
{
namespace
{

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
  const auto times = MeasureInTurn({[&] { bare.Run(); }, [&] { ReadLevel2(file); }}, runs);
  return {file.filename().string(), bare.Describe(), static_cast<double>(bare.StoredBytes()) / 1e6,
    times[0], times[1], times[1].median / times[0].median};
}

} // namespace

BenchTable MakeDecodeTable(
  const std::vector<std::filesystem::path>& files, int runs, std::vector<std::string>& problems)
{
  BenchTable table;
  table.key = "decode";
  table.title = "Decoding a file, all moments, and bare decompression of the same bytes on the "
                "same threads";
  table.columns = {NameColumn("file", "file"), GivenColumn("container", "container"),
    GivenColumn("stored_mb", "MB", 1), {"bare_s", "bare, s", 4}, {"decode_s", "decode, s", 4},
    {"ratio", "ratio", 2}};
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

} // namespace nexrad::application
