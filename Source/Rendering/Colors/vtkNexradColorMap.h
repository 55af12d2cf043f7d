// SPDX-License-Identifier: BSD-3-Clause
// What a colour map is between its file and vtkNexradTransferFunction.
#ifndef vtkNexradColorMap_h
#define vtkNexradColorMap_h

#include <array>
#include <string>
#include <vector>

/// Nodes of the four channels over the data, and the steps that a colour bar shows.
struct vtkNexradColorMap
{
  /// Place (in the unit of the data) and value (0 to 1).
  using Node = std::array<double, 2>;
  using Color = std::array<double, 3>;

  /// One box of a colour bar: a colour from a value up to another, or a ramp of two colours.
  struct Bin
  {
    double From = 0.0; ///< unit of the data
    double To = 0.0;   ///< same unit, above From
    Color Lower{};
    Color Upper{};

    bool operator==(const Bin& other) const
    {
      return this->From == other.From && this->To == other.To && this->Lower == other.Lower &&
             this->Upper == other.Upper;
    }
  };

  /// Places of nodes and bins lie within plus and minus this, so that slopes between them can be
  /// computed.
  static constexpr double LargestPlace = 1e30;

  /// Whether a place lies so far above another that slopes between them can be computed.
  static bool IsAbove(double place, double other);

  std::string Name;
  std::string Array = "REF"; ///< the moment whose values the places are
  /// Red, green, blue, opacity; places ascend within each. A file without opacities leaves the last
  /// one empty.
  std::array<std::vector<Node>, 4> Channels;
  /// Values whose surfaces are to be drawn, in any order; then the opacity has a shell about each.
  std::vector<double> IsoValues;
  std::vector<Bin> Bins; ///< ascending; empty: the map has no steps

  /// Makes the nodes of red, green and blue from the bins: a box of one colour has a node in its
  /// middle; a ramp has one at each end that it shares with a neighbour, and a quarter of its width
  /// inside where the colour jumps.
  void MakeColorNodesFromBins();
};

#endif
