// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/GroundPicture.h"

#include "Scene/Map/PlacedMap.h"
#include "nexrad/Geometry/Angles.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkTexture.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace nexrad::scene
{
namespace
{

// The cells of a picture whose middles lie in a ring.
class RingPainter
{
public:
  RingPainter(std::vector<std::uint8_t>& theCells, int theColumns, int theRows)
    : cells(theCells)
    , columns(theColumns)
    , rows(theRows)
    , crossings(static_cast<std::size_t>(theRows))
  {
  }

  // The ring's points are in cells from the corner of the picture.
  void Paint(const GroundLine& ring, std::uint8_t value)
  {
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      this->Cross(ring[i], ring[(i + 1) % ring.size()]);
    }
    for (int row = 0; row < rows; ++row)
    {
      this->Fill(row, value);
    }
  }

private:
  int FirstMiddle(double place, int count) const
  {
    return static_cast<int>(std::ceil(std::clamp(place - 0.5, 0.0, static_cast<double>(count))));
  }

  void Cross(const std::array<double, 2>& from, const std::array<double, 2>& to)
  {
    const auto [low, high] = std::minmax(from[1], to[1]);
    for (int row = this->FirstMiddle(low, rows); row < this->FirstMiddle(high, rows); ++row)
    {
      const double share = (row + 0.5 - from[1]) / (to[1] - from[1]);
      crossings[static_cast<std::size_t>(row)].push_back(from[0] + share * (to[0] - from[0]));
    }
  }

  void Fill(int row, std::uint8_t value)
  {
    auto& places = crossings[static_cast<std::size_t>(row)];
    std::sort(places.begin(), places.end());
    const auto first = cells.begin() + static_cast<std::ptrdiff_t>(row) * columns;
    for (std::size_t i = 0; i + 1 < places.size(); i += 2)
    {
      std::fill(first + this->FirstMiddle(places[i], columns),
        first + this->FirstMiddle(places[i + 1], columns), value);
    }
    places.clear();
  }

  std::vector<std::uint8_t>& cells;
  int columns;
  int rows;
  std::vector<std::vector<double>> crossings; ///< of each row
};

bool Touches(const MapPolyline& area, const GeographicBounds& reach)
{
  GeographicBounds box{1e9, 1e9, -1e9, -1e9};
  for (const auto& [longitude, latitude] : area.points)
  {
    box = {std::min(box.west, longitude), std::min(box.south, latitude),
      std::max(box.east, longitude), std::max(box.north, latitude)};
  }
  return box.west <= reach.east && box.east >= reach.west && box.south <= reach.north &&
         box.north >= reach.south;
}

} // namespace

std::vector<std::uint8_t> PaintLand(
  const SceneFrame& frame, const std::vector<MapPolyline>& areas, int columns, int rows)
{
  std::vector<std::uint8_t> land(static_cast<std::size_t>(columns) * rows, 0);
  RingPainter painter(land, columns, rows);
  const auto& box = frame.Bounds();
  const GeographicBounds reach = ReachOf(frame);
  for (const MapPolyline& area : areas)
  {
    if (!Touches(area, reach))
    {
      continue;
    }
    GroundLine ring;
    for (const auto& [longitude, latitude] : area.points)
    {
      const auto place = frame.Place(longitude, latitude);
      ring.push_back({columns * (place[0] - box[0]) / (box[1] - box[0]),
        rows * (place[1] - box[2]) / (box[3] - box[2])});
    }
    painter.Paint(ring, area.kind);
  }
  return land;
}

namespace
{

constexpr double stretch = 15.0; // of heights
constexpr double gain = 3.0;     // of the change in brightness, before it is compressed

// Rise a length towards the east and the north.
struct Slope
{
  double east;
  double north;
};

// Between the neighbours on both sides; at the edge, between the cell and its neighbour.
Slope SlopeAt(const HeightGrid& ground, int column, int row)
{
  const auto at = [&](int i, int j)
  { return ground.heights[static_cast<std::size_t>(j) * ground.columns + i]; };
  const int west = std::max(column - 1, 0);
  const int east = std::min(column + 1, ground.columns - 1);
  const int south = std::max(row - 1, 0);
  const int north = std::min(row + 1, ground.rows - 1);
  const double metres = 1000.0;
  return {(at(east, row) - at(west, row)) / (metres * ground.cellWidth * std::max(east - west, 1)),
    (at(column, north) - at(column, south)) /
      (metres * ground.cellHeight * std::max(north - south, 1))};
}

// The ground under a domain. Cells without elevations have 0 m.
HeightGrid MakeHeightGrid(
  const SceneFrame& frame, const Elevations& elevations, int columns, int rows)
{
  const auto& box = frame.Bounds();
  HeightGrid ground{columns, rows, (box[1] - box[0]) / columns, (box[3] - box[2]) / rows, {}};
  ground.heights.resize(static_cast<std::size_t>(columns) * rows);
  vtkSMPTools::For(0, rows,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType row = first; row < last; ++row)
      {
        for (int column = 0; column < columns; ++column)
        {
          const auto [longitude, latitude] =
            frame.Geographic(box[0] + (column + 0.5) * ground.cellWidth,
              box[2] + (static_cast<double>(row) + 0.5) * ground.cellHeight);
          ground.heights[static_cast<std::size_t>(row) * columns + column] =
            elevations.At(longitude, latitude).value_or(0.0);
        }
      }
    });
  return ground;
}

} // namespace

std::vector<float> ShadeRelief(const HeightGrid& ground, const LightDirection& light)
{
  const double azimuth = light.azimuth * RadiansPerDegree;
  const double elevation = light.elevation * RadiansPerDegree;
  const std::array<double, 3> towards = {std::sin(azimuth) * std::cos(elevation),
    std::cos(azimuth) * std::cos(elevation), std::sin(elevation)};
  std::vector<float> shades;
  shades.reserve(ground.heights.size());
  for (int row = 0; row < ground.rows; ++row)
  {
    for (int column = 0; column < ground.columns; ++column)
    {
      const Slope slope = SlopeAt(ground, column, row);
      const double east = stretch * slope.east;
      const double north = stretch * slope.north;
      const double lit = (towards[2] - east * towards[0] - north * towards[1]) /
                         std::sqrt(1.0 + east * east + north * north);
      shades.push_back(static_cast<float>(std::tanh(gain * (lit - towards[2]))));
    }
  }
  return shades;
}

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
    *texel++ = ToByte(std::min(part * brightness, 1.0));
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

// Where a cell of a picture lies among coarser cells: those on both sides of its middle.
struct CellPlace
{
  int before = 0;
  int after = 0;
  float share = 0.0F; // of the later one
};

// The places of all cells along an axis. `part`: of the length of the coarser cells, that which the
// cells take.
std::vector<CellPlace> PlacesAmong(int cells, int coarser, double part = 1.0)
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

// A value of row-by-row cells, `columns` in a row, at a place.
float ValueAt(const std::vector<float>& values, int columns, const CellPlace& x, const CellPlace& y)
{
  const float* below = values.data() + static_cast<std::size_t>(y.before) * columns;
  const float* above = values.data() + static_cast<std::size_t>(y.after) * columns;
  return Between(Between(below[x.before], below[x.after], x.share),
    Between(above[x.before], above[x.after], x.share), y.share);
}

} // namespace

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
