// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/GroundShadow.h"

#include "Scene/Map/GroundPicture.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkTexture.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nexrad::scene
{
namespace
{

// What the texels of the light volume's lowest layer leave of the ground's brightness, 0…1.
std::vector<float> BrightnessOf(vtkImageData* light, const LightOptions& options)
{
  vtkDataArray* arriving = light->GetPointData()->GetScalars();
  const int* size = light->GetDimensions();
  std::vector<float> brightness(static_cast<std::size_t>(size[0]) * size[1]);
  for (std::size_t i = 0; i < brightness.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    // The light of the volume comes farther into cores than to the ground.
    const double share = arriving->GetComponent(id, 0);
    const double ofLight = 1.0 - options.shadow * (1.0 - share * share);
    const double ofSky = 1.0 - options.occlusion * (1.0 - arriving->GetComponent(id, 1));
    brightness[i] = static_cast<float>(ofLight * ofSky);
  }
  return brightness;
}

// The cell of a picture of `from` cells in place of one of `to` cells.
std::size_t SameCell(int cell, int to, int from)
{
  return static_cast<std::size_t>(cell) * static_cast<std::size_t>(from) /
         static_cast<std::size_t>(to);
}

} // namespace

GroundShadow::GroundShadow()
{
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->EdgeClampOn();
}

GroundShadow::~GroundShadow() = default;

void GroundShadow::Show(vtkActor* ground, vtkImageData* light, const LightOptions& options,
  vtkImageData* volume, bool keeps)
{
  const bool newGround = ground->GetTexture() != texture && ground->GetTexture() != lit;
  if (newGround)
  {
    lit = ground->GetTexture();
  }
  if (light == nullptr)
  {
    ground->SetTexture(lit);
    return;
  }
  const bool changed =
    light->GetMTime() != made || options.shadow != shadow || options.occlusion != occlusion;
  if (newGround || (changed && !keeps))
  {
    this->Fill(light, options, volume);
    made = light->GetMTime();
    shadow = options.shadow;
    occlusion = options.occlusion;
  }
  ground->SetTexture(texture);
}

void GroundShadow::Fill(vtkImageData* light, const LightOptions& options, vtkImageData* volume)
{
  vtkImageData* picture = lit->GetInput();
  const int* colours = picture->GetDimensions();
  const int* texels = light->GetDimensions();
  std::array<int, 2> size{};
  std::array<std::vector<CellPlace>, 2> places;
  for (int axis = 0; axis < 2; ++axis)
  {
    size[axis] = std::max(colours[axis], texels[axis]);
    const double part = volume->GetDimensions()[axis] * volume->GetSpacing()[axis] /
                        (texels[axis] * light->GetSpacing()[axis]);
    places[axis] = PlacesAmong(size[axis], texels[axis], part);
  }
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const std::vector<float> brightness = BrightnessOf(light, options);
  const auto* from = static_cast<const unsigned char*>(picture->GetScalarPointer());
  auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int row = 0; row < size[1]; ++row)
  {
    const unsigned char* line = from + 3 * SameCell(row, size[1], colours[1]) * colours[0];
    for (int column = 0; column < size[0]; ++column)
    {
      const float left = ValueAt(brightness, texels[0], places[0][column], places[1][row]);
      const unsigned char* colour = line + 3 * SameCell(column, size[0], colours[0]);
      for (int channel = 0; channel < 3; ++channel)
      {
        *texel++ = static_cast<unsigned char>(colour[channel] * left + 0.5F);
      }
    }
  }
  image->Modified();
}

} // namespace nexrad::scene
