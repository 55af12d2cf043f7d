// SPDX-License-Identifier: BSD-3-Clause
#include "Gltf/Glb.h"

#include "GlbParts.h"

#include <gtest/gtest.h>

#include <string>

using namespace nexrad::scene;
using namespace nexrad::testing;

namespace
{

// Points along a line, joined.
GlbMesh MakeLine(std::uint32_t points)
{
  GlbMesh mesh;
  mesh.name = "line";
  mesh.shape = GlbShape::Lines;
  for (std::uint32_t i = 0; i < points; ++i)
  {
    mesh.points.push_back({static_cast<float>(i), -0.1F, 7.0F});
  }
  for (std::uint32_t i = 1; i < points; ++i)
  {
    mesh.indices.insert(mesh.indices.end(), {i - 1, i});
  }
  return mesh;
}

GlbParts PartsOf(const std::vector<GlbMesh>& meshes)
{
  return GlbParts(MakeGlb({"scene", {{"key", "value"}}, meshes}));
}

} // namespace

TEST(Glb, APointIsFoundAgain)
{
  const GlbMesh line = MakeLine(5);
  const GlbParts parts = PartsOf({line});
  const nlohmann::json primitive = parts.Primitive("line");
  EXPECT_EQ(primitive.at("mode"), 1);
  const std::size_t points = primitive.at("attributes").at("POSITION");
  EXPECT_EQ(parts.Vectors(points), line.points);
  EXPECT_EQ(parts.Indices(primitive.at("indices")), line.indices);
  const nlohmann::json accessor = parts.json.at("accessors").at(points);
  EXPECT_EQ(accessor.at("min"), (std::array<float, 3>{0.0F, -0.1F, 7.0F}));
  EXPECT_EQ(accessor.at("max"), (std::array<float, 3>{4.0F, -0.1F, 7.0F}));
  EXPECT_FALSE(primitive.at("attributes").contains("NORMAL"));
  EXPECT_EQ(parts.json.at("asset").at("version"), "2.0");
  EXPECT_EQ(parts.json.at("scenes").at(0).at("extras").at("key"), "value");
  EXPECT_EQ(parts.json.at("scenes").at(0).at("nodes"), (std::vector<int>{0}));
  EXPECT_EQ(parts.json.at("buffers").at(0).at("byteLength"), parts.arrays.size());
}

// 65535 is not an index: it would end a strip.
TEST(Glb, IndicesTakeSixteenBitsWhereTheyFit)
{
  for (const auto& [points, type] : {std::pair(65'535U, 5123), std::pair(65'536U, 5125)})
  {
    const GlbMesh line = MakeLine(points);
    const GlbParts parts = PartsOf({line});
    const std::size_t indices = parts.Primitive("line").at("indices");
    EXPECT_EQ(parts.json.at("accessors").at(indices).at("componentType"), type);
    EXPECT_EQ(parts.Indices(indices), line.indices);
  }
}

// The middle grey of a screen has 0.2140 of the light of white (IEC 61966-2-1).
TEST(Glb, ColoursAreLinear)
{
  GlbMesh clear = MakeLine(2);
  clear.name = "clear";
  clear.material = {{0.5, 0.0, 1.0}, 0.25, true};
  GlbMesh opaque = MakeLine(2);
  const GlbParts parts = PartsOf({clear, opaque});
  const nlohmann::json material = parts.MaterialOf("clear");
  const std::vector<double> colour = material.at("pbrMetallicRoughness").at("baseColorFactor");
  EXPECT_NEAR(colour.at(0), 0.2140, 1e-4);
  EXPECT_EQ(colour.at(1), 0.0);
  EXPECT_DOUBLE_EQ(colour.at(2), 1.0);
  EXPECT_EQ(colour.at(3), 0.25);
  EXPECT_EQ(material.at("alphaMode"), "BLEND");
  EXPECT_EQ(material.at("doubleSided"), true);
  EXPECT_FALSE(material.contains("extensions"));
  EXPECT_EQ(parts.MaterialOf("line").at("alphaMode"), "OPAQUE");
  EXPECT_TRUE(parts.MaterialOf("line").at("extensions").contains("KHR_materials_unlit"));
  EXPECT_EQ(parts.json.at("extensionsUsed"), (std::vector<std::string>{"KHR_materials_unlit"}));
}

TEST(Glb, MeshesWithoutIndicesAreLeftOut)
{
  GlbMesh empty = MakeLine(1);
  empty.name = "empty";
  const GlbParts parts = PartsOf({empty, MakeLine(3)});
  EXPECT_EQ(parts.Node("empty"), nullptr);
  EXPECT_EQ(parts.json.at("nodes").size(), 1);
  const GlbParts nothing = PartsOf({empty});
  EXPECT_TRUE(nothing.arrays.empty());
  EXPECT_FALSE(nothing.json.contains("buffers"));
  EXPECT_FALSE(nothing.json.at("scenes").at(0).contains("nodes"));
}
