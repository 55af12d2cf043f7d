// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Map/PlacedMap.h"
#include "Scene/Shapes/Theme.h"

#include "vtkNew.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkCellArray;
class vtkPoints;
class vtkPolyData;
class vtkUnsignedCharArray;

/// Collects lines and polygons of the scene as those of the volume, each with its kind and the
/// colour of that kind.
class MapBuilder
{
public:
  using ColourOfKind = std::function<nexrad::scene::Colour(int)>;

  MapBuilder(
    const nexrad::scene::SceneFrame& theFrame, ColourOfKind theColours, vtkPolyData* theOutput);
  ~MapBuilder();

  const nexrad::scene::SceneFrame& Frame() const { return frame; }
  /// The ground under the volume in the scene: west, east, south and north.
  std::array<double, 4> Rectangle() const;

  void AddLine(const nexrad::scene::GroundLine& line, int kind);
  /// The parts of a line that lie over the ground.
  void AddClipped(const nexrad::scene::GroundLine& line, int kind);
  void AddPolygon(const nexrad::scene::GroundLine& corners, int kind);

  /// Gives the output what was added.
  void Finish();

private:
  void InsertCell(vtkCellArray* cells, const nexrad::scene::GroundLine& line);

  const nexrad::scene::SceneFrame& frame;
  ColourOfKind colours;
  vtkPolyData* output;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkUnsignedCharArray> lineColors;
  vtkNew<vtkUnsignedCharArray> lineKinds;
  vtkNew<vtkUnsignedCharArray> polygonColors;
  vtkNew<vtkUnsignedCharArray> polygonKinds;
};

/// Writes names on the ground, each beside a disc at its place.
class NameWriter
{
public:
  explicit NameWriter(MapBuilder& theBuilder)
    : builder(theBuilder)
  {
  }

  /// Writes a name at the right of a place in the scene, in letters of a height in km.
  void Write(const std::string& name, const std::array<double, 2>& place, double height, int kind);

  /// Writes it at the right or the left of the place, where it lies over the ground and nearer than
  /// `room` km to no name before it. Returns whether it does.
  bool WriteWhereFree(const std::string& name, const std::array<double, 2>& place, double height,
    double room, int kind);

private:
  struct Name; ///< letters, and where they are

  bool IsFree(const Name& name, double room) const;
  void Add(const Name& name, int kind);

  MapBuilder& builder;
  std::vector<std::array<double, 4>> written; ///< west, east, south, north
};
