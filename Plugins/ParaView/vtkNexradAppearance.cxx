// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradAppearance.h"

#include "nexrad/Model/Moment.h"

#include "vtkBoundingBox.h"
#include "vtkDataAssembly.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{

constexpr double UnitDistance = 5000.0; // m, that the presets' opacities are for
// Where x and y are degrees and z is metres, distances have no unit; this gives pictures like those
// in metres.
constexpr double GeographicUnitDistance = 1000.0;
constexpr double GeographicSlices = 256.0;
constexpr double MostExaggeration = 8.0; // as of nexrad3d
constexpr double MetresPerDegree = 111'195.0;
constexpr double ShadowStrength = 0.5;
constexpr double OcclusionStrength = 0.5;
constexpr std::array<double, 3> Background = {0.04, 0.05, 0.07};

vtkPVDataInformation* InputInformation(vtkSMProxy* representation)
{
  const vtkSMPropertyHelper input(representation, "Input");
  auto* producer = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  return producer ? producer->GetDataInformation(input.GetOutputPort()) : nullptr;
}

// The active scalars, or the first moment among the arrays. Empty when there is none.
std::string FirstMoment(vtkPVDataInformation* data)
{
  std::string first;
  for (const nexrad::MomentName moment : nexrad::KnownMoments)
  {
    const char* const name = nexrad::ToString(moment);
    const auto* array = data->GetArrayInformation(name, vtkDataObject::POINT);
    const auto* cells = array ? nullptr : data->GetArrayInformation(name, vtkDataObject::CELL);
    if (first.empty() && (array || cells))
    {
      first = name;
    }
  }
  const auto* active =
    data->GetPointDataInformation()->GetAttributeInformation(vtkDataSetAttributes::SCALARS);
  const char* name = active ? active->GetName() : nullptr;
  return name && nexrad::ParseMomentName(name) ? name : first;
}

// Whether x and y are degrees: then a volume is far higher, in numbers, than it is wide.
bool IsGeographic(const double bounds[6])
{
  return std::abs(bounds[0]) <= 540.0 && std::abs(bounds[1]) <= 540.0 &&
         std::abs(bounds[2]) <= 90.0 && std::abs(bounds[3]) <= 90.0;
}

// What heights are multiplied with.
double HeightScale(const double bounds[6])
{
  const double unit = IsGeographic(bounds) ? MetresPerDegree : 1.0;
  const double width = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]) * unit;
  const double height = bounds[5] - bounds[4];
  const double wanted = height > 0.0 ? width / 3.0 / height : 1.0;
  return std::clamp(wanted, 1.0, MostExaggeration) / unit;
}

// The selectors of the first sweep of each radar: its block is named "KLSX Sweep 00 0.50 deg".
std::vector<std::string> FirstSweeps(vtkPVDataInformation* data)
{
  std::vector<std::string> selectors;
  vtkDataAssembly* blocks = data->GetHierarchy();
  for (const int node :
    blocks ? blocks->GetChildNodes(vtkDataAssembly::GetRootNode(), false) : std::vector<int>())
  {
    const std::string name = blocks->GetNodeName(node);
    if (name.find("Sweep00") != std::string::npos || name.find("Sweep_00") != std::string::npos)
    {
      selectors.push_back(blocks->GetNodePath(node));
    }
  }
  return selectors;
}

void ShowFirstSweeps(vtkSMProxy* representation, vtkPVDataInformation* data)
{
  const std::vector<std::string> sweeps = FirstSweeps(data);
  if (!sweeps.empty() && representation->GetProperty("BlockSelectors"))
  {
    vtkSMPropertyHelper selectors(representation, "BlockSelectors");
    selectors.SetNumberOfElements(static_cast<unsigned int>(sweeps.size()));
    for (std::size_t i = 0; i < sweeps.size(); ++i)
    {
      selectors.Set(static_cast<unsigned int>(i), sweeps[i].c_str());
    }
  }
}

void Set(vtkSMProxy* proxy, const char* property, double value)
{
  vtkSMPropertyHelper(proxy, property, true).Set(value);
}

void Set(vtkSMProxy* proxy, const char* property, const std::array<double, 3>& values)
{
  vtkSMPropertyHelper(proxy, property, true).Set(values.data(), 3);
}

} // namespace

bool vtkNexradShowsData(vtkSMViewProxy* view)
{
  const vtkSMPropertyHelper shown(view, "Representations");
  for (unsigned int i = 0; i < shown.GetNumberOfElements(); ++i)
  {
    auto* each = vtkSMPVRepresentationProxy::SafeDownCast(shown.GetAsProxy(i));
    if (each && vtkSMPropertyHelper(each, "Visibility").GetAsInt() != 0)
    {
      return true;
    }
  }
  return false;
}

void vtkNexradDressData(vtkSMProxy* representation, bool isVolume)
{
  vtkPVDataInformation* data = InputInformation(representation);
  if (!data)
  {
    return;
  }
  const std::string moment = FirstMoment(data);
  if (!moment.empty())
  {
    const bool isPoints =
      data->GetArrayInformation(moment.c_str(), vtkDataObject::POINT) != nullptr;
    vtkSMPVRepresentationProxy::SetScalarColoring(
      representation, moment.c_str(), isPoints ? vtkDataObject::POINT : vtkDataObject::CELL);
  }
  double bounds[6];
  data->GetBounds(bounds);
  if (vtkBoundingBox(bounds).IsValid())
  {
    Set(representation, "Scale", {1.0, 1.0, HeightScale(bounds)});
    if (isVolume)
    {
      const bool isGeographic = IsGeographic(bounds);
      Set(representation, "ScalarOpacityUnitDistance",
        isGeographic ? GeographicUnitDistance : UnitDistance);
      if (isGeographic)
      {
        // Voxels that are 400 m high and 0.05 degrees wide do not tell how far slices may lie
        // apart.
        Set(representation, "NumberOfSlices", GeographicSlices);
      }
    }
  }
  if (isVolume)
  {
    Set(representation, "ShadowStrength", ShadowStrength);
    Set(representation, "AmbientOcclusionStrength", OcclusionStrength);
  }
  else
  {
    ShowFirstSweeps(representation, data);
    Set(representation, "Ambient", 1.0); // the colours of the legend, whatever way a sweep faces
    Set(representation, "Diffuse", 0.0);
  }
  representation->UpdateVTKObjects();
}

void vtkNexradDressMap(vtkSMProxy* representation, vtkSMViewProxy* view)
{
  vtkSMPVRepresentationProxy::SetScalarColoring(representation, "MapColor", vtkDataObject::CELL);
  Set(representation, "MapScalars", 0.0); // its values are colours
  Set(representation, "Ambient", 1.0);    // lines have no side that faces a light
  Set(representation, "Diffuse", 0.0);
  auto* map =
    vtkSMSourceProxy::SafeDownCast(vtkSMPropertyHelper(representation, "Input").GetAsProxy());
  const vtkSMPropertyHelper input(map, "Input");
  auto* volume = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  if (vtkSMProxy* shown =
        volume ? view->FindRepresentation(volume, input.GetOutputPort()) : nullptr)
  {
    std::array<double, 3> scale{};
    vtkSMPropertyHelper(shown, "Scale").Get(scale.data(), 3);
    Set(representation, "Scale", scale);
  }
  representation->UpdateVTKObjects();
}

void vtkNexradDressView(vtkSMViewProxy* view, vtkSMProxy* representation, bool isVolume)
{
  vtkPVDataInformation* data = InputInformation(representation);
  double bounds[6];
  data->GetBounds(bounds);
  if (!vtkBoundingBox(bounds).IsValid())
  {
    return;
  }
  Set(view, "UseColorPaletteForBackground", 0.0);
  vtkSMPropertyHelper(view, "BackgroundColorMode", true).Set("Single Color");
  Set(view, "Background", Background);
  const double scale = HeightScale(bounds);
  const double width = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  const std::array<double, 3> middle = {(bounds[0] + bounds[1]) / 2.0,
    (bounds[2] + bounds[3]) / 2.0, scale * (bounds[4] + (bounds[5] - bounds[4]) / 4.0)};
  Set(view, "CameraFocalPoint", middle);
  if (isVolume)
  {
    Set(view, "CameraPosition",
      {middle[0] - 0.35 * width, middle[1] - 1.15 * width, middle[2] + 0.9 * width});
    Set(view, "CameraViewUp", {0.0, 0.0, 1.0});
  }
  else
  {
    Set(view, "CameraPosition", {middle[0], middle[1], middle[2] + 2.0 * width});
    Set(view, "CameraViewUp", {0.0, 1.0, 0.0});
  }
  view->UpdateVTKObjects();
}
