// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradAppearance.h"

#include "Scene/Frame/SceneFrame.h"
#include "Scene/VolumeAppearance.h"
#include "nexrad/Model/Moment.h"
#include "vtkNexradFirstView.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include "vtkBoundingBox.h"
#include "vtkDataAssembly.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{

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

// Nothing where there are no data.
std::optional<vtkNexradBox> BoundsOf(vtkPVDataInformation* data)
{
  vtkNexradBox bounds{};
  if (data != nullptr)
  {
    data->GetBounds(bounds.data());
  }
  return data != nullptr && vtkBoundingBox(bounds.data()).IsValid() ? std::optional(bounds)
                                                                    : std::nullopt;
}

vtkNexradBox Scaled(vtkNexradBox box, const std::array<double, 3>& scale)
{
  for (std::size_t side = 0; side < box.size(); ++side)
  {
    box[side] *= scale[side / 2];
  }
  return box;
}

void ColorByFirstMoment(vtkSMProxy* representation, vtkPVDataInformation* data)
{
  const std::string moment = FirstMoment(data);
  if (!moment.empty())
  {
    const bool isPoints =
      data->GetArrayInformation(moment.c_str(), vtkDataObject::POINT) != nullptr;
    vtkSMPVRepresentationProxy::SetScalarColoring(
      representation, moment.c_str(), isPoints ? vtkDataObject::POINT : vtkDataObject::CELL);
  }
}

// The box that vtkNexradFraming found, once it has set what it found.
vtkNexradBox Frame(vtkSMProxy* representation, double time)
{
  const vtkSMPropertyHelper input(representation, "Input");
  vtkSMProxy* volume = input.GetAsProxy();
  const auto made = vtkSmartPointer<vtkSMProxy>::Take(
    volume->GetSessionProxyManager()->NewProxy("internal_filters", "NexradFraming"));
  auto* framing = vtkSMSourceProxy::SafeDownCast(made);
  vtkSMPropertyHelper(framing, "Input").Set(volume, input.GetOutputPort());
  framing->UpdateVTKObjects();
  framing->UpdatePipeline(time);
  framing->UpdatePropertyInformation();
  std::array<double, 3> scale{};
  vtkNexradBox box{};
  vtkSMPropertyHelper(framing, "Scale").Get(scale.data(), 3);
  vtkSMPropertyHelper(framing, "Framed").Get(box.data(), 6);
  Set(representation, "Scale", scale);
  Set(representation, "ScalarOpacityUnitDistance",
    vtkSMPropertyHelper(framing, "OpacityDistance").GetAsDouble());
  Set(representation, "NumberOfSlices", vtkSMPropertyHelper(framing, "Slices").GetAsDouble());
  return Scaled(box, scale);
}

// The light of the scene, as it is set on a mapper.
void Light(vtkSMProxy* representation)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> lit;
  nexrad::scene::SetLight(lit, nexrad::scene::LightOptions(), false);
  Set(representation, "ShadowStrength", lit->GetShadowStrength());
  Set(representation, "AmbientOcclusionStrength", lit->GetOcclusionStrength());
  Set(representation, "ShadowDensity", lit->GetShadowDensity());
  Set(representation, "Exposure", lit->GetExposure());
  const double* toLight = lit->GetLightDirection();
  Set(representation, "LightDirection", {toLight[0], toLight[1], toLight[2]});
}

// As the scene does. `voxel`: its width, as a part of the width of the view.
void SizePixels(vtkSMProxy* representation, vtkSMViewProxy* view, double voxel)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> sized;
  nexrad::scene::SetPixelSize(sized, voxel * vtkSMPropertyHelper(view, "ViewSize").GetAsDouble(0));
  Set(representation, "ImageSampleDistance", static_cast<double>(sized->GetImageSampleDistance()));
}

// How the view shows the input of a filter; nullptr where it does not.
vtkSMProxy* RepresentationOfInput(vtkSMProxy* filter, vtkSMViewProxy* view)
{
  const vtkSMPropertyHelper input(filter, "Input");
  auto* producer = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  return producer ? view->FindRepresentation(producer, input.GetOutputPort()) : nullptr;
}

std::array<double, 3> ScaleOf(vtkSMProxy* representation)
{
  std::array<double, 3> scale{};
  vtkSMPropertyHelper(representation, "Scale").Get(scale.data(), 3);
  return scale;
}

} // namespace

std::optional<vtkNexradBox> vtkNexradDressVolume(vtkSMProxy* representation, vtkSMViewProxy* view)
{
  vtkPVDataInformation* data = InputInformation(representation);
  const auto bounds = BoundsOf(data);
  if (!bounds)
  {
    return std::nullopt;
  }
  ColorByFirstMoment(representation, data);
  Light(representation);
  Set(representation, "Ground", 1.0);
  const vtkNexradBox box =
    Frame(representation, vtkSMPropertyHelper(view, "ViewTime").GetAsDouble());
  const vtkNexradBox whole = Scaled(*bounds, ScaleOf(representation));
  const int* extent = data->GetExtent();
  SizePixels(
    representation, view, (whole[1] - whole[0]) / (extent[1] - extent[0]) / (box[1] - box[0]));
  representation->UpdateVTKObjects();
  return box;
}

std::optional<vtkNexradBox> vtkNexradDressSweeps(vtkSMProxy* representation)
{
  vtkPVDataInformation* data = InputInformation(representation);
  const auto bounds = BoundsOf(data);
  if (!bounds)
  {
    return std::nullopt;
  }
  ColorByFirstMoment(representation, data);
  const auto& [west, east, south, north, bottom, top] = *bounds;
  const double width = std::sqrt((east - west) * (north - south));
  const std::array<double, 3> scale = {
    1.0, 1.0, nexrad::scene::DefaultExaggeration(width / 1000.0, (top - bottom) / 1000.0)};
  Set(representation, "Scale", scale);
  ShowFirstSweeps(representation, data);
  Set(representation, "Ambient", 1.0); // the colours of the legend, whatever way a sweep faces
  Set(representation, "Diffuse", 0.0);
  representation->UpdateVTKObjects();
  return Scaled(*bounds, scale);
}

void vtkNexradDressMap(vtkSMProxy* representation, vtkSMViewProxy* view)
{
  vtkSMPVRepresentationProxy::SetScalarColoring(representation, "MapColor", vtkDataObject::CELL);
  Set(representation, "MapScalars", 0.0); // its values are colours
  Set(representation, "Ambient", 1.0);    // lines have no side that faces a light
  Set(representation, "Diffuse", 0.0);
  vtkSMProxy* map = vtkSMPropertyHelper(representation, "Input").GetAsProxy();
  if (vtkSMProxy* shown = RepresentationOfInput(map, view))
  {
    Set(representation, "Scale", ScaleOf(shown));
  }
  representation->UpdateVTKObjects();
}

void vtkNexradSizeLetters(vtkSMProxy* map, vtkSMViewProxy* view)
{
  vtkSMProxy* shown = RepresentationOfInput(map, view);
  if (const auto bounds = shown != nullptr ? BoundsOf(InputInformation(shown)) : std::nullopt)
  {
    const vtkNexradBox box = Scaled(*bounds, ScaleOf(shown));
    Set(map, "LetterHeight",
      vtkNexradLetterHeight(view) / std::max(box[1] - box[0], box[3] - box[2]));
  }
}
