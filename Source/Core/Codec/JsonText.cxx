// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/JsonText.h"

#include "nexrad/System/Error.h"

#include <cstddef>

namespace nexrad
{

namespace
{

// The place of the quotation mark that ends the string which begins at `place`.
std::size_t EndOfString(std::string_view text, std::size_t place)
{
  for (++place; place < text.size() && text[place] != '"'; ++place)
  {
    place += text[place] == '\\' ? 1 : 0;
  }
  return place;
}

} // namespace

void RequireShallowJson(std::string_view text)
{
  constexpr int deepest = 16;
  int depth = 0;
  for (std::size_t place = 0; place < text.size(); ++place)
  {
    const char letter = text[place];
    if (letter == '"')
    {
      place = EndOfString(text, place);
    }
    else if (letter == '[' || letter == '{')
    {
      if (++depth > deepest)
      {
        throw Error("byte " + std::to_string(place) +
                    " of the JSON text: lists and objects more than " + std::to_string(deepest) +
                    " deep within each other");
      }
    }
    else if (letter == ']' || letter == '}')
    {
      --depth;
    }
  }
}

std::string Excerpt(const std::string& text, std::size_t longest)
{
  return text.size() <= longest ? text : text.substr(0, longest) + "…";
}

} // namespace nexrad
