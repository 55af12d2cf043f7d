// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Shapes/Letters.h"

#include "Scene/Shapes/Embedded.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkTexture.h>
#include <vtkTexturedActor2D.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace nexrad::scene
{
namespace
{

// VTK reads a face from a file alone. This one lies in memory, and lasts as long as the process.
std::string MakeFile(const unsigned char* bytes, std::size_t size)
{
#if defined(__linux__)
  const int file = memfd_create("letters", MFD_CLOEXEC);
  const std::string path = "/proc/self/fd/" + std::to_string(file);
  if (file >= 0 && write(file, bytes, size) == static_cast<ssize_t>(size) &&
      access(path.c_str(), R_OK) == 0)
  {
    return path;
  }
#else
  static_cast<void>(bytes);
  static_cast<void>(size);
#endif
  return "";
}

const std::string& FileOf(bool bold)
{
  static const std::string usual = MakeFile(embedded::letters, embedded::lettersSize);
  static const std::string strong = MakeFile(embedded::boldLetters, embedded::boldLettersSize);
  return bold ? strong : usual;
}

// The face of all letters is Inter (Data/README.md), which is compiled in. Where the operating
// system gives no file without a folder (it needs memfd_create and /proc), it is VTK's own Arial.
void SetFace(vtkTextProperty* property, bool bold)
{
  const std::string& file = FileOf(bold);
  if (file.empty())
  {
    property->SetFontFamilyToArial();
    property->SetBold(bold ? 1 : 0);
    return;
  }
  property->SetFontFamily(VTK_FONT_FILE);
  property->SetFontFile(file.c_str());
}

constexpr int dotsPerInch = 72; // letters of N points are N pixels high
constexpr double lineSpacing = 1.25;
constexpr std::size_t mostPictures = 300;

// How much of each pixel the letters cover, 0…1, with a margin on every side.
struct Coverage
{
  int width = 0, height = 0;
  std::vector<double> values;

  double At(int x, int y) const
  {
    const bool inside = x >= 0 && y >= 0 && x < width && y < height;
    return inside ? values[static_cast<std::size_t>(y) * width + x] : 0.0;
  }
};

Coverage Draw(const std::string& text, const TextStyle& style, int margin)
{
  vtkNew<vtkTextProperty> property;
  SetFace(property, style.bold);
  property->SetFontSize(style.size);
  property->SetColor(1.0, 1.0, 1.0);
  property->SetLineSpacing(lineSpacing);
  vtkNew<vtkImageData> drawn;
  int dimensions[2] = {0, 0};
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  if (renderer == nullptr || text.empty() ||
      !renderer->RenderString(property, text, drawn, dimensions, dotsPerInch))
  {
    return {};
  }
  Coverage coverage;
  coverage.width = dimensions[0] + 2 * margin;
  coverage.height = dimensions[1] + 2 * margin;
  const int* extent = drawn->GetExtent();
  for (int y = -margin; y < dimensions[1] + margin; ++y)
  {
    for (int x = -margin; x < dimensions[0] + margin; ++x)
    {
      const bool inside = x >= 0 && y >= 0 && x < dimensions[0] && y < dimensions[1];
      coverage.values.push_back(
        inside
          ? drawn->GetScalarComponentAsDouble(extent[0] + x, extent[2] + y, extent[4], 3) / 255.0
          : 0.0);
    }
  }
  return coverage;
}

// How much of a pixel the rim covers: the letters, widened by `width` pixels.
double RimAt(const Coverage& letters, int x, int y, double width)
{
  const int reach = static_cast<int>(std::ceil(width));
  double most = 0.0;
  for (int j = -reach; j <= reach; ++j)
  {
    for (int i = -reach; i <= reach; ++i)
    {
      const double letter = letters.At(x + i, y + j);
      if (letter > most) // of most pixels there is none, and roots take long
      {
        const double near = std::clamp(width + 0.5 - std::hypot(i, j), 0.0, 1.0);
        most = std::max(most, near * letter);
      }
    }
  }
  return most;
}

vtkSmartPointer<vtkImageData> Compose(
  const Coverage& letters, const TextStyle& style, double rimWidth)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(letters.width, letters.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < letters.height; ++y)
  {
    for (int x = 0; x < letters.width; ++x)
    {
      const double front = letters.At(x, y);
      const double behind = (1.0 - front) * RimAt(letters, x, y, rimWidth);
      const double opacity = front + behind;
      const double share = opacity > 0.0 ? front / opacity : 0.0;
      for (std::size_t i = 0; i < 3; ++i)
      {
        *pixel++ =
          ToByte(std::clamp(share * style.colour[i] + (1.0 - share) * style.rim[i], 0.0, 1.0));
      }
      *pixel++ = ToByte(std::clamp(opacity, 0.0, 1.0));
    }
  }
  return image;
}

// A rectangle in pixels with the whole image on it.
vtkSmartPointer<vtkActor2D> MakeActor(vtkImageData* image, double left, double bottom)
{
  const int* size = image->GetDimensions();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> places;
  vtkNew<vtkCellArray> cells;
  places->SetNumberOfComponents(2);
  cells->InsertNextCell(4);
  for (const auto& [x, y] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}})
  {
    cells->InsertCellPoint(points->InsertNextPoint(left + x * size[0], bottom + y * size[1], 0.0));
    places->InsertNextTuple2(x, y);
  }
  vtkNew<vtkPolyData> rectangle;
  rectangle->SetPoints(points);
  rectangle->SetPolys(cells);
  rectangle->GetPointData()->SetTCoords(places);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(rectangle);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOff();
  texture->RepeatOff();
  auto actor = vtkSmartPointer<vtkTexturedActor2D>::New();
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  return actor;
}

} // namespace

std::string NumberWord(double value, int digits)
{
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

double PixelBox::Shared(const PixelBox& other) const
{
  const double width = std::min(right, other.right) - std::max(left, other.left);
  const double height = std::min(top, other.top) - std::max(bottom, other.bottom);
  return width > 0.0 && height > 0.0 ? width * height : 0.0;
}

TextPicture::TextPicture(const std::string& text, const TextStyle& style)
{
  const double rimWidth = std::max(1.0, style.size / 11.0);
  rim = static_cast<int>(std::ceil(rimWidth)) + 1;
  const Coverage letters = Draw(text, style, rim);
  if (letters.width > 0)
  {
    image = Compose(letters, style, rimWidth);
    size = {letters.width - 2 * rim, letters.height - 2 * rim};
  }
}

// The letters' lower left corner as seen from the point.
std::array<double, 2> TextPicture::CornerOf(LabelSide side, double gap) const
{
  const double width = size[0];
  const double height = size[1];
  const double slant = 0.5 * gap;
  switch (side)
  {
  case LabelSide::Left:
    return {-gap - width, -0.5 * height};
  case LabelSide::Right:
    return {gap, -0.5 * height};
  case LabelSide::Above:
    return {-0.5 * width, gap};
  case LabelSide::Below:
    return {-0.5 * width, -gap - height};
  case LabelSide::AboveLeft:
    return {-slant - width, slant};
  case LabelSide::AboveRight:
    return {slant, slant};
  case LabelSide::BelowLeft:
    return {-slant - width, -slant - height};
  case LabelSide::BelowRight:
    return {slant, -slant - height};
  default:
    return {-0.5 * width, -0.5 * height};
  }
}

PixelBox TextPicture::BoxAt(const std::array<double, 2>& point, LabelSide side, double gap) const
{
  const auto corner = this->CornerOf(side, gap);
  const double left = point[0] + corner[0];
  const double bottom = point[1] + corner[1];
  return {left, bottom, left + size[0], bottom + size[1]};
}

vtkSmartPointer<vtkProp> TextPicture::MakeLabel(
  const ScenePoint& point, LabelSide side, double gap) const
{
  if (image == nullptr)
  {
    auto nothing = vtkSmartPointer<vtkActor2D>::New();
    nothing->VisibilityOff(); // VTK reports an actor that is drawn without a mapper
    return nothing;
  }
  const auto corner = this->CornerOf(side, gap);
  auto actor = MakeActor(image, std::round(corner[0]) - rim, std::round(corner[1]) - rim);
  vtkCoordinate* coordinate = actor->GetPositionCoordinate();
  coordinate->SetCoordinateSystemToWorld();
  coordinate->SetValue(point[0], point[1], point[2]);
  return actor;
}

vtkSmartPointer<vtkProp> TextPicture::MakeCaption(
  const std::array<double, 2>& place, LabelSide side) const
{
  const auto prop = this->MakeLabel({place[0], place[1], 0.0}, side, 0.0);
  vtkActor2D::SafeDownCast(prop)
    ->GetPositionCoordinate()
    ->SetCoordinateSystemToNormalizedViewport();
  return prop;
}

const TextPicture& TextPictures::Get(const std::string& text, const TextStyle& style)
{
  const Key key(text, style.size, style.colour, style.rim, style.bold);
  const auto found = pictures.find(key);
  if (found != pictures.end())
  {
    return found->second;
  }
  if (pictures.size() >= mostPictures)
  {
    pictures.clear();
  }
  return pictures.emplace(key, TextPicture(text, style)).first->second;
}

} // namespace nexrad::scene
