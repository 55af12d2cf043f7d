// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzTarget.h"

#include <cstdio>
#include <cstdlib>

namespace nexrad::testing
{

void Require(bool holds, const char* promise)
{
  if (!holds)
  {
    std::fprintf(stderr, "broken promise: %s\n", promise);
    std::abort();
  }
}

void RequireMessage(const std::string& message)
{
  constexpr std::size_t longest = 2'000;
  if (message.empty() || message.size() > longest || message.find('\n') != std::string::npos)
  {
    std::fprintf(stderr, "message of %zu bytes: %.300s\n", message.size(), message.c_str());
    Require(false, "a message is one line of at most 2000 bytes");
  }
}

Bytes BytesOf(const std::string& text)
{
  return {text.begin(), text.end()};
}

InputFile::InputFile(const std::string& name)
  : path(folder.Path() / name)
{
}

void InputFile::Write(const std::uint8_t* data, std::size_t size) const
{
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  Require(file != nullptr, "the temporary folder can be written to");
  // No bytes may have no address.
  Require(size == 0 || std::fwrite(data, 1, size, file) == size, "the temporary folder has room");
  std::fclose(file);
}

} // namespace nexrad::testing
