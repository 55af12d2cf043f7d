// SPDX-License-Identifier: BSD-3-Clause
#include "Sheets/PictureSheet.h"

#include "Drawing/PictureWindow.h"
#include "Scene/Elements/Letters.h"
#include "Scene/Elements/SceneText.h"

#include <vtkActor2D.h>
#include <vtkImageData.h>
#include <vtkImageMapper.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace nexrad::scene
{
namespace
{

constexpr Colour backgroundColour = {0.12, 0.13, 0.15};
constexpr Colour textColour = {0.95, 0.96, 0.98};

// Where things stand in a sheet, in pixels from its lower left corner.
struct Layout
{
  std::array<int, 2> picture{};
  int columns = 1;
  int rows = 1;
  int letters = 12;

  int Gap() const { return letters / 2; }
  int Strip() const { return 2 * letters; } // above each picture, and for the title

  std::array<int, 2> Size() const
  {
    return {columns * (picture[0] + this->Gap()) + this->Gap(),
      rows * (picture[1] + this->Strip() + this->Gap()) + this->Strip()};
  }
  std::array<int, 2> Corner(int panel) const
  {
    const int row = rows - 1 - panel / columns;
    return {this->Gap() + panel % columns * (picture[0] + this->Gap()),
      this->Gap() + row * (picture[1] + this->Strip() + this->Gap())};
  }
};

Layout MakeLayout(const std::vector<SheetPanel>& panels, int columns)
{
  const int* size = panels.front().picture->GetDimensions();
  Layout layout;
  layout.picture = {size[0], size[1]};
  layout.columns = std::min(columns, static_cast<int>(panels.size()));
  layout.rows = (static_cast<int>(panels.size()) + layout.columns - 1) / layout.columns;
  layout.letters = std::max(10, size[1] / 28);
  return layout;
}

void AddPicture(vtkRenderer* renderer, vtkImageData* picture, const std::array<int, 2>& corner)
{
  vtkNew<vtkImageMapper> mapper;
  mapper->SetInputData(picture);
  mapper->SetColorWindow(255.0);
  mapper->SetColorLevel(127.5);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(corner[0], corner[1]);
  renderer->AddActor2D(actor);
}

void AddText(vtkRenderer* renderer, const Layout& layout, const std::string& text,
  const std::array<int, 2>& place, bool title)
{
  const auto size = layout.Size();
  const auto caption = MakeCaption(text,
    {static_cast<double>(place[0]) / size[0], static_cast<double>(place[1]) / size[1]},
    title ? layout.letters * 6 / 5 : layout.letters, textColour, LabelSide::Right);
  SetFace(caption->GetTextProperty(), title);
  renderer->AddActor2D(caption);
}

const unsigned char* Pixel(vtkImageData* picture, int x, int y)
{
  return static_cast<const unsigned char*>(picture->GetScalarPointer(x, y, 0));
}

} // namespace

vtkSmartPointer<vtkImageData> MakeSheet(
  const std::string& title, const std::vector<SheetPanel>& panels, int columns)
{
  RequireDisplay();
  const Layout layout = MakeLayout(panels, columns);
  const auto size = layout.Size();
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(backgroundColour[0], backgroundColour[1], backgroundColour[2]);
  AddText(renderer, layout, title, {layout.Gap(), size[1] - layout.Strip() / 2}, true);
  for (std::size_t i = 0; i < panels.size(); ++i)
  {
    const auto corner = layout.Corner(static_cast<int>(i));
    AddPicture(renderer, panels[i].picture, corner);
    AddText(renderer, layout, panels[i].label,
      {corner[0], corner[1] + layout.picture[1] + layout.Strip() / 2}, false);
  }
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(size[0], size[1]);
  window->AddRenderer(renderer);
  return GrabPicture(window);
}

PictureDifference CompareCovered(
  vtkImageData* picture, vtkImageData* reference, vtkImageData* without)
{
  const int* size = reference->GetDimensions();
  double sum = 0.0;
  double covered = 0.0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const unsigned char* expected = Pixel(reference, x, y);
      if (!std::equal(expected, expected + 3, Pixel(without, x, y)))
      {
        covered += 1.0;
        for (int channel = 0; channel < 3; ++channel)
        {
          sum += std::abs(Pixel(picture, x, y)[channel] - expected[channel]);
        }
      }
    }
  }
  return {covered > 0.0 ? sum / (3.0 * covered) : 0.0, covered / (1.0 * size[0] * size[1])};
}

} // namespace nexrad::scene
