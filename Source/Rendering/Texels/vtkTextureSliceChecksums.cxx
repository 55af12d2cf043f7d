// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceChecksums.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"
#include "vtkTextureSliceRows.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

vtkStandardNewMacro(vtkTextureSliceChecksums);
vtkInformationKeyMacro(vtkTextureSliceChecksums, PREPARED, ObjectBase);

namespace
{

using Range = vtkTextureSliceBricks::Range;

/// What is found of the texels of one or more layers.
struct Findings
{
  std::vector<Range> Ranges;
  bool Invisible = false;

  void Add(const Findings& other)
  {
    for (std::size_t c = 0; c < this->Ranges.size(); ++c)
    {
      this->Ranges[c].Low = std::min(this->Ranges[c].Low, other.Ranges[c].Low);
      this->Ranges[c].High = std::max(this->Ranges[c].High, other.Ranges[c].High);
    }
    this->Invisible = this->Invisible || other.Invisible;
  }
};

/// @param ranges whether to find the ranges too
template <typename Scalar>
Findings LookAtLayer(const vtkTextureSlice::Rows<Scalar>& rows, int height, int z, bool ranges)
{
  vtkTextureSlice::ColumnExtremes<Scalar> extremes(rows.Length, rows.Components);
  std::vector<unsigned char> marks(rows.Length);
  Findings found{std::vector<Range>(rows.Components)};
  for (int y = 0; y < height; ++y)
  {
    if (ranges)
    {
      rows.MarkFinite(y, z, 0, rows.Length, marks.data());
      extremes.Extend(rows.GetScalars(y, z), marks.data());
    }
    if (!found.Invisible)
    {
      rows.MarkVisible(y, z, 0, rows.Length, marks.data());
      found.Invisible = std::memchr(marks.data(), 0, marks.size()) != nullptr;
    }
  }
  for (std::size_t c = 0; c < rows.Components; ++c)
  {
    extremes.ExtendRange(0, rows.Length, c, found.Ranges[c]);
  }
  return found;
}

} // namespace

vtkTextureSliceChecksums::Key vtkTextureSliceChecksums::MakeKey(
  const vtkTextureSliceScalars& source)
{
  return {source.Scalars, source.Scalars->GetMTime(), source.Ghosts,
    source.Ghosts != nullptr ? source.Ghosts->GetMTime() : 0, source.Size, source.CellData,
    source.Codes};
}

void vtkTextureSliceChecksums::Build(const vtkTextureSliceScalars& source)
{
  this->Made = MakeKey(source);
  const auto components = static_cast<std::size_t>(source.Scalars->GetNumberOfComponents());
  Findings all{std::vector<Range>(components)};
  // Hidden scalars that are finite count for the ranges, but not for those of the bricks. The
  // values of hidden codes are added later (vtkTextureSliceTexels).
  const bool fromBricks = source.Codes && source.Ghosts == nullptr;
  const auto look = [&](const auto& rows)
  {
    std::vector<Findings> layers(static_cast<std::size_t>(source.Size[2]));
    vtkSMPTools::For(0, source.Size[2],
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType z = begin; z < end; ++z)
        {
          layers[static_cast<std::size_t>(z)] =
            LookAtLayer(rows, source.Size[1], static_cast<int>(z), !fromBricks);
        }
      });
    for (const Findings& layer : layers)
    {
      all.Add(layer);
    }
  };
  switch (source.Scalars->GetDataType())
  {
    vtkTemplateMacro(look(vtkTextureSlice::Rows<VTK_TT>(source)));
  }
  this->Bricks.Build(source);
  if (fromBricks)
  {
    Range& range = all.Ranges.front();
    for (const Range& brick : this->Bricks.GetRanges())
    {
      range = {std::min(range.Low, brick.Low), std::max(range.High, brick.High)};
    }
  }
  else if (source.Codes)
  {
    vtkTextureSlice::ToValues(*source.Codes, all.Ranges);
  }
  this->Texels = {source, all.Ranges, all.Invisible};
  this->Blocks.Build(source);
}

vtkSmartPointer<vtkTextureSliceChecksums> vtkTextureSliceChecksums::Prepare(
  const vtkTextureSliceScalars& source, const vtkTextureSliceChecksums* before)
{
  // The array makes its information when it is first asked, and counts as changed by that.
  vtkInformation* information = source.Scalars->GetInformation();
  auto checksum = vtkSmartPointer<vtkTextureSliceChecksums>::New();
  checksum->Build(source);
  if (before != nullptr)
  {
    checksum->PreparedOver = before->Made;
    checksum->Prepared = checksum->MakeChanges(source, before);
  }
  information->Set(PREPARED(), checksum);
  return checksum;
}

vtkSmartPointer<vtkTextureSliceChecksums> vtkTextureSliceChecksums::Find(
  const vtkTextureSliceScalars& source)
{
  if (!source.Scalars->HasInformation())
  {
    return nullptr;
  }
  auto* prepared =
    vtkTextureSliceChecksums::SafeDownCast(source.Scalars->GetInformation()->Get(PREPARED()));
  return prepared != nullptr && prepared->Made == MakeKey(source) ? prepared : nullptr;
}

vtkSmartPointer<vtkTextureSliceChecksums> vtkTextureSliceChecksums::Get(
  const vtkTextureSliceScalars& source)
{
  auto checksum = Find(source);
  if (checksum == nullptr)
  {
    checksum = vtkSmartPointer<vtkTextureSliceChecksums>::New();
    checksum->Build(source);
  }
  return checksum;
}

vtkTextureSliceChanges vtkTextureSliceChecksums::MakeChanges(
  const vtkTextureSliceScalars& source, const vtkTextureSliceChecksums* before) const
{
  const bool comparable = before != nullptr && this->Texels.IsLike(before->Texels);
  vtkTextureSliceChanges changes;
  changes.Build(
    source, this->Texels, this->Blocks.FindChanges(comparable ? &before->Blocks : nullptr));
  return changes;
}

vtkTextureSliceChanges vtkTextureSliceChecksums::TakeChanges(
  const vtkTextureSliceScalars& source, const vtkTextureSliceChecksums* before)
{
  auto prepared = std::exchange(this->Prepared, std::nullopt);
  if (prepared && before != nullptr && before->Made == this->PreparedOver)
  {
    return std::move(*prepared);
  }
  return this->MakeChanges(source, before);
}
