// SPDX-License-Identifier: BSD-3-Clause
#include "Feed/TarMaker.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <numeric>

namespace nexrad::testing
{

namespace
{

constexpr std::size_t blockBytes = 512;
constexpr std::size_t sumPlace = 148;

} // namespace

void SetTarCheckSum(Bytes& header)
{
  std::fill_n(header.begin() + sumPlace, 8, std::uint8_t(' '));
  const unsigned sum = std::accumulate(header.begin(), header.begin() + blockBytes, 0U);
  char text[8];
  std::snprintf(text, sizeof text, "%06o", sum & 0777777U);
  std::copy_n(text, 7, header.begin() + sumPlace);
}

Bytes MakeTarHeader(const std::string& name, std::uint64_t size, char type)
{
  char digits[13];
  std::snprintf(
    digits, sizeof digits, "%011llo", static_cast<unsigned long long>(size & 077777777777ULL));
  Bytes header = BlockWriter(blockBytes)
                   .Text(0, name.substr(0, 100))
                   .Text(100, "0000644")
                   .Text(124, digits)
                   .Text(136, "14567012345")
                   .U8(156, static_cast<unsigned char>(type))
                   .Text(257, "ustar")
                   .Text(263, "00")
                   .Take();
  SetTarCheckSum(header);
  return header;
}

Bytes MakeTarMember(const TarEntry& entry)
{
  Bytes member = MakeTarHeader(entry.name, entry.content.size(), entry.type);
  member.insert(member.end(), entry.content.begin(), entry.content.end());
  member.resize((member.size() + blockBytes - 1) / blockBytes * blockBytes);
  return member;
}

Bytes MakeTar(const std::vector<TarEntry>& entries)
{
  Bytes tar;
  for (const TarEntry& entry : entries)
  {
    const Bytes member = MakeTarMember(entry);
    tar.insert(tar.end(), member.begin(), member.end());
  }
  tar.resize(tar.size() + 2 * blockBytes);
  return tar;
}

std::filesystem::path WriteBytes(const std::filesystem::path& path, const Bytes& bytes)
{
  std::ofstream(path, std::ios::binary)
    .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return path;
}

} // namespace nexrad::testing
