// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Map/PlacedMap.h"
#include "Scene/Shapes/Shapes.h"
#include "Scene/Shapes/Theme.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace nexrad::scene
{

/// What neighbouring indices of a mesh are. The numbers are those of glTF.
enum class GlbShape
{
  Lines = 1,    ///< two indices a line
  Triangles = 4 ///< three a triangle, anticlockwise as seen from outside
};

/// A colour, and how light falls on it.
struct GlbMaterial
{
  Colour colour{};      ///< as a screen shows it (sRGB)
  double opacity = 1.0; ///< 0 to 1
  bool lit = false;     ///< by the lights of the program that draws it; else it has its colour
};

/// A mesh with a name, at the place that its points have. What is added has coordinates of a scene:
/// x, y and height in km become m to the east, up and to the south.
struct GlbMesh
{
  std::string name;
  GlbShape shape = GlbShape::Triangles;
  GlbMaterial material;
  std::vector<std::array<float, 3>> points = {};  ///< m: x, y up, z
  std::vector<std::array<float, 3>> normals = {}; ///< one a point, of length 1; none: all empty
  std::vector<std::uint32_t> indices = {};        ///< of points
  nlohmann::json extras = {};                     ///< an object; null: none

  /// Adds a point. The number that it has.
  std::uint32_t Add(const ScenePoint& point);
  void AddLine(const GroundLine& line, double height);
  /// Anticlockwise as seen from outside.
  void AddTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  /// Adds triangles, with their normals where they have some: such a mesh is lit.
  void Add(vtkPolyData* surface);
};

/// The contents of a binary glTF file.
struct GlbScene
{
  std::string name;
  nlohmann::json extras; ///< an object; null: none
  std::vector<GlbMesh> meshes;
};

/// The bytes of a binary glTF 2.0 file (ISO/IEC 12113): a JSON chunk and a chunk of arrays. Indices
/// take 16 bits where they fit. Materials are double-sided; those that are not lit have the
/// extension KHR_materials_unlit, which programs may ignore. Meshes without indices are left out.
/// Throws Error for a scene of more than 4 GiB, which the format cannot hold.
std::vector<unsigned char> MakeGlb(const GlbScene& scene);

} // namespace nexrad::scene
