// SPDX-License-Identifier: BSD-3-Clause
#include "Gltf/Glb.h"

#include "nexrad/System/Error.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

namespace nexrad::scene
{
namespace
{

// Numbers of glTF 2.0.
constexpr int ofVertices = 34962; // targets of buffer views
constexpr int ofIndices = 34963;
constexpr int unsignedShort = 5123; // types of components
constexpr int unsignedInt = 5125;
constexpr int floatingPoint = 5126;
constexpr std::uint32_t magic = 0x46546C67; // "glTF"
constexpr std::uint32_t formatVersion = 2;
constexpr std::uint32_t jsonChunk = 0x4E4F534A; // "JSON"
constexpr std::uint32_t binaryChunk = 0x004E4942;
constexpr char unlit[] = "KHR_materials_unlit";

// The largest 16-bit number is no index: it would end a strip.
constexpr std::size_t mostForShort = 65'535;

using Bytes = std::vector<unsigned char>;

// The file has little-endian numbers, as the machines that the program is made for.
template <class Number>
void Append(Bytes& bytes, const Number* numbers, std::size_t count)
{
  const auto* first = reinterpret_cast<const unsigned char*>(numbers);
  bytes.insert(bytes.end(), first, first + count * sizeof(Number));
}

void Pad(Bytes& bytes, unsigned char filling)
{
  constexpr std::size_t unit = 4;
  bytes.resize((bytes.size() + unit - 1) / unit * unit, filling);
}

// glTF has linear colours (IEC 61966-2-1).
double Linear(double shown)
{
  return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

nlohmann::json MaterialOf(const GlbMesh& mesh)
{
  const auto& [colour, opacity, lit] = mesh.material;
  nlohmann::json material = {{"name", mesh.name}, {"doubleSided", true},
    {"alphaMode", opacity < 1.0 ? "BLEND" : "OPAQUE"},
    {"pbrMetallicRoughness",
      {{"baseColorFactor", {Linear(colour[0]), Linear(colour[1]), Linear(colour[2]), opacity}},
        {"metallicFactor", 0.0}, {"roughnessFactor", 0.8}}}};
  if (!lit)
  {
    material["extensions"][unlit] = nlohmann::json::object();
  }
  return material;
}

constexpr double metresOfUnit = 1000.0; // of the scene

std::array<float, 3> Turned(const double* vector, double factor)
{
  return {static_cast<float>(factor * vector[0]), static_cast<float>(factor * vector[2]),
    static_cast<float>(-factor * vector[1])};
}

class GlbMaker
{
public:
  explicit GlbMaker(const GlbScene& scene)
  {
    json["asset"] = {{"version", "2.0"}, {"generator", "vtk-nexrad"}};
    json["scene"] = 0;
    nlohmann::json nodes = nlohmann::json::array();
    for (const GlbMesh& mesh : scene.meshes)
    {
      if (!mesh.indices.empty())
      {
        nodes.push_back(json["nodes"].size());
        this->Add(mesh);
      }
    }
    nlohmann::json contents = {{"name", scene.name}};
    AddExtras(contents, scene.extras);
    if (!nodes.empty())
    {
      contents["nodes"] = nodes;
      json["buffers"].push_back({{"byteLength", arrays.size()}});
    }
    json["scenes"].push_back(std::move(contents));
  }

  Bytes Make() const
  {
    const std::string text = json.dump();
    Bytes header(text.begin(), text.end());
    Pad(header, ' ');
    constexpr std::size_t frames = 28; // of the file and of two chunks
    if (header.size() + arrays.size() + frames > std::numeric_limits<std::uint32_t>::max())
    {
      throw Error("the surfaces take more than 4 GiB, which a .glb cannot hold; make a grid of "
                  "fewer voxels (--dims), or draw fewer surfaces");
    }
    Bytes file;
    file.reserve(header.size() + arrays.size() + frames);
    Append(file, &magic, 1);
    Append(file, &formatVersion, 1);
    constexpr std::size_t lengthPlace = 8;
    file.resize(lengthPlace + sizeof(std::uint32_t));
    AppendChunk(file, jsonChunk, header);
    if (!arrays.empty())
    {
      AppendChunk(file, binaryChunk, arrays);
    }
    const auto length = static_cast<std::uint32_t>(file.size());
    std::memcpy(file.data() + lengthPlace, &length, sizeof(length));
    return file;
  }

private:
  static void AddExtras(nlohmann::json& object, const nlohmann::json& extras)
  {
    if (!extras.is_null())
    {
      object["extras"] = extras;
    }
  }

  static void AppendChunk(Bytes& file, std::uint32_t type, const Bytes& contents)
  {
    const auto length = static_cast<std::uint32_t>(contents.size());
    Append(file, &length, 1);
    Append(file, &type, 1);
    file.insert(file.end(), contents.begin(), contents.end());
  }

  void Add(const GlbMesh& mesh)
  {
    nlohmann::json primitive = {{"mode", static_cast<int>(mesh.shape)},
      {"material", json["materials"].size()}, {"indices", this->AddIndices(mesh)}};
    primitive["attributes"]["POSITION"] = this->AddPoints(mesh.points);
    if (!mesh.normals.empty())
    {
      primitive["attributes"]["NORMAL"] = this->AddVectors(mesh.normals);
    }
    json["materials"].push_back(MaterialOf(mesh));
    if (!mesh.material.lit)
    {
      json["extensionsUsed"] = nlohmann::json::array({unlit});
    }
    nlohmann::json node = {{"name", mesh.name}, {"mesh", json["meshes"].size()}};
    AddExtras(node, mesh.extras);
    json["nodes"].push_back(node);
    json["meshes"].push_back(
      {{"name", mesh.name}, {"primitives", nlohmann::json::array({std::move(primitive)})}});
  }

  // The number of the accessor.
  template <class Number>
  std::size_t AddArray(const std::vector<Number>& numbers, int target, int type, const char* shape)
  {
    nlohmann::json view = {{"buffer", 0}, {"byteOffset", arrays.size()},
      {"byteLength", numbers.size() * sizeof(Number)}, {"target", target}};
    nlohmann::json accessor = {{"bufferView", json["bufferViews"].size()}, {"componentType", type},
      {"count", numbers.size()}, {"type", shape}};
    json["bufferViews"].push_back(std::move(view));
    json["accessors"].push_back(std::move(accessor));
    Append(arrays, numbers.data(), numbers.size());
    Pad(arrays, 0);
    return json["accessors"].size() - 1;
  }

  std::size_t AddVectors(const std::vector<std::array<float, 3>>& vectors)
  {
    return this->AddArray(vectors, ofVertices, floatingPoint, "VEC3");
  }

  std::size_t AddPoints(const std::vector<std::array<float, 3>>& points)
  {
    const std::size_t number = this->AddVectors(points);
    std::array<float, 3> least = points.front();
    std::array<float, 3> most = points.front();
    for (const auto& point : points)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        least[axis] = std::min(least[axis], point[axis]);
        most[axis] = std::max(most[axis], point[axis]);
      }
    }
    json["accessors"][number]["min"] = least;
    json["accessors"][number]["max"] = most;
    return number;
  }

  std::size_t AddIndices(const GlbMesh& mesh)
  {
    if (mesh.points.size() > mostForShort)
    {
      return this->AddArray(mesh.indices, ofIndices, unsignedInt, "SCALAR");
    }
    const std::vector<std::uint16_t> shorts(mesh.indices.begin(), mesh.indices.end());
    return this->AddArray(shorts, ofIndices, unsignedShort, "SCALAR");
  }

  nlohmann::json json;
  Bytes arrays;
};

} // namespace

std::vector<unsigned char> MakeGlb(const GlbScene& scene)
{
  return GlbMaker(scene).Make();
}

std::uint32_t GlbMesh::Add(const ScenePoint& point)
{
  points.push_back(Turned(point.data(), metresOfUnit));
  return static_cast<std::uint32_t>(points.size() - 1);
}

void GlbMesh::AddLine(const GroundLine& line, double height)
{
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const std::uint32_t point = this->Add({line[i][0], line[i][1], height});
    if (i > 0)
    {
      indices.insert(indices.end(), {point - 1, point});
    }
  }
}

void GlbMesh::AddTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  indices.insert(indices.end(), {a, b, c});
}

void GlbMesh::Add(vtkPolyData* surface)
{
  const auto first = static_cast<std::uint32_t>(points.size());
  vtkDataArray* given = surface->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    points.push_back(Turned(surface->GetPoint(i), metresOfUnit));
    if (given != nullptr)
    {
      normals.push_back(Turned(given->GetTuple3(i), 1.0));
    }
  }
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  vtkCellArray* cells = surface->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(size, corners) != 0;)
  {
    std::transform(corners, corners + size, std::back_inserter(indices),
      [first](vtkIdType corner) { return first + static_cast<std::uint32_t>(corner); });
  }
  material.lit = given != nullptr;
}

} // namespace nexrad::scene
