// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Beams/VolumeSummary.h"

#include "nexrad/System/Error.h"

#include <algorithm>

namespace nexrad
{

namespace
{

constexpr float notScanned = -1.0F;
constexpr int longestRun = 1 << 23; // a float still counts in ones

float ValueOf(const VolumeComposite& composite, std::size_t cell)
{
  return composite.cells[cell] == VolumeComposite::Cell::NotScanned ? notScanned
                                                                    : composite.values[cell];
}

std::vector<float> PackPicture(const VolumeComposite& composite)
{
  std::vector<float> picture;
  const std::size_t count = composite.cells.size();
  for (std::size_t cell = 0; cell < count;)
  {
    const float value = ValueOf(composite, cell);
    int run = 1;
    while (run < longestRun && cell + static_cast<std::size_t>(run) < count &&
           ValueOf(composite, cell + static_cast<std::size_t>(run)) == value)
    {
      ++run;
    }
    if (run > 1)
    {
      picture.push_back(-static_cast<float>(run));
    }
    picture.push_back(value);
    cell += static_cast<std::size_t>(run);
  }
  return picture;
}

PackedComposite Pack(const VolumeComposite& composite)
{
  return {
    composite.rings, composite.echoTime, composite.echo, composite.tilts, PackPicture(composite)};
}

// The cells of a composite, one after the other.
class CellWriter
{
public:
  explicit CellWriter(VolumeComposite& target)
    : composite(target)
  {
  }

  void Write(float value, std::size_t count)
  {
    if (count > composite.cells.size() - next)
    {
      throw Error("the picture of a volume has more cells than its rings");
    }
    const auto cell = value < 0.0F   ? VolumeComposite::Cell::NotScanned
                      : value > 0.0F ? VolumeComposite::Cell::Held
                                     : VolumeComposite::Cell::NoEcho;
    const auto from = static_cast<std::ptrdiff_t>(next);
    std::fill_n(composite.cells.begin() + from, count, cell);
    std::fill_n(composite.values.begin() + from, count, std::max(0.0F, value));
    next += count;
  }

  bool AtEnd() const { return next == composite.cells.size(); }

private:
  VolumeComposite& composite;
  std::size_t next = 0;
};

} // namespace

std::size_t VolumeSummary::MemoryBytes() const
{
  std::size_t bytes = sizeof(*this);
  for (const PackedComposite* packed : {&composite, &lowest})
  {
    bytes +=
      packed->picture.size() * sizeof(float) + packed->tilts.size() * sizeof(VolumeComposite::Tilt);
  }
  return bytes;
}

VolumeSummary MakeSummary(const BeamVolume& volume)
{
  VolumeSummary summary;
  if (volume.moment == MomentName::REF)
  {
    summary.composite = Pack(volume.composite);
    summary.lowest = Pack(volume.lowest);
  }
  for (const BeamSweep& sweep : volume.sweeps)
  {
    summary.reach = std::max(summary.reach, static_cast<double>(sweep.Reach()));
  }
  return summary;
}

VolumeSummary MakeSummary(const PolarVolume& volume)
{
  VolumeSummary summary;
  if (volume.moment == MomentName::REF)
  {
    summary = MakeSummary(PrepareBeamVolume(volume));
  }
  for (const PolarSweep& sweep : volume.sweeps)
  {
    summary.reach = std::max(
      summary.reach, sweep.firstGate + static_cast<double>(sweep.gates) * sweep.gateSpacing);
  }
  return summary;
}

VolumeComposite CompositeOf(const PackedComposite& packed)
{
  VolumeComposite composite;
  composite.rings = packed.rings;
  composite.echoTime = packed.echoTime;
  composite.echo = packed.echo;
  composite.tilts = packed.tilts;
  const std::size_t size = composite.Index(VolumeComposite::Sectors, 0);
  composite.cells.assign(size, VolumeComposite::Cell::NotScanned);
  composite.tops.assign(size, 0);
  composite.values.assign(size, 0.0F);
  CellWriter writer(composite);
  std::size_t count = 1;
  for (const float word : packed.picture)
  {
    if (word <= -2.0F)
    {
      count = static_cast<std::size_t>(-word);
      continue;
    }
    writer.Write(word, count);
    count = 1;
  }
  if (!writer.AtEnd())
  {
    throw Error("the picture of a volume has fewer cells than its rings");
  }
  return composite;
}

} // namespace nexrad
