// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Frame/EchoExtent.h"

#include "Scene/Frame/SceneFrame.h"
#include "Scene/Frame/VolumeInformation.h"
#include "vtkNexradThreads.h"
#include "vtkNexradTransferFunction.h"
#include "vtkNexradVoxels.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace nexrad::scene
{
namespace
{

constexpr double leastDepth = 1e-3; // of EchoExtent::Depths
constexpr double linesPerDecade = 11.0;

// Optical depth of 1 km of a value, as a table over the values that are seen.
class Extinction
{
public:
  explicit Extinction(vtkNexradTransferFunction* opacities)
  {
    double range[2];
    opacities->GetRange(range);
    first = range[0];
    step = (range[1] - range[0]) / static_cast<double>(table.size() - 1);
    for (std::size_t i = 0; i < table.size(); ++i)
    {
      const double opacity = opacities->Evaluate(
        vtkNexradTransferFunction::OPACITY, first + step * static_cast<double>(i));
      table[i] =
        static_cast<float>(-std::log(1.0 - std::min(opacity, mostOpacity)) / OpacityUnitDistance);
    }
  }

  float Of(double value) const
  {
    const double place = (value - first) / step;
    return place >= 0.0 // of no value that is NaN or below what is seen
             ? table[static_cast<std::size_t>(
                 std::min(place + 0.5, static_cast<double>(table.size() - 1)))]
             : 0.0f;
  }

private:
  static constexpr double mostOpacity = 0.99;
  double first = 0.0;
  double step = 1.0;
  std::array<float, 1024> table{};
};

// The volume in columns of several voxels, and the mean extinction of each of their layers.
struct Columns
{
  static constexpr int most = 64; // along x, and along y

  std::array<int, 2> count{};
  std::array<int, 2> voxels{}; // along an edge of a column
  int layers = 0;
  std::vector<float> extinctions; // per km; of a column one after the other

  std::size_t At(int x, int y) const
  {
    return static_cast<std::size_t>((y * count[0] + x) * layers);
  }
};

template <class Value, class ExtinctionOf>
void SumVoxels(const Value* values, const int* size, const ExtinctionOf& of, Columns& columns)
{
  vtkNexradRangeLoop()(columns.count[1],
    [&](int begin, int end)
    {
      const int first = begin * columns.voxels[1];
      const int last = std::min(end * columns.voxels[1], size[1]);
      for (int z = 0; z < size[2]; ++z)
      {
        for (int y = first; y < last; ++y)
        {
          const Value* row = values + (static_cast<std::size_t>(z) * size[1] + y) * size[0];
          for (int x = 0; x < size[0]; ++x)
          {
            const float extinction = of(row[x]);
            if (extinction > 0.0f)
            {
              columns.extinctions[columns.At(x / columns.voxels[0], y / columns.voxels[1]) +
                                  static_cast<std::size_t>(z)] += extinction;
            }
          }
        }
      }
    });
  const float each = 1.0f / static_cast<float>(columns.voxels[0] * columns.voxels[1]);
  for (float& extinction : columns.extinctions)
  {
    extinction *= each;
  }
}

// Values that are hidden are those of no echo, which no preset shows, or NaN.
Columns ColumnsOf(vtkImageData* volume, const Extinction& extinction)
{
  const int* size = volume->GetDimensions();
  Columns columns;
  columns.layers = size[2];
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    columns.voxels[axis] = (size[axis] + Columns::most - 1) / Columns::most;
    columns.count[axis] = (size[axis] + columns.voxels[axis] - 1) / columns.voxels[axis];
  }
  columns.extinctions.resize(columns.At(0, columns.count[1]));
  vtkDataArray* scalars = volume->GetPointData()->GetScalars();
  if (vtkDataArray* meant = vtkNexradFindCodeValues(volume, ArrayOf(volume)))
  {
    std::array<float, 256> table{};
    for (std::size_t code = 0; code < table.size(); ++code)
    {
      table[code] = extinction.Of(meant->GetComponent(static_cast<vtkIdType>(code), 0));
    }
    SumVoxels(
      vtkUnsignedCharArray::SafeDownCast(scalars)->GetPointer(0), size,
      [&](unsigned char code) { return table[code]; }, columns);
  }
  else if (auto* floats = vtkFloatArray::SafeDownCast(scalars))
  {
    SumVoxels(
      floats->GetPointer(0), size,
      [&](float value) { return extinction.Of(static_cast<double>(value)); }, columns);
  }
  return columns;
}

// Lengths in km.
struct Edges
{
  std::array<double, 3> voxel{};

  explicit Edges(vtkImageData* volume)
  {
    const SceneFrame frame(volume, 1.0);
    const std::array<double, 6>& box = frame.Bounds();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      voxel[axis] = (box[2 * axis + 1] - box[2 * axis]) / volume->GetDimensions()[axis];
    }
  }
};

void Count(double depth, EchoExtent::Depths& depths)
{
  if (depth >= leastDepth)
  {
    const double line = linesPerDecade * std::log10(depth / leastDepth);
    depths[std::min(static_cast<std::size_t>(line), depths.size() - 1)] += 1.0;
  }
}

// How much a view from above shows of each column, 0 to 1.
std::vector<double> SeenFromAbove(const Columns& columns, double layer)
{
  constexpr double stretch = 3.0;
  std::vector<double> seen;
  for (std::size_t first = 0; first < columns.extinctions.size();
       first += static_cast<std::size_t>(columns.layers))
  {
    const auto column = columns.extinctions.begin() + static_cast<std::ptrdiff_t>(first);
    const double sum = std::accumulate(column, column + columns.layers, 0.0);
    seen.push_back(1.0 - std::exp(-stretch * layer * sum));
  }
  return seen;
}

// The columns that hang together with one, which are taken from `left`.
std::vector<int> TakeRegion(int from, const std::array<int, 2>& count, std::vector<bool>& left)
{
  std::vector<int> region = {from};
  left[static_cast<std::size_t>(from)] = false;
  for (std::size_t i = 0; i < region.size(); ++i)
  {
    const int x = region[i] % count[0];
    const int y = region[i] / count[0];
    for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, count[1] - 1); ++ny)
    {
      for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, count[0] - 1); ++nx)
      {
        const int next = ny * count[0] + nx;
        if (left[static_cast<std::size_t>(next)])
        {
          left[static_cast<std::size_t>(next)] = false;
          region.push_back(next);
        }
      }
    }
  }
  return region;
}

// Makes nothing of what does not count: columns of hardly any echo, and small regions.
void LeaveOutSpecks(const std::array<int, 2>& count, std::vector<double>& seen)
{
  constexpr double faint = 0.02; // of the densest column
  constexpr double small = 0.005;
  const double most = *std::max_element(seen.begin(), seen.end());
  std::vector<bool> left;
  for (double& column : seen)
  {
    column = column < faint * most ? 0.0 : column;
    left.push_back(column > 0.0);
  }
  const double all = std::accumulate(seen.begin(), seen.end(), 0.0);
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    if (!left[i])
    {
      continue;
    }
    const std::vector<int> region = TakeRegion(static_cast<int>(i), count, left);
    const double sum = std::accumulate(region.begin(), region.end(), 0.0,
      [&](double part, int column) { return part + seen[static_cast<std::size_t>(column)]; });
    for (const int column : region)
    {
      seen[static_cast<std::size_t>(column)] *= sum < small * all ? 0.0 : 1.0;
    }
  }
}

// Columns along x and y: the first one, and the one after the last.
using Rectangle = std::array<int, 4>;

double SumOf(
  const std::vector<double>& seen, const std::array<int, 2>& count, const Rectangle& rectangle)
{
  double sum = 0.0;
  for (int y = rectangle[2]; y < rectangle[3]; ++y)
  {
    const auto row = seen.begin() + static_cast<std::ptrdiff_t>(y) * count[0];
    sum = std::accumulate(row + rectangle[0], row + rectangle[1], sum);
  }
  return sum;
}

// A strip that is cut off a side.
struct Strip
{
  double gain = 0.0; // part of the area, less a multiple of the part of the echo; above 0: a gain
  Rectangle left{};  // without it
  double lost = 0.0; // of the echo
};

// The strip without which the rectangle is filled best.
Strip BestStrip(const std::vector<double>& seen, const std::array<int, 2>& count,
  const Rectangle& rectangle, double mayLose)
{
  constexpr double weightOfEcho = 3.0;
  const double all = SumOf(seen, count, rectangle);
  Strip best;
  for (std::size_t side = 0; side < rectangle.size(); ++side)
  {
    const std::size_t axis = side / 2;
    const int width = rectangle[2 * axis + 1] - rectangle[2 * axis];
    for (int strip = 1; strip < width; ++strip)
    {
      Rectangle left = rectangle;
      left[side] += side % 2 == 0 ? strip : -strip;
      const double lost = all - SumOf(seen, count, left);
      const double gain = static_cast<double>(strip) / width - weightOfEcho * lost / all;
      if (lost > mayLose)
      {
        break;
      }
      best = gain > best.gain ? Strip{gain, left, lost} : best;
    }
  }
  return best;
}

// The columns that are framed.
Rectangle FindRectangle(const std::vector<double>& seen, const std::array<int, 2>& count)
{
  // A storm with more of the echo is not left out, but several smaller ones may be.
  constexpr double mayLoseAtOnce = 0.15;
  constexpr double mayLose = 0.25;
  Rectangle rectangle = {0, count[0], 0, count[1]};
  const double all = SumOf(seen, count, rectangle);
  double left = mayLose * all;
  const auto next = [&]
  { return BestStrip(seen, count, rectangle, std::min(left, mayLoseAtOnce * all)); };
  for (Strip strip = next(); strip.gain > 0.0; strip = next())
  {
    rectangle = strip.left;
    left -= strip.lost;
  }
  return rectangle;
}

// Per km; what is above a layer that has it is not seen.
constexpr float faintestTop = 0.004f;

// How much is seen of the columns whose echo ends in each layer.
std::vector<double> Tops(const Columns& columns, const std::vector<double>& seen)
{
  std::vector<double> tops(static_cast<std::size_t>(columns.layers));
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    int top = columns.layers - 1;
    const std::size_t first = i * static_cast<std::size_t>(columns.layers);
    while (top > 0 && columns.extinctions[first + static_cast<std::size_t>(top)] < faintestTop)
    {
      --top;
    }
    tops[static_cast<std::size_t>(top)] += seen[i];
  }
  return tops;
}

// The layer below which the echo of nearly all columns ends.
int HighestTop(const std::vector<double>& tops)
{
  constexpr double out = 0.005;
  double left = out * std::accumulate(tops.begin(), tops.end(), 0.0);
  auto top = static_cast<int>(tops.size());
  while (top > 1 && left >= tops[static_cast<std::size_t>(top - 1)])
  {
    --top;
    left -= tops[static_cast<std::size_t>(top)];
  }
  return top;
}

std::array<double, 6> BoxOf(
  vtkImageData* volume, const Columns& columns, const std::vector<double>& seen)
{
  const Rectangle rectangle = FindRectangle(seen, columns.count);
  std::array<double, 6> box = FacesOf(volume);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double edge = volume->GetSpacing()[axis] * columns.voxels[axis];
    const double first = box[2 * axis];
    box[2 * axis] = first + edge * rectangle[2 * axis];
    box[2 * axis + 1] = std::min(box[2 * axis + 1], first + edge * rectangle[2 * axis + 1]);
  }
  box[5] = box[4] + volume->GetSpacing()[2] * HighestTop(Tops(columns, seen));
  return box;
}

void CountDepths(
  const Columns& columns, const std::vector<double>& seen, const Edges& edges, EchoExtent& echo)
{
  const auto [columnsX, columnsY] = columns.count;
  const auto lines = static_cast<std::size_t>(columns.layers);
  std::vector<double> alongY(static_cast<std::size_t>(columnsX) * lines);
  std::vector<double> alongX(static_cast<std::size_t>(columnsY) * lines);
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    const auto x = i % static_cast<std::size_t>(columnsX);
    const auto y = i / static_cast<std::size_t>(columnsX);
    double sum = 0.0;
    for (std::size_t z = 0; z < lines && seen[i] > 0.0; ++z)
    {
      const auto extinction = static_cast<double>(columns.extinctions[i * lines + z]);
      sum += extinction;
      alongX[y * lines + z] += extinction * edges.voxel[0] * columns.voxels[0];
      alongY[x * lines + z] += extinction * edges.voxel[1] * columns.voxels[1];
    }
    Count(sum * edges.voxel[2], echo.upright);
  }
  for (const std::vector<double>* depths : {&alongX, &alongY})
  {
    for (const double depth : *depths)
    {
      Count(depth, echo.level);
    }
  }
}

// The opacity of what is seen, each line of sight counted as much as it is seen.
double MeanOpacity(const EchoExtent::Depths& depths, double strength)
{
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    const double opacity = 1.0 - std::exp(-strength * DepthOf(i));
    sum += depths[i] * opacity;
    squares += depths[i] * opacity * opacity;
  }
  return sum > 0.0 ? squares / sum : 0.0;
}

} // namespace

double DepthOf(std::size_t line)
{
  return leastDepth * std::pow(10.0, (static_cast<double>(line) + 0.5) / linesPerDecade);
}

std::optional<EchoExtent> FindExtent(vtkImageData* volume, vtkNexradTransferFunction* opacities)
{
  const Edges edges(volume);
  const Columns columns = ColumnsOf(volume, Extinction(opacities));
  std::vector<double> seen = SeenFromAbove(columns, edges.voxel[2]);
  if (std::all_of(seen.begin(), seen.end(), [](double column) { return column <= 0.0; }))
  {
    return std::nullopt;
  }
  LeaveOutSpecks(columns.count, seen);
  EchoExtent echo;
  echo.box = BoxOf(volume, columns, seen);
  CountDepths(columns, seen, edges, echo);
  return echo;
}

EchoExtent Join(const EchoExtent& a, const EchoExtent& b)
{
  EchoExtent joined = a;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    joined.box[2 * axis] = std::min(a.box[2 * axis], b.box[2 * axis]);
    joined.box[2 * axis + 1] = std::max(a.box[2 * axis + 1], b.box[2 * axis + 1]);
  }
  std::transform(
    a.upright.begin(), a.upright.end(), b.upright.begin(), joined.upright.begin(), std::plus<>());
  std::transform(
    a.level.begin(), a.level.end(), b.level.begin(), joined.level.begin(), std::plus<>());
  return joined;
}

double OpacityDistanceOf(const EchoExtent& echo, double exaggeration)
{
  constexpr double wanted = 0.7;
  constexpr double weakest = 0.25;
  constexpr double strongest = 10.0;
  double low = weakest;
  double high = strongest;
  for (int i = 0; i < 20; ++i)
  {
    const double strength = std::sqrt(low * high);
    const double mean = 0.5 * (MeanOpacity(echo.upright, strength * exaggeration) +
                                MeanOpacity(echo.level, strength));
    (mean < wanted ? low : high) = strength;
  }
  return OpacityUnitDistance / std::sqrt(low * high);
}

} // namespace nexrad::scene
