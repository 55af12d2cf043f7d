// SPDX-License-Identifier: BSD-3-Clause
#include "Gltf/MeshBuilder.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace nexrad::scene
{
namespace
{

constexpr double metresOfUnit = 1000.0; // of the scene

std::array<float, 3> Turned(const double* vector, double factor)
{
  return {static_cast<float>(factor * vector[0]), static_cast<float>(factor * vector[2]),
    static_cast<float>(-factor * vector[1])};
}

} // namespace

MeshBuilder::MeshBuilder(std::string name, GlbShape shape, const Colour& colour, double opacity)
{
  mesh.name = std::move(name);
  mesh.shape = shape;
  mesh.material = {colour, opacity, false};
}

std::uint32_t MeshBuilder::Add(const ScenePoint& point)
{
  mesh.points.push_back(Turned(point.data(), metresOfUnit));
  return static_cast<std::uint32_t>(mesh.points.size() - 1);
}

void MeshBuilder::AddLine(const GroundLine& line, double height)
{
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const std::uint32_t point = this->Add({line[i][0], line[i][1], height});
    if (i > 0)
    {
      mesh.indices.insert(mesh.indices.end(), {point - 1, point});
    }
  }
}

void MeshBuilder::AddTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

void MeshBuilder::Add(vtkPolyData* surface)
{
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    mesh.points.push_back(Turned(surface->GetPoint(i), metresOfUnit));
    if (normals != nullptr)
    {
      mesh.normals.push_back(Turned(normals->GetTuple3(i), 1.0));
    }
  }
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  vtkCellArray* cells = surface->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(size, corners) != 0;)
  {
    std::transform(corners, corners + size, std::back_inserter(mesh.indices),
      [first](vtkIdType corner) { return first + static_cast<std::uint32_t>(corner); });
  }
  mesh.material.lit = normals != nullptr;
}

} // namespace nexrad::scene
