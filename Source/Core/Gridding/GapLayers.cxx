// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/GapLayers.h"

namespace nexrad
{

namespace
{

// By the time between the middle of a volume and the merge; half at the usual length of a volume.
float WeightOf(const BeamVolume& volume, Time time)
{
  constexpr float half = 300.0F; // s
  const Time middle = volume.start + (volume.end - volume.start) / 2;
  const float part = static_cast<float>((middle - time).count()) / 1000.0F / half;
  return 1.0F / (1.0F + part * part);
}

} // namespace

float GapLayers::ShareAt(const ColumnDirection& column) const
{
  float share = 0.0F;
  for (const Part& part : parts)
  {
    share += part.weight * part.layers->ShareAt(*part.gap, column);
  }
  return share;
}

std::vector<GapLayers> GapLayers::Find(
  const std::vector<const BeamVolume*>& volumes, const std::vector<BeamTilt>& tilts, Time time)
{
  std::vector<GapLayers> found;
  for (std::size_t i = 0; i + 1 < tilts.size(); ++i)
  {
    GapLayers layers;
    float sum = 0.0F;
    const float middle = 0.5F * (tilts[i].elevation + tilts[i + 1].elevation);
    for (const BeamVolume* volume : volumes)
    {
      if (const EchoLayers::Gap* gap = volume->layers.FindGap(middle))
      {
        layers.parts.push_back({&volume->layers, gap, WeightOf(*volume, time)});
        sum += layers.parts.back().weight;
      }
    }
    for (Part& part : layers.parts)
    {
      part.weight /= sum;
    }
    found.push_back(std::move(layers));
  }
  return found;
}

} // namespace nexrad
