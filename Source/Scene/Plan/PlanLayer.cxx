// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Plan/PlanLayer.h"

#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkImageSliceMapper.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace nexrad::scene
{
namespace
{

// None where the ground is seen.
std::optional<Colour> ColourOf(
  const PlanView& view, const ColourScale& scale, std::size_t column, const Theme& theme)
{
  switch (view.states[column])
  {
  case VoxelState::NotScanned:
    return theme.notScanned;
  case VoxelState::RangeFolded:
    return scale.rangeFolded.value_or(theme.rangeFolded);
  case VoxelState::Filtered:
    return theme.filtered;
  case VoxelState::NoEcho:
    return std::nullopt;
  default:
    return ColourAt(scale, static_cast<double>(view.values[column]));
  }
}

bool Holds(const PlanView& view, VoxelState state)
{
  return std::find(view.states.begin(), view.states.end(), state) != view.states.end();
}

} // namespace

vtkSmartPointer<vtkProp> MakePlanLayer(const PlanView& view, const ColourScale& scale,
  vtkImageData* placed, double height, const Theme& theme)
{
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(view.width, view.height, 1);
  picture->SetOrigin(placed->GetOrigin()[0], placed->GetOrigin()[1], height);
  picture->SetSpacing(placed->GetSpacing()[0], placed->GetSpacing()[1], 1.0);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (std::size_t column = 0; column < view.values.size(); ++column)
  {
    const std::optional<Colour> colour = ColourOf(view, scale, column, theme);
    for (const double component : colour.value_or(Colour()))
    {
      *pixel++ = static_cast<unsigned char>(std::lround(255.0 * component));
    }
    *pixel++ = colour ? 255 : 0;
  }
  auto actor = vtkSmartPointer<vtkImageActor>::New();
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(picture);
  mapper->BorderOn(); // whole voxels at the edges as well
  actor->SetMapper(mapper);
  actor->InterpolateOff();
  return actor;
}

std::string PlanKey(const PlanView& view, const ColourScale& scale)
{
  std::string key;
  for (const auto& [state, text] : StateTexts)
  {
    const bool ofTable = state == VoxelState::RangeFolded && scale.rangeFolded;
    const std::string words = ofTable ? "RF of the colour table: range folded" : text;
    key += Holds(view, state) ? (key.empty() ? "" : ", ") + words : "";
  }
  return key;
}

} // namespace nexrad::scene
