// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Captions/MapShown.h"

#include "Scene/Frame/VolumeInformation.h"
#include "nexrad/Model/Moment.h"

#include <algorithm>
#include <optional>
#include <sstream>

namespace nexrad::scene
{
namespace
{

// A value of a map, to two digits that count.
std::string SmallText(double value)
{
  constexpr double least = 0.01;
  std::ostringstream text;
  text.precision(2);
  text << std::max(value, least);
  return (value < least ? "less than " : "") + text.str();
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
  std::ostringstream threshold;
  threshold << plan.threshold;
  return none + (all.highest < plan.threshold ? ": no echo of " + threshold.str() + " dBZ" : "") +
         "; " + EchoUpTo(all, biologicalShare);
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

} // namespace

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

std::string WordsForMap(const PlanView& view, const PlanOptions& plan, const ColourScale& scale,
  vtkImageData* volume, double biologicalShare, PresetWords presets)
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
  return WordsForNothing(found, array, leastShown, biologicalShare, presets);
}

} // namespace nexrad::scene
