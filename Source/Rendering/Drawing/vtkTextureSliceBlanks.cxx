// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceBlanks.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkUnsignedCharArray.h"

namespace
{

/// nullptr where no flag hides anything.
vtkUnsignedCharArray* FindFlags(vtkImageData* image, bool ofCells)
{
  vtkDataSetAttributes* attributes =
    ofCells ? static_cast<vtkDataSetAttributes*>(image->GetCellData()) : image->GetPointData();
  const vtkIdType count = ofCells ? image->GetNumberOfCells() : image->GetNumberOfPoints();
  auto* flags = vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return flags != nullptr && flags->GetNumberOfTuples() == count && flags->GetRange()[1] > 0.0
           ? flags
           : nullptr;
}

} // namespace

bool vtkTextureSliceBlanks::Update(
  vtkOpenGLRenderWindow* window, vtkImageData* image, bool cellData, std::string& error)
{
  vtkUnsignedCharArray* flags = FindFlags(image, !cellData);
  this->Used = flags != nullptr;
  if (!this->Used)
  {
    return true;
  }
  const auto size = vtkTextureSliceScalars::GetSize(image, !cellData);
  const auto texels = vtkTextureSliceScalars::GetSize(image, cellData);
  this->Flags->SetDimensions(size.data());
  if (!this->Texture.Update(window, this->Flags, flags, false, error))
  {
    return false;
  }
  this->Texture.SetNearest(true);
  // Scalars of points: half a texel before the first cell. Scalars of cells: half a point after.
  const float offset = cellData ? 0.5f : -0.5f;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Scale[axis] = static_cast<float>(texels[axis]) / static_cast<float>(size[axis]);
    this->Bias[axis] = offset / static_cast<float>(size[axis]);
  }
  return true;
}

void vtkTextureSliceBlanks::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniform3f("blankScale", this->Scale.data());
  program->SetUniform3f("blankBias", this->Bias.data());
}
