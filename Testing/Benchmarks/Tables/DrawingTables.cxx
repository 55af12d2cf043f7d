// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/DrawingTables.h"

#include "Tables/ThesisFigures.h"
#include "Volumes/WriteVolumes.h"

#include <algorithm>

namespace nexrad::application
{
namespace
{

constexpr int usualSlices = 256; // of the thesis's table 4.2

// As many steps as are wanted, or as there are, in the middle of the series.
std::vector<Time> MiddleSteps(const std::vector<Time>& times, std::size_t wanted)
{
  const std::size_t count = std::min(wanted, times.size());
  const auto first = times.begin() + static_cast<std::ptrdiff_t>((times.size() - count) / 2);
  return {first, first + static_cast<std::ptrdiff_t>(count)};
}

Measurement InMilliseconds(const Measurement& time)
{
  return {1e3 * time.median, 1e3 * time.least, 1e3 * time.most};
}

std::string Suffix(bool synthetic)
{
  return synthetic ? ", SYNTHETIC" : "";
}

double FramesPerSecond(double read, double upload, double draw)
{
  return 1.0 / (read + upload + draw);
}

const FrameTimes* FindFrames(const DrawingOfSize& size, int slices)
{
  const auto found = std::find_if(size.frames.begin(), size.frames.end(),
    [slices](const FrameTimes& frames) { return frames.slices == slices; });
  return found == size.frames.end() ? nullptr : &*found;
}

void AddSteps(const DrawingOfSize& size, const FrameTimes& frames, BenchTable& table)
{
  const std::string name = FormatDimensions(size.dimensions);
  const ThesisFigures* thesis = FindThesisFigures(size.dimensions);
  const auto ofThesis = [thesis](auto figure)
  { return thesis ? BenchCell(thesis->*figure) : BenchCell(); };
  const auto total = [](const Measurement& read, const Measurement& upload, const Measurement& draw)
  { return 1e3 * (read.median + upload.median + draw.median); };
  table.rows.push_back(
    {name, std::string("t1, read"), thesis ? BenchCell(std::string(thesis->readMs)) : BenchCell(),
      InMilliseconds(size.read), InMilliseconds(size.rayCastingRead)});
  table.rows.push_back({name, std::string("t2, upload"), ofThesis(&ThesisFigures::uploadMs),
    InMilliseconds(size.upload), InMilliseconds(size.rayCastingUpload)});
  table.rows.push_back({name, std::string("t3, draw"), ofThesis(&ThesisFigures::drawMs),
    InMilliseconds(frames.slicing), InMilliseconds(frames.rayCasting)});
  table.rows.push_back({name, std::string("total"), ofThesis(&ThesisFigures::totalMs),
    total(size.read, size.upload, frames.slicing),
    total(size.rayCastingRead, size.rayCastingUpload, frames.rayCasting)});
}

BenchCell ThesisRate(const std::array<int, 3>& dimensions, int slices)
{
  for (std::size_t size = 0; size < ThesisTables.size(); ++size)
  {
    for (const ThesisFrameRates& rates : ThesisFrameRateTable)
    {
      if (ThesisTables[size].dimensions == dimensions && rates.slices == slices)
      {
        return rates.framesPerSecond[size];
      }
    }
  }
  return {};
}

} // namespace

DrawingRequest PrepareDrawing(const BenchRequest& request)
{
  const std::vector<Time> steps =
    MiddleSteps(StepsOf(request), static_cast<std::size_t>(request.runs) + 1);
  DrawingRequest drawing;
  drawing.runs = request.runs;
  for (const ThesisFrameRates& rates : ThesisFrameRateTable)
  {
    drawing.slices.push_back(rates.slices);
  }
  for (const std::array<int, 3>& dimensions : request.dimensions)
  {
    GridJob job;
    job.inputs = request.files;
    job.folder = request.folder / ("drawing-" + FormatDimensions(dimensions));
    job.options = request.options;
    job.options.grid.dimensions = dimensions;
    job.options.begin = steps.front();
    job.options.end = steps.back();
    drawing.volumes.push_back({dimensions, WriteVolumes(job).files});
  }
  return drawing;
}

BenchTable MakeRenderingTable(const DrawingReport& report, bool synthetic)
{
  BenchTable table;
  table.key = "rendering";
  table.title = "Thesis, table 4.2: milliseconds to read and decompress a volume (t1), to put it "
                "into texture memory (t2), to draw a frame of 256 slices, 796x532 (t3)" +
                Suffix(synthetic);
  table.columns = {NameColumn("dimensions", "voxels"), NameColumn("step", "step"),
    GivenColumn("thesis_ms", "thesis", 1), {"slices_ms", "here, slices", 1},
    {"ray_caster_ms", "here, GPU ray caster", 1}};
  for (const DrawingOfSize& size : report.sizes)
  {
    if (const FrameTimes* frames = FindFrames(size, usualSlices))
    {
      AddSteps(size, *frames, table);
    }
  }
  return table;
}

BenchTable MakeFrameRateTable(const DrawingReport& report, bool synthetic)
{
  BenchTable table;
  table.key = "frame_rates";
  table.title = "Thesis, table 4.3: frames a second, 1 / (t1 + t2 + t3), 796x532; the GPU ray "
                "caster's samples are as far apart as the slices" +
                Suffix(synthetic);
  table.columns = {NameColumn("dimensions", "voxels"), NameColumn("slices", "slices"),
    GivenColumn("thesis_fps", "thesis, a second", 1), {"fps", "slices, a second", 1},
    {"ray_caster_fps", "GPU ray caster, a second", 1}, {"t3_ms", "slices, t3, ms", 1},
    {"ray_caster_t3_ms", "GPU ray caster, t3, ms", 1}, {"ratio", "t3 ratio", 2}};
  for (const DrawingOfSize& size : report.sizes)
  {
    for (const FrameTimes& frames : size.frames)
    {
      table.rows.push_back({FormatDimensions(size.dimensions), static_cast<double>(frames.slices),
        ThesisRate(size.dimensions, frames.slices),
        FramesPerSecond(size.read.median, size.upload.median, frames.slicing.median),
        FramesPerSecond(
          size.rayCastingRead.median, size.rayCastingUpload.median, frames.rayCasting.median),
        InMilliseconds(frames.slicing), InMilliseconds(frames.rayCasting),
        frames.slicing.median / frames.rayCasting.median});
    }
  }
  return table;
}

} // namespace nexrad::application
