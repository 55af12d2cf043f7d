// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradColorMap.h"

#include <algorithm>
#include <cmath>

bool vtkNexradColorMap::IsAbove(double place, double other)
{
  constexpr double leastShare = 1e-9; // of the larger of the two
  constexpr double leastDistance = 1e-30;
  return place - other >
         std::max(leastDistance, leastShare * std::max(std::abs(place), std::abs(other)));
}

vtkNexradColorMap::Color vtkNexradColorMap::Bin::GetColor(double value) const
{
  const double share = (value - this->From) / (this->To - this->From);
  Color color{};
  for (std::size_t i = 0; i < color.size(); ++i)
  {
    color[i] = (1.0 - share) * this->Lower[i] + share * this->Upper[i];
  }
  return color;
}

void vtkNexradColorMap::MakeColorNodesFromBins()
{
  for (std::size_t channel = 0; channel < 3; ++channel)
  {
    std::vector<Node>& nodes = this->Channels[channel];
    nodes.clear();
    for (std::size_t i = 0; i < this->Bins.size(); ++i)
    {
      const Bin& bin = this->Bins[i];
      const double width = bin.To - bin.From;
      const double lower = bin.Lower[channel];
      const double upper = bin.Upper[channel];
      if (bin.Lower == bin.Upper)
      {
        nodes.push_back({bin.From + 0.5 * width, lower});
        continue;
      }
      const bool jumpsBelow = i > 0 && this->Bins[i - 1].Upper != bin.Lower;
      const bool jumpsAbove = i + 1 < this->Bins.size() && this->Bins[i + 1].Lower != bin.Upper;
      const double slope = (upper - lower) / width;
      const double first = bin.From + (jumpsBelow ? 0.25 * width : 0.0);
      const double last = bin.To - (jumpsAbove ? 0.25 * width : 0.0);
      // Rounding may lead beyond the ends of the ramp.
      const auto shareAt = [&](double place)
      { return std::clamp(lower + slope * (place - bin.From), 0.0, 1.0); };
      // The end of a ramp is the beginning of the next where they meet.
      if (nodes.empty() || nodes.back()[0] < first)
      {
        nodes.push_back({first, shareAt(first)});
      }
      nodes.push_back({last, shareAt(last)});
    }
  }
}
