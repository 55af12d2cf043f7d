// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/GateRows.h"

#include "nexrad/Polar/GateCode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace nexrad;

namespace
{

using Codes = std::vector<std::uint16_t>;

std::uint16_t LargestOf(const std::vector<Codes>& rows)
{
  std::uint16_t largest = 0;
  for (const Codes& row : rows)
  {
    largest = row.empty() ? largest : std::max(largest, *std::max_element(row.begin(), row.end()));
  }
  return largest;
}

GateRows RowsOf(const std::vector<Codes>& all)
{
  GateRows rows(LargestOf(all));
  for (const Codes& row : all)
  {
    rows.Append(row.data(), row.size());
  }
  rows.Finish();
  return rows;
}

// All gates, and all shorter reaches of them.
void ExpectSame(const GateRows& rows, const std::vector<Codes>& expected)
{
  ASSERT_EQ(rows.Count(), expected.size());
  for (std::size_t row = 0; row < expected.size(); ++row)
  {
    const Codes& all = expected[row];
    for (std::size_t gates = 0; gates <= all.size(); gates += gates + 7 < all.size() ? 7 : 1)
    {
      const auto end = all.begin() + static_cast<std::ptrdiff_t>(gates);
      Codes read(gates, 9);
      rows.Read(row, gates, read.data());
      ASSERT_TRUE(std::equal(all.begin(), end, read.begin())) << row << " " << gates;
      const GateRange held = rows.Held(row, gates);
      const auto isHeld = [](std::uint16_t code) { return code != GateCode::NoEcho; };
      const auto first = std::find_if(all.begin(), end, isHeld);
      ASSERT_EQ(held.IsEmpty(), first == end) << row << " " << gates;
      if (first != end)
      {
        ASSERT_EQ(held.begin, static_cast<std::size_t>(first - all.begin()));
        ASSERT_LE(held.end, gates);
        ASSERT_TRUE(std::none_of(all.begin() + static_cast<std::ptrdiff_t>(held.end), end, isHeld));
      }
    }
  }
}

} // namespace

// Every pattern of gates with and without echo, so that gaps and stretches of all short lengths
// stand at the beginning, within and at the end.
TEST(GateRows, GiveBackEveryPattern)
{
  constexpr std::size_t gates = 13;
  for (const std::uint16_t largest : {std::uint16_t(255), std::uint16_t(256), GateCode::Last})
  {
    std::vector<Codes> all;
    for (unsigned pattern = 0; pattern < 1U << gates; ++pattern)
    {
      Codes row;
      for (std::size_t gate = 0; gate < gates; ++gate)
      {
        const bool echo = (pattern >> gate & 1U) != 0;
        row.push_back(echo ? static_cast<std::uint16_t>(largest - pattern % 7) : GateCode::NoEcho);
      }
      all.push_back(row);
    }
    ExpectSame(RowsOf(all), all);
  }
}

TEST(GateRows, GiveBackLongRowsOfAllStates)
{
  std::minstd_rand random(5);
  std::vector<Codes> all;
  for (int row = 0; row < 40; ++row)
  {
    Codes codes;
    while (codes.size() < 1'832)
    {
      const auto code =
        static_cast<std::uint16_t>(random() % 4 == 0 ? random() % 200 : random() % 4);
      codes.insert(codes.end(), 1 + random() % 90, code);
    }
    codes.resize(1'832);
    all.push_back(codes);
  }
  all.emplace_back(1'832, GateCode::NotSampled);
  all.emplace_back(1'832, GateCode::NoEcho);
  all.emplace_back(1'832, GateCode::RangeFolded);
  ExpectSame(RowsOf(all), all);
}

TEST(GateRows, GiveBackWordsThatStayWhereTheyAre)
{
  std::mt19937 random(4);
  std::vector<Codes> expected;
  std::vector<std::vector<std::uint8_t>> words;
  for (std::size_t row = 0; row < 200; ++row)
  {
    words.emplace_back(row % 7 == 0 ? 40 : 60, std::uint8_t(0)); // of 60 gates
    for (std::size_t gate = random() % 40; gate < words.back().size() && random() % 30 > 0; ++gate)
    {
      words.back()[gate] = static_cast<std::uint8_t>(random() % 3 == 0 ? random() % 256 : 0);
    }
    expected.emplace_back(60, GateCode::NotSampled);
    std::transform(words.back().begin(), words.back().end(), expected.back().begin(), CodeOfWord);
  }
  GateRows rows(255);
  for (const std::vector<std::uint8_t>& each : words)
  {
    rows.AppendWords(each.data(), each.size());
  }
  rows.Finish();
  ExpectSame(rows, expected);
}

TEST(GateRows, TakeTheLongestRow)
{
  Codes row(GateRows::MostGates, GateCode::NoEcho);
  row.front() = 7;
  row.back() = 300;
  ExpectSame(RowsOf({row}), {row});
  row.back() = GateCode::NotSampled;
  ExpectSame(RowsOf({row}), {row});
  row.assign(row.size(), 300);
  ExpectSame(RowsOf({row}), {row});
}

TEST(GateRows, ReplaceCodesWhereSomethingIsHeld)
{
  for (const std::uint16_t largest : {std::uint16_t(255), std::uint16_t(300)})
  {
    std::vector<Codes> all;
    for (std::uint16_t first = 0; first < 3; ++first)
    {
      Codes row(200, GateCode::NoEcho);
      std::fill(row.begin() + 20 * first, row.begin() + 50, largest);
      std::fill(row.begin() + 52, row.begin() + 54, std::uint16_t(9));
      std::fill(row.begin() + 100, row.begin() + 110, std::uint16_t(8));
      std::fill(row.begin() + 150, row.end(), GateCode::NotSampled);
      all.push_back(row);
    }
    GateRows rows = RowsOf(all);
    const std::size_t bytes = rows.MemoryBytes();
    std::replace(all[1].begin(), all[1].end(), std::uint16_t(8), GateCode::Filtered);
    std::replace(all[1].begin(), all[1].begin() + 40, largest, std::uint16_t(7));
    rows.Replace(1, all[1].data());
    ExpectSame(rows, all);
    EXPECT_EQ(rows.MemoryBytes(), bytes);
  }
}

TEST(GateRows, NoGatesAndNoRows)
{
  ExpectSame(RowsOf({Codes(), Codes()}), {Codes(), Codes()});
  EXPECT_EQ(GateRows().Count(), 0U);
  EXPECT_EQ(GateRows().MemoryBytes(), 0U);
}

// By hand: eight bytes a row, four a stretch, and the codes; gates behind the last echo, and those
// that were not sampled, take none.
TEST(GateRows, KeepOnlyWhatIsHeld)
{
  Codes row(1'000, GateCode::NoEcho);
  std::fill_n(row.begin() + 100, 30, std::uint16_t(90));
  EXPECT_EQ(RowsOf({row, Codes(1'000, GateCode::NoEcho)}).MemoryBytes(), 8U + 4U + 30U + 8U);
  std::fill(row.begin() + 500, row.end(), GateCode::NotSampled);
  EXPECT_EQ(RowsOf({row}).MemoryBytes(), 8U + 4U + 30U + 4U);
  row[100] = 256;
  EXPECT_EQ(RowsOf({row}).MemoryBytes(), 8U + 4U + 60U + 4U);
}
