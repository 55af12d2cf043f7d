// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradColorMapPresets.h"

#include "vtkNexradTransferFunction.h"

#include "vtkNew.h"
#include "vtkProcessModule.h"
#include "vtkSMTransferFunctionPresets.h"
#include "vtk_jsoncpp.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace
{

// Points of a colour map: a place, then `width` values of each.
using Points = std::vector<std::vector<double>>;

Points PointsOf(const Json::Value& list, Json::ArrayIndex width)
{
  Points points;
  for (Json::ArrayIndex i = 0; i + width < list.size(); i += width + 1)
  {
    points.emplace_back();
    for (Json::ArrayIndex k = 0; k <= width; ++k)
    {
      points.back().push_back(list[i + k].asDouble());
    }
  }
  return points;
}

// How far the point lies from the straight line between two others, in what is allowed: 0.015 of a
// value, and a tenth of small ones.
double Deviation(
  const std::vector<double>& from, const std::vector<double>& to, const std::vector<double>& point)
{
  const double part = to[0] > from[0] ? (point[0] - from[0]) / (to[0] - from[0]) : 0.0;
  double worst = 0.0;
  for (std::size_t k = 1; k < point.size(); ++k)
  {
    const double allowed = std::clamp(0.1 * point[k], 0.001, 0.015);
    worst = std::max(worst, std::abs(from[k] + part * (to[k] - from[k]) - point[k]) / allowed);
  }
  return worst;
}

// Marks the points that a polyline needs between two of them (Douglas and Peucker).
void KeepNeeded(const Points& points, std::size_t first, std::size_t last, std::vector<bool>& kept)
{
  double worst = 1.0;
  std::size_t at = first;
  for (std::size_t i = first + 1; i < last; ++i)
  {
    const double deviation = Deviation(points[first], points[last], points[i]);
    if (deviation > worst)
    {
      worst = deviation;
      at = i;
    }
  }
  if (at != first)
  {
    kept[at] = true;
    KeepNeeded(points, first, at, kept);
    KeepNeeded(points, at, last, kept);
  }
}

// The list of a colour map with as few points as it needs, so that a person can edit them. `width`
// of the values behind each place count; a list has `all` of them.
Json::Value WithFewPoints(const Json::Value& list, Json::ArrayIndex all, std::size_t width)
{
  Points points = PointsOf(list, all);
  if (points.size() < 3)
  {
    return list;
  }
  Points counting = points;
  std::for_each(
    counting.begin(), counting.end(), [width](auto& point) { point.resize(width + 1); });
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  KeepNeeded(counting, 0, points.size() - 1, kept);
  Json::Value few = Json::arrayValue;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t k = 0; kept[i] && k < points[i].size(); ++k)
    {
      few.append(points[i][k]);
    }
  }
  return few;
}

// ParaView keeps presets in the user's settings, so one of an earlier version of the plugin may be
// there. What else the user's settings say of it, as its groups, stays.
void UpdatePreset(
  vtkSMTransferFunctionPresets* presets, const std::string& name, const Json::Value& map)
{
  Json::Value kept = presets->GetFirstPresetWithName(name.c_str());
  for (const std::string& member : map.getMemberNames())
  {
    kept[member] = map[member];
  }
  kept["Name"] = name;
  presets->SetPreset(name.c_str(), kept);
}

} // namespace

void vtkNexradAddColorMapPresets()
{
  const vtkProcessModule::ProcessTypes process = vtkProcessModule::GetProcessType();
  if (process != vtkProcessModule::PROCESS_CLIENT && process != vtkProcessModule::PROCESS_BATCH)
  {
    return;
  }
  vtkSMTransferFunctionPresets* presets = vtkSMTransferFunctionPresets::GetInstance();
  for (int i = 0; i < vtkNexradTransferFunction::GetNumberOfPresets(); ++i)
  {
    const std::string preset = vtkNexradTransferFunction::GetPresetName(i);
    const std::string name = "NEXRAD " + preset;
    vtkNew<vtkNexradTransferFunction> function;
    function->ApplyPreset(preset.c_str());
    Json::Value list;
    std::istringstream(function->FormatJSON()) >> list;
    Json::Value& map = list[0];
    map["RGBPoints"] = WithFewPoints(map["RGBPoints"], 3, 3);
    map["Points"] = WithFewPoints(map["Points"], 3, 1);
    map["DefaultMap"] = true;
    if (presets->HasPreset(name.c_str()))
    {
      UpdatePreset(presets, name, map);
    }
    else
    {
      presets->AddPreset(name.c_str(), map);
    }
  }
}
