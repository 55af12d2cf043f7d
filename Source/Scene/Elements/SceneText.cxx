// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Elements/SceneText.h"

#include "Scene/Elements/Letters.h"

#include <vtkCoordinate.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace nexrad::scene
{
namespace
{

vtkSmartPointer<vtkTextActor> MakeText(
  const std::string& text, int size, const Colour& colour, LabelSide side)
{
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->SetTextScaleModeToNone();
  vtkTextProperty* property = actor->GetTextProperty();
  SetFace(property, false);
  property->SetFontSize(size);
  property->SetColor(colour[0], colour[1], colour[2]);
  // Bright echo may lie behind the letters.
  property->ShadowOn();
  property->SetShadowOffset(1, -1);
  switch (side)
  {
  case LabelSide::Left:
    property->SetJustificationToRight();
    property->SetVerticalJustificationToCentered();
    break;
  case LabelSide::Right:
    property->SetJustificationToLeft();
    property->SetVerticalJustificationToCentered();
    break;
  default:
    property->SetJustificationToCentered();
    property->SetVerticalJustificationToTop();
    break;
  }
  return actor;
}

} // namespace

vtkSmartPointer<vtkTextActor> MakeLabel(const std::string& text, const std::array<double, 3>& point,
  int size, const Colour& colour, LabelSide side)
{
  auto actor = MakeText(text, size, colour, side);
  vtkCoordinate* coordinate = actor->GetPositionCoordinate();
  coordinate->SetCoordinateSystemToWorld();
  coordinate->SetValue(point[0], point[1], point[2]);
  return actor;
}

vtkSmartPointer<vtkTextActor> MakeCaption(const std::string& text,
  const std::array<double, 2>& place, int size, const Colour& colour, LabelSide side)
{
  auto actor = MakeText(text, size, colour, side);
  vtkCoordinate* coordinate = actor->GetPositionCoordinate();
  coordinate->SetCoordinateSystemToNormalizedViewport();
  coordinate->SetValue(place[0], place[1]);
  return actor;
}

} // namespace nexrad::scene
