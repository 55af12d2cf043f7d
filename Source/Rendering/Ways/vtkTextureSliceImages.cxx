// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceImages.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceOpenGL.h"

#include <algorithm>
#include <cmath>

namespace
{

vtkDataArray* Allocate(vtkImageData* image, const std::array<int, 2>& size, int type, int count)
{
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(type, count);
  return image->GetPointData()->GetScalars();
}

/// The depth in the window, 0 to 1, of a place as texture coordinates.
double FindDepth(const vtkTextureSliceFrame& frame, const float* place)
{
  const std::array<double, 16>& toClip = frame.GetView().BoxToClip;
  double z = toClip[11];
  double w = toClip[15];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto box = static_cast<double>(
      (place[axis] - frame.GetTextureBias()[axis]) / frame.GetTextureScale()[axis]);
    z += toClip[8 + axis] * box;
    w += toClip[12 + axis] * box;
  }
  return std::clamp(0.5 * z / w + 0.5, 0.0, 1.0);
}

} // namespace

std::vector<float> vtkTextureSliceImages::Download(vtkTextureObject* picture)
{
  std::vector<float> pixels(std::size_t{4} * picture->GetWidth() * picture->GetHeight());
  picture->Activate();
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, pixels.data());
  picture->Deactivate();
  return pixels;
}

void vtkTextureSliceImages::Fill(const std::array<int, 2>& size, int depthType,
  const std::vector<float>& colors, const std::vector<float>& places,
  const vtkTextureSliceFrame& frame, bool clamps)
{
  vtkDataArray* bytes = Allocate(this->Color, size, VTK_UNSIGNED_CHAR, 4);
  vtkDataArray* depths = Allocate(this->Depth, size, depthType, 1);
  const bool rounds = depthType != VTK_FLOAT;
  const double farthest = rounds ? depths->GetDataTypeMax() : 1.0;
  for (vtkIdType pixel = 0; pixel < bytes->GetNumberOfTuples(); ++pixel)
  {
    const float* color = colors.data() + 4 * pixel;
    const float* place = places.data() + 4 * pixel;
    const bool meetsVolume = place[3] > 0.0f;
    for (int i = 0; i < 4; ++i)
    {
      const float value = meetsVolume ? std::clamp(color[i], 0.0f, 1.0f) : (i < 3 ? 1.0f : 0.0f);
      bytes->SetComponent(pixel, i, std::round(255.0f * value));
    }
    const bool hasDepth = place[3] == 1.0f || (clamps && meetsVolume);
    const double depth = farthest * (hasDepth ? FindDepth(frame, place) : 1.0);
    depths->SetComponent(pixel, 0, rounds ? std::round(depth) : depth);
  }
}
