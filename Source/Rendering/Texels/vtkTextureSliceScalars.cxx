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

vtkTextureSliceScalars vtkTextureSliceScalars::Find(
  vtkImageData* image, vtkDataArray* scalars, bool cellData)
{
  vtkTextureSliceScalars found;
  found.Scalars = scalars;
  found.Size = GetSize(image, cellData);
  found.CellData = cellData;
  found.Codes = vtkTextureSliceCodes::Find(image, scalars);
  vtkDataSetAttributes* attributes =
    cellData ? static_cast<vtkDataSetAttributes*>(image->GetCellData()) : image->GetPointData();
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const vtkIdType texels = cellData ? image->GetNumberOfCells() : image->GetNumberOfPoints();
  found.Ghosts = ghosts != nullptr && ghosts->GetNumberOfTuples() == texels ? ghosts : nullptr;
  return found;
}
