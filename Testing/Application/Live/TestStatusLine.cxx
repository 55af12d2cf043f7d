// SPDX-License-Identifier: BSD-3-Clause
// What a person reads of the radars of a feed, of few and of many.
#include "Live/LiveFolder.h"

#include <gtest/gtest.h>

using namespace nexrad;
using namespace nexrad::application;
using namespace std::chrono_literals;

namespace
{

// So many radars, K001 and on, of which the last are silent.
LiveStatus StatusOf(int radars, int stale)
{
  LiveStatus status;
  status.written = Time(18h + 5min + 21s);
  for (int i = 1; i <= radars; ++i)
  {
    const std::string number = std::to_string(1000 + i).substr(1);
    auto& radar = status.radars["K" + number];
    radar.live = i <= radars - stale;
    radar.newest = status.written - (radar.live ? Duration(9s) : Duration(15min));
  }
  return status;
}

} // namespace

TEST(StatusLine, NamesFewRadars)
{
  EXPECT_EQ(StatusLine(StatusOf(2, 1)), "18:05:21Z K001 LIVE 9 s, K002 STALE 15 min");
  EXPECT_NE(StatusLine(StatusOf(12, 0)).find("K012 LIVE 9 s"), std::string::npos);
}

TEST(StatusLine, CountsManyAndNamesTheSilent)
{
  EXPECT_EQ(StatusLine(StatusOf(143, 0)), "18:05:21Z 143 radars LIVE");
  EXPECT_EQ(StatusLine(StatusOf(143, 2)),
    "18:05:21Z 141 radars LIVE, K142 STALE 15 min, K143 STALE 15 min");
  EXPECT_EQ(StatusLine(StatusOf(143, 13)), "18:05:21Z 130 radars LIVE, 13 STALE");
}

TEST(StatusLine, LeavesOutRadarsWithoutRays)
{
  LiveStatus status = StatusOf(1, 0);
  status.radars["K002"] = {};
  EXPECT_EQ(StatusLine(status), "18:05:21Z K001 LIVE 9 s");
  status.radars.erase("K001");
  EXPECT_EQ(StatusLine(status), "18:05:21Z");
}
