// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Archives/ForeignFormats.h"

#include "Level2Bytes.h"

#include <gtest/gtest.h>

#include <string>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

std::string NameOf(const std::string& start)
{
  return NameForeignFormat(
    ByteView(reinterpret_cast<const std::uint8_t*>(start.data()), start.size()));
}

} // namespace

TEST(ForeignFormats, AreNamedByTheirFirstBytes)
{
  EXPECT_EQ(NameOf(std::string("PK\3\4\24\0", 6)), "a zip archive; unpack it first");
  EXPECT_EQ(NameOf("\x89HDF\r\n\x1A\n"), "an HDF5 or NetCDF-4 file (ODIM, CfRadial), not Level II");
  EXPECT_EQ(NameOf("CDF\1"), "a NetCDF file, not Level II");
  EXPECT_EQ(NameOf("\xFD"
                   "7zXZ") +
              NameOf(std::string("\xFD"
                                 "7zXZ\0",
                6)),
    "compressed by xz; unpack it first")
    << "all of the first bytes count";
  EXPECT_EQ(NameOf("SDUS54 KOUN 202016"), "a product of Level III, not Level II");
  EXPECT_EQ(NameOf("\1\r\r\n123 \r\r\nSDUS54 KOUN 202016"), "a product of Level III, not Level II");
  std::string iris(64, '\7');
  iris.replace(0, 2, std::string("\x1B\0", 2)).replace(12, 2, std::string("\x1A\0", 2));
  EXPECT_EQ(NameOf(iris), "an IRIS (Sigmet) file, not Level II");
  EXPECT_EQ(NameOf("<!DOCTYPE html>"), "a web page, not the file: download it again");
}

TEST(ForeignFormats, AreNoneOfLevel2)
{
  for (const unsigned type : {1U, 31U})
  {
    const Bytes volume = MakeSmallVolume(type);
    for (const Bytes& bytes : {volume, Gzip(volume), Bzip2(volume), Compress(volume),
           MakeLdmRecord(volume), Bytes(volume.begin() + 24, volume.end())})
    {
      EXPECT_EQ(NameForeignFormat(ByteView(bytes.data(), bytes.size())), "");
    }
  }
  EXPECT_EQ(NameOf(""), "");
}
