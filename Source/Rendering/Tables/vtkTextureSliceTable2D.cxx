// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTable2D.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkTextureSliceOpenGL.h"

#include <algorithm>

namespace
{

/// Four floats a point, in one plane.
bool IsTable(vtkImageData* image)
{
  vtkDataArray* scalars = image != nullptr ? image->GetPointData()->GetScalars() : nullptr;
  return scalars != nullptr && scalars->GetDataType() == VTK_FLOAT &&
         scalars->GetNumberOfComponents() == 4 && image->GetDimensions()[2] == 1;
}

bool HaveOneSize(const std::vector<vtkImageData*>& images, int limit)
{
  const int* size = images.front()->GetDimensions();
  const int height = size[1] * static_cast<int>(images.size());
  return size[0] <= limit && height <= limit &&
         std::all_of(images.begin(), images.end(),
           [size](vtkImageData* image) {
             return image->GetDimensions()[0] == size[0] && image->GetDimensions()[1] == size[1];
           });
}

} // namespace

bool vtkTextureSliceTable2D::Update(vtkOpenGLRenderWindow* window,
  const std::vector<vtkImageData*>& images, bool nearest, std::string& error)
{
  if (!std::all_of(images.begin(), images.end(), IsTable))
  {
    error = "a two-dimensional transfer function must be a 2-D image of four floats: see "
            "vtkVolumeProperty::SetTransferFunction2D";
    return false;
  }
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  if (!HaveOneSize(images, limit))
  {
    error =
      "the two-dimensional transfer functions of all components must have one size, at most " +
      std::to_string(limit) + " wide and together as high";
    return false;
  }
  std::vector<std::pair<const void*, vtkMTimeType>> key;
  for (vtkImageData* image : images)
  {
    key.emplace_back(image, image->GetMTime());
  }
  const bool current = this->Texture->GetHandle() != 0 && this->Texture->GetContext() == window;
  this->Texture->SetContext(window);
  if ((!current || key != this->Last) && !this->Upload(images))
  {
    error = "OpenGL could not make a texture of the two-dimensional transfer functions";
    return false;
  }
  this->Last = key;
  vtkTextureSliceSetSampling(this->Texture, nearest);
  return true;
}

bool vtkTextureSliceTable2D::Upload(const std::vector<vtkImageData*>& images)
{
  const int* size = images.front()->GetDimensions();
  std::vector<float> entries;
  for (vtkImageData* image : images)
  {
    const auto* first = static_cast<const float*>(image->GetScalarPointer());
    entries.insert(entries.end(), first, first + 4 * image->GetNumberOfPoints());
  }
  this->Rows = size[1];
  this->Width = size[0];
  this->IndexOpacities(entries, images.size());
  return this->Texture->Create2DFromRaw(static_cast<unsigned int>(size[0]),
    static_cast<unsigned int>(size[1]) * static_cast<unsigned int>(images.size()), 4, VTK_FLOAT,
    entries.data());
}

void vtkTextureSliceTable2D::IndexOpacities(const std::vector<float>& entries, std::size_t images)
{
  const auto width = static_cast<std::size_t>(this->Width);
  this->Visibilities.clear();
  for (std::size_t image = 0; image < images; ++image)
  {
    std::vector<float> most(width, 0.0f);
    const float* alpha = entries.data() + image * width * static_cast<std::size_t>(this->Rows) * 4;
    for (std::size_t i = 0; i < width * static_cast<std::size_t>(this->Rows); ++i)
    {
      most[i % width] = std::max(most[i % width], alpha[4 * i + 3]);
    }
    this->Visibilities.emplace_back(most);
  }
  this->FillTime.Modified();
}
