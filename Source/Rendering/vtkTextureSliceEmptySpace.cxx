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
#include <array>
#include <functional>
#include <limits>

namespace
{

constexpr unsigned char Most = vtkTextureSliceDistanceMap::MostDistance;

/// One row of bricks.
struct Row
{
  const unsigned char* Visible;
  unsigned char* Distances;
  int Length;
  int ToNext; ///< 1 or -1: where rays go
};

/// Distances of a row, from its far end back: one more than the least of the seven bricks ahead.
/// @param beside distances of the three rows ahead.
/// @param nearest, limits room for Length + 2 and for Length numbers.
void FillRow(const Row& row, const std::array<const unsigned char*, 3>& beside,
  unsigned char* nearest, unsigned char* limits)
{
  const auto [besideY, besideZ, besideBoth] = beside;
  nearest[0] = nearest[row.Length + 1] = Most;
  for (int x = 0; x < row.Length; ++x)
  {
    nearest[x + 1] = std::min(std::min(besideY[x], besideZ[x]), besideBoth[x]);
  }
  for (int x = 0; x < row.Length; ++x)
  {
    const unsigned char clear = std::min(nearest[x + 1], nearest[x + 1 + row.ToNext]);
    const auto further = static_cast<unsigned char>(clear + (clear < Most ? 1 : 0));
    limits[x] = row.Visible[x] != 0 ? static_cast<unsigned char>(0) : further;
  }
  int distance = Most;
  int x = row.ToNext > 0 ? row.Length - 1 : 0;
  for (int i = 0; i < row.Length; ++i, x -= row.ToNext)
  {
    distance = std::min(distance + 1, static_cast<int>(limits[x]));
    row.Distances[x] = static_cast<unsigned char>(distance);
  }
}

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

/// The opacities of one component of a brick are above 0 somewhere.
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

/// A surface passes through the brick.
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
  const auto seen =
    visible.size() - static_cast<std::size_t>(std::count(visible.begin(), visible.end(), 0));
  this->VisibleShare =
    static_cast<double>(seen) / static_cast<double>(std::max<std::size_t>(1, visible.size()));
  this->Uploaded = false;
}

void vtkTextureSliceDistanceMap::Fill(
  unsigned int octant, const std::vector<unsigned char>& visible)
{
  const auto [length, height, layers] = this->Count;
  unsigned char* const map = this->Distances.data() + octant * visible.size();
  const auto along = [octant](unsigned int axis) { return (octant >> axis & 1) != 0 ? -1 : 1; };
  const auto begin = [this](int y, int z)
  { return static_cast<std::size_t>(z * this->Count[1] + y) * this->Count[0]; };
  const std::vector<unsigned char> outside(static_cast<std::size_t>(length), Most);
  const auto rowAt = [&](int y, int z)
  {
    const bool inside = y >= 0 && y < this->Count[1] && z >= 0 && z < this->Count[2];
    return inside ? map + begin(y, z) : outside.data();
  };
  std::vector<unsigned char> nearest(static_cast<std::size_t>(length) + 2);
  std::vector<unsigned char> limits(static_cast<std::size_t>(length));
  for (int iz = 0; iz < layers; ++iz)
  {
    const int z = along(2) > 0 ? layers - 1 - iz : iz;
    for (int iy = 0; iy < height; ++iy)
    {
      const int y = along(1) > 0 ? height - 1 - iy : iy;
      FillRow({visible.data() + begin(y, z), map + begin(y, z), length, along(0)},
        {rowAt(y + along(1), z), rowAt(y, z + along(2)), rowAt(y + along(1), z + along(2))},
        nearest.data(), limits.data());
    }
  }
}

std::array<double, 6> vtkTextureSliceDistanceMap::FindSeen() const
{
  std::array<int, 6> bricks{this->Count[0], -1, this->Count[1], -1, this->Count[2], -1};
  const unsigned char* distance = this->Distances.data();
  for (int z = 0; z < this->Count[2]; ++z)
  {
    for (int y = 0; y < this->Count[1]; ++y)
    {
      for (int x = 0; x < this->Count[0]; ++x, ++distance)
      {
        const std::array<int, 3> brick{x, y, z};
        for (std::size_t axis = 0; axis < 3 && *distance == 0; ++axis)
        {
          bricks[2 * axis] = std::min(bricks[2 * axis], brick[axis]);
          bricks[2 * axis + 1] = std::max(bricks[2 * axis + 1], brick[axis]);
        }
      }
    }
  }
  std::array<double, 6> seen{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    seen[2 * axis] = bricks[2 * axis] * this->Edge[axis];
    seen[2 * axis + 1] = std::min(1.0, (bricks[2 * axis + 1] + 1) * this->Edge[axis]);
  }
  return seen;
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

vtkTextureSliceEmptySpace::Key vtkTextureSliceEmptySpace::MakeKey(const Source& source)
{
  return {source.Texture.GetBricks().GetBuildTime(), source.Table.GetVisibilityTime(),
    source.Table2D.GetFillTime(),
    {source.Request.Mapper->GetAverageIPScalarRange()[0],
      source.Request.Mapper->GetAverageIPScalarRange()[1]},
    source.Request.GetIsoValues(), source.Request.GetFeatures().GetDefines()};
}

void vtkTextureSliceEmptySpace::Update(const Source& source)
{
  Key key = MakeKey(source);
  if (key == this->Last)
  {
    return;
  }
  this->Last = std::move(key);
  const std::vector<unsigned char> before = this->Visible;
  this->FindVisible(source);
  const vtkTextureSliceBricks& bricks = source.Texture.GetBricks();
  if (this->Visible == before && bricks.GetEdge() == this->Distances.GetEdge())
  {
    return; // another colour, or another opacity of what is visible
  }
  this->Distances.Build(bricks.GetCount(), bricks.GetEdge(), this->Visible);
  this->Seen = this->Distances.FindSeen();
}

void vtkTextureSliceEmptySpace::FindVisible(const Source& source)
{
  const std::vector<vtkTextureSliceBricks::Range>& ranges = source.Texture.GetBricks().GetRanges();
  const std::size_t components = source.Texture.GetComponents().size();
  this->Visible.resize(ranges.size() / components);
  const auto tests = MakeTests(source);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Visible.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto brick = static_cast<std::size_t>(begin); brick < static_cast<std::size_t>(end);
           ++brick)
      {
        const auto* const own = ranges.data() + brick * components;
        // Bricks without echoes have the ranges of those before them.
        if (static_cast<vtkIdType>(brick) > begin &&
            std::equal(own, own + components, own - components))
        {
          this->Visible[brick] = this->Visible[brick - 1];
          continue;
        }
        const bool visible =
          std::any_of(tests.begin(), tests.end(), [own](const Test& test) { return test(own); });
        this->Visible[brick] = visible ? 1 : 0;
      }
    });
}
