// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace nexrad
{

/// A direction off the beam's middle, in standard deviations of the two-way pattern, and its
/// weight.
struct QuadratureNode
{
  double position;
  double weight;
};

constexpr double Root3 = 1.7320508075688772;

/// The Gauss-Hermite rule of three nodes: for what is smooth across the beam.
constexpr std::array<QuadratureNode, 3> SmoothNodes = {
  {{-Root3, 1.0 / 6.0}, {0.0, 2.0 / 3.0}, {Root3, 1.0 / 6.0}}};

/// How far LayerNodes reach.
constexpr double FarthestNode = 2.4;

/// Equal steps weighted with the pattern: storms are layered, so that the beam meets more change
/// upwards than sideways.
inline const std::array<QuadratureNode, 7>& LayerNodes()
{
  static const std::array<QuadratureNode, 7> layerNodes = []
  {
    std::array<QuadratureNode, 7> nodes{};
    double sum = 0.0;
    for (std::size_t index = 0; index < nodes.size(); ++index)
    {
      const double position = FarthestNode * (static_cast<double>(index) - 3.0) / 3.0;
      nodes[index] = {position, std::exp(-position * position / 2.0)};
      sum += nodes[index].weight;
    }
    for (QuadratureNode& node : nodes)
    {
      node.weight /= sum;
    }
    return nodes;
  }();
  return layerNodes;
}

} // namespace nexrad
