// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ColourField.h"

#include "Scene/Plan/PlanLayer.h"
#include "Scene/VolumeAppearance.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/Error.h"
#include "vtkNexradMessages.h"
#include "vtkNexradTransferFunction.h"
#include "vtkNexradTwoFields.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <string_view>

namespace nexrad::scene
{
namespace
{

// Brown: no table of a moment has it, and grey is a velocity of 0.
constexpr Colour missingColour = {0.44, 0.36, 0.27};

std::string TitleOfArray(const std::string& array)
{
  const auto moment = ParseMomentName(array);
  return moment ? TitleOf(*moment) : array;
}

// The largest colour value where the array of the opacities has a value.
double LargestOf(vtkImageData* volume)
{
  auto* values = vtkFloatArray::SafeDownCast(volume->GetPointData()->GetScalars());
  const std::string name = std::string(values->GetComponentName(1)) + "_state";
  auto* states = vtkUnsignedCharArray::SafeDownCast(volume->GetPointData()->GetArray(name.c_str()));
  const float* value = values->GetPointer(0);
  float largest = 0.0F;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const bool echo =
      !states || states->GetValue(i) == static_cast<unsigned char>(VoxelState::Echo);
    largest = echo ? std::max(largest, value[2 * i]) : largest;
  }
  return static_cast<double>(largest);
}

// One colour at the middle of each bin, and the last one beyond.
void AddBins(const ColourScale& scale, vtkColorTransferFunction* colours)
{
  for (std::size_t i = 0; i < scale.bins.size(); ++i)
  {
    const double from = scale.bins[i].from;
    const double to = i + 1 < scale.bins.size() ? scale.bins[i + 1].from : from;
    const double place = scale.labels.empty() ? 0.5 * (from + to) : from;
    const Colour& colour = scale.bins[i].colour;
    colours->AddRGBPoint(place / scale.factor, colour[0], colour[1], colour[2]);
  }
}

// Brown for what has no value: from a width of the usual range below it, down to the missing value.
void AddMissing(const std::string& array, vtkColorTransferFunction* colours)
{
  double range[2];
  if (!vtkNexradTwoFields::GetUsualRange(array.c_str(), range))
  {
    return;
  }
  const double width = range[1] - range[0];
  double lowest[3];
  colours->GetColor(colours->GetRange()[0], lowest);
  colours->AddRGBPoint(range[0] - width, lowest[0], lowest[1], lowest[2]);
  colours->AddRGBPoint(
    range[0] - 1.01 * width, missingColour[0], missingColour[1], missingColour[2]);
}

void SetMomentColours(const SceneOptions& options, ColourField& field)
{
  SceneOptions own;
  own.colours = options.colours;
  const auto function = MakeTransferFunction(own, options.colourBy);
  function->FillColorFunction(field.colours);
  field.scale = ScaleOf(options.colourBy, function);
}

void SetAncillaryColours(
  const SceneOptions& options, const VolumeInformation& information, ColourField& field)
{
  if (!options.colours.empty())
  {
    throw Error(options.colours.string() + ": " + options.colourBy +
                " has colours of its own; a file of colours is for a moment");
  }
  field.scale = ScaleFor(LargestOf(field.volume), options.colourBy, information.sites, {});
  if (field.scale.bins.empty())
  {
    throw Error(options.colourBy + " has no colours; name a moment, or the age, radars, weight or "
                                   "site of one, as REF_age");
  }
  constexpr std::string_view site = "_site";
  field.categories = options.colourBy.find(site) == options.colourBy.size() - site.size();
  AddBins(field.scale, field.colours);
}

} // namespace

void ColourField::FillProperty(vtkVolumeProperty* property) const
{
  property->SetColor(colours);
  property->IndependentComponentsOff();
  if (categories)
  {
    property->SetInterpolationTypeToNearest();
  }
}

ColourField MakeColourField(
  const SceneOptions& options, vtkImageData* volume, const VolumeInformation& information)
{
  vtkNew<vtkNexradTwoFields> filter;
  vtkNexradMessages messages;
  messages.Watch(filter);
  filter->SetInputData(volume);
  filter->SetColorArrayName(options.colourBy);
  filter->Update();
  messages.ThrowFirstError();
  ColourField field;
  field.volume = filter->GetOutput();
  field.colours = vtkSmartPointer<vtkColorTransferFunction>::New();
  if (ParseMomentName(options.colourBy))
  {
    SetMomentColours(options, field);
  }
  else
  {
    SetAncillaryColours(options, information, field);
  }
  AddMissing(options.colourBy, field.colours);
  field.note =
    filter->GetNumberOfMissingValues() > 0 ? "brown: no value of " + options.colourBy : "";
  field.scale.title += "; opacity by " + TitleOfArray(ArrayOf(volume));
  return field;
}

} // namespace nexrad::scene
