// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace nexrad::application
{

/// Collects the parts of a page and writes it: Source/Web/page.html with its style, shaders and
/// scripts, which are compiled in.
class PageText
{
public:
  /// A page with the faces of its letters.
  PageText();

  /// Adds an element whose text is the bytes, deflated and in base64. `id`: letters, digits and
  /// "-".
  void AddPart(const std::string& id, const std::vector<std::uint8_t>& bytes);
  void AddTextPart(const std::string& id, const std::string& text);

  /// Adds the names of the files that were written beside the page, for ReadWrittenFiles.
  void AddWrittenFiles(const std::set<std::string>& names);

  /// The page. `title`: plain text.
  std::string Make(const std::string& title) const;

private:
  std::string parts;
};

/// The names that AddWrittenFiles put into a page; empty where there is no such page. Throws Error
/// for a file of that name that is no page of this program.
std::set<std::string> ReadWrittenFiles(const std::filesystem::path& page);

/// Bytes as text of the letters of base64 (RFC 4648, section 4), without line breaks.
std::string FormatBase64(const std::vector<std::uint8_t>& bytes);

} // namespace nexrad::application
