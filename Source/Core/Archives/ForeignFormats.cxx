// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Archives/ForeignFormats.h"

#include <algorithm>
#include <string_view>

namespace nexrad
{

namespace
{

using namespace std::string_view_literals;

struct ForeignFormat
{
  std::string_view firstBytes;
  const char* name;
};

// Archives and compressors; formats of radar data; and what servers send in place of a file.
constexpr ForeignFormat foreignFormats[] = {
  {"PK\3\4"sv, "a zip archive; unpack it first"},
  {"PK\5\6"sv, "an empty zip archive"},
  {"7z\xBC\xAF\x27\x1C"sv, "a 7z archive; unpack it first"},
  {"Rar!\x1A\7"sv, "a rar archive; unpack it first"},
  {"\xFD"
   "7zXZ\0"sv,
    "compressed by xz; unpack it first"},
  {"\x28\xB5\x2F\xFD"sv, "compressed by zstd; unpack it first"},
  {"\x89HDF\r\n\x1A\n"sv, "an HDF5 or NetCDF-4 file (ODIM, CfRadial), not Level II"},
  {"CDF\1"sv, "a NetCDF file, not Level II"},
  {"CDF\2"sv, "a NetCDF file, not Level II"},
  {"CDF\5"sv, "a NetCDF file, not Level II"},
  {"GRIB"sv, "a GRIB file, not Level II"},
  {"SSWB"sv, "a DORADE file, not Level II"},
  {"VOLD"sv, "a DORADE file, not Level II"},
  {"<!DOCTYPE"sv, "a web page, not the file: download it again"},
  {"<!doctype"sv, "a web page, not the file: download it again"},
  {"<html"sv, "a web page, not the file: download it again"},
  {"<?xml"sv, "an XML text, perhaps the refusal of a server: download the file again"},
};

// Products of Level III stand behind the heading of the weather service: "SDUS54 KOUN 202016".
bool IsLevel3(std::string_view start)
{
  constexpr std::size_t longestControl = 24; // bytes of the transmission before the heading
  const std::size_t place = start.find("SDUS"sv);
  return place <= longestControl;
}

// IRIS begins with the headers of its structures 27, a product, and 26, the product's
// configuration, little-endian, 12 bytes each (IRIS Programming Guide, M211318EN, chapter 4).
bool IsIris(std::string_view start)
{
  return start.substr(0, 2) == "\x1B\0"sv && start.size() > 14 && start.substr(12, 2) == "\x1A\0"sv;
}

} // namespace

std::string NameForeignFormat(ByteView bytes)
{
  const ByteView first = bytes.Sub(0, foreignStartBytes);
  const std::string_view start(reinterpret_cast<const char*>(first.Data()), first.Size());
  const auto* const found = std::find_if(std::begin(foreignFormats), std::end(foreignFormats),
    [start](const ForeignFormat& format)
    { return start.substr(0, format.firstBytes.size()) == format.firstBytes; });
  if (found != std::end(foreignFormats))
  {
    return found->name;
  }
  return IsLevel3(start) ? "a product of Level III, not Level II"
         : IsIris(start) ? "an IRIS (Sigmet) file, not Level II"
                         : "";
}

} // namespace nexrad
