// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Captions/EchoShown.h"

#include "Scene/Frame/VolumeInformation.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/System/Error.h"
#include "vtkNexradTransferFunction.h"

#include <vtkImageData.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace nexrad::scene
{
namespace
{

// What echo a volume or a map has, and whether a picture shows any of it.
struct EchoShown
{
  // Takes note of a voxel, or of a column of a map. `opacityOf` says how opaque its value is
  // drawn.
  void Add(VoxelState state, double value, const std::function<double(double)>& opacityOf);

  bool isKnown = true;   // false: the volume's array is no moment
  bool enough = false;   // something is to be seen; then nothing further is counted
  double shown = 0.0;    // sum of the opacities of the voxels
  bool scanned = false;  // some voxel was measured, or is range folded
  bool filtered = false; // quality control took echo out of some voxel
  std::size_t echo = 0;  // voxels with a value
  double lowest = 0.0;   // of their values, in the unit of the moment
  double highest = 0.0;
  double opacityOfHighest = 0.0; // of the value `highest`
};

// Which of a volume's voxels along an axis lie between two places: from the first to before the
// second.
std::array<int, 2> VoxelsBetween(vtkImageData* volume, int axis, double from, double to)
{
  const double origin = volume->GetOrigin()[axis];
  const double spacing = volume->GetSpacing()[axis];
  const int count = volume->GetDimensions()[axis];
  const auto at = [&](double place)
  { return static_cast<int>(std::clamp(std::ceil((place - origin) / spacing), 0.0, 1.0 * count)); };
  return {at(from), at(to)};
}

bool Shows(vtkNexradTransferFunction* look, double value)
{
  return look->Evaluate(vtkNexradTransferFunction::OPACITY, value) > 0.0;
}

std::string Text(double value)
{
  return NumberWord(std::round(10.0 * value) / 10.0 + 0.0);
}

// The first preset of the array, in their order, that shows a value well, and clearly better than
// with an opacity; nullptr: none does.
const char* PresetThatShows(const std::string& array, double value, double opacity)
{
  constexpr double seen = 0.015;
  constexpr double better = 2.0;
  const double wanted = std::max(seen, better * opacity);
  vtkNew<vtkNexradTransferFunction> look;
  const char* name = nullptr;
  for (int i = 0; (name = vtkNexradTransferFunction::FindPreset(array.c_str(), i)) != nullptr; ++i)
  {
    if (look->ApplyPreset(name) &&
        look->Evaluate(vtkNexradTransferFunction::OPACITY, value) >= wanted)
    {
      return name;
    }
  }
  return nullptr;
}

// The sum of opacities from which something is to be seen, among columns seen from above: in
// 256 × 256 of them fifteen voxels of 35 dBZ, or a hundred of the weakest rain.
double EnoughShown(int width, int height)
{
  constexpr double ofColumn = 5e-5;
  constexpr double least = 0.02; // a voxel of rain, where there are few
  return std::max(least, ofColumn * width * height);
}

// The echo of a volume in words: "clear-air echo up to 3 dBZ".
std::string EchoUpTo(const EchoShown& found, double biologicalShare)
{
  constexpr double weakest = 5.0; // dBZ: the weather service's colours begin there
  const char* kind = biologicalShare > MostlyBiological ? "biological echo"
                     : found.highest < weakest          ? "clear-air echo"
                                                        : "echo";
  return std::string(kind) + " up to " + Text(found.highest) + " " + UnitOf(MomentName::REF);
}

// What the values of an array are called.
std::string WordFor(const std::string& array)
{
  return array == ToString(MomentName::REF) ? "echo" : array;
}

// What is said where no voxel has a value of that name.
std::string WordsForNone(const EchoShown& found, const std::string& name)
{
  if (!found.scanned)
  {
    return "Nothing was scanned here";
  }
  return "No " + name + (found.filtered ? ": quality control took out all that there was" : "");
}

// What there is in place of what the look shows, and the preset that shows it.
std::string WordsForTheRest(const EchoShown& found, const std::string& array,
  const std::string& unit, double biologicalShare, bool namesOptions)
{
  std::string words =
    array == ToString(MomentName::REF)
      ? EchoUpTo(found, biologicalShare)
      : "values from " + Text(found.lowest) + " to " + Text(found.highest) + " " + unit;
  const char* preset = PresetThatShows(array, found.highest, found.opacityOfHighest);
  if (preset != nullptr)
  {
    words += std::string(namesOptions ? ": --preset \"" : ": preset \"") + preset + "\"";
  }
  return words;
}

void EchoShown::Add(VoxelState state, double value, const std::function<double(double)>& opacityOf)
{
  filtered = filtered || state == VoxelState::Filtered;
  scanned = scanned || state != VoxelState::NotScanned;
  if (state != VoxelState::Echo)
  {
    return;
  }
  lowest = echo == 0 ? value : std::min(lowest, value);
  const double opacity = opacityOf(value);
  if (echo == 0 || value > highest)
  {
    highest = value;
    opacityOfHighest = opacity;
  }
  ++echo;
  shown += opacity;
}

// Looks through the voxels of a volume of values or of codes whose middles lie in a box: west,
// east, south, north, bottom and top in the units of the volume; empty: in all. `opacityOf` says
// how opaque a value is drawn, 0…1.
EchoShown FindEchoShown(vtkImageData* volume, const std::optional<std::array<double, 6>>& box,
  const std::function<double(double)>& opacityOf)
{
  EchoShown found;
  PlanSource source;
  try
  {
    source = SourceOf(volume);
  }
  catch (const Error&) // no moment, or values alone without states
  {
    found.isKnown = false;
    return found;
  }
  const int* size = volume->GetDimensions();
  std::array<std::array<int, 2>, 3> part = {{{0, size[0]}, {0, size[1]}, {0, size[2]}}};
  for (int axis = 0; box && axis < 3; ++axis)
  {
    const auto face = static_cast<std::size_t>(2 * axis);
    part[static_cast<std::size_t>(axis)] =
      VoxelsBetween(volume, axis, (*box)[face], (*box)[face + 1]);
  }
  const auto& [x, y, z] = part;
  const double enough = EnoughShown(size[0], size[1]);
  std::vector<float> values(static_cast<std::size_t>(std::max(0, x[1] - x[0])));
  std::vector<VoxelState> states(values.size());
  for (int k = z[0]; k < z[1]; ++k)
  {
    for (int j = y[0]; j < y[1] && found.shown < enough; ++j)
    {
      const std::size_t line = static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) +
                               static_cast<std::size_t>(j);
      source.voxels.read(line * static_cast<std::size_t>(size[0]) + static_cast<std::size_t>(x[0]),
        values.size(), values.data(), states.data());
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        found.Add(states[i], static_cast<double>(values[i]), opacityOf);
      }
    }
  }
  found.enough = found.shown >= enough;
  return found;
}

// The opacity of each value in a look.
std::function<double(double)> OpacitiesOf(vtkNexradTransferFunction* look)
{
  constexpr std::size_t last = 4095;
  double range[2];
  look->GetRange(range);
  const double first = range[0];
  const double step = std::max(range[1] - range[0], 1e-12) / last;
  std::vector<double> table;
  for (std::size_t i = 0; i <= last; ++i)
  {
    table.push_back(
      look->Evaluate(vtkNexradTransferFunction::OPACITY, first + step * static_cast<double>(i)));
  }
  return [table = std::move(table), first, step](double value)
  {
    const double place = std::clamp(std::round((value - first) / step), 0.0, 1.0 * last);
    return table[static_cast<std::size_t>(place)];
  };
}

// The value from which a look shows all that is above it; nothing where it shows other values.
std::optional<double> LeastShown(vtkNexradTransferFunction* look)
{
  constexpr int steps = 2000;
  double range[2];
  look->GetRange(range);
  const double step = (range[1] - range[0]) / steps;
  if (!Shows(look, range[1]) || !(step > 0.0))
  {
    return std::nullopt;
  }
  int least = steps;
  while (least > 0 && Shows(look, range[0] + step * (least - 1)))
  {
    --least;
  }
  const bool alsoBelow = least > 0 && Shows(look, range[0]);
  return alsoBelow ? std::nullopt : std::optional(range[0] + step * std::max(0, least - 1));
}

// As WordsForNothing, of what was found.
std::string WordsForFound(const EchoShown& found, const std::string& array,
  const std::optional<double>& leastShown, double biologicalShare, bool namesOptions)
{
  if (found.enough || !found.isKnown)
  {
    return {};
  }
  const std::string what = WordFor(array);
  if (found.echo == 0)
  {
    return WordsForNone(found, what);
  }
  const std::string unit = UnitOf(*ParseMomentName(array));
  return (found.shown > 0.0 ? "Hardly any " : "No ") + what +
         (leastShown ? " above " + Text(*leastShown) + " " + unit : std::string(" is shown")) +
         "; " + WordsForTheRest(found, array, unit, biologicalShare, namesOptions);
}

// A value of a map, to two digits that count.
std::string SmallText(double value)
{
  constexpr double least = 0.01;
  return (value < least ? "less than " : "") + NumberWord(std::max(value, least), 2);
}

const char* NameOf(PlanLevel product)
{
  switch (product)
  {
  case PlanLevel::EchoTop:
    return "echo top";
  case PlanLevel::LiquidDensity:
    return "VIL density";
  default:
    return "vertically integrated liquid";
  }
}

EchoShown AllEchoOf(vtkImageData* volume)
{
  return FindEchoShown(volume, std::nullopt, [](double) { return 0.0; });
}

// Why no column has a value of a product.
std::string WhyNone(const PlanOptions& plan, vtkImageData* volume, double biologicalShare)
{
  const EchoShown all = AllEchoOf(volume);
  if (all.echo == 0)
  {
    return WordsForNone(all, "echo");
  }
  const std::string none = std::string("No ") + NameOf(plan.level);
  const bool below = all.highest < plan.threshold;
  return none + (below ? ": no echo of " + NumberWord(plan.threshold) + " dBZ" : "") + "; " +
         EchoUpTo(all, biologicalShare);
}

std::string WordsForProduct(const EchoShown& found, const PlanOptions& plan,
  const ColourScale& scale, vtkImageData* volume, double biologicalShare)
{
  if (found.echo == 0)
  {
    return WhyNone(plan, volume, biologicalShare);
  }
  const double highest = found.highest * scale.factor + scale.offset;
  return std::string(found.shown > 0.0 ? "Hardly any " : "No ") + NameOf(plan.level) + " above " +
         SmallText(scale.bins.front().from) + " " + scale.unit + "; values up to " +
         SmallText(highest) + " " + scale.unit;
}

// What the volume has in other voxels than those of a map without a value.
std::string WordsForOtherVoxels(PlanLevel level, vtkImageData* volume, double biologicalShare)
{
  const EchoShown all = AllEchoOf(volume);
  if (level == PlanLevel::Composite || all.echo == 0)
  {
    return {};
  }
  const std::string array = ArrayOf(volume);
  const std::string what =
    array == ToString(MomentName::REF) ? EchoUpTo(all, biologicalShare) : array;
  return level == PlanLevel::Height ? " at this height; " + what + " at others"
                                    : " in the lowest voxels; " + what + " above them";
}

// The values of a map's columns, and how many of them have a colour of its scale.
EchoShown FindMapShown(const PlanView& view, const ColourScale& scale)
{
  const auto opacityOf = [&](double value) { return ColourAt(scale, value) ? 1.0 : 0.0; };
  EchoShown found;
  for (std::size_t column = 0; column < view.values.size(); ++column)
  {
    found.Add(view.states[column], static_cast<double>(view.values[column]), opacityOf);
  }
  constexpr double asVoxels =
    0.23; // the opacity of 35 dBZ: fifteen columns of 256 × 256 are enough
  found.enough = asVoxels * found.shown >= EnoughShown(view.width, view.height);
  return found;
}

} // namespace

std::string WordsForNothing(vtkImageData* volume, const std::optional<std::array<double, 6>>& box,
  vtkNexradTransferFunction* look, double biologicalShare, bool namesOptions)
{
  return WordsForFound(FindEchoShown(volume, box, OpacitiesOf(look)), ArrayOf(volume),
    LeastShown(look), biologicalShare, namesOptions);
}

std::string WordsForMap(const PlanView& view, const PlanOptions& plan, const ColourScale& scale,
  vtkImageData* volume, double biologicalShare, bool namesOptions)
{
  const EchoShown found = FindMapShown(view, scale);
  const std::string array = ArrayOf(volume);
  if (found.enough)
  {
    return {};
  }
  if (IsColumnProduct(plan.level))
  {
    return WordsForProduct(found, plan, scale, volume, biologicalShare);
  }
  const bool ofMoment = plan.array.empty() || plan.array == array;
  if (found.echo == 0)
  {
    return WordsForNone(found, ofMoment ? WordFor(array) : plan.array) +
           (found.scanned ? WordsForOtherVoxels(plan.level, volume, biologicalShare) : "");
  }
  if (!ofMoment)
  {
    return {}; // its scale has a colour for each value
  }
  const auto leastShown =
    scale.openBelow ? std::nullopt
                    : std::optional((scale.bins.front().from - scale.offset) / scale.factor);
  return WordsForFound(found, array, leastShown, biologicalShare, namesOptions);
}

} // namespace nexrad::scene
