// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceChanges.h"

#include "vtkSMPTools.h"

void vtkTextureSliceChanges::Build(const vtkTextureSliceScalars& source,
  const vtkTextureSliceTexels& texels, const std::vector<Box>& boxes)
{
  this->Boxes = boxes;
  this->Begins.clear();
  std::size_t bytes = 0;
  for (const Box& box : boxes)
  {
    this->Begins.push_back(bytes);
    bytes += texels.CountBytes(box);
  }
  this->Data.reset(new unsigned char[bytes]);
  vtkSMPTools::For(0, static_cast<vtkIdType>(boxes.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        texels.Encode(source, this->Boxes[i], this->Data.get() + this->Begins[i]);
      }
    });
}

void vtkTextureSliceChanges::ForEach(
  const std::function<void(const Box& box, const unsigned char* texels)>& take) const
{
  for (std::size_t i = 0; i < this->Boxes.size(); ++i)
  {
    take(this->Boxes[i], this->Data.get() + this->Begins[i]);
  }
}
