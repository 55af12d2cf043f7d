// SPDX-License-Identifier: BSD-3-Clause
#include "Web/PageText.h"

#include "Web/Base64.h"
#include "nexrad/Compression/Deflate.h"

#include <cstddef>
#include <utility>

namespace nexrad::embedded
{
extern const unsigned char webPage[];
extern const std::size_t webPageSize;
extern const unsigned char letters[];
extern const std::size_t lettersSize;
extern const unsigned char boldLetters[];
extern const std::size_t boldLettersSize;
} // namespace nexrad::embedded

namespace nexrad::application
{
namespace
{

void ReplaceMark(std::string& text, const std::string& mark, const std::string& by)
{
  text.replace(text.find(mark), mark.size(), by); // a mark that is missing throws
}

} // namespace

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

std::string PageText::Make(const std::string& title) const
{
  std::string page(reinterpret_cast<const char*>(embedded::webPage), embedded::webPageSize);
  ReplaceMark(page, "@TITLE@", EscapeHtml(title));
  ReplaceMark(page, "@PARTS@", parts);
  return page;
}

PageText MakePageWithLetters()
{
  PageText page;
  page.AddPart("letters", {embedded::letters, embedded::letters + embedded::lettersSize});
  page.AddPart(
    "bold-letters", {embedded::boldLetters, embedded::boldLetters + embedded::boldLettersSize});
  return page;
}

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

} // namespace nexrad::application
