// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Level2Bytes.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// Tar archives made byte by byte, from the tables of POSIX: SYNTHETIC.
namespace nexrad::testing
{

struct TarEntry
{
  std::string name;
  Bytes content;
  char type = '0';
};

/// A header of 512 bytes with its check sum.
Bytes MakeTarHeader(const std::string& name, std::uint64_t size, char type = '0');

/// Puts the right check sum into a header that was changed.
void SetTarCheckSum(Bytes& header);

/// A header, and the content filled up with zeros to blocks.
Bytes MakeTarMember(const TarEntry& entry);

/// Members, and the two blocks of zeros at the end.
Bytes MakeTar(const std::vector<TarEntry>& entries);

/// Writes bytes to a file and returns its path.
std::filesystem::path WriteBytes(const std::filesystem::path& path, const Bytes& bytes);

} // namespace nexrad::testing
