// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Shapes/Shapes.h"
#include "Scene/Shapes/Theme.h"

#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <string>
#include <tuple>
#include <vector>

class vtkImageData;
class vtkProp;

namespace nexrad::scene
{

/// A number as pictures write it, with at most so many digits that count.
std::string NumberWord(double value, int digits = 6);

/// How letters look.
struct TextStyle
{
  int size = 16; ///< height of the letters in pixels
  Colour colour{};
  Colour rim{}; ///< of a thin line about the letters, which tells them from echo behind them
  bool bold = false;
};

/// Where a label stands beside its point.
enum class LabelSide
{
  Left,
  Right,
  Above,
  Below,
  AboveLeft,
  AboveRight,
  BelowLeft,
  BelowRight,
  Centre
};

/// A rectangle of the picture: left, bottom, right, top in pixels.
struct PixelBox
{
  double left = 0.0, bottom = 0.0, right = 0.0, top = 0.0;

  /// Area that two rectangles share.
  double Shared(const PixelBox& other) const;
};

/// Letters with their rim as a picture. Lines of a text have even distances.
class TextPicture
{
public:
  TextPicture(const std::string& text, const TextStyle& style);

  /// Pixels, without the rim.
  const std::array<int, 2>& Size() const { return size; }

  /// The letters beside a point of the picture.
  PixelBox BoxAt(const std::array<double, 2>& point, LabelSide side, double gap) const;

  /// An actor beside a point of the scene, drawn over everything.
  vtkSmartPointer<vtkProp> MakeLabel(const ScenePoint& point, LabelSide side, double gap) const;

  /// An actor beside a place of the picture: fractions of its width and height from the lower left
  /// corner.
  vtkSmartPointer<vtkProp> MakeCaption(const std::array<double, 2>& place, LabelSide side) const;

private:
  std::array<double, 2> CornerOf(LabelSide side, double gap) const;

  vtkSmartPointer<vtkImageData> image; ///< RGBA, with the rim
  std::array<int, 2> size = {0, 0};
  int rim = 0; ///< pixels on each side
};

/// Text pictures that are kept, so that a label that only moves is not drawn anew.
class TextPictures
{
public:
  const TextPicture& Get(const std::string& text, const TextStyle& style);

private:
  using Key = std::tuple<std::string, int, Colour, Colour, bool>;
  std::map<Key, TextPicture> pictures;
};

/// A word at a point of the scene.
struct Label
{
  std::string text;
  ScenePoint point{};
  TextStyle style;
  std::vector<LabelSide> sides; ///< where it may stand, the best first
  double gap = 0.0;             ///< pixels between the point and the letters
  bool optional = false;        ///< left out where it would lie over other letters
  double room = 0.0;            ///< pixels, distance of an optional label from others that have one
  double dot = 0.0;             ///< pixels, radius of a dot at the point; 0: none
  double spread = 0.0; ///< scene units; left out where the picture shows this length too short for
                       ///< letters; 0: never
};

/// A part of a scene, and the words that belong to it.
struct SceneLayer
{
  std::vector<vtkSmartPointer<vtkProp>> props;
  std::vector<Label> labels;
};

} // namespace nexrad::scene
