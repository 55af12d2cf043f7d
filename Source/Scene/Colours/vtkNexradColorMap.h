// SPDX-License-Identifier: BSD-3-Clause
// What a colour map is between its file and vtkNexradTransferFunction.
#ifndef vtkNexradColorMap_h
#define vtkNexradColorMap_h

#include <array>
#include <optional>
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

    /// The colour at a value between From and To.
    Color GetColor(double value) const;

    bool operator==(const Bin& other) const
    {
      return this->From == other.From && this->To == other.To && this->Lower == other.Lower &&
             this->Upper == other.Upper;
    }
  };

  /// How a colour bar writes the values of the data: factor × value + offset, in a unit of its own.
  struct Labels
  {
    std::string Unit; ///< empty: that of the data
    double Factor = 1.0;
    double Offset = 0.0;
    double Step = 0.0; ///< from one label to the next, in that unit; 0: any
    int Decimals = -1; ///< behind the point; -1: as many as it takes

    bool operator==(const Labels& other) const
    {
      return this->Unit == other.Unit && this->Factor == other.Factor &&
             this->Offset == other.Offset && this->Step == other.Step &&
             this->Decimals == other.Decimals;
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
  /// Which channels go from node to node in straight lines; the others are splines.
  std::array<bool, 4> Linear{};
  /// Values whose surfaces are to be drawn, in any order; then the opacity has a shell about each.
  std::vector<double> IsoValues;
  std::vector<Bin> Bins; ///< ascending; empty: the map has no steps
  Labels Bar;
  std::optional<Color> RangeFolded; ///< of range-folded gates and voxels, where the map has one
  /// What was passed over in the file, a line each that begins with the number of the file's line.
  std::vector<std::string> PassedOver;

  /// Makes the nodes of red, green and blue from the bins: a box of one colour has a node in its
  /// middle; a ramp has one at each end that it shares with a neighbour, and a quarter of its width
  /// inside where the colour jumps.
  void MakeColorNodesFromBins();
};

#endif
