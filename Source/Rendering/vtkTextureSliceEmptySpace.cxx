// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceEmptySpace.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceParts.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace
{

using Range = vtkTextureSliceBricks::Range;
using Source = vtkTextureSliceParts;

/// Whether a brick counts, by the ranges of its scalars, one for each component.
using Test = std::function<bool(const Range* ranges)>;

constexpr double Unbounded = std::numeric_limits<double>::infinity();

/// What the graphics hardware may err by in a scalar.
double FindScalarError(const vtkTextureSliceComponent& component)
{
  return 1e-5 * (component.Range[1] - component.Range[0]);
}

/// How far from its scalars a sample looks at the table, of the width of the functions' domain.
double FindMargin(const Source& source, const vtkTextureSliceFeatures& features)
{
  if (features.Table2D)
  {
    // Its entries lie in the middle of equal parts of the domain.
    return 0.5 / static_cast<double>(std::max(2, source.Table2D.GetWidth()) - 1);
  }
  const std::size_t width = vtkTextureSliceIntegralTable::ChooseWidth(source.Table.GetWidth());
  return features.Slabs ? 1.0 / static_cast<double>(width - 1) : 0.0;
}

Test MakeOpacityTest(const Source& source, const vtkTextureSliceFeatures& features, std::size_t row)
{
  const auto& components = source.Texture.GetComponents();
  // Dependent components take their opacity from the last one.
  const std::size_t component = features.Functions > 1 ? row : components.size() - 1;
  std::vector<const vtkTextureSliceVisibility*> visibilities{
    features.Table2D ? &source.Table2D.GetVisibility(row) : &source.Table.GetVisibility(row)};
  for (int label = features.Functions; label < features.CountFunctions(); ++label)
  {
    visibilities.push_back(&source.Table.GetVisibility(static_cast<std::size_t>(label)));
  }
  const auto [least, most] = components[component].Range;
  // A brick of which all scalars are invisible may still hide a lesser extreme that is visible; it
  // is without effect only if everything below (or above) its scalars is invisible too.
  const double below =
    features.BlendMode == vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND ? Unbounded : 0.0;
  const double above =
    features.BlendMode == vtkVolumeMapper::MINIMUM_INTENSITY_BLEND ? Unbounded : 0.0;
  return [=, begin = least, margin = FindMargin(source, features),
           scale = least < most ? 1.0 / (most - least) : 1.0](const Range* ranges)
  {
    const Range& range = ranges[component];
    const double low = (range.Low - below - begin) * scale - margin;
    const double high = (range.High + above - begin) * scale + margin;
    return range.Low <= range.High && std::any_of(visibilities.begin(), visibilities.end(),
                                        [&](const vtkTextureSliceVisibility* visibility)
                                        { return visibility->IsVisible(low, high); });
  };
}

/// The brick has samples that an average counts, of a component with functions of its own.
Test MakeAverageTest(const Source& source, std::size_t component)
{
  const double error = FindScalarError(source.Texture.GetComponents()[component]);
  const double* range = source.Request.Mapper->GetAverageIPScalarRange();
  return [component, least = range[0] - error, most = range[1] + error](const Range* ranges)
  {
    const Range& range = ranges[component];
    return range.Low <= range.High && range.High >= least && range.Low <= most;
  };
}

Test MakeSurfaceTest(const Source& source)
{
  const std::size_t component = source.Texture.GetComponents().size() - 1;
  const double error = FindScalarError(source.Texture.GetComponents()[component]);
  return [component, error, values = source.Request.GetIsoValues()](const Range* ranges)
  {
    const Range& range = ranges[component];
    const auto next = std::lower_bound(values.begin(), values.end(), range.Low - error);
    return range.Low <= range.High && next != values.end() && *next <= range.High + error;
  };
}

/// A brick counts if one of these is true.
std::vector<Test> MakeTests(const Source& source)
{
  const vtkTextureSliceFeatures features = source.Request.GetFeatures();
  if (features.BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND)
  {
    return {MakeSurfaceTest(source)};
  }
  std::vector<Test> tests;
  for (std::size_t row = 0; row < static_cast<std::size_t>(features.Functions); ++row)
  {
    tests.push_back(features.BlendMode == vtkVolumeMapper::AVERAGE_INTENSITY_BLEND
                      ? MakeAverageTest(source, row)
                      : MakeOpacityTest(source, features, row));
  }
  return tests;
}

/// For each brick, 1 where it counts, else 0.
std::vector<unsigned char> FindVisible(const Source& source)
{
  const std::vector<Range>& ranges = source.Texture.GetBricks().Ranges;
  const std::size_t components = source.Texture.GetComponents().size();
  std::vector<unsigned char> visible(ranges.size() / components);
  const auto tests = MakeTests(source);
  vtkSMPTools::For(0, static_cast<vtkIdType>(visible.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto brick = static_cast<std::size_t>(begin); brick < static_cast<std::size_t>(end);
           ++brick)
      {
        const auto* const own = ranges.data() + brick * components;
        const bool counts =
          std::any_of(tests.begin(), tests.end(), [own](const Test& test) { return test(own); });
        visible[brick] = counts ? 1 : 0;
      }
    });
  return visible;
}

} // namespace

void vtkTextureSliceDistanceMap::Build(const std::array<int, 3>& count,
  const std::array<double, 3>& edge, const std::vector<unsigned char>& visible)
{
  this->Count = count;
  this->Edge = edge;
  this->Distances.resize(Octants * visible.size());
  vtkSMPTools::For(0, Octants,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType octant = begin; octant < end; ++octant)
      {
        this->Fill(static_cast<unsigned int>(octant), visible);
      }
    });
  this->FindSeen(visible);
  const auto seen =
    visible.size() - static_cast<std::size_t>(std::count(visible.begin(), visible.end(), 0));
  this->VisibleShare =
    static_cast<double>(seen) / static_cast<double>(std::max<std::size_t>(1, visible.size()));
  this->Uploaded = false;
}

void vtkTextureSliceDistanceMap::Fill(
  unsigned int octant, const std::vector<unsigned char>& visible)
{
  // One more than the least of the seven bricks ahead. There is a border of bricks that are far
  // from all visible ones.
  const std::ptrdiff_t rowStride = this->Count[0] + 2;
  const std::ptrdiff_t layerStride = rowStride * (this->Count[1] + 2);
  std::vector<unsigned char> map(
    static_cast<std::size_t>(layerStride * (this->Count[2] + 2)), MostDistance);
  const std::ptrdiff_t x = (octant & 1) != 0 ? -1 : 1;
  const std::ptrdiff_t y = (octant & 2) != 0 ? -rowStride : rowStride;
  const std::ptrdiff_t z = (octant & 4) != 0 ? -layerStride : layerStride;
  const auto inTurn = [this, octant](std::size_t axis, int i)
  { return (octant >> axis & 1) != 0 ? i : this->Count[axis] - 1 - i; };
  for (int iz = 0; iz < this->Count[2]; ++iz)
  {
    for (int iy = 0; iy < this->Count[1]; ++iy)
    {
      const std::ptrdiff_t row = std::ptrdiff_t{inTurn(2, iz)} * this->Count[1] + inTurn(1, iy);
      const unsigned char* seen = visible.data() + row * this->Count[0];
      unsigned char* distances =
        this->Distances.data() + octant * visible.size() + row * this->Count[0];
      unsigned char* here =
        map.data() + (inTurn(2, iz) + 1) * layerStride + (inTurn(1, iy) + 1) * rowStride + 1;
      for (int ix = 0; ix < this->Count[0]; ++ix)
      {
        const int column = inTurn(0, ix);
        const unsigned char* d = here + column;
        const unsigned char least =
          std::min({d[x], d[y], d[z], d[x + y], d[x + z], d[y + z], d[x + y + z]});
        here[column] = seen[column] != 0
                         ? 0
                         : static_cast<unsigned char>(least + (least < MostDistance ? 1 : 0));
        distances[column] = here[column];
      }
    }
  }
}

void vtkTextureSliceDistanceMap::FindSeen(const std::vector<unsigned char>& visible)
{
  std::array<int, 6> bricks{this->Count[0], -1, this->Count[1], -1, this->Count[2], -1};
  for (int id = 0; id < static_cast<int>(visible.size()); ++id)
  {
    const std::array<int, 3> brick{id % this->Count[0], id / this->Count[0] % this->Count[1],
      id / (this->Count[0] * this->Count[1])};
    for (std::size_t axis = 0; axis < 3 && visible[static_cast<std::size_t>(id)] != 0; ++axis)
    {
      bricks[2 * axis] = std::min(bricks[2 * axis], brick[axis]);
      bricks[2 * axis + 1] = std::max(bricks[2 * axis + 1], brick[axis]);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Seen[2 * axis] = bricks[2 * axis] * this->Edge[axis];
    this->Seen[2 * axis + 1] = std::min(1.0, (bricks[2 * axis + 1] + 1) * this->Edge[axis]);
  }
}

void vtkTextureSliceDistanceMap::Upload(vtkOpenGLRenderWindow* window)
{
  if (this->Uploaded && this->Texture->GetContext() == window && this->Texture->GetHandle() != 0)
  {
    return;
  }
  this->Texture->SetContext(window);
  vtkTextureSliceSetSampling(this->Texture, true);
  this->Texture->Create3DFromRaw(static_cast<unsigned int>(this->Count[0]),
    static_cast<unsigned int>(this->Count[1]), static_cast<unsigned int>(Octants * this->Count[2]),
    1, VTK_UNSIGNED_CHAR, this->Distances.data());
  this->Uploaded = true;
}

void vtkTextureSliceDistanceMap::SetUniforms(
  vtkShaderProgram* program, const vtkTextureSliceFrame& frame) const
{
  std::array<float, 3> scale{};
  std::array<float, 3> bias{};
  std::array<float, 3> last{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    scale[axis] = 1.0f / (static_cast<float>(this->Edge[axis]) * frame.TextureScale[axis]);
    bias[axis] = -frame.TextureBias[axis] * scale[axis];
    last[axis] = static_cast<float>(this->Count[axis] - 1);
  }
  program->SetUniform3f("brickScale", scale.data());
  program->SetUniform3f("brickBias", bias.data());
  program->SetUniform3f("lastBrick", last.data());
}

void vtkTextureSliceEmptySpace::Update(const Source& source)
{
  const double* range = source.Request.Mapper->GetAverageIPScalarRange();
  Key key{source.Texture.GetBricks().BuildTime, source.Table.GetFillTime(),
    source.Table2D.GetFillTime(), {range[0], range[1]}, source.Request.GetIsoValues(),
    source.Request.GetFeatures().GetDefines()};
  if (key == this->Last)
  {
    return;
  }
  this->Last = std::move(key);
  const std::vector<unsigned char> before = std::exchange(this->Visible, FindVisible(source));
  const vtkTextureSliceBricks& bricks = source.Texture.GetBricks();
  if (this->Visible == before && bricks.Edge == this->Distances.Edge)
  {
    return; // another colour, or another opacity of what is visible
  }
  this->Distances.Build(bricks.Count, bricks.Edge, this->Visible);
}
