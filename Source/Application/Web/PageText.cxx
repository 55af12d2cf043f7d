// SPDX-License-Identifier: BSD-3-Clause
#include "Web/PageText.h"

#include "Scene/Shapes/Embedded.h"
#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/System/Error.h"

#include <nlohmann/json.hpp>
#include <vtksys/Base64.h>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <system_error>

namespace nexrad::embedded
{
extern const unsigned char webPage[];
extern const std::size_t webPageSize;
} // namespace nexrad::embedded

namespace nexrad::application
{
namespace
{

// The first words of Source/Web/page.html, and the element with the names of files beside it.
constexpr char madeBy[] = "<!-- Made by nexrad3d web";
constexpr char writtenFiles[] = "<script type=\"text/plain\" id=\"written-files\">";

void ReplaceMark(std::string& text, const std::string& mark, const std::string& by)
{
  text.replace(text.find(mark), mark.size(), by); // a mark that is missing throws
}

// Text with the letters that mean something in HTML as entities.
std::string EscapeHtml(const std::string& text)
{
  std::string escaped;
  for (const char letter : text)
  {
    switch (letter)
    {
    case '&':
      escaped += "&amp;";
      break;
    case '<':
      escaped += "&lt;";
      break;
    case '>':
      escaped += "&gt;";
      break;
    default:
      escaped += letter;
    }
  }
  return escaped;
}

} // namespace

PageText::PageText()
{
  this->AddPart("letters", {embedded::letters, embedded::letters + embedded::lettersSize});
  this->AddPart(
    "bold-letters", {embedded::boldLetters, embedded::boldLetters + embedded::boldLettersSize});
}

void PageText::AddPart(const std::string& id, const std::vector<std::uint8_t>& bytes)
{
  parts += "<script type=\"text/plain\" id=\"" + id + "\">";
  parts += FormatBase64(DeflateBytes(bytes.data(), bytes.size()));
  parts += "</script>\n";
}

void PageText::AddTextPart(const std::string& id, const std::string& text)
{
  this->AddPart(id, std::vector<std::uint8_t>(text.begin(), text.end()));
}

void PageText::AddWrittenFiles(const std::set<std::string>& names)
{
  const std::string list =
    nlohmann::json(names).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  parts += writtenFiles;
  for (const char letter : list)
  {
    parts +=
      letter == '<' ? std::string("\\u003c") : std::string(1, letter); // would end the element
  }
  parts += "</script>\n";
}

std::string PageText::Make(const std::string& title) const
{
  std::string page(reinterpret_cast<const char*>(embedded::webPage), embedded::webPageSize);
  ReplaceMark(page, "@TITLE@", EscapeHtml(title));
  ReplaceMark(page, "@PARTS@", parts);
  return page;
}

std::set<std::string> ReadWrittenFiles(const std::filesystem::path& page)
{
  std::error_code failure;
  if (!std::filesystem::exists(std::filesystem::symlink_status(page, failure)))
  {
    return {};
  }
  std::string text;
  if (IsOrdinaryFile(page))
  {
    std::ifstream file(page, std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  if (text.find(madeBy) == std::string::npos)
  {
    throw Error(page.string() + ": is no page of nexrad3d web, and stays as it is; move it, or "
                                "name another folder (-o)");
  }
  const std::size_t begin = text.find(writtenFiles);
  const std::size_t list = begin + std::string(writtenFiles).size();
  const nlohmann::json names =
    begin == std::string::npos
      ? nlohmann::json()
      : nlohmann::json::parse(text.substr(list, text.find('<', list) - list), nullptr, false);
  std::set<std::string> written;
  for (std::size_t i = 0; names.is_array() && i < names.size(); ++i)
  {
    written.insert(names[i].is_string() ? names[i].get<std::string>() : std::string());
  }
  return written;
}

std::string FormatBase64(const std::vector<std::uint8_t>& bytes)
{
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  vtksysBase64_Encode(bytes.data(), bytes.size(), reinterpret_cast<unsigned char*>(text.data()), 0);
  return text;
}

} // namespace nexrad::application
