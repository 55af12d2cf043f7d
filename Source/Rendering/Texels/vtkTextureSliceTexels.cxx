// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTexels.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <type_traits>
#include <utility>

namespace
{

using Range = vtkTextureSliceBricks::Range;

/// Intervals along a brick's edge: small bricks follow the data closely, but more of them than a
/// cube of 64 has cost more to look at than they save.
int ChooseEdge(const std::array<int, 3>& intervals)
{
  constexpr double most = 64.0 * 64.0 * 64.0;
  // Of a texture along an axis; that of the distances has so many layers for each octant.
  constexpr int mostAlongAxis = 2048;
  constexpr int mostLayers = mostAlongAxis / 8;
  int edge = 4;
  const auto count = [&](std::size_t axis) { return (intervals[axis] + edge - 1) / edge; };
  while (double(count(0)) * count(1) * count(2) > most || count(0) > mostAlongAxis ||
         count(1) > mostAlongAxis || count(2) > mostLayers)
  {
    ++edge;
  }
  return edge;
}

template <typename Scalar>
class RowScanner
{
public:
  RowScanner(const vtkTextureSliceScalars& source, int edge, const std::array<int, 3>& count)
    : Source(source)
    , Edge(edge)
    , Count(count)
    , Rows(source)
    , Marks(Rows.Length)
    , Hides(Rows.Length)
    , Low(Rows.Length * Rows.Components)
    , High(Rows.Length * Rows.Components)
  {
  }

  /// @param hides of each brick of the row, whether it has texels that do not count
  void Scan(int row, Range* ranges, unsigned char* hides)
  {
    std::fill(this->Low.begin(), this->Low.end(), std::numeric_limits<Scalar>::max());
    std::fill(this->High.begin(), this->High.end(), std::numeric_limits<Scalar>::lowest());
    std::fill(this->Hides.begin(), this->Hides.end(), static_cast<unsigned char>(0));
    const auto [firstY, endY] = this->Reach(row % this->Count[1], 1);
    const auto [firstZ, endZ] = this->Reach(row / this->Count[1], 2);
    for (int z = firstZ; z < endZ; ++z)
    {
      for (int y = firstY; y < endY; ++y)
      {
        this->Rows.MarkVisible(y, z, 0, this->Rows.Length, this->Marks.data());
        this->TakeHidden();
        const std::size_t components = this->Rows.Components;
        for (std::size_t c = 0; c < components; ++c)
        {
          // A constant step lets the compiler take several texels at a time.
          components == 1 ? this->Extend(this->Rows.GetScalars(y, z), 0, 1)
                          : this->Extend(this->Rows.GetScalars(y, z), c, components);
        }
      }
    }
    for (int brick = 0; brick < this->Count[0]; ++brick, ranges += this->Rows.Components)
    {
      this->SetRanges(brick, ranges);
      const auto [first, end] = this->Reach(brick, 0);
      const unsigned char* columns = this->Hides.data();
      hides[brick] = *std::max_element(columns + first, columns + end);
    }
  }

private:
  /// The first texel that samples inside a brick can reach along an axis, and the end of them.
  std::array<int, 2> Reach(int brick, std::size_t axis) const
  {
    int first = brick * this->Edge; // interval between points
    int end = first + this->Edge;
    const std::vector<double>& places = this->Source.Places[axis];
    if (!places.empty())
    {
      // The intervals that an equal part of the box touches.
      constexpr double margin = 1.0 / 1024; // what the shaders' places may be off at most
      const double edge = this->Edge / static_cast<double>(places.size() - 1);
      const auto low =
        std::upper_bound(places.begin() + 1, places.end() - 1, brick * edge - margin);
      const auto high =
        std::lower_bound(places.begin() + 1, places.end() - 1, (brick + 1) * edge + margin);
      first = static_cast<int>(low - places.begin()) - 1;
      end = static_cast<int>(high - places.begin());
    }
    // Point scalars stand at the intervals' ends, cell scalars half a cell inside of them.
    return {std::max(0, this->Source.CellData ? first - 1 : first),
      std::min(this->Source.Size[axis], end + 1)};
  }

  void TakeHidden()
  {
    if (std::memchr(this->Marks.data(), 0, this->Rows.Length) != nullptr)
    {
      std::transform(this->Hides.begin(), this->Hides.end(), this->Marks.begin(),
        this->Hides.begin(),
        [](unsigned char hides, unsigned char counts)
        { return static_cast<unsigned char>(hides | (counts ^ 1U)); });
    }
  }

  /// Takes one component of a row of texels into the extremes of the columns.
  void Extend(const Scalar* row, std::size_t component, std::size_t step)
  {
    constexpr Scalar most = std::numeric_limits<Scalar>::max();
    constexpr Scalar least = std::numeric_limits<Scalar>::lowest();
    Scalar* low = this->Low.data() + component;
    Scalar* high = this->High.data() + component;
    const unsigned char* counts = this->Marks.data();
    const std::size_t length = this->Rows.Length;
    for (std::size_t i = 0; i < length; ++i)
    {
      const Scalar scalar = row[i * step + component];
      const Scalar forLow = counts[i] != 0 ? scalar : most;
      const Scalar forHigh = counts[i] != 0 ? scalar : least;
      low[i * step] = forLow < low[i * step] ? forLow : low[i * step];
      high[i * step] = high[i * step] < forHigh ? forHigh : high[i * step];
    }
  }

  void SetRanges(int brick, Range* ranges) const
  {
    const std::size_t components = this->Rows.Components;
    const auto [first, end] = this->Reach(brick, 0);
    for (std::size_t i = static_cast<std::size_t>(first) * components;
         i < static_cast<std::size_t>(end) * components; ++i)
    {
      if (this->Low[i] <= this->High[i]) // else nothing counted
      {
        Range& range = ranges[i % components];
        range.Low = std::min(range.Low, static_cast<double>(this->Low[i]));
        range.High = std::max(range.High, static_cast<double>(this->High[i]));
      }
    }
  }

  const vtkTextureSliceScalars& Source;
  int Edge;
  const std::array<int, 3>& Count;
  vtkTextureSlice::Rows<Scalar> Rows;
  std::vector<unsigned char> Marks; ///< 1 for texels of a row that count
  std::vector<unsigned char> Hides; ///< 1 for columns with texels that do not
  std::vector<Scalar> Low;          ///< of each component of each column of texels
  std::vector<Scalar> High;
};

} // namespace

void vtkTextureSliceBricks::Build(const vtkTextureSliceScalars& source)
{
  std::array<int, 3> intervals = source.Size; // between the texels that the box spans
  std::for_each(intervals.begin(), intervals.end(),
    [&source](int& count) { count -= source.CellData ? 0 : 1; });
  const int edge = ChooseEdge(intervals);
  this->Intervals = edge;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Count[axis] = (intervals[axis] + edge - 1) / edge;
    this->Edge[axis] = double(edge) / intervals[axis];
  }
  const vtkIdType rows = static_cast<vtkIdType>(this->Count[1]) * this->Count[2];
  const vtkIdType rangesOfRow =
    static_cast<vtkIdType>(this->Count[0]) * source.Scalars->GetNumberOfComponents();
  this->Ranges.assign(static_cast<std::size_t>(rows * rangesOfRow), Range());
  this->Hides.assign(static_cast<std::size_t>(rows * this->Count[0]), 0);
  const auto scan = [&](auto scalar)
  {
    vtkSMPTools::For(0, rows,
      [&](vtkIdType begin, vtkIdType end)
      {
        RowScanner<decltype(scalar)> scanner(source, edge, this->Count);
        for (vtkIdType row = begin; row < end; ++row)
        {
          scanner.Scan(static_cast<int>(row), this->Ranges.data() + row * rangesOfRow,
            this->Hides.data() + row * this->Count[0]);
        }
      });
  };
  switch (source.Scalars->GetDataType())
  {
    vtkTemplateMacro(scan(VTK_TT()));
  }
  for (Range& range : this->Ranges)
  {
    if (source.Codes && range.Low <= range.High)
    {
      const auto [low, high] = source.Codes->GetRange(
        static_cast<std::size_t>(range.Low), static_cast<std::size_t>(range.High));
      range = {low, high};
    }
  }
  vtkTimeStamp now;
  now.Modified();
  this->BuildTime = now.GetMTime();
}

std::optional<std::vector<double>> vtkTextureSliceBricks::FindScalars(
  const std::array<int, 3>& brick) const
{
  const auto number =
    static_cast<std::size_t>((brick[2] * this->Count[1] + brick[1]) * this->Count[0] + brick[0]);
  const std::size_t components = this->Ranges.size() / this->Hides.size();
  std::vector<double> scalars;
  for (std::size_t i = number * components; i < (number + 1) * components; ++i)
  {
    const Range& range = this->Ranges[i];
    if (range.Low > range.High)
    {
      return std::vector<double>();
    }
    if (range.Low < range.High || this->Hides[number] != 0)
    {
      return std::nullopt;
    }
    scalars.push_back(range.Low);
  }
  return scalars;
}

namespace
{

using Box = vtkTextureSliceBlocks::Box;
constexpr int Edge = vtkTextureSliceBlocks::Edge;

constexpr std::uint64_t Seed = 0x9E3779B97F4A7C15;
constexpr std::uint64_t Factor = 0xD6E8FEB86659FD93; // odd, so that no two words give the same

/// Takes bytes into a sum, the last word filled with zeros.
std::uint64_t MixBytes(std::uint64_t sum, const unsigned char* bytes, std::size_t count)
{
  constexpr std::size_t size = sizeof(std::uint64_t);
  for (std::size_t i = 0; i < count; i += size)
  {
    std::uint64_t word = 0;
    i + size <= count ? std::memcpy(&word, bytes + i, size)
                      : std::memcpy(&word, bytes + i, count - i);
    const std::uint64_t product = (sum ^ word) * Factor;
    sum = product ^ (product >> 32);
  }
  return sum;
}

/// Takes a row of texels into the sums of the blocks along it.
void MixRow(
  const unsigned char* row, std::size_t length, std::size_t bytesOfTexel, std::uint64_t* sums)
{
  constexpr auto edge = static_cast<std::size_t>(Edge);
  for (std::size_t begin = 0; begin < length; begin += edge, ++sums)
  {
    const std::size_t texels = std::min(edge, length - begin);
    *sums = MixBytes(*sums, row + begin * bytesOfTexel, texels * bytesOfTexel);
  }
}

template <typename Scalar>
void SumRowOfBlocks(const vtkTextureSlice::Rows<Scalar>& rows, const Box& box, std::uint64_t* sums)
{
  for (int z = box.Begin[2]; z < box.End[2]; ++z)
  {
    for (int y = box.Begin[1]; y < box.End[1]; ++y)
    {
      MixRow(reinterpret_cast<const unsigned char*>(rows.GetScalars(y, z)), rows.Length,
        rows.Components * sizeof(Scalar), sums);
      if (const unsigned char* ghosts = rows.GetGhosts(y, z))
      {
        MixRow(ghosts, rows.Length, 1, sums);
      }
    }
  }
}

/// Adds a box, or extends one with the same texels along x that ends where it begins along y.
void Add(const Box& box, std::vector<Box>& boxes)
{
  const auto before = std::find_if(boxes.begin(), boxes.end(),
    [&box](const Box& other)
    {
      return other.Begin[0] == box.Begin[0] && other.End[0] == box.End[0] &&
             other.End[1] == box.Begin[1];
    });
  before != boxes.end() ? static_cast<void>(before->End[1] = box.End[1]) : boxes.push_back(box);
}

using Component = vtkTextureSliceComponent;

template <typename Scalar>
using TexelOf = std::conditional_t<std::is_integral_v<Scalar> && sizeof(Scalar) <= 2,
  std::conditional_t<sizeof(Scalar) == 1, std::uint8_t, std::uint16_t>, float>;

template <typename Texel>
constexpr int TypeOf = std::is_same_v<Texel, float>
                         ? VTK_FLOAT
                         : (sizeof(Texel) == 1 ? VTK_UNSIGNED_CHAR : VTK_UNSIGNED_SHORT);

template <typename Scalar>
void SetScale(Component& component)
{
  if constexpr (std::is_integral_v<TexelOf<Scalar>>)
  {
    // What is stored is the distance from the type's least value.
    component.Scale = std::numeric_limits<TexelOf<Scalar>>::max();
    component.Bias = static_cast<double>(std::numeric_limits<Scalar>::lowest());
  }
  else if constexpr (!std::is_same_v<Scalar, float>)
  {
    const auto [low, high] = component.Range;
    component.Scale = high > low ? high - low : 1.0;
    component.Bias = low;
  }
}

template <typename Scalar>
TexelOf<Scalar> ToTexel(Scalar scalar, const Component& component)
{
  if constexpr (std::is_integral_v<TexelOf<Scalar>>)
  {
    return static_cast<TexelOf<Scalar>>(scalar - std::numeric_limits<Scalar>::lowest());
  }
  else if constexpr (std::is_same_v<Scalar, float>)
  {
    return scalar;
  }
  else
  {
    return static_cast<float>((static_cast<double>(scalar) - component.Bias) / component.Scale);
  }
}

/// One component of the texels of a row, and their mask. @a visible: nullptr: without a mask.
template <typename Scalar, typename Texel, typename Convert>
void EncodeRow(const Scalar* scalars, std::size_t components, const unsigned char* visible,
  std::size_t count, Texel* texels, const Convert& toTexel)
{
  // What OpenGL reads as 1.
  constexpr Texel one =
    std::is_floating_point_v<Texel> ? Texel{1} : std::numeric_limits<Texel>::max();
  const std::size_t channels = components + (visible != nullptr ? 1 : 0);
  for (std::size_t c = 0; c < components; ++c)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const Texel texel = toTexel(scalars[i * components + c], c);
      texels[i * channels + c] = visible == nullptr || visible[i] != 0 ? texel : Texel{0};
    }
  }
  for (std::size_t i = 0; visible != nullptr && i < count; ++i)
  {
    texels[i * channels + components] = visible[i] != 0 ? one : Texel{0};
  }
}

template <typename Scalar, typename Texel, typename Convert>
void EncodeRows(const vtkTextureSlice::Rows<Scalar>& rows, const Box& box, bool masked,
  Texel* texels, const Convert& toTexel)
{
  const auto count = static_cast<std::size_t>(box.End[0] - box.Begin[0]);
  std::vector<unsigned char> visible(masked ? count : 0);
  for (int z = box.Begin[2]; z < box.End[2]; ++z)
  {
    for (int y = box.Begin[1]; y < box.End[1]; ++y)
    {
      if (masked)
      {
        rows.MarkVisible(y, z, box.Begin[0], count, visible.data());
      }
      EncodeRow(rows.GetScalars(y, z, box.Begin[0]), rows.Components,
        masked ? visible.data() : nullptr, count, texels, toTexel);
      texels += count * (rows.Components + (masked ? 1 : 0));
    }
  }
}

} // namespace

void vtkTextureSliceBlocks::Build(const vtkTextureSliceScalars& source)
{
  this->Size = source.Size;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Count[axis] = (this->Size[axis] + Edge - 1) / Edge;
  }
  const vtkIdType rowsOfBlocks = static_cast<vtkIdType>(this->Count[1]) * this->Count[2];
  this->Checksums.assign(static_cast<std::size_t>(rowsOfBlocks * this->Count[0]), Seed);
  const auto sumUp = [&](const auto& rows)
  {
    vtkSMPTools::For(0, rowsOfBlocks,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
        {
          SumRowOfBlocks(rows,
            this->GetBox(0, this->Count[0] - 1, row % this->Count[1], row / this->Count[1]),
            this->Checksums.data() + std::ptrdiff_t{row} * this->Count[0]);
        }
      });
  };
  switch (source.Scalars->GetDataType())
  {
    vtkTemplateMacro(sumUp(vtkTextureSlice::Rows<VTK_TT>(source)));
  }
}

std::vector<Box> vtkTextureSliceBlocks::FindChanges(const vtkTextureSliceBlocks* other) const
{
  std::vector<Box> boxes;
  std::size_t row = 0; // the first block of a row of blocks
  for (int z = 0; z < this->Count[2]; ++z)
  {
    std::vector<Box> ofLayer;
    for (int y = 0; y < this->Count[1]; ++y, row += static_cast<std::size_t>(this->Count[0]))
    {
      int unchanged = -1; // the last block that is as in the other volume
      for (int x = 0; x <= this->Count[0]; ++x)
      {
        const std::size_t block = row + static_cast<std::size_t>(x);
        if (x < this->Count[0] &&
            (other == nullptr || this->Checksums[block] != other->Checksums[block]))
        {
          continue;
        }
        if (unchanged + 1 < x)
        {
          Add(this->GetBox(unchanged + 1, x - 1, y, z), ofLayer);
        }
        unchanged = x;
      }
    }
    boxes.insert(boxes.end(), ofLayer.begin(), ofLayer.end());
  }
  return boxes;
}

Box vtkTextureSliceBlocks::GetBox(int first, int last, int y, int z) const
{
  const auto end = [this](int block, std::size_t axis)
  { return std::min((block + 1) * Edge, this->Size[axis]); };
  return {{first * Edge, y * Edge, z * Edge}, {end(last, 0), end(y, 1), end(z, 2)}};
}

vtkTextureSliceTexels::vtkTextureSliceTexels(
  const vtkTextureSliceScalars& source, const vtkTextureSliceBricks& bricks)
  : SourceType(source.Scalars->GetDataType())
  , Size(source.Size)
  , Masked(std::find(bricks.Hides.begin(), bricks.Hides.end(), 1) != bricks.Hides.end())
  , Codes(source.Codes)
  , Components(static_cast<std::size_t>(source.Scalars->GetNumberOfComponents()))
{
  for (std::size_t c = 0; c < this->Components.size(); ++c)
  {
    vtkTextureSliceBricks::Range range;
    for (std::size_t i = c; i < bricks.Ranges.size(); i += this->Components.size())
    {
      range.Low = std::min(range.Low, bricks.Ranges[i].Low);
      range.High = std::max(range.High, bricks.Ranges[i].High);
    }
    Component& component = this->Components[c];
    component.Range =
      range.Low <= range.High ? std::array<double, 2>{range.Low, range.High} : component.Range;
    switch (this->Codes ? VTK_VOID : this->SourceType)
    {
      vtkTemplateMacro(SetScale<VTK_TT>(component); this->ScalarType = TypeOf<TexelOf<VTK_TT>>);
    default:
      break;
    }
  }
  if (this->AreCodeBytes())
  {
    this->ScalarType = VTK_UNSIGNED_CHAR;
    this->Components.front().Scale = std::numeric_limits<std::uint8_t>::max() * this->Codes->Step;
    this->Components.front().Bias = this->Codes->Base;
  }
}

bool vtkTextureSliceTexels::IsLike(const vtkTextureSliceTexels& other) const
{
  const auto sameScale = [](const Component& a, const Component& b)
  { return a.Scale == b.Scale && a.Bias == b.Bias; };
  return this->SourceType == other.SourceType && this->Size == other.Size &&
         this->Masked == other.Masked && this->Codes == other.Codes &&
         std::equal(this->Components.begin(), this->Components.end(), other.Components.begin(),
           other.Components.end(), sameScale);
}

std::size_t vtkTextureSliceTexels::CountBytes(const std::array<int, 3>& size) const
{
  const auto bytesOfTexel = static_cast<std::size_t>(
    vtkDataArray::GetDataTypeSize(this->ScalarType) * this->CountChannels());
  return std::accumulate(size.begin(), size.end(), bytesOfTexel,
    [](std::size_t product, int texels) { return product * static_cast<std::size_t>(texels); });
}

vtkTextureSliceChanges vtkTextureSliceTexels::Encode(
  const vtkTextureSliceScalars& source, std::vector<Box> boxes) const
{
  vtkTextureSliceChanges changes;
  std::size_t bytes = 0;
  for (const Box& box : boxes)
  {
    changes.Begins.push_back(bytes);
    bytes += this->CountBytes(
      {box.End[0] - box.Begin[0], box.End[1] - box.Begin[1], box.End[2] - box.Begin[2]});
  }
  changes.Boxes = std::move(boxes);
  changes.Bytes.reset(new unsigned char[bytes]);
  vtkSMPTools::For(0, static_cast<vtkIdType>(changes.Boxes.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        this->EncodeBox(source, changes.Boxes[i], changes.Bytes.get() + changes.Begins[i]);
      }
    });
  return changes;
}

void vtkTextureSliceTexels::EncodeBox(
  const vtkTextureSliceScalars& source, const Box& box, unsigned char* texels) const
{
  const auto encode = [&](const auto& rows, auto texel, const auto& toTexel)
  { EncodeRows(rows, box, this->Masked, reinterpret_cast<decltype(texel)*>(texels), toTexel); };
  if (this->AreCodeBytes())
  {
    encode(vtkTextureSlice::Rows<unsigned char>(source), std::uint8_t(),
      [this](unsigned char code, std::size_t) { return this->Codes->Bytes[code]; });
    return;
  }
  if (this->Codes)
  {
    encode(vtkTextureSlice::Rows<unsigned char>(source), float(),
      [this](unsigned char code, std::size_t)
      { return static_cast<float>(this->Codes->Values[code]); });
    return;
  }
  switch (this->SourceType)
  {
    vtkTemplateMacro(encode(vtkTextureSlice::Rows<VTK_TT>(source), TexelOf<VTK_TT>(),
      [this](VTK_TT scalar, std::size_t c) { return ToTexel(scalar, this->Components[c]); }));
  }
}
