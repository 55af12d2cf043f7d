// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/MessageText.h"

#include <cstdio>

namespace nexrad
{

namespace
{

std::string WithoutControl(const std::string& text)
{
  std::string shown;
  unsigned char before = 0;
  for (const char letter : text)
  {
    const auto byte = static_cast<unsigned char>(letter);
    if (IsControlByte(byte, before))
    {
      shown += ControlText(byte);
    }
    else
    {
      shown += letter;
    }
    before = byte;
  }
  return shown;
}

// Whether a letter of several bytes (UTF-8) goes on there.
bool GoesOn(const std::string& text, std::size_t byte)
{
  return byte < text.size() && (static_cast<unsigned char>(text[byte]) & 0xC0U) == 0x80U;
}

} // namespace

bool IsControlByte(unsigned char byte, unsigned char before)
{
  return byte < 0x20 || byte == 0x7F || (before == 0xC2 && byte >= 0x80 && byte < 0xA0);
}

std::string ControlText(unsigned char byte)
{
  char code[5];
  std::snprintf(code, sizeof code, "\\x%02x", byte);
  return code;
}

std::string CountText(std::size_t count, const std::string& noun)
{
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

std::string MessageLine(const std::string& message)
{
  constexpr std::size_t most = 2000;
  constexpr std::size_t end = 500; // what is wrong, behind a long path
  const std::string line = WithoutControl(message);
  if (line.size() <= most)
  {
    return line;
  }
  std::size_t first = most - end;
  while (first > 0 && GoesOn(line, first))
  {
    --first;
  }
  std::size_t second = line.size() - end;
  while (GoesOn(line, second))
  {
    ++second;
  }
  return line.substr(0, first) + "…" + line.substr(second);
}

std::string Shortened(const std::string& message)
{
  constexpr std::size_t most = 300;
  if (message.size() <= most)
  {
    return message;
  }
  std::size_t end = most;
  while (end > 0 && GoesOn(message, end))
  {
    --end;
  }
  return message.substr(0, end) + "…";
}

Error FileError(const std::filesystem::path& path, const std::string& what)
{
  return Error(path.string() + ": " + Shortened(WithoutControl(what)));
}

} // namespace nexrad
