// SPDX-License-Identifier: BSD-3-Clause
// How well real volumes, whose truth nobody knows, are interpolated between their tilts: each tilt
// but the lowest and the highest is left out in turn, and foretold from the others.
#include "LeftOutTilts.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Level2/Level2File.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

using namespace nexrad;

namespace
{

constexpr std::array files{"legacy/KTLX19910605_162126.gz", "legacy/KTLX19990503_235621.gz",
  "legacy/KVWX_20050626_221551.gz", "run-kbgm-20050821/KBGM20050821_025458.gz",
  "superres/KBLX20090603_004417_V03.gz", "multisite-20100911/KENX20100911_011108_V03.gz",
  "multisite-20100911/KTYX20100911_012210_V04.gz", "multisite-20100911/KGYX20100911_005803_V03.gz",
  "quality/KAMA19940525_003434.gz", "quality/KLSX19930707_040351.gz",
  "quality/KMLB19980707_220118.gz", "pairs/KLIX20050828_180149.gz", "pairs/KLIX20050828_181658.gz"};

enum Scheme : std::size_t
{
  Nearest,
  Barnes,
  Measured, // the gates as measured, linear in elevation
  Sharpened,
  Trend,
  Beam, // all, as the merge is by default
  SchemeCount
};
constexpr std::array<const char*, SchemeCount> names{
  "nearest", "Barnes", "linear", "lin.+G9", "G11+G12", "beam"};

// Of lengths from 0.5 to 3 km and from 0.4 to 2 degrees those of the least error on these volumes.
constexpr BarnesLengths barnesLengths{1000.0, 1.0};

struct VolumeErrors
{
  std::string name;
  std::vector<SchemeErrors> schemes{SchemeCount};
};

VolumeErrors Judge(const std::filesystem::path& file)
{
  VolumeErrors errors{file.filename().string().substr(0, 20)};
  for (const LeftOutTilt& tilt : LeaveTiltsOut(MakePolarVolume(ReadLevel2(file), MomentName::REF)))
  {
    const std::vector<SortedTilt> tilts = SortTilts(tilt.others);
    const NearestScheme nearest(tilts);
    const BarnesScheme barnes(tilts, barnesLengths);
    const auto merge = [&tilt](bool sharpen, bool trend)
    {
      BeamMergeOptions options;
      options.sharpen = sharpen;
      options.trend = trend;
      return MergedScheme(tilt.others, options, tilt.farthest, tilt.highest);
    };
    const MergedScheme measured = merge(false, false);
    const MergedScheme sharpened = merge(true, false);
    const MergedScheme trend = merge(false, true);
    const MergedScheme beam = merge(true, true);
    AddErrors(tilt, {&nearest, &barnes, &measured, &sharpened, &trend, &beam}, errors.schemes);
  }
  return errors;
}

using Figure = double (GateErrors::*)() const;

double MeanOf(const std::vector<VolumeErrors>& volumes, Scheme scheme,
  GateErrors SchemeErrors::*judged, Figure figure)
{
  double sum = 0.0;
  for (const VolumeErrors& volume : volumes)
  {
    sum += (volume.schemes[scheme].*judged.*figure)();
  }
  return sum / static_cast<double>(volumes.size());
}

// Of each scheme the figure in the middle of the gate, and over the beam.
void PrintTable(const char* title, const std::vector<VolumeErrors>& volumes, Figure figure)
{
  std::printf("\n%-21s", title);
  for (const char* name : names)
  {
    std::printf("%14s", name);
  }
  std::printf("\n");
  for (const VolumeErrors& volume : volumes)
  {
    std::printf("%-21s", volume.name.c_str());
    for (const SchemeErrors& scheme : volume.schemes)
    {
      std::printf("  %5.2f /%5.2f", (scheme.point.*figure)(), (scheme.beam.*figure)());
    }
    std::printf("  %7zu gates\n", volume.schemes[Beam].beam.gates);
  }
  std::printf("%-21s", "mean");
  for (std::size_t i = 0; i < SchemeCount; ++i)
  {
    const auto scheme = static_cast<Scheme>(i);
    std::printf("  %5.2f /%5.2f", MeanOf(volumes, scheme, &SchemeErrors::point, figure),
      MeanOf(volumes, scheme, &SchemeErrors::beam, figure));
  }
  std::printf("\n");
}

} // namespace

TEST(LeftOutTilt, IsForetoldBetterByTheMergeThanByNearestAndBarnes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  std::vector<VolumeErrors> volumes;
  for (const char* file : files)
  {
    volumes.push_back(Judge(data / "level2" / file));
    EXPECT_AT_LEAST(volumes.back().schemes[Beam].beam.gates, 4'000u, "gates of a volume compared")
      << file;
  }
  std::printf("In the middle of the gate / over the beam, dB:\n");
  PrintTable("RMSE, 10 dBZ or more", volumes, &GateErrors::Rmse);
  PrintTable("bias, 10 dBZ or more", volumes, &GateErrors::Bias);
  PrintTable("bias, foretold 10 dBZ", volumes, &GateErrors::BiasOfForetold);
  PrintTable("bias, all echo", volumes, &GateErrors::BiasOfEcho);

  const auto rmse = [&volumes](Scheme scheme, GateErrors SchemeErrors::*judged)
  { return MeanOf(volumes, scheme, judged, &GateErrors::Rmse); };
  for (const auto judged : {&SchemeErrors::point, &SchemeErrors::beam})
  {
    EXPECT_AT_MOST(rmse(Beam, judged) / std::min(rmse(Nearest, judged), rmse(Barnes, judged)), 0.8,
      "RMSE of beam, part of the better one of nearest and Barnes");
    EXPECT_LT(rmse(Trend, judged), rmse(Measured, judged));
    EXPECT_LT(rmse(Beam, judged), rmse(Sharpened, judged));
  }
  EXPECT_LT(rmse(Sharpened, &SchemeErrors::beam), rmse(Measured, &SchemeErrors::beam));
  EXPECT_LT(rmse(Beam, &SchemeErrors::beam), rmse(Trend, &SchemeErrors::beam));
  const auto bias = [&volumes](GateErrors SchemeErrors::*judged)
  { return MeanOf(volumes, Beam, judged, &GateErrors::BiasOfEcho); };
  EXPECT_WITHIN(bias(&SchemeErrors::point), 0.0, 0.2, "bias of beam in the middle of the gate, dB");
  EXPECT_WITHIN(bias(&SchemeErrors::beam), 0.0, 0.2, "bias of beam over the beam, dB");
}
