// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Plan/PlanView.h"
#include "Scene/Scales/ColourScale.h"
#include "nexrad/Grid/GriddedVolume.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

class vtkImageData;
class vtkNexradTransferFunction;

namespace nexrad::scene
{

/// What echo a volume or a map has, and whether a picture shows any of it.
struct EchoShown
{
  /// Takes note of a voxel, or of a column of a map. `opacityOf` says how opaque its value is
  /// drawn.
  void Add(VoxelState state, double value, const std::function<double(double)>& opacityOf);

  bool isKnown = true;   ///< false: the volume's array is no moment
  bool enough = false;   ///< something is to be seen; then nothing further is counted
  double shown = 0.0;    ///< sum of the opacities of the voxels
  bool scanned = false;  ///< some voxel was measured, or is range folded
  bool filtered = false; ///< quality control took echo out of some voxel
  std::size_t echo = 0;  ///< voxels with a value
  double lowest = 0.0;   ///< of their values, in the unit of the moment
  double highest = 0.0;
  double opacityOfHighest = 0.0; ///< of the value `highest`
};

/// Looks through the voxels of a volume of values or of codes whose middles lie in a box: west,
/// east, south, north, bottom and top in the units of the volume; empty: in all. `opacityOf` says
/// how opaque a value is drawn, 0…1.
EchoShown FindEchoShown(vtkImageData* volume, const std::optional<std::array<double, 6>>& box,
  const std::function<double(double)>& opacityOf);

/// The sum of opacities from which something is to be seen, among columns seen from above.
double EnoughShown(int width, int height);

/// The opacity of each value in a look, for FindEchoShown.
std::function<double(double)> OpacitiesOf(vtkNexradTransferFunction* look);

/// The value from which a look shows all that is above it; nothing where it shows other values.
std::optional<double> LeastShown(vtkNexradTransferFunction* look);

/// The echo of a volume in words: "clear-air echo up to 3 dBZ". `biologicalShare`: of the echo,
/// 0…1.
std::string EchoUpTo(const EchoShown& found, double biologicalShare);

/// What the values of an array are called: "echo", or the name of the array.
std::string WordFor(const std::string& array);

/// What is said where no voxel has a value of that name: that there is none, or that nothing was
/// scanned.
std::string WordsForNone(const EchoShown& found, const std::string& name);

/// How a caption names a preset: as an option of the program, or as a setting.
enum class PresetWords
{
  Option, ///< --preset "clear air"
  Setting ///< preset "clear air"
};

/// What a picture that shows nothing, or next to nothing, says: that there is no echo above the
/// value from which it is shown (nothing where no such value is), and what there is; empty where
/// something is to be seen.
std::string WordsForNothing(const EchoShown& found, const std::string& array,
  const std::optional<double>& leastShown, double biologicalShare, PresetWords presets);

/// The values of a map's columns, and how many of them have a colour of its scale.
EchoShown FindMapShown(const PlanView& view, const ColourScale& scale);

/// What a map that shows nothing, or next to nothing, says: that it has no value above the first
/// of its scale, or none at all, and what there is in the volume that it is of. Empty where
/// something is to be seen.
std::string WordsForMap(const PlanView& view, const PlanOptions& plan, const ColourScale& scale,
  vtkImageData* volume, double biologicalShare, PresetWords presets);

} // namespace nexrad::scene
