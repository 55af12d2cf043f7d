// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::testing
{

/// A binary glTF file taken apart by its specification (ISO/IEC 12113), independently of what
/// writes it. Fails the test for a file that is none.
struct GlbParts
{
  explicit GlbParts(const std::vector<unsigned char>& file);

  nlohmann::json json;
  std::vector<unsigned char> arrays;

  /// The node of that name; null where there is none.
  nlohmann::json Node(const std::string& name) const;
  /// The only primitive of that node's mesh.
  nlohmann::json Primitive(const std::string& name) const;
  nlohmann::json MaterialOf(const std::string& name) const;

  /// The numbers of an accessor.
  std::vector<std::array<float, 3>> Vectors(std::size_t accessor) const;
  std::vector<std::uint32_t> Indices(std::size_t accessor) const;

private:
  template <class Number>
  std::vector<Number> Numbers(std::size_t accessor, std::size_t each) const;
};

/// That of a file.
GlbParts ReadGlb(const std::filesystem::path& path);

} // namespace nexrad::testing
