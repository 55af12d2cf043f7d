// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorMessage.h"
#include "Tables/BareDecompression.h"
#include "Tables/BenchTable.h"
#include "Tables/Measurement.h"
#include "Tables/PeakMemory.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/mman.h>

#include <cstring>
#include <fstream>
#include <sstream>

using namespace nexrad;
using namespace nexrad::application;
using namespace nexrad::testing;

namespace
{

BenchTable SmallTable()
{
  BenchTable table;
  table.title = "Two rows";
  table.columns = {{"name", "name"}, {"time_s", "time, s", 2}, {"ratio", "ratio", 1}};
  table.rows = {{std::string("short"), Measurement{1.234, 1.0, 2.0}, 0.25},
    {std::string("a longer name"), std::monostate{}, 12.0}};
  return table;
}

} // namespace

TEST(Measurement, MedianAndExtremes)
{
  const Measurement odd = Summarize({3.0, 1.0, 8.0});
  EXPECT_EQ(odd.median, 3.0);
  EXPECT_EQ(odd.least, 1.0);
  EXPECT_EQ(odd.most, 8.0);
  EXPECT_EQ(Summarize({4.0, 1.0, 2.0, 8.0}).median, 3.0);
  EXPECT_THROW(Summarize({}), Error);
}

TEST(Measurement, PiecesTakeTurns)
{
  std::string order;
  const auto times = MeasureInTurn({[&] { order += 'a'; }, [&] { order += 'b'; }}, 3);
  EXPECT_EQ(order, "abababab"); // the first round is not measured
  ASSERT_EQ(times.size(), 2U);
  EXPECT_LE(times[0].least, times[0].median);
  EXPECT_LE(times[0].median, times[0].most);
  order.clear();
  MeasureInTurn({[&] { order += 'a'; }}, 2, false);
  EXPECT_EQ(order, "aa");
}

TEST(BenchTable, PrintsAlignedColumns)
{
  std::ostringstream out;
  PrintTable(SmallTable(), out);
  EXPECT_EQ(out.str(), "Two rows\n"
                       "  name                     time, s  ratio\n"
                       "  short          1.23 (1.00..2.00)    0.2\n"
                       "  a longer name                  -   12.0\n\n");
}

TEST(BenchTable, JsonKeepsWhatWasMeasured)
{
  const nlohmann::ordered_json json = MakeTableJson(SmallTable());
  EXPECT_EQ(json["rows"][0]["time_s"]["median"], 1.234);
  EXPECT_EQ(json["rows"][0]["time_s"]["most"], 2.0);
  EXPECT_EQ(json["rows"][0]["ratio"], 0.25);
  EXPECT_TRUE(json["rows"][1]["time_s"].is_null());
}

TEST(BareDecompression, FindsTheStreamsOfAFile)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  // The numbers of records are those that a list of the files names.
  BareDecompression records(data / "level2" / "superres" / "KDMX20250101_225441_V06");
  EXPECT_EQ(records.Describe(), "43 records");
  records.Run();
  BareDecompression nested(data / "level2" / "run-kbgm-20050821" / "KBGM20050821_024323.gz");
  EXPECT_EQ(nested.Describe(), "gzip, 45 records");
  nested.Run();
  BareDecompression whole(data / "level2" / "superres" / "example_nexrad_archive_msg31.bz2");
  EXPECT_EQ(whole.Describe(), "bzip2");
  whole.Run();
  whole.Run(); // again into the same memory
}

TEST(BareDecompression, FilesOfASeriesAreReadAnewEachTime)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const auto folder = data / "level2" / "run-kbgm-20050821";
  const std::vector<std::filesystem::path> files = {
    folder / "KBGM20050821_024323.gz", folder / "KBGM20050821_025458.gz"};
  BareSeries series(files, 2);
  EXPECT_EQ(series.StoredBytes(), static_cast<double>(std::filesystem::file_size(files[0]) +
                                                      std::filesystem::file_size(files[1])));
  series.Run();
  series.Run();
  const TemporaryFolder changing;
  const auto file = changing.Path() / "file";
  std::filesystem::copy_file(files[0], file);
  BareSeries changed({file}, 1);
  std::filesystem::resize_file(file, 1'000);
  EXPECT_THROW(changed.Run(), Error);
  EXPECT_THROW(BareSeries({files[0], file}, 2), Error);
}

TEST(PeakMemory, SeesWhatIsUsedAndForgetsIt)
{
  if (!PeakMemory())
  {
    GTEST_SKIP() << "this system does not tell";
  }
  constexpr std::size_t large = 64'000'000;
  RestartPeakMemory();
  const double before = *PeakMemory();
  // Straight from the system, so that it goes back there: an allocator may keep what is freed.
  void* used = mmap(nullptr, large, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(used, MAP_FAILED);
  std::memset(used, 'x', large); // pages count once they are written to
  ASSERT_EQ(munmap(used, large), 0);
  EXPECT_AT_LEAST(
    (*PeakMemory() - before) / large, 0.9, "peak of the memory, part of what was used");
  RestartPeakMemory();
  EXPECT_AT_MOST((*PeakMemory() - before) / large, 0.5,
    "peak of the memory after its restart, part of what was used",
    "the test program itself uses some memory between the two");
}

TEST(BareDecompression, RefusesWhatHasNoTimeToCompareWith)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  EXPECT_THROW(BareDecompression(data / "level2" / "damaged" / "KLRX20000125_180740.Z"), Error);
  EXPECT_THROW(BareDecompression("/nonexistent"), Error);
  const TemporaryFolder folder;
  const auto cut = folder.Path() / "cut.gz";
  std::ifstream from(data / "level2" / "legacy" / "KABR20050101_000745.gz", std::ios::binary);
  std::string bytes(50'000, '\0');
  from.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  std::ofstream(cut, std::ios::binary) << bytes;
  const std::string error = MessageOf([&] { BareDecompression stream(cut); });
  EXPECT_NE(error.find("ends early"), std::string::npos) << error;
}
