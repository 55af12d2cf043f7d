// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceScalars.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

std::array<int, 3> vtkTextureSliceScalars::GetSize(vtkImageData* image, bool cellData)
{
  std::array<int, 3> size;
  image->GetDimensions(size.data());
  for (int& texels : size)
  {
    texels -= cellData ? 1 : 0;
  }
  return size;
}

vtkUnsignedCharArray* vtkTextureSliceScalars::FindGhosts(vtkImageData* image, bool ofCells)
{
  vtkDataSetAttributes* attributes =
    ofCells ? static_cast<vtkDataSetAttributes*>(image->GetCellData()) : image->GetPointData();
  const vtkIdType count = ofCells ? image->GetNumberOfCells() : image->GetNumberOfPoints();
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return ghosts != nullptr && ghosts->GetNumberOfTuples() == count ? ghosts : nullptr;
}

vtkTextureSliceScalars vtkTextureSliceScalars::Find(
  vtkImageData* image, vtkDataArray* scalars, bool cellData)
{
  return {scalars, GetSize(image, cellData), cellData, FindGhosts(image, cellData),
    vtkTextureSliceCodes::Find(image, scalars)};
}
