// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::application
{

/// Collects the parts of a page and writes it: Source/Web/page.html with its style, shaders and
/// scripts, which are compiled in.
class PageText
{
public:
  /// Adds an element whose text is the bytes, deflated and in base64. `id`: letters, digits and
  /// "-".
  void AddPart(const std::string& id, const std::vector<std::uint8_t>& bytes);
  void AddTextPart(const std::string& id, const std::string& text);

  /// The page. `title`: plain text.
  std::string Make(const std::string& title) const;

private:
  std::string parts;
};

/// A page without parts, with the faces of its letters.
PageText MakePageWithLetters();

/// Text with the letters that mean something in HTML as entities.
std::string EscapeHtml(const std::string& text);

} // namespace nexrad::application
