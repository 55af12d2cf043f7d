// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

class vtkImageData;
class vtkNexradTransferFunction;

namespace nexrad::scene
{

/// Where the echo of a volume is that can be seen, and how much it hides.
struct EchoExtent
{
  /// How many lines through the volume meet how much: line i counts those of an optical depth of
  /// about DepthOf(i).
  using Depths = std::array<double, 64>;

  /// West, east, south and north in the volume's x and y; bottom and top in m above mean sea level.
  std::array<double, 6> box{};
  Depths upright{}; ///< of vertical lines, were heights not stretched
  Depths level{};   ///< of lines along x and along y
};

/// The middle optical depth of a line of EchoExtent::Depths, with opacities of OpacityUnitDistance.
double DepthOf(std::size_t line);

/// The echo of a volume as those opacities show it. The box holds at least 3/4 of what a view from
/// above shows: strips at its sides with much less echo than the rest, each with at most 3/20 of
/// the echo, and regions of less than 1 in 200, are left out, so that neither specks nor distant
/// showers decide. Nothing where no echo is seen.
std::optional<EchoExtent> FindExtent(vtkImageData* volume, vtkNexradTransferFunction* opacities);

/// What holds both.
EchoExtent Join(const EchoExtent& a, const EchoExtent& b);

/// The length along a ray, in scene units, to which opacities are to belong: so that what is seen
/// has an opacity of about 0.7 in the mean, and a volume of weak echo, a small one or a flat one is
/// seen as well as a large storm through its skirts. From a tenth to four times
/// OpacityUnitDistance.
double OpacityDistanceOf(const EchoExtent& echo, double exaggeration);

} // namespace nexrad::scene
