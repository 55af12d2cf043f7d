// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradColorMapJSON.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{

using Json = nlohmann::json;

// Ours among ParaView's keys: the nodes of the splines, by channel, which channels are straight
// lines instead, the bins, the iso-values, and what the colour bar writes.
constexpr const char* nodesKey = "vtkNexradNodes";
constexpr const char* binsKey = "vtkNexradBins";
constexpr const char* isoValuesKey = "vtkNexradIsoValues";
constexpr const char* linearKey = "vtkNexradLinear";
constexpr const char* labelsKey = "vtkNexradLabels";
constexpr const char* rangeFoldedKey = "vtkNexradRangeFolded";
constexpr std::array<const char*, 4> channelNames = {"red", "green", "blue", "opacity"};

constexpr int samplesBetweenPoints = 8;

// Numbers in groups of `width`, the first of each a place, which ascend. False when they are not
// that.
bool ReadGroups(const Json& list, std::size_t width, std::vector<double>& numbers)
{
  if (!list.is_array() || list.empty() || list.size() % width != 0 ||
      !std::all_of(list.begin(), list.end(), [](const Json& each) { return each.is_number(); }))
  {
    return false;
  }
  numbers = list.get<std::vector<double>>();
  for (std::size_t i = 0; i < numbers.size(); i += width)
  {
    if (std::abs(numbers[i]) > vtkNexradColorMap::LargestPlace ||
        (i > 0 && numbers[i] < numbers[i - width]))
    {
      return false;
    }
  }
  return true;
}

// Adds a node, unless one stands there: of two points at one place the later counts.
void AddNode(std::vector<vtkNexradColorMap::Node>& nodes, double place, double value)
{
  const double share = std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0;
  const vtkNexradColorMap::Node node = {place, share};
  if (!nodes.empty() && !vtkNexradColorMap::IsAbove(place, nodes.back()[0]))
  {
    nodes.back() = node;
  }
  else
  {
    nodes.push_back(node);
  }
}

void SetColorSpace(const std::string& wanted, vtkColorTransferFunction* function)
{
  constexpr std::pair<const char*, int> spaces[] = {{"HSV", VTK_CTF_HSV}, {"Lab", VTK_CTF_LAB},
    {"CIEDE2000", VTK_CTF_LAB_CIEDE2000}, {"Diverging", VTK_CTF_DIVERGING}, {"Step", VTK_CTF_STEP}};
  for (const auto& [name, space] : spaces)
  {
    if (wanted == name)
    {
      function->SetColorSpace(space);
    }
  }
}

// Places of the points, and between them when the way from one to the next is not straight.
std::vector<double> PlacesOf(const std::vector<double>& numbers, std::size_t width, bool between)
{
  std::vector<double> places;
  for (std::size_t i = 0; i < numbers.size(); i += width)
  {
    if (between && i > 0)
    {
      for (int k = 1; k < samplesBetweenPoints; ++k)
      {
        const double share = static_cast<double>(k) / samplesBetweenPoints;
        places.push_back(numbers[i - width] + share * (numbers[i] - numbers[i - width]));
      }
    }
    places.push_back(numbers[i]);
  }
  return places;
}

bool ReadColors(const Json& source, vtkNexradColorMap& map)
{
  constexpr std::size_t width = 4;
  std::vector<double> numbers;
  if (!source.contains("RGBPoints") || !ReadGroups(source["RGBPoints"], width, numbers))
  {
    return false;
  }
  const std::string space = source.contains("ColorSpace") && source["ColorSpace"].is_string()
                              ? source["ColorSpace"].get<std::string>()
                              : "RGB";
  vtkNew<vtkColorTransferFunction> function;
  SetColorSpace(space, function);
  for (std::size_t i = 0; i < numbers.size(); i += width)
  {
    function->AddRGBPoint(numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3]);
  }
  for (const double place : PlacesOf(numbers, width, space != "RGB"))
  {
    std::array<double, 3> color{};
    function->GetColor(place, color.data());
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      AddNode(map.Channels[channel], place, color[channel]);
    }
  }
  return true;
}

// Place, opacity, midpoint and sharpness of each point.
bool ReadOpacities(const Json& source, vtkNexradColorMap& map)
{
  constexpr std::size_t width = 4;
  std::vector<double> numbers;
  if (!source.contains("Points") || source["Points"].is_null())
  {
    return true;
  }
  if (!ReadGroups(source["Points"], width, numbers))
  {
    return false;
  }
  vtkNew<vtkPiecewiseFunction> function;
  bool straight = true;
  for (std::size_t i = 0; i < numbers.size(); i += width)
  {
    const double midpoint = std::clamp(numbers[i + 2], 0.0, 1.0);
    const double sharpness = std::clamp(numbers[i + 3], 0.0, 1.0);
    function->AddPoint(numbers[i], numbers[i + 1], midpoint, sharpness);
    straight = straight && midpoint == 0.5 && sharpness == 0.0;
  }
  for (const double place : PlacesOf(numbers, width, !straight))
  {
    AddNode(map.Channels[3], place, function->GetValue(place));
  }
  return true;
}

bool ReadOwnNodes(const Json& source, vtkNexradColorMap& map)
{
  for (std::size_t channel = 0; channel < channelNames.size(); ++channel)
  {
    const auto list = source.find(channelNames[channel]);
    std::vector<double> numbers;
    if (list == source.end() || (!list->empty() && !ReadGroups(*list, 2, numbers)))
    {
      return false;
    }
    for (std::size_t i = 0; i < numbers.size(); i += 2)
    {
      AddNode(map.Channels[channel], numbers[i], numbers[i + 1]);
    }
  }
  return true;
}

bool ReadOwnBins(const Json& list, vtkNexradColorMap& map)
{
  constexpr std::size_t width = 8;
  std::vector<double> numbers;
  if (!ReadGroups(list, width, numbers))
  {
    return false;
  }
  for (auto at = numbers.begin(); at != numbers.end(); at += width)
  {
    if (!vtkNexradColorMap::IsAbove(at[1], at[0]) || at[1] > vtkNexradColorMap::LargestPlace)
    {
      return false;
    }
    std::for_each(at + 2, at + width, [](double& share) { share = std::clamp(share, 0.0, 1.0); });
    map.Bins.push_back({at[0], at[1], {at[2], at[3], at[4]}, {at[5], at[6], at[7]}});
  }
  return true;
}

bool ReadLinear(const Json& list, vtkNexradColorMap& map)
{
  return list.is_array() &&
         std::all_of(list.begin(), list.end(),
           [&map](const Json& name)
           {
             const auto found = std::find(channelNames.begin(), channelNames.end(), name);
             if (found == channelNames.end())
             {
               return false;
             }
             map.Linear[static_cast<std::size_t>(found - channelNames.begin())] = true;
             return true;
           });
}

bool ReadLabels(const Json& source, vtkNexradColorMap::Labels& labels)
{
  const auto number = [&source](const char* key, double& value)
  {
    const auto found = source.find(key);
    if (found == source.end() || !found->is_number())
    {
      return false;
    }
    value = found->get<double>();
    return std::isfinite(value);
  };
  constexpr double mostDecimals = 6.0;
  double decimals = 0.0;
  if (!source.is_object() || !source.contains("unit") || !source["unit"].is_string() ||
      !number("factor", labels.Factor) || labels.Factor == 0.0 ||
      !number("offset", labels.Offset) || !number("step", labels.Step) ||
      !number("decimals", decimals) || !(decimals >= -1.0 && decimals <= mostDecimals))
  {
    return false;
  }
  labels.Unit = source["unit"].get<std::string>();
  labels.Decimals = static_cast<int>(decimals);
  return true;
}

bool ReadRangeFolded(const Json& list, vtkNexradColorMap& map)
{
  vtkNexradColorMap::Color color{};
  if (!list.is_array() || list.size() != color.size())
  {
    return false;
  }
  for (std::size_t i = 0; i < color.size(); ++i)
  {
    if (!list[i].is_number())
    {
      return false;
    }
    color[i] = std::clamp(list[i].get<double>(), 0.0, 1.0);
  }
  map.RangeFolded = color;
  return true;
}

// What FormatJSON added to ParaView's keys. Says what is wrong.
std::string ReadOwn(const Json& source, vtkNexradColorMap& map)
{
  if (!source[nodesKey].is_object() || !ReadOwnNodes(source[nodesKey], map))
  {
    return std::string(nodesKey) + " must hold red, green, blue and opacity, each a list of " +
           "ascending dBZ and values";
  }
  if (source.contains(binsKey) && !source[binsKey].empty() && !ReadOwnBins(source[binsKey], map))
  {
    return std::string(binsKey) + " must be a list of ascending ranges and two colours each";
  }
  if (source.contains(isoValuesKey) && !source[isoValuesKey].empty() &&
      !ReadGroups(source[isoValuesKey], 1, map.IsoValues))
  {
    return std::string(isoValuesKey) + " must be a list of ascending values";
  }
  if (source.contains(linearKey) && !ReadLinear(source[linearKey], map))
  {
    return std::string(linearKey) + " must be a list of red, green, blue and opacity";
  }
  if (source.contains(labelsKey) && !ReadLabels(source[labelsKey], map.Bar))
  {
    return std::string(labelsKey) + " must hold unit, factor, offset, step and decimals";
  }
  if (source.contains(rangeFoldedKey) && !ReadRangeFolded(source[rangeFoldedKey], map))
  {
    return std::string(rangeFoldedKey) + " must hold red, green and blue";
  }
  return {};
}

} // namespace

namespace vtkNexradColorMapText
{

std::string ParseJSON(const std::string& text, vtkNexradColorMap& map)
{
  const Json whole = Json::parse(text, nullptr, false);
  if (whole.is_discarded())
  {
    return "this is not JSON; a colour map that ParaView exported would be right";
  }
  const Json& source = whole.is_array() && !whole.empty() ? whole.front() : whole;
  if (!source.is_object())
  {
    return "this JSON holds no colour map; one that ParaView exported would be right";
  }
  if (source.contains("Name") && source["Name"].is_string())
  {
    map.Name = source["Name"].get<std::string>();
  }
  if (source.contains(nodesKey))
  {
    return ReadOwn(source, map);
  }
  if (!ReadColors(source, map))
  {
    return "RGBPoints must be a list of ascending values, each with red, green and blue";
  }
  if (!ReadOpacities(source, map))
  {
    return "Points must be a list of ascending values, each with opacity, midpoint and sharpness";
  }
  return {};
}

std::string FormatJSON(
  const vtkNexradColorMap& map, const std::vector<std::array<double, 5>>& samples)
{
  Json result;
  result["Name"] = map.Name;
  result["ColorSpace"] = "RGB";
  result["NanColor"] = {0.0, 0.0, 0.0};
  for (const char* list : {"RGBPoints", "Points", binsKey, isoValuesKey})
  {
    result[list] = Json::array();
  }
  for (const std::array<double, 5>& sample : samples)
  {
    result["RGBPoints"].insert(
      result["RGBPoints"].end(), {sample[0], sample[1], sample[2], sample[3]});
    result["Points"].insert(result["Points"].end(), {sample[0], sample[4], 0.5, 0.0});
  }
  for (std::size_t channel = 0; channel < channelNames.size(); ++channel)
  {
    Json& list = result[nodesKey][channelNames[channel]] = Json::array();
    for (const vtkNexradColorMap::Node& node : map.Channels[channel])
    {
      list.insert(list.end(), {node[0], node[1]});
    }
    if (map.Linear[channel])
    {
      result[linearKey].push_back(channelNames[channel]);
    }
  }
  for (const vtkNexradColorMap::Bin& bin : map.Bins)
  {
    result[binsKey].insert(
      result[binsKey].end(), {bin.From, bin.To, bin.Lower[0], bin.Lower[1], bin.Lower[2],
                               bin.Upper[0], bin.Upper[1], bin.Upper[2]});
  }
  std::vector<double> isoValues = map.IsoValues;
  std::sort(isoValues.begin(), isoValues.end());
  result[isoValuesKey] = isoValues;
  if (!(map.Bar == vtkNexradColorMap::Labels()))
  {
    result[labelsKey] = {{"unit", map.Bar.Unit}, {"factor", map.Bar.Factor},
      {"offset", map.Bar.Offset}, {"step", map.Bar.Step}, {"decimals", map.Bar.Decimals}};
  }
  if (map.RangeFolded)
  {
    result[rangeFoldedKey] = *map.RangeFolded;
  }
  // The name and the unit may be of a file, in any encoding.
  return Json::array({result}).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace vtkNexradColorMapText
