// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceBlanks.h"

#include "vtkImageData.h"
#include "vtkShaderProgram.h"
#include "vtkUnsignedCharArray.h"

bool vtkTextureSliceBlanks::Update(
  vtkOpenGLRenderWindow* window, vtkImageData* image, bool cellData, std::string& error)
{
  vtkUnsignedCharArray* flags = vtkTextureSliceScalars::FindGhosts(image, !cellData);
  this->Used = flags != nullptr && flags->GetRange()[1] > 0.0;
  if (!this->Used)
  {
    return true;
  }
  const auto size = vtkTextureSliceScalars::GetSize(image, !cellData);
  const auto texels = vtkTextureSliceScalars::GetSize(image, cellData);
  // Scalars of points: half a texel before the first cell. Scalars of cells: half a point after.
  const float offset = cellData ? 0.5f : -0.5f;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Scale[axis] = static_cast<float>(texels[axis]) / static_cast<float>(size[axis]);
    this->Bias[axis] = offset / static_cast<float>(size[axis]);
  }
  return this->Texture.Update(window, {flags, size}, true, error);
}

void vtkTextureSliceBlanks::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniform3f("blankScale", this->Scale.data());
  program->SetUniform3f("blankBias", this->Bias.data());
}
