// SPDX-License-Identifier: BSD-3-Clause
#include "GlbParts.h"

#include "TestData.h"

#include <gtest/gtest.h>

#include <cstring>

namespace nexrad::testing
{
namespace
{

std::uint32_t Word(const std::vector<unsigned char>& bytes, std::size_t at)
{
  std::uint32_t word = 0;
  if (at + 4 <= bytes.size())
  {
    std::memcpy(&word, bytes.data() + at, 4);
  }
  return word;
}

// The contents of the chunk at a place, which becomes that of the next one.
std::vector<unsigned char> Chunk(
  const std::vector<unsigned char>& file, std::size_t& at, const std::string& type)
{
  const std::size_t length = Word(file, at);
  const std::size_t first = at + 8;
  EXPECT_EQ(length % 4, 0);
  EXPECT_LE(first + length, file.size());
  if (first + length > file.size())
  {
    return {};
  }
  EXPECT_EQ(std::string(file.begin() + static_cast<std::ptrdiff_t>(at) + 4,
              file.begin() + static_cast<std::ptrdiff_t>(first)),
    type);
  at = first + length;
  return {file.begin() + static_cast<std::ptrdiff_t>(first),
    file.begin() + static_cast<std::ptrdiff_t>(at)};
}

} // namespace

GlbParts::GlbParts(const std::vector<unsigned char>& file)
{
  EXPECT_EQ(Word(file, 0), 0x46546C67);
  EXPECT_EQ(Word(file, 4), 2);
  EXPECT_EQ(Word(file, 8), file.size());
  std::size_t at = 12;
  const std::vector<unsigned char> text = Chunk(file, at, "JSON");
  json = nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
  EXPECT_TRUE(json.is_object());
  if (at < file.size())
  {
    arrays = Chunk(file, at, std::string("BIN\0", 4));
  }
  EXPECT_EQ(at, file.size());
}

nlohmann::json GlbParts::Node(const std::string& name) const
{
  for (const nlohmann::json& node : json.value("nodes", nlohmann::json::array()))
  {
    if (node.at("name") == name)
    {
      return node;
    }
  }
  return nullptr;
}

nlohmann::json GlbParts::Primitive(const std::string& name) const
{
  const nlohmann::json mesh = json.at("meshes").at(this->Node(name).at("mesh").get<std::size_t>());
  EXPECT_EQ(mesh.at("primitives").size(), 1);
  return mesh.at("primitives").at(0);
}

nlohmann::json GlbParts::MaterialOf(const std::string& name) const
{
  return json.at("materials").at(this->Primitive(name).at("material").get<std::size_t>());
}

template <class Number>
std::vector<Number> GlbParts::Numbers(std::size_t accessor, std::size_t each) const
{
  const nlohmann::json& described = json.at("accessors").at(accessor);
  const nlohmann::json& view =
    json.at("bufferViews").at(described.at("bufferView").get<std::size_t>());
  const std::size_t first = view.at("byteOffset");
  const std::size_t length = view.at("byteLength");
  std::vector<Number> numbers(described.at("count").get<std::size_t>() * each);
  EXPECT_EQ(length, numbers.size() * sizeof(Number));
  EXPECT_EQ(first % 4, 0);
  EXPECT_LE(first + length, arrays.size());
  if (first + length <= arrays.size() && length == numbers.size() * sizeof(Number))
  {
    std::memcpy(numbers.data(), arrays.data() + first, length);
  }
  return numbers;
}

std::vector<std::array<float, 3>> GlbParts::Vectors(std::size_t accessor) const
{
  EXPECT_EQ(json.at("accessors").at(accessor).at("componentType"), 5126);
  EXPECT_EQ(json.at("accessors").at(accessor).at("type"), "VEC3");
  const std::vector<float> numbers = this->Numbers<float>(accessor, 3);
  std::vector<std::array<float, 3>> vectors;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
  {
    vectors.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  }
  return vectors;
}

std::vector<std::uint32_t> GlbParts::Indices(std::size_t accessor) const
{
  const int type = json.at("accessors").at(accessor).at("componentType");
  if (type == 5125)
  {
    return this->Numbers<std::uint32_t>(accessor, 1);
  }
  EXPECT_EQ(type, 5123);
  const std::vector<std::uint16_t> shorts = this->Numbers<std::uint16_t>(accessor, 1);
  return {shorts.begin(), shorts.end()};
}

GlbParts ReadGlb(const std::filesystem::path& path)
{
  const std::string content = FileContent(path);
  return GlbParts({content.begin(), content.end()});
}

} // namespace nexrad::testing
