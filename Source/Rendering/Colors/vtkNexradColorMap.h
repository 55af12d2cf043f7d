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
  };

  std::string Name;
  std::string Array = "REF"; ///< the moment whose values the places are
  /// Red, green, blue, opacity; places ascend within each. A file without opacities leaves the last
  /// one empty.
  std::array<std::vector<Node>, 4> Channels;
  std::vector<Bin> Bins; ///< ascending; empty: the map has no steps

  /// Makes the nodes of red, green and blue from the bins: a box of one colour has a node in its
  /// middle; a ramp has one at each end that it shares with a neighbour, and a quarter of its width
  /// inside where the colour jumps.
  void MakeColorNodesFromBins();
};

/// Reads and writes the text of colour maps. A reader returns an empty string, or says what is
/// wrong and what would be right; then the map is of no use. Numbers are read the same in any
/// locale.
namespace vtkNexradColorMapText
{

/// ParaView's JSON (an array of maps, of which the first is taken, or one map). RGBPoints, and
/// Points for the opacity, become nodes; colour spaces other than RGB, and opacities with midpoints
/// or sharpness, are sampled eight times between points. Nodes written by FormatJSON come back as
/// they were.
std::string ParseJSON(const std::string& text, vtkNexradColorMap& map);

/// The same as ParaView reads it, sampled finely enough to look alike, with the nodes themselves
/// under a key that ParaView passes over. `samples`: dBZ, red, green, blue, opacity.
std::string FormatJSON(
  const vtkNexradColorMap& map, const std::vector<std::array<double, 5>>& samples);

/// A .pal table of GRLevelX and its kin: Color, Color4, SolidColor, SolidColor4, Scale, Offset;
/// other statements are passed over.
std::string ParsePalette(const std::string& text, vtkNexradColorMap& map);

/// The bins as a .pal table; without bins, ramps between the samples.
std::string FormatPalette(
  const vtkNexradColorMap& map, const std::vector<std::array<double, 5>>& samples);

/// Lines "dbz,#rrggbb" below a heading: the colour from that value up to the next.
std::string ParseTable(const std::string& text, vtkNexradColorMap& map);

} // namespace vtkNexradColorMapText

#endif
