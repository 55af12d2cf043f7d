// SPDX-License-Identifier: BSD-3-Clause
// Merges what the Level II decoder makes of any bytes: quality control, dealiasing and both methods
// get rays that no radar would send. How it is merged depends on the length of the input.
#include "FuzzTarget.h"

#include "nexrad/Level2/Level2File.h"
#include "nexrad/Live/LiveSeries.h"
#include "nexrad/System/Error.h"

#include <cmath>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr std::array<int, 3> dimensions = {8, 8, 4};

MergeOptions OptionsOf(std::size_t choice)
{
  MergeOptions options;
  options.grid.dimensions = dimensions;
  options.grid.range = 20'000.0;
  switch (choice % 4)
  {
  case 0:
    options.method = MergeMethod::Thesis;
    break;
  case 1:
    options.moments = {MomentName::AZSHEAR};
    break;
  case 2:
    options.moments = {MomentName::REF, MomentName::VEL};
    break;
  default:
    break;
  }
  return options;
}

void LookAt(const GriddedVolume& volume)
{
  Require(volume.values.size() == volume.grid.VoxelCount(), "each voxel has a value");
  Require(volume.states.size() == volume.grid.VoxelCount(), "each voxel has a state");
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    const bool echo = volume.states[i] == VoxelState::Echo;
    Require(static_cast<unsigned>(volume.states[i]) < VoxelStateCount, "states are known ones");
    Require(std::isfinite(volume.values[i]), "values are numbers");
    Require(echo || volume.values[i] == volume.fill, "what is no echo has the fill value");
  }
  for (const GriddedVolume& further : volume.further)
  {
    LookAt(further);
  }
}

void Merge(const RadarVolume& volume, const MergeOptions& options)
{
  try
  {
    LiveSeries series(options, {});
    for (const ScannedFile& file : series.Put({{"fuzz", "fuzz", volume, true}}))
    {
      for (const InputProblem& problem : file.problems)
      {
        RequireMessage(problem.what);
      }
    }
    if (series.HasGrid() && series.Known().Last())
    {
      const auto merged = series.Merge(*series.Known().Last());
      Require(merged.has_value(), "a merge that nobody stops is made");
      LookAt(*merged);
    }
  }
  catch (const Error& error)
  {
    RequireMessage(error.what());
  }
}

// Sweeps all round, with echo and velocities.
Bytes VolumeOf(unsigned type, unsigned rays)
{
  RayPlan first;
  first.status = 3;
  first.ref = Bytes(40, 120);
  first.vel = Bytes(40, 150);
  first.width = Bytes(40, 135);
  first.moments = {{"REF", Bytes(40, 120), 40}, {"VEL", Bytes(40, 150), 40}};
  first.moments[1].offset = 129.0F;
  RayPlan second = first;
  second.status = 0;
  second.cut = 2;
  second.elevation = 3.0;
  return Join({MakeVolumeHeader(type == 1 ? "ARCHIVE2." : "AR2V0006"),
    MakeSweepBytes(type, first, rays, 2), MakeSweepBytes(type, second, rays, 4)});
}

} // namespace

namespace nexrad::testing
{

std::vector<Bytes> FuzzSeeds()
{
  return {
    MakeSmallVolume(1), MakeSmallVolume(31), VolumeOf(1, 20), VolumeOf(31, 60), VolumeOf(31, 360)};
}

} // namespace nexrad::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Level2Options options;
  if (IsSanitised)
  {
    options.maximumRecordBytes = std::size_t(1) << 20;
    options.maximumFileBytes = std::size_t(1) << 20;
  }
  options.threads = 1;
  const RadarVolume volume =
    DecodeLevel2(std::vector<std::uint8_t>(data, data + size), "KTLX", options);
  Merge(volume, OptionsOf(size));
  return 0;
}
