// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceChecksums.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"
#include "vtkUnsignedCharArray.h"

#include <utility>

vtkStandardNewMacro(vtkTextureSliceChecksums);
vtkInformationKeyMacro(vtkTextureSliceChecksums, PREPARED, ObjectBase);

vtkTextureSliceChecksums::Key vtkTextureSliceChecksums::MakeKey(
  const vtkTextureSliceScalars& source)
{
  return {source.Scalars, source.Scalars->GetMTime(), source.Ghosts,
    source.Ghosts != nullptr ? source.Ghosts->GetMTime() : 0, source.Size, source.CellData,
    source.Codes, source.Places};
}

void vtkTextureSliceChecksums::Build(const vtkTextureSliceScalars& source)
{
  this->Made = MakeKey(source);
  this->Bricks.Build(source);
  this->Texels = {source, this->Bricks};
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
    checksum->Prepared = checksum->TakeChanges(source, before);
    checksum->PreparedOver = before->Made;
  }
  information->Set(PREPARED(), checksum);
  return checksum;
}

vtkSmartPointer<vtkTextureSliceChecksums> vtkTextureSliceChecksums::Get(
  const vtkTextureSliceScalars& source)
{
  vtkSmartPointer<vtkTextureSliceChecksums> checksum;
  if (source.Scalars->HasInformation())
  {
    checksum =
      vtkTextureSliceChecksums::SafeDownCast(source.Scalars->GetInformation()->Get(PREPARED()));
  }
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
