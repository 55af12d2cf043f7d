// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Gltf/Glb.h"
#include "Scene/Map/PlacedMap.h"
#include "Scene/Shapes/Shapes.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace nexrad::scene
{

/// Makes a mesh of a binary glTF file of what has coordinates of a scene: the scene's x, y and
/// height in km become m to the east, up and to the south.
class MeshBuilder
{
public:
  MeshBuilder(std::string name, GlbShape shape, const Colour& colour, double opacity = 1.0);

  /// Adds a point. The number that it has.
  std::uint32_t Add(const ScenePoint& point);
  void AddLine(const GroundLine& line, double height);
  /// Anticlockwise as seen from outside.
  void AddTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  /// Adds triangles, with their normals where they have some: such a mesh is lit.
  void Add(vtkPolyData* surface);

  std::size_t Triangles() const { return mesh.indices.size() / 3; }
  void SetExtras(nlohmann::json extras) { mesh.extras = std::move(extras); }

  /// The mesh; the builder is empty then.
  GlbMesh Take() { return std::move(mesh); }

private:
  GlbMesh mesh;
};

} // namespace nexrad::scene
