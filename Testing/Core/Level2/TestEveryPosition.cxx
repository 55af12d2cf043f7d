// SPDX-License-Identifier: BSD-3-Clause
// A part of a real file that is repeated, late, swapped, or of another radar changes no ray of the
// volume, and no byte of what is merged of it. With the environment variable NEXRAD_EVERY_POSITION
// every place of the files is tried and merged; without it the rays of each seventh are compared,
// and few are merged.
#include "nexrad/Level2/Level2File.h"

#include "FileParts.h"
#include "TestData.h"
#include "nexrad/Live/LiveSeries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

struct SpoiltFile
{
  const char* name;      // in the test data's folder level2
  std::size_t messages;  // in a part, where the file has no records
  const char* foreigner; // the file that the foreign part is of
  bool asStored = false; // records stay compressed
};

// Formats: message 1 of 1991 to 2006, with and without the radar's name, times of whole seconds,
// several cycles with lost rays; message 31 in bzip2 records, without records, in gzip; split cuts,
// AVSET; terminal radars.
const SpoiltFile files[] = {
  {"legacy/KTLX19910605_162126.gz", 60, "quality/KLSX19930707_040351.gz"},
  {"legacy/KTLX19990503_235621.gz", 90, "legacy/KVWX_20050626_221551.gz"},
  {"legacy/KVWX_20050626_221551.gz", 61, "run-kbgm-20050821/KBGM20050821_024323.gz"},
  {"pairs/KBBX20060113_170337.gz", 203, "pairs/KLIX20050828_180149.gz"},
  {"superres/KTLX20100501_000444_V03.gz", 60, "superres/KBLX20090603_004417_V03.gz"},
  {"superres/PGUA20160602_055618_V06.raw.gz", 71, "pairs/KVBX20190501_093433_V06"},
  {"superres/Level2_KFTG_20150430_1419.ar2v", 90, "pairs/KVBX20190501_093433_V06"},
  {"superres/KTLX20190715_120037_V06", 60, "superres/KLOT20220317_000842_V06", true},
  {"superres/KLSX20251229_065156_V06", 80, "superres/KDMX20250101_225441_V06"},
  {"tdwr/Level2_TSTL_20220213_2357.ar2v", 53, "superres/KLOT20220317_000842_V06"},
  {"tdwr/TDAL20191021021543V08.raw.gz", 47, "tdwr/Level2_TSTL_20220213_2357.ar2v"},
};

bool TriesEveryPlace()
{
  return std::getenv("NEXRAD_EVERY_POSITION") != nullptr;
}

MergeOptions SmallMerges()
{
  MergeOptions options;
  options.grid.dimensions = {64, 64, 16};
  return options;
}

RadarVolume Later(RadarVolume volume, Duration by)
{
  for (Sweep& sweep : volume.sweeps)
  {
    for (Ray& ray : sweep.rays)
    {
      ray.time += by;
    }
  }
  return volume;
}

/// Merges as the program does when nobody says otherwise, with quality control and motion: at the
/// end of the volume, between it and the clean one of the file scanned again.
class MergeWithNext
{
public:
  explicit MergeWithNext(const RadarVolume& clean)
    : series(SmallMerges(), {})
    , end(*clean.End())
  {
    series.Put({{"next", "next", Later(clean, *clean.End() - *clean.Start()), true}});
    expected = this->Merged(clean);
  }

  /// What differs from the merge of the clean file; "" when nothing does.
  std::string DifferenceOf(const RadarVolume& volume)
  {
    const GriddedVolume made = this->Merged(volume);
    const bool same = made.values == expected.values && made.states == expected.states &&
                      made.sites == expected.sites && made.notes == expected.notes &&
                      made.biologicalShare == expected.biologicalShare;
    return same ? "" : "the merged volume";
  }

  std::size_t EchoCount() const
  {
    return static_cast<std::size_t>(
      std::count(expected.states.begin(), expected.states.end(), VoxelState::Echo));
  }

private:
  GriddedVolume Merged(const RadarVolume& volume)
  {
    series.Put({{"volume", "volume", volume, true}});
    return series.Merge(end).value();
  }

  LiveSeries series;
  const Time end;
  GriddedVolume expected;
};

class EveryPosition : public ::testing::TestWithParam<SpoiltFile>
{
};

} // namespace

TEST_P(EveryPosition, GivesTheSameRaysAndMerges)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const SpoiltFile& spoilt = GetParam();
  FileParts file = CutFile(data / "level2" / spoilt.name, spoilt.messages);
  FileParts other = CutFile(data / "level2" / spoilt.foreigner, spoilt.messages);
  ASSERT_GT(file.parts.size(), 20U);
  if (!spoilt.asStored)
  {
    file = Decompress(file);
    other = Decompress(other);
  }
  const RadarVolume clean = DecodeLevel2(file.Whole(), spoilt.name);
  MergeWithNext merge(clean);
  EXPECT_GT(merge.EchoCount(), 100U);
  std::size_t changedFiles = 0;
  std::size_t merges = 0;
  const std::size_t step = TriesEveryPlace() ? 1 : 7;
  const std::size_t mergeStep = TriesEveryPlace() ? 1 : 35;
  for (std::size_t place = 0; place < file.parts.size(); place += step)
  {
    const Bytes& foreignPart = other.parts[place % other.parts.size()];
    for (const ChangedFile& changed : ChangeAt(file, place, foreignPart))
    {
      const RadarVolume volume = DecodeLevel2(changed.bytes, spoilt.name);
      EXPECT_EQ(DifferenceOf(volume, clean), "") << changed.what;
      if (changedFiles++ % mergeStep == mergeStep / 2)
      {
        EXPECT_EQ(merge.DifferenceOf(volume), "") << changed.what;
        ++merges;
      }
    }
  }
  std::cout << spoilt.name << ": " << changedFiles << " changed files, " << merges << " merged\n";
}

INSTANTIATE_TEST_SUITE_P(RealFiles, EveryPosition, ::testing::ValuesIn(files),
  [](const auto& file)
  {
    std::string name = std::filesystem::path(file.param.name).filename().string();
    for (char& letter : name)
    {
      letter = std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
    }
    return name;
  });
