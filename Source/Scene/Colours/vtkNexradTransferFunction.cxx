// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradTransferFunction.h"

#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"
#include "vtkNexradColorMapJSON.h"
#include "vtkNexradColorMapPalette.h"
#include "vtkNexradColorMapSources.h"

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <string>

namespace
{

constexpr int numberOfChannels = 4;
constexpr int piecesBetweenNodes = 16;

using Node = vtkNexradColorMap::Node;
using Nodes = std::vector<Node>;

bool IsChannel(int channel)
{
  return channel >= 0 && channel < numberOfChannels;
}

bool IsBefore(const Node& node, double dBZ)
{
  return node[0] < dBZ;
}

bool IsAfter(double dBZ, const Node& node)
{
  return dBZ < node[0];
}

// The Cardinal tangent at a node: from its neighbour before to that after, or to the only one.
double SlopeAt(const Nodes& nodes, std::size_t index)
{
  const Node& before = nodes[index > 0 ? index - 1 : 0];
  const Node& after = nodes[std::min(index + 1, nodes.size() - 1)];
  return (after[1] - before[1]) / (after[0] - before[0]);
}

// Formulas T10 between a node and the next. VTK's Kochanek spline has the same inner tangents, but
// slopes at its ends that know nothing of the spacing, and a form whose rounding leaves traces of
// opacity where there is none, which nothing could then skip as empty.
double Hermite(const Nodes& nodes, std::size_t index, double dBZ)
{
  const Node& from = nodes[index];
  const Node& to = nodes[index + 1];
  const double width = to[0] - from[0];
  const double t = (dBZ - from[0]) / width;
  const double rest = 1.0 - t;
  return (1.0 + 2.0 * t) * rest * rest * from[1] + t * t * (3.0 - 2.0 * t) * to[1] +
         t * rest * width * (rest * SlopeAt(nodes, index) - t * SlopeAt(nodes, index + 1));
}

// The nodes' places of some channels, and where one of them is a spline, evenly spaced ones
// between.
std::vector<double> PlacesOf(const vtkNexradColorMap& map, std::size_t first, std::size_t channels)
{
  std::vector<double> nodes;
  bool splines = false;
  for (std::size_t channel = first; channel < first + channels; ++channel)
  {
    splines = splines || !map.Linear[channel];
    for (const Node& node : map.Channels[channel])
    {
      nodes.push_back(node[0]);
    }
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::vector<double> places;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    for (int piece = 1; splines && i > 0 && piece < piecesBetweenNodes; ++piece)
    {
      const double share = static_cast<double>(piece) / piecesBetweenNodes;
      places.push_back(nodes[i - 1] + share * (nodes[i] - nodes[i - 1]));
    }
    places.push_back(nodes[i]);
  }
  return places;
}

// The step of the bar that holds a value, or null.
const vtkNexradColorMap::Bin* FindBin(const vtkNexradColorMap& map, double value)
{
  const auto holds = [value](const vtkNexradColorMap::Bin& bin)
  { return bin.From <= value && value < bin.To; };
  const auto found = std::find_if(map.Bins.begin(), map.Bins.end(), holds);
  return found != map.Bins.end() ? &*found : nullptr;
}

// About each value an interval in which a surface has one colour, so that a table that is sampled
// near the value has it, too.
std::vector<std::array<double, 2>> SurfaceIntervals(const vtkNexradColorMap& map)
{
  constexpr double shareOfBin = 0.1;
  constexpr double shareOfGap = 0.3;
  std::vector<double> values = map.IsoValues;
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<std::array<double, 2>> intervals;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const vtkNexradColorMap::Bin* bin = FindBin(map, values[i]);
    double half = bin != nullptr ? shareOfBin * (bin->To - bin->From) : 0.0;
    half = i > 0 ? std::min(half, shareOfGap * (values[i] - values[i - 1])) : half;
    half = i + 1 < values.size() ? std::min(half, shareOfGap * (values[i + 1] - values[i])) : half;
    intervals.push_back({values[i] - half, values[i] + half});
  }
  return intervals;
}

// What a file of samples holds: dBZ, red, green, blue, opacity.
std::vector<std::array<double, 5>> SamplesOf(
  vtkNexradTransferFunction* function, const vtkNexradColorMap& map)
{
  std::vector<std::array<double, 5>> samples;
  for (const double dBZ : PlacesOf(map, 0, numberOfChannels))
  {
    std::array<double, 5>& sample = samples.emplace_back();
    sample[0] = dBZ;
    for (int channel = 0; channel < numberOfChannels; ++channel)
    {
      sample[static_cast<std::size_t>(channel) + 1] = function->Evaluate(channel, dBZ);
    }
  }
  return samples;
}

// Nothing up to a place; from there on the nodes as they are.
void BeginAt(double first, Nodes& nodes)
{
  nodes.erase(nodes.begin(), std::upper_bound(nodes.begin(), nodes.end(), first, IsAfter));
  nodes.insert(nodes.begin(), Node{first, 0.0});
}

} // namespace

struct vtkNexradTransferFunction::Internals
{
  vtkNexradColorMap Map;

  Nodes& Channel(int channel) { return this->Map.Channels[static_cast<std::size_t>(channel)]; }

  void Changed(int channel)
  {
    if (channel != OPACITY)
    {
      this->Map.Bins.clear();
    }
    else
    {
      this->Map.IsoValues.clear();
    }
  }
};

vtkStandardNewMacro(vtkNexradTransferFunction);

vtkNexradTransferFunction::vtkNexradTransferFunction()
  : Internal(std::make_unique<Internals>())
{
  this->ApplyPreset(GetPresetName(0));
}

vtkNexradTransferFunction::~vtkNexradTransferFunction() = default;

void vtkNexradTransferFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* names[numberOfChannels] = {"Red", "Green", "Blue", "Opacity"};
  os << indent << "Name: " << this->Internal->Map.Name << '\n';
  for (int channel = 0; channel < numberOfChannels; ++channel)
  {
    os << indent << names[channel] << " nodes: " << this->GetNumberOfNodes(channel) << '\n';
  }
  os << indent << "Bins: " << this->GetNumberOfBins() << '\n';
}

void vtkNexradTransferFunction::DeepCopy(vtkNexradTransferFunction* other)
{
  if (other != nullptr && other != this)
  {
    this->Internal->Map = other->Internal->Map;
    this->Modified();
  }
}

bool vtkNexradTransferFunction::IsEqual(vtkNexradTransferFunction* other) const
{
  if (other == nullptr)
  {
    return false;
  }
  const vtkNexradColorMap& a = this->Internal->Map;
  const vtkNexradColorMap& b = other->Internal->Map;
  return a.Channels == b.Channels && a.Linear == b.Linear && a.IsoValues == b.IsoValues &&
         a.Bins == b.Bins && a.Bar == b.Bar && a.RangeFolded == b.RangeFolded;
}

int vtkNexradTransferFunction::GetNumberOfNodes(int channel) const
{
  return IsChannel(channel) ? static_cast<int>(this->Internal->Channel(channel).size()) : 0;
}

bool vtkNexradTransferFunction::GetNode(int channel, int index, double node[2]) const
{
  if (index < 0 || index >= this->GetNumberOfNodes(channel))
  {
    return false;
  }
  const Node& found = this->Internal->Channel(channel)[static_cast<std::size_t>(index)];
  std::copy(found.begin(), found.end(), node);
  return true;
}

int vtkNexradTransferFunction::AddNode(int channel, double dBZ, double value)
{
  if (!IsChannel(channel) || !std::isfinite(dBZ) || !std::isfinite(value))
  {
    vtkErrorMacro("node of channel " << channel << " at " << dBZ << " dBZ with " << value
                                     << ": the channel must be 0 to 3, the numbers finite");
    return -1;
  }
  Nodes& nodes = this->Internal->Channel(channel);
  auto at = std::lower_bound(nodes.begin(), nodes.end(), dBZ, IsBefore);
  if (at == nodes.end() || (*at)[0] != dBZ)
  {
    at = nodes.insert(at, Node{});
  }
  *at = {dBZ, std::clamp(value, 0.0, 1.0)};
  this->Internal->Changed(channel);
  this->Modified();
  return static_cast<int>(at - nodes.begin());
}

int vtkNexradTransferFunction::MoveNode(int channel, int index, double dBZ, double value)
{
  if (index < 0 || index >= this->GetNumberOfNodes(channel) || !std::isfinite(dBZ) ||
      !std::isfinite(value))
  {
    vtkErrorMacro("node " << index << " of channel " << channel << " to " << dBZ << " dBZ with "
                          << value << ": the node must exist, the numbers be finite");
    return -1;
  }
  Nodes& nodes = this->Internal->Channel(channel);
  const auto at = nodes.begin() + index;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double least = at != nodes.begin() ? std::nextafter((*(at - 1))[0], infinity) : -infinity;
  const double most = at + 1 != nodes.end() ? std::nextafter((*(at + 1))[0], -infinity) : infinity;
  *at = {std::clamp(dBZ, least, most), std::clamp(value, 0.0, 1.0)};
  this->Internal->Changed(channel);
  this->Modified();
  return index;
}

bool vtkNexradTransferFunction::RemoveNode(int channel, int index)
{
  if (index < 0 || index >= this->GetNumberOfNodes(channel))
  {
    return false;
  }
  Nodes& nodes = this->Internal->Channel(channel);
  nodes.erase(nodes.begin() + index);
  this->Internal->Changed(channel);
  this->Modified();
  return true;
}

void vtkNexradTransferFunction::RemoveAllNodes(int channel)
{
  if (this->GetNumberOfNodes(channel) > 0)
  {
    this->Internal->Channel(channel).clear();
    this->Internal->Map.Linear[static_cast<std::size_t>(channel)] = false;
    this->Internal->Changed(channel);
    this->Modified();
  }
}

void vtkNexradTransferFunction::SetLinear(int channel, bool linear)
{
  if (IsChannel(channel) && this->IsLinear(channel) != linear)
  {
    this->Internal->Map.Linear[static_cast<std::size_t>(channel)] = linear;
    this->Modified();
  }
}

bool vtkNexradTransferFunction::IsLinear(int channel) const
{
  return IsChannel(channel) && this->Internal->Map.Linear[static_cast<std::size_t>(channel)];
}

double vtkNexradTransferFunction::Evaluate(int channel, double dBZ)
{
  if (this->GetNumberOfNodes(channel) == 0 || std::isnan(dBZ))
  {
    return 0.0;
  }
  const Nodes& nodes = this->Internal->Channel(channel);
  const auto next = std::upper_bound(nodes.begin(), nodes.end(), dBZ, IsAfter);
  if (next == nodes.begin() || next == nodes.end())
  {
    return next == nodes.begin() ? nodes.front()[1] : nodes.back()[1];
  }
  const auto index = static_cast<std::size_t>(next - nodes.begin());
  if (this->IsLinear(channel))
  {
    const Node& before = nodes[index - 1];
    const double share = (dBZ - before[0]) / ((*next)[0] - before[0]);
    return (1.0 - share) * before[1] + share * (*next)[1];
  }
  return std::clamp(Hermite(nodes, index - 1, dBZ), 0.0, 1.0);
}

void vtkNexradTransferFunction::GetRange(double range[2]) const
{
  double least = std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::lowest();
  for (const Nodes& nodes : this->Internal->Map.Channels)
  {
    if (!nodes.empty())
    {
      least = std::min(least, nodes.front()[0]);
      most = std::max(most, nodes.back()[0]);
    }
  }
  range[0] = least <= most ? least : 0.0;
  range[1] = least <= most ? most : 0.0;
}

void vtkNexradTransferFunction::Rescale(double first, double last)
{
  double range[2];
  this->GetRange(range);
  if (!(first < last) || !std::isfinite(first) || !std::isfinite(last) || !(range[0] < range[1]))
  {
    vtkErrorMacro("rescale " << range[0] << " to " << range[1] << " dBZ to " << first << " to "
                             << last << " dBZ: the first must be below the last in both");
    return;
  }
  const double factor = (last - first) / (range[1] - range[0]);
  const auto scale = [&](double& place) { place = first + factor * (place - range[0]); };
  for (int channel = 0; channel < numberOfChannels; ++channel)
  {
    for (Node& node : this->Internal->Channel(channel))
    {
      scale(node[0]);
    }
  }
  for (vtkNexradColorMap::Bin& bin : this->Internal->Map.Bins)
  {
    scale(bin.From);
    scale(bin.To);
  }
  this->Modified();
}

void vtkNexradTransferFunction::FillColorFunction(vtkColorTransferFunction* function)
{
  function->RemoveAllPoints();
  function->SetColorSpaceToRGB();
  for (const auto& [from, to] : SurfaceIntervals(this->Internal->Map))
  {
    double color[3];
    this->GetSurfaceColor(0.5 * (from + to), color);
    function->AddRGBPoint(from, color[0], color[1], color[2]);
    function->AddRGBPoint(to, color[0], color[1], color[2]);
  }
  if (this->GetNumberOfIsoValues() > 0)
  {
    return;
  }
  for (const double dBZ : PlacesOf(this->Internal->Map, RED, 3))
  {
    function->AddRGBPoint(
      dBZ, this->Evaluate(RED, dBZ), this->Evaluate(GREEN, dBZ), this->Evaluate(BLUE, dBZ));
  }
}

void vtkNexradTransferFunction::FillOpacityFunction(vtkPiecewiseFunction* function)
{
  function->RemoveAllPoints();
  for (const double dBZ : PlacesOf(this->Internal->Map, OPACITY, 1))
  {
    function->AddPoint(dBZ, this->Evaluate(OPACITY, dBZ));
  }
}

void vtkNexradTransferFunction::FillProperty(vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  this->FillColorFunction(color);
  this->FillOpacityFunction(opacity);
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  vtkContourValues* contours = property->GetIsoSurfaceValues();
  contours->SetNumberOfContours(this->GetNumberOfIsoValues());
  for (int i = 0; i < this->GetNumberOfIsoValues(); ++i)
  {
    contours->SetValue(i, this->GetIsoValue(i));
  }
}

int vtkNexradTransferFunction::GetNumberOfIsoValues() const
{
  return static_cast<int>(this->Internal->Map.IsoValues.size());
}

double vtkNexradTransferFunction::GetIsoValue(int index) const
{
  return index >= 0 && index < this->GetNumberOfIsoValues()
           ? this->Internal->Map.IsoValues[static_cast<std::size_t>(index)]
           : 0.0;
}

void vtkNexradTransferFunction::GetSurfaceColor(double value, double color[3])
{
  const vtkNexradColorMap::Bin* bin = FindBin(this->Internal->Map, value);
  for (int channel = RED; channel <= BLUE; ++channel)
  {
    color[channel] = bin == nullptr ? this->Evaluate(channel, value)
                                    : bin->GetColor(value)[static_cast<std::size_t>(channel)];
  }
}

int vtkNexradTransferFunction::GetNumberOfBins() const
{
  return static_cast<int>(this->Internal->Map.Bins.size());
}

bool vtkNexradTransferFunction::GetBin(
  int index, double range[2], double lower[3], double upper[3]) const
{
  if (index < 0 || index >= this->GetNumberOfBins())
  {
    return false;
  }
  const vtkNexradColorMap::Bin& bin = this->Internal->Map.Bins[static_cast<std::size_t>(index)];
  range[0] = bin.From;
  range[1] = bin.To;
  std::copy(bin.Lower.begin(), bin.Lower.end(), lower);
  std::copy(bin.Upper.begin(), bin.Upper.end(), upper);
  return true;
}

const char* vtkNexradTransferFunction::GetLabelUnit() const
{
  return this->Internal->Map.Bar.Unit.c_str();
}

double vtkNexradTransferFunction::GetLabelFactor() const
{
  return this->Internal->Map.Bar.Factor;
}

double vtkNexradTransferFunction::GetLabelOffset() const
{
  return this->Internal->Map.Bar.Offset;
}

double vtkNexradTransferFunction::GetLabelStep() const
{
  return this->Internal->Map.Bar.Step;
}

int vtkNexradTransferFunction::GetLabelDecimals() const
{
  return this->Internal->Map.Bar.Decimals;
}

bool vtkNexradTransferFunction::GetRangeFoldedColor(double color[3]) const
{
  const auto& rangeFolded = this->Internal->Map.RangeFolded;
  if (rangeFolded)
  {
    std::copy(rangeFolded->begin(), rangeFolded->end(), color);
  }
  return rangeFolded.has_value();
}

void vtkNexradTransferFunction::FillSteppedColorFunction(vtkColorTransferFunction* function)
{
  if (this->Internal->Map.Bins.empty())
  {
    this->FillColorFunction(function);
    return;
  }
  function->RemoveAllPoints();
  function->SetColorSpaceToRGB();
  for (const vtkNexradColorMap::Bin& bin : this->Internal->Map.Bins)
  {
    // A bin holds its lower end, the next one its upper end.
    const double end = std::nextafter(bin.To, bin.From);
    function->AddRGBPoint(bin.From, bin.Lower[0], bin.Lower[1], bin.Lower[2]);
    function->AddRGBPoint(end, bin.Upper[0], bin.Upper[1], bin.Upper[2]);
  }
}

int vtkNexradTransferFunction::GetNumberOfPresets()
{
  return static_cast<int>(vtkNexradTransferFunctionPresets().size());
}

const char* vtkNexradTransferFunction::GetPresetName(int index)
{
  return index >= 0 && index < GetNumberOfPresets()
           ? vtkNexradTransferFunctionPresets()[static_cast<std::size_t>(index)].Name.c_str()
           : nullptr;
}

const char* vtkNexradTransferFunction::GetPresetArray(int index)
{
  return index >= 0 && index < GetNumberOfPresets()
           ? vtkNexradTransferFunctionPresets()[static_cast<std::size_t>(index)].Array.c_str()
           : nullptr;
}

const char* vtkNexradTransferFunction::FindPreset(const char* array, int number)
{
  const std::string wanted = array != nullptr ? array : "";
  for (int index = 0; index < GetNumberOfPresets(); ++index)
  {
    if (wanted == GetPresetArray(index) && number-- == 0)
    {
      return GetPresetName(index);
    }
  }
  return nullptr;
}

bool vtkNexradTransferFunction::ApplyPreset(const char* name)
{
  const std::string wanted = name != nullptr ? name : "";
  std::string names;
  for (const vtkNexradColorMap& preset : vtkNexradTransferFunctionPresets())
  {
    if (preset.Name == wanted)
    {
      this->Internal->Map = preset;
      this->Modified();
      return true;
    }
    names += (names.empty() ? "" : ", ") + preset.Name;
  }
  vtkErrorMacro("no preset is named '" << wanted << "'; there are: " << names);
  return false;
}

void vtkNexradTransferFunction::SetOpacityToIsoValues(
  const double* values, int count, double opacity, double halfWidth)
{
  const std::vector<double> opacities(static_cast<std::size_t>(std::max(count, 0)), opacity);
  this->SetOpacityToIsoValues(values, opacities.data(), count, halfWidth);
}

void vtkNexradTransferFunction::SetOpacityToIsoValues(
  const double* values, const double* opacities, int count, double halfWidth)
{
  if (count < 1 || !(halfWidth > 0.0) ||
      !std::all_of(values, values + count, [](double value) { return std::isfinite(value); }) ||
      !std::all_of(opacities, opacities + count,
        [](double opacity) { return opacity >= 0.0 && opacity <= 1.0; }))
  {
    vtkErrorMacro("iso-values: give one or more finite ones, opacities of 0 to 1 and a half width "
                  "above 0 dBZ");
    return;
  }
  std::vector<vtkNexradIsoShell> shells;
  std::transform(values, values + count, opacities, std::back_inserter(shells),
    [](double value, double opacity) { return vtkNexradIsoShell(value, opacity); });
  this->Internal->Channel(OPACITY) = vtkNexradIsoShells(shells, halfWidth);
  this->Internal->Map.Linear[OPACITY] = false;
  this->Internal->Map.IsoValues.assign(values, values + count);
  this->Modified();
}

bool vtkNexradTransferFunction::ReadFile(const char* path)
{
  vtkNexradColorMap map;
  const std::string problem = vtkNexradReadColorMap(path != nullptr ? path : "", map);
  if (!problem.empty())
  {
    vtkErrorMacro(<< (path != nullptr ? path : "(no name)") << ": " << problem);
    return false;
  }
  for (const std::string& line : map.PassedOver)
  {
    vtkWarningMacro(<< path << ": passed over: " << line);
  }
  this->TakeOver(std::move(map));
  return true;
}

bool vtkNexradTransferFunction::ParseJSON(const std::string& text)
{
  vtkNexradColorMap map;
  const std::string problem = vtkNexradColorMapText::ParseJSON(text, map);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return false;
  }
  this->TakeOver(std::move(map));
  return true;
}

// Of a map without opacities the colours alone.
void vtkNexradTransferFunction::TakeOver(vtkNexradColorMap map)
{
  if (map.Channels[OPACITY].empty())
  {
    map.Channels[OPACITY] = this->Internal->Channel(OPACITY);
    map.Linear[OPACITY] = this->IsLinear(OPACITY);
    map.IsoValues = this->Internal->Map.IsoValues;
    if (!map.Bins.empty())
    {
      BeginAt(map.Bins.front().From, map.Channels[OPACITY]);
    }
  }
  this->Internal->Map = std::move(map);
  this->Modified();
}

std::string vtkNexradTransferFunction::FormatJSON()
{
  return vtkNexradColorMapText::FormatJSON(
    this->Internal->Map, SamplesOf(this, this->Internal->Map));
}

bool vtkNexradTransferFunction::WriteFile(const char* path)
{
  const std::string ending =
    std::filesystem::path(path != nullptr ? path : "").extension().string();
  if (ending != ".json" && ending != ".pal")
  {
    vtkErrorMacro(<< (path != nullptr ? path : "(no name)")
                  << ": a colour map to write ends in .json or .pal");
    return false;
  }
  const std::string text = ending == ".json"
                             ? this->FormatJSON()
                             : vtkNexradColorMapText::FormatPalette(
                                 this->Internal->Map, SamplesOf(this, this->Internal->Map));
  try
  {
    nexrad::WriteFileAtomically(path, text.data(), text.size());
    return true;
  }
  catch (const nexrad::Error&)
  {
    vtkErrorMacro(<< path << ": cannot be written");
    return false;
  }
}
