// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/GroundPicture.h"

#include "Scene/Map/Elevations.h"
#include "Scene/Map/MapAreas.h"
#include "Scene/Map/Relief.h"

#include <vtkImageData.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace nexrad::scene
{
namespace
{

constexpr int texelsPerShade = 4; // the elevations are much coarser than coasts

vtkSmartPointer<vtkImageData> MakePicture(int columns, int rows)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(columns, rows, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  return picture;
}

void Paint(unsigned char*& texel, const Colour& colour, double brightness)
{
  for (const double part : colour)
  {
    *texel++ = static_cast<unsigned char>(std::lround(255.0 * std::min(part * brightness, 1.0)));
  }
}

vtkSmartPointer<vtkImageData> MakePlainPicture(const Colour& colour)
{
  constexpr int side = 2;
  auto picture = MakePicture(side, side);
  auto* texel = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (int i = 0; i < side * side; ++i)
  {
    Paint(texel, colour, 1.0);
  }
  return picture;
}

// Texels of a side in steps of texelsPerShade.
int TexelsOf(double length, double longest, int longSide)
{
  const double shades = longSide / texelsPerShade * length / longest;
  return texelsPerShade * std::max(1, static_cast<int>(std::lround(shades)));
}

float Between(float from, float to, float share)
{
  return from + share * (to - from);
}

} // namespace

std::vector<CellPlace> PlacesAmong(int cells, int coarser, double part)
{
  std::vector<CellPlace> places;
  for (int cell = 0; cell < cells; ++cell)
  {
    const double place =
      std::clamp((cell + 0.5) / cells * part * coarser - 0.5, 0.0, coarser - 1.0);
    const int before = static_cast<int>(place);
    places.push_back(
      {before, std::min(before + 1, coarser - 1), static_cast<float>(place - before)});
  }
  return places;
}

float ValueAt(const std::vector<float>& values, int columns, const CellPlace& x, const CellPlace& y)
{
  const float* below = values.data() + static_cast<std::size_t>(y.before) * columns;
  const float* above = values.data() + static_cast<std::size_t>(y.after) * columns;
  return Between(Between(below[x.before], below[x.after], x.share),
    Between(above[x.before], above[x.after], x.share), y.share);
}

vtkSmartPointer<vtkImageData> MakeGroundPicture(
  const SceneFrame& frame, const Theme& theme, int longSide)
{
  const auto& box = frame.Bounds();
  const Elevations& elevations = EmbeddedElevations();
  const std::array<double, 2> middle = {0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3])};
  const auto [longitude, latitude] =
    frame.HasMap() ? frame.Geographic(middle[0], middle[1]) : std::array<double, 2>{0.0, 90.0};
  if (!frame.HasMap() || !elevations.At(longitude, latitude))
  {
    return MakePlainPicture(theme.ground);
  }
  const double longest = std::max(box[1] - box[0], box[3] - box[2]);
  const int columns = TexelsOf(box[1] - box[0], longest, longSide);
  const int rows = TexelsOf(box[3] - box[2], longest, longSide);
  const std::vector<std::uint8_t> land = PaintLand(frame, EmbeddedMapAreas(), columns, rows);
  const HeightGrid ground =
    MakeHeightGrid(frame, elevations, columns / texelsPerShade, rows / texelsPerShade);
  const std::vector<float> shades = ShadeRelief(ground, LightDirection());
  const std::vector<CellPlace> acrossX = PlacesAmong(columns, ground.columns);
  const std::vector<CellPlace> acrossY = PlacesAmong(rows, ground.rows);
  auto picture = MakePicture(columns, rows);
  auto* texel = static_cast<unsigned char*>(picture->GetScalarPointer());
  auto onLand = land.begin();
  for (const CellPlace& y : acrossY)
  {
    for (const CellPlace& x : acrossX)
    {
      *onLand++ != 0
        ? Paint(texel, theme.ground,
            1.0 + theme.relief * static_cast<double>(ValueAt(shades, ground.columns, x, y)))
        : Paint(texel, theme.water, 1.0);
    }
  }
  return picture;
}

} // namespace nexrad::scene
