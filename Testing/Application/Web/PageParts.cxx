// SPDX-License-Identifier: BSD-3-Clause
#include "PageParts.h"

#include "Level2Bytes.h"

#include <algorithm>

namespace nexrad::testing
{
namespace
{

// Hands out the bytes one by one; 0 and a mark behind the end.
class ByteQueue
{
public:
  explicit ByteQueue(const Bytes& all)
    : bytes(all)
  {
  }

  std::uint8_t Next()
  {
    over = over || place >= bytes.size();
    return over ? std::uint8_t{0} : bytes[place++];
  }

  bool IsUsedUp() const { return !over && place == bytes.size(); }

private:
  const Bytes& bytes;
  std::size_t place = 0;
  bool over = false;
};

std::optional<Bytes> ParseBase64(const std::string& text)
{
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  Bytes bytes;
  std::uint32_t word = 0;
  std::size_t bits = 0;
  for (const char letter : text.substr(0, text.find('=')))
  {
    const std::size_t value = letters.find(letter);
    if (value == std::string::npos)
    {
      return std::nullopt;
    }
    word = word << 6 | static_cast<std::uint32_t>(value);
    bits += 6;
    if (bits >= 8)
    {
      bits -= 8;
      bytes.push_back(static_cast<std::uint8_t>(word >> bits & 255U));
    }
  }
  return bytes;
}

} // namespace

Bytes UnpackColumns(const std::array<int, 3>& size, const Bytes& ends, const Bytes& codes)
{
  const auto width = static_cast<std::size_t>(size[0]);
  const std::size_t layer = width * static_cast<std::size_t>(size[1]);
  Bytes voxels(layer * static_cast<std::size_t>(size[2]));
  ByteQueue endQueue(ends);
  ByteQueue codeQueue(codes);
  std::vector<std::uint8_t> before;
  for (std::size_t column = 0; column < layer; ++column)
  {
    std::vector<std::uint8_t> own(endQueue.Next());
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      const std::uint8_t guess =
        own.size() == before.size() ? before[i] : (i > 0 ? own[i - 1] : std::uint8_t{0});
      own[i] = static_cast<std::uint8_t>(guess + endQueue.Next());
    }
    for (std::size_t z = 0; z < static_cast<std::size_t>(size[2]); ++z)
    {
      const auto passed = std::count_if(own.begin(), own.end(), [&](auto end) { return end <= z; });
      if (passed % 2 == 0)
      {
        continue;
      }
      const std::size_t voxel = z * layer + column;
      std::uint8_t guess = z > 0 ? voxels[voxel - layer] : std::uint8_t{0};
      guess = guess == 0 && column % width > 0 ? voxels[voxel - 1] : guess;
      guess = guess == 0 && column >= width ? voxels[voxel - width] : guess;
      voxels[voxel] = static_cast<std::uint8_t>(guess + codeQueue.Next());
    }
    before = own;
  }
  return endQueue.IsUsedUp() && codeQueue.IsUsedUp() ? voxels : Bytes();
}

std::optional<Bytes> ReadPagePart(const std::string& page, const std::string& id)
{
  const std::string begin = "id=\"" + id + "\">";
  const std::size_t first = page.find(begin);
  if (first == std::string::npos)
  {
    return std::nullopt;
  }
  const std::size_t text = first + begin.size();
  const auto stream = ParseBase64(page.substr(text, page.find('<', text) - text));
  return stream ? InflateStream(*stream) : std::nullopt;
}

} // namespace nexrad::testing
