// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceChecksums.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkTextureSliceChecksums);
vtkInformationKeyMacro(vtkTextureSliceChecksums, PREPARED, ObjectBase);

namespace
{

/// Hidden scalars that are finite count, unlike in the ranges of the bricks. The values of hidden
/// codes are added later (vtkTextureSliceTexels).
std::vector<std::array<double, 2>> FindRanges(
  const vtkTextureSliceScalars& source, const vtkTextureSliceBricks& bricks)
{
  const auto components = static_cast<std::size_t>(source.Scalars->GetNumberOfComponents());
  std::vector<vtkTextureSliceBricks::Range> ofBricks(components);
  for (std::size_t i = 0; i < bricks.GetRanges().size(); ++i)
  {
    vtkTextureSliceBricks::Range& range = ofBricks[i % components];
    range = {std::min(range.Low, bricks.GetRanges()[i].Low),
      std::max(range.High, bricks.GetRanges()[i].High)};
  }
  std::vector<std::array<double, 2>> ranges;
  for (std::size_t c = 0; c < components; ++c)
  {
    ranges.push_back({ofBricks[c].Low, ofBricks[c].High});
    if (source.Ghosts != nullptr && !source.Codes)
    {
      // Several times as long as a look at all bricks.
      source.Scalars->GetFiniteRange(ranges.back().data(), static_cast<int>(c));
    }
  }
  return ranges;
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
  this->Bricks.Build(source);
  this->Texels = {source, FindRanges(source, this->Bricks), this->Bricks.HasInvisible()};
  this->Blocks.Build(source);
}

vtkSmartPointer<vtkTextureSliceChecksums> vtkTextureSliceChecksums::Prepare(
  const vtkTextureSliceScalars& source, const vtkTextureSliceChecksums* before)
{
  auto checksum = vtkSmartPointer<vtkTextureSliceChecksums>::New();
  checksum->Build(source);
  if (before != nullptr)
  {
    checksum->Prepared = checksum->TakeChanges(source, before);
    checksum->PreparedOver = before->Made;
  }
  source.Scalars->GetInformation()->Set(PREPARED(), checksum);
  return checksum;
}

vtkSmartPointer<vtkTextureSliceChecksums> vtkTextureSliceChecksums::Get(
  const vtkTextureSliceScalars& source)
{
  vtkSmartPointer<vtkTextureSliceChecksums> checksum =
    vtkTextureSliceChecksums::SafeDownCast(source.Scalars->GetInformation()->Get(PREPARED()));
  if (checksum == nullptr || checksum->Made != MakeKey(source))
  {
    checksum = vtkSmartPointer<vtkTextureSliceChecksums>::New();
    checksum->Build(source);
  }
  return checksum;
}

vtkTextureSliceChanges vtkTextureSliceChecksums::TakeChanges(
  const vtkTextureSliceScalars& source, const vtkTextureSliceChecksums* before)
{
  auto prepared = std::exchange(this->Prepared, std::nullopt);
  if (prepared && before != nullptr && before->Made == this->PreparedOver)
  {
    return std::move(*prepared);
  }
  const bool comparable = before != nullptr && this->Texels.IsLike(before->Texels);
  return this->Texels.Encode(
    source, this->Blocks.FindChanges(comparable ? &before->Blocks : nullptr));
}
