// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvFile.h"

#include "ErrorMessage.h"
#include "TestData.h"
#include "Tolerance.h"
#include "VolumeMaker.h"
#include "nexrad/Codec/JsonText.h"
#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>

using namespace nexrad;
using nexrad::testing::AddAncillary;
using nexrad::testing::FileContent;
using nexrad::testing::MakeGriddedVolume;
using nexrad::testing::MessageOf;
using nexrad::testing::TemporaryFolder;

namespace
{

namespace fs = std::filesystem;

// A folder with one file in it that is written again and again.
class Damaged
{
public:
  const fs::path& Path() const { return path; }

  void Write(const std::string& content) const
  {
    // Some file systems wait for the disk when a file is cut to nothing and written again.
    fs::remove(path);
    std::ofstream(path, std::ios::binary) << content;
  }

  // The error of reading it, "" when it is read.
  std::string ErrorOf(const std::string& content) const
  {
    this->Write(content);
    return MessageOf(
      [&]
      {
        last = ReadNxv(path);
        for (std::size_t level = ReadNxvLevels(path).size() - 1; level > 0; --level)
        {
          NxvReadOptions options;
          options.level = level;
          ReadNxv(path, options);
        }
      });
  }

  const GriddedVolume& Last() const { return last; }

private:
  TemporaryFolder folder;
  fs::path path = folder.Path() / "a.nxv";
  mutable GriddedVolume last;
};

// A volume file whose header and payload can be set at will; CRC and lengths are right.
std::string FileOf(NxvHeader header, const std::vector<std::string>& payloads)
{
  std::string end;
  for (std::size_t i = 0; i < payloads.size(); ++i)
  {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(payloads[i].data());
    header.arrays[i].length = payloads[i].size();
    header.arrays[i].crc32 = Crc32(bytes, payloads[i].size());
    end += payloads[i];
  }
  const std::string text = FormatNxvHeader(header);
  std::string start = "NXV1";
  for (unsigned shift = 0; shift < 32; shift += 8)
  {
    start.push_back(static_cast<char>(text.size() >> shift & 0xFF));
  }
  return start + text + end;
}

NxvHeader SmallHeader()
{
  NxvHeader header;
  header.volume = MakeGriddedVolume({2, 2, 1});
  header.arrays.resize(1);
  header.arrays[0].name = "REF";
  return header;
}

std::string Deflated(const std::string& text)
{
  const auto bytes = DeflateBytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  return {bytes.begin(), bytes.end()};
}

// Files of every encoding, all but the first with ancillary arrays, as codes and as floats.
std::vector<std::string> GoodFiles()
{
  const TemporaryFolder folder;
  GriddedVolume volume = MakeGriddedVolume({3, 2, 2});
  volume.states[1] = VoxelState::RangeFolded;
  std::vector<std::string> files;
  for (const auto encoding : {NxvEncoding::Thesis, NxvEncoding::Float, NxvEncoding::RadarSteps})
  {
    if (encoding == NxvEncoding::Float)
    {
      AddAncillary(volume);
    }
    WriteNxv(folder.Path() / "a.nxv", volume, encoding);
    files.push_back(FileContent(folder.Path() / "a.nxv"));
  }
  for (const GriddedVolume& each : {volume, MakeGriddedVolume({513, 2, 1})}) // the second in levels
  {
    NxvBandWriter bricks(folder.Path() / "a.nxv", each.grid);
    bricks.Add(each);
    bricks.Commit();
    files.push_back(FileContent(folder.Path() / "a.nxv"));
  }
  return files;
}

} // namespace

// An index, and bricks, that contradict the grid or each other.
TEST(NxvDamage, BricksMustFitTheGrid)
{
  const Damaged file;
  NxvHeader header = SmallHeader(); // 2 x 2 x 1 voxels: one brick
  header.arrays[0].type = NxvType::UInt8;
  header.arrays[0].storage = NxvStorage::Bricks;
  header.arrays[0].brick = {64, 64, 8};
  const auto errorOf = [&](const std::string& index, const std::string& bricks)
  {
    header.arrays[0].indexLength = index.size();
    return file.ErrorOf(FileOf(header, {index + bricks}));
  };
  const std::string codes = Deflated(std::string("\x50\x50\x50\x51", 4));
  const auto entry = [](std::size_t length)
  { return std::string(1, static_cast<char>(length)) + std::string(7, '\0'); };
  EXPECT_EQ(errorOf(Deflated(entry(codes.size())), codes), "");
  EXPECT_EQ(errorOf(Deflated(entry(0)), ""), ""); // all voxels have code 0
  EXPECT_NE(errorOf(Deflated(entry(codes.size() + 1)), codes).find("longer than its payload"),
    std::string::npos);
  EXPECT_NE(
    errorOf(Deflated(entry(codes.size() - 1)), codes).find("bytes of bricks"), std::string::npos);
  EXPECT_NE(errorOf(Deflated(entry(0) + entry(0)), ""), "");   // of two bricks
  EXPECT_NE(errorOf(Deflated(entry(4).substr(1)), codes), ""); // of less than one
  EXPECT_NE(errorOf(Deflated(entry(12)), Deflated("abc")), "");
  for (const std::array<int, 3>& size :
    {std::array<int, 3>{0, 64, 64}, {7, 8, 9}, {-1, 64, 64}, {4096, 4096, 2}})
  {
    header.arrays[0].brick = size;
    EXPECT_NE(errorOf(Deflated(entry(0)), "").find("must be 2^9 to 2^24"), std::string::npos);
  }
  header.arrays[0].brick = {64, 64, 8};
  header.arrays[0].indexLength = 1000;
  EXPECT_NE(
    file.ErrorOf(FileOf(header, {"abc"})).find("an index of 1000 bytes"), std::string::npos);
  header.volume.grid.dimensions = {30000, 30000, 2}; // whose index is longer than it can be
  header.arrays[0].indexLength = 3;
  EXPECT_NE(
    file.ErrorOf(FileOf(header, {"abc"})).find("cannot be decompressed"), std::string::npos);
}

TEST(NxvDamage, EveryTruncationIsAnError)
{
  const Damaged file;
  for (const std::string& content : GoodFiles())
  {
    for (std::size_t length = 0; length < content.size(); ++length)
    {
      const std::string error = file.ErrorOf(content.substr(0, length));
      EXPECT_EQ(error.rfind(file.Path().string() + ": byte ", 0), 0u) << length << ": " << error;
    }
    EXPECT_EQ(file.ErrorOf(content), "");
    EXPECT_NE(file.ErrorOf(content + "x"), "");
  }
}

// The CRCs cover header and payloads: a flipped bit is found, or it changes nothing (it fell into
// the name of the key that holds the header's own CRC). One bit of each byte, a different one from
// byte to byte.
TEST(NxvDamage, AFlippedBitIsFoundOrHarmless)
{
  const Damaged file;
  for (const std::string& content : GoodFiles())
  {
    ASSERT_EQ(file.ErrorOf(content), "");
    const GriddedVolume good = file.Last();
    std::size_t unnoticed = 0;
    for (std::size_t byte = 0; byte < content.size(); ++byte)
    {
      std::string damaged = content;
      damaged[byte] = static_cast<char>(damaged[byte] ^ (1 << (byte * 3) % 8));
      if (file.ErrorOf(damaged).empty())
      {
        ++unnoticed;
        EXPECT_EQ(file.Last().values, good.values) << "byte " << byte;
        EXPECT_EQ(file.Last().states, good.states) << "byte " << byte;
        EXPECT_EQ(file.Last().ancillary.age, good.ancillary.age) << "byte " << byte;
        EXPECT_EQ(file.Last().ancillary.nearestSite, good.ancillary.nearestSite);
        EXPECT_EQ(file.Last().grid.origin, good.grid.origin) << "byte " << byte;
        EXPECT_EQ(file.Last().time, good.time) << "byte " << byte;
        EXPECT_EQ(file.Last().sites, good.sites) << "byte " << byte;
      }
    }
    EXPECT_AT_MOST(unnoticed, sizeof(",\"header_crc32\":"), "bytes whose change goes unnoticed");
  }
}

// Levels whose header or payloads contradict the volume or the file.
TEST(NxvDamage, LevelsMustFitTheFile)
{
  const Damaged file;
  NxvHeader header = SmallHeader();
  NxvArray coarse = header.arrays[0];
  const std::string payload = "\x81"; // of 1 x 1 x 1 voxel
  coarse.length = payload.size();
  coarse.crc32 = Crc32(reinterpret_cast<const std::uint8_t*>(payload.data()), payload.size());
  const auto errorOf =
    [&](const VoxelsInOne& voxels, const std::vector<NxvArray>& arrays, const std::string& end)
  {
    header.levels = {{voxels, arrays}};
    return file.ErrorOf(FileOf(header, {"\x81\x82\x83\x84"}) + end);
  };
  EXPECT_EQ(errorOf({2, 2, 1}, {coarse}, payload), "");
  EXPECT_NE(errorOf({2, 2, 1}, {coarse}, "").find("should have 1 bytes, the file has 0"),
    std::string::npos);
  EXPECT_NE(errorOf({2, 2, 1}, {coarse}, payload + "x").find("1 bytes after the last array"),
    std::string::npos);
  EXPECT_NE(errorOf({2, 1, 1}, {coarse}, payload), "") << "two voxels, of which one is there";
  EXPECT_NE(errorOf({2, 2, 0}, {coarse}, payload).find("must be 1 to 2^16"), std::string::npos);
  EXPECT_NE(errorOf({2, -2, 1}, {coarse}, payload), "");
  EXPECT_NE(errorOf({2, 2, 1}, {}, payload).find("must be a moment"), std::string::npos);
  coarse.name = "VEL";
  EXPECT_NE(errorOf({2, 2, 1}, {coarse}, payload), "");
}

TEST(NxvDamage, StreamsThatDoNotFitTheGridAreErrors)
{
  const Damaged file;
  const NxvHeader header = SmallHeader();
  EXPECT_EQ(file.ErrorOf(FileOf(header, {"\x81\x82\x83\x84"})), "");
  for (const std::string& stream : {std::string(), std::string("\x81\x82\x83"),
         std::string("\x81\x82\x83\x84\x85"), std::string("\x05\x00\x00\x00\x00\x81\x81\x81", 8),
         std::string("\x05\xFF\xFF\xFF\xFF", 5), std::string("\x05\x04\x00\x00", 4)})
  {
    const std::string error = file.ErrorOf(FileOf(header, {stream}));
    EXPECT_NE(error.find("array \"REF\""), std::string::npos) << error;
    EXPECT_NE(error.find("run-length stream"), std::string::npos) << error;
  }
}

// 4 MiB of zeros deflate to a few KiB; no more than a piece of them may come out.
TEST(NxvDamage, ADeflatedStreamCannotGrowBeyondTheGrid)
{
  const Damaged file;
  const std::string bomb = Deflated(std::string(4 << 20, '\0'));
  NxvHeader header = SmallHeader();
  header.arrays[0].type = NxvType::Float32;
  header.arrays[0].storage = NxvStorage::Deflated;
  EXPECT_NE(file.ErrorOf(FileOf(header, {bomb})).find("more than 16 bytes"), std::string::npos);
  EXPECT_NE(file.ErrorOf(FileOf(header, {Deflated("short")})), "");
  EXPECT_NE(file.ErrorOf(FileOf(header, {Deflated(std::string(16, 'x')) + "more"})), "");
  EXPECT_NE(file.ErrorOf(FileOf(header, {"no deflated stream"})), "");
  EXPECT_EQ(file.ErrorOf(FileOf(header, {Deflated(std::string(16, 'x'))})), "");
}

// Five bytes may stand for two billion voxels: that is no damage, but it needs leave.
TEST(NxvDamage, AGridBeyondTheMemoryAllowedIsAnError)
{
  const Damaged file;
  NxvHeader header = SmallHeader();
  header.volume.grid.dimensions = {2048, 1024, 1023};
  const std::string content = FileOf(header, {std::string("\x00\x00\x00\xE0\x7F", 5)});
  EXPECT_NE(file.ErrorOf(content).find("more memory than"), std::string::npos);
  EXPECT_EQ(ReadNxvHeader(file.Path()).grid.dimensions[0], 2048);
  file.Write(FileOf(SmallHeader(), {"\x81\x82\x83\x84"}));
  EXPECT_THROW(ReadNxv(file.Path(), {23}), Error);
  EXPECT_EQ(ReadNxv(file.Path(), {24}).values.size(), 4u);
}

// A deflated byte stands for 1032 at most: no memory is taken for voxels that a file cannot hold.
TEST(NxvDamage, AGridThatItsBytesCannotHoldIsAnError)
{
  const Damaged file;
  NxvHeader header = SmallHeader();
  header.arrays[0].type = NxvType::UInt8;
  header.arrays[0].storage = NxvStorage::Deflated;
  header.volume.grid.dimensions = {100, 100, 100};
  const std::string all = Deflated(std::string(1'000'000, '\0'));
  EXPECT_EQ(file.ErrorOf(FileOf(header, {all})), "");
  EXPECT_NE(file.ErrorOf(FileOf(header, {all.substr(0, 900)}))
              .find("900 bytes cannot be decompressed to 1000000"),
    std::string::npos);
  header.arrays[0].type = NxvType::Float32;
  EXPECT_NE(file.ErrorOf(FileOf(header, {all})).find("cannot be decompressed to 4000000"),
    std::string::npos);
}

TEST(NxvDamage, StatesMayNotContradictTheCodes)
{
  const Damaged file;
  NxvHeader header = SmallHeader();
  header.arrays.resize(2);
  header.arrays[1].name = "REF_state";
  header.arrays[1].type = NxvType::UInt8;
  header.arrays[1].storage = NxvStorage::Deflated;
  const std::string codes = "\x80\x80\xA3\xFF"; // no echo, no echo, 35 dBZ, not scanned
  const auto errorWith = [&](const std::string& states) {
    return file.ErrorOf(FileOf(header, {codes, Deflated(states)}));
  };
  EXPECT_EQ(errorWith(std::string("\1\2\0\3", 4)), "");
  EXPECT_EQ(file.Last().states[1], VoxelState::RangeFolded);
  EXPECT_NE(errorWith(std::string("\1\1\2\3", 4)).find("voxel 2"), std::string::npos);
  EXPECT_NE(errorWith(std::string("\1\1\0\2", 4)).find("voxel 3"), std::string::npos);
  EXPECT_NE(errorWith(std::string("\1\5\0\3", 4)).find("voxel 1"), std::string::npos);
}

// Such values were taken for those of no echo, in pictures and in files written again.
TEST(NxvDamage, FloatsWithoutEchoGetTheFillValue)
{
  const Damaged file;
  NxvHeader header = SmallHeader();
  header.arrays.resize(2);
  header.arrays[0].type = NxvType::Float32;
  header.arrays[0].storage = NxvStorage::Deflated;
  header.arrays[0].fill = -33.0;
  header.arrays[1].name = "REF_state";
  header.arrays[1].type = NxvType::UInt8;
  header.arrays[1].storage = NxvStorage::Deflated;
  const std::string ones("\0\0\x80\x3F\0\0\x80\x3F\0\0\x80\x3F\0\0\x80\x3F", 16);
  EXPECT_EQ(
    file.ErrorOf(FileOf(header, {Deflated(ones), Deflated(std::string("\0\1\2\3", 4))})), "");
  EXPECT_EQ(file.Last().values, (std::vector<float>{1.0F, -33.0F, -33.0F, -33.0F}));
}

TEST(NxvDamage, FilteredVoxelsMayNotContradictTheCodes)
{
  const Damaged file;
  NxvHeader header = SmallHeader();
  header.arrays.resize(2);
  header.arrays[1].name = "REF_filtered";
  header.arrays[1].type = NxvType::UInt8;
  header.arrays[1].storage = NxvStorage::Deflated;
  const std::string codes = "\x80\x80\xA3\xFF"; // no echo, no echo, 35 dBZ, not scanned
  const auto errorWith = [&](const std::string& filtered) {
    return file.ErrorOf(FileOf(header, {codes, Deflated(filtered)}));
  };
  EXPECT_EQ(errorWith(std::string("\0\1\0\0", 4)), "");
  EXPECT_EQ(file.Last().states[0], VoxelState::NoEcho);
  EXPECT_EQ(file.Last().states[1], VoxelState::Filtered);
  EXPECT_NE(errorWith(std::string("\0\0\1\0", 4)).find("voxel 2"), std::string::npos);
  EXPECT_NE(errorWith(std::string("\0\0\0\1", 4)).find("voxel 3"), std::string::npos);
  EXPECT_NE(errorWith(std::string("\2\0\0\0", 4)).find("voxel 0"), std::string::npos);
}

// The reader used to write states into memory that was not there.
TEST(NxvDamage, StatesBeforeTheirMomentAreErrors)
{
  for (const char* name : {"VEL_state", "VEL_filtered"})
  {
    const Damaged file;
    NxvHeader header = SmallHeader();
    header.arrays.resize(3, header.arrays[0]);
    header.arrays[1].name = name;
    header.arrays[1].type = NxvType::UInt8;
    header.arrays[1].storage = NxvStorage::Deflated;
    header.arrays[2].name = "VEL";
    const std::string codes = "\x80\x80\xA3\xFF";
    const std::string error =
      file.ErrorOf(FileOf(header, {codes, Deflated(std::string("\1\1\0\3", 4)), codes}));
    EXPECT_NE(error.find("must follow the array VEL"), std::string::npos) << error;
  }
}

// Codes of one byte, and of two: lower bytes first.
TEST(NxvDamage, DeflatedCodesThatDoNotFitAreErrors)
{
  const Damaged file;
  NxvHeader header = SmallHeader();
  header.arrays[0].storage = NxvStorage::Deflated;
  header.arrays[0].type = NxvType::UInt8;
  header.arrays[0].offset = header.arrays[0].fill = -33.0;
  header.arrays[0].scale = 0.5;
  EXPECT_EQ(file.ErrorOf(FileOf(header, {Deflated(std::string("\0\1\2\xFF", 4))})), "");
  EXPECT_EQ(file.Last().states, (std::vector<VoxelState>{VoxelState::NoEcho, VoxelState::NotScanned,
                                  VoxelState::Echo, VoxelState::Echo}));
  EXPECT_EQ(file.Last().values, (std::vector<float>{-33.0F, -33.0F, -32.0F, 94.5F}));
  EXPECT_NE(
    file.ErrorOf(FileOf(header, {Deflated("abc")})).find("array \"REF\""), std::string::npos);
  EXPECT_NE(file.ErrorOf(FileOf(header, {Deflated("abcde")})), "");
  header.arrays[0].type = NxvType::UInt16;
  const std::string words("\0\1\2\2\0\0\0\1", 8);
  EXPECT_EQ(file.ErrorOf(FileOf(header, {Deflated(words)})), "");
  EXPECT_EQ(file.Last().values, (std::vector<float>{-33.0F, -33.0F, -32.0F, 96.0F}));
  EXPECT_NE(file.ErrorOf(FileOf(header, {Deflated(words.substr(4))})), "");
  EXPECT_THROW(ReadNxv(file.Path(), {27}), Error) << "six bytes a voxel and the wider code";
}

// Pieces of four bytes, which hold what the header says and end where it says.
TEST(NxvDamage, PiecesThatDoNotFitAreErrors)
{
  const Damaged file;
  NxvHeader header = SmallHeader();
  header.volume.grid.dimensions = {5, 2, 1};
  header.arrays[0].storage = NxvStorage::Deflated;
  header.arrays[0].type = NxvType::UInt8;
  const std::string codes("\0\1\2\xFF\7\7\7\7\x8\x9", 10);
  const DeflatedPieces pieces =
    DeflateInPieces([&codes](std::size_t first, std::size_t count, std::uint8_t* to)
      { std::copy_n(codes.begin() + static_cast<std::ptrdiff_t>(first), count, to); },
      codes.size(), 4);
  const std::string payload(pieces.stream.begin(), pieces.stream.end());
  ASSERT_EQ(pieces.lengths.size(), 3u);
  const auto errorWith = [&](std::uint64_t pieceBytes, const std::vector<std::uint64_t>& lengths)
  {
    header.arrays[0].pieceBytes = pieceBytes;
    header.arrays[0].pieces = lengths;
    return file.ErrorOf(FileOf(header, {payload}));
  };
  const auto [a, b, c] = std::array{pieces.lengths[0], pieces.lengths[1], pieces.lengths[2]};
  EXPECT_EQ(errorWith(4, {a, b, c}), "");
  EXPECT_EQ(file.Last().values[6], 7.0F);
  for (const std::uint64_t wrongBytes : {3, 5})
  {
    EXPECT_NE(errorWith(wrongBytes, {a, b, c}).find("array \"REF\""), std::string::npos);
  }
  for (const auto& lengths : std::vector<std::vector<std::uint64_t>>{{a + 1, b - 1, c},
         {a - 1, b + 1, c}, {a, b + 1, c - 1}, {a, b + c}, {a + b + c}, {1, a - 1, b + c}})
  {
    EXPECT_NE(errorWith(4, lengths), "");
  }
  // Those that the header alone refuses.
  for (const auto& lengths : std::vector<std::vector<std::uint64_t>>{
         {a, b}, {a, b, c, 1}, {a, b, c, 0}, {~std::uint64_t(0), a, b, c}})
  {
    EXPECT_NE(errorWith(4, lengths).find("header: array \"REF\""), std::string::npos);
  }
  EXPECT_NE(errorWith(0, {a, b, c}).find("header"), std::string::npos);
  EXPECT_NE(errorWith(std::uint64_t(1) << 31, {a, b, c}).find("header"), std::string::npos);
}

TEST(NxvDamage, AnArrayOfAnotherNameIsPassedOver)
{
  const Damaged file;
  for (const char* name : {"REF_quality", "VEL_age", "age"})
  {
    NxvHeader header = SmallHeader();
    header.arrays.resize(2);
    header.arrays[1].name = name;
    header.arrays[1].type = NxvType::Float32;
    header.arrays[1].storage = NxvStorage::Deflated;
    EXPECT_EQ(file.ErrorOf(FileOf(header, {"\x81\x82\x83\x84", Deflated("anything")})), "");
    EXPECT_TRUE(file.Last().ancillary.age.empty());
  }
}

TEST(NxvDamage, AncillaryArraysThatCannotBeAreErrors)
{
  const Damaged file;
  const auto errorWith = [&](const std::string& name, NxvType type, const std::string& bytes)
  {
    NxvHeader header = SmallHeader(); // of two sites
    header.arrays.resize(2);
    header.arrays[1].name = name;
    header.arrays[1].type = type;
    header.arrays[1].storage = NxvStorage::Deflated;
    return file.ErrorOf(FileOf(header, {"\x81\x82\x83\x84", Deflated(bytes)}));
  };
  const std::string ones("\0\0\x80\x3F\0\0\x80\x3F\0\0\x80\x3F\0\0\x80\x3F", 16);
  for (const char* name : {"REF_age", "REF_weight"})
  {
    EXPECT_EQ(errorWith(name, NxvType::Float32, ones), "");
    for (const std::string& bad : {std::string("\0\0\x80\xBF", 4), std::string("\0\0\xC0\x7F", 4),
           std::string("\0\0\x80\x7F", 4)}) // −1, NaN, infinity
    {
      const std::string error =
        errorWith(name, NxvType::Float32, std::string(ones).replace(8, 4, bad));
      EXPECT_NE(error.find(std::string("array \"") + name), std::string::npos) << error;
      EXPECT_NE(error.find("voxel 2"), std::string::npos) << error;
    }
    EXPECT_EQ(errorWith(name, NxvType::UInt8, "abcd"), ""); // codes
    EXPECT_NE(errorWith(name, NxvType::Float32, "short"), "");
    EXPECT_NE(errorWith(name, NxvType::Float32, ones + "more"), "");
  }
  EXPECT_EQ(errorWith("REF_radars", NxvType::UInt8, std::string("\0\1\2\7", 4)), "");
  EXPECT_EQ(errorWith("REF_site", NxvType::UInt8, std::string("\0\1\xFF\1", 4)), "");
  EXPECT_NE(errorWith("REF_site", NxvType::UInt8, std::string("\0\1\1\2", 4)).find("voxel 3"),
    std::string::npos);
  EXPECT_NE(errorWith("REF_site", NxvType::Float32, ones).find("must be uint8"), std::string::npos);
}

TEST(NxvDamage, HeadersOutOfRangeAreErrors)
{
  const Damaged file;
  const auto errorAfter = [&file](const std::function<void(NxvHeader&)>& change)
  {
    NxvHeader header = SmallHeader();
    change(header);
    return file.ErrorOf(FileOf(header, {"\x81\x82\x83\x84"}));
  };
  const auto dimensions = [](std::array<int, 3> size)
  { return [size](NxvHeader& header) { header.volume.grid.dimensions = size; }; };
  EXPECT_EQ(errorAfter([](NxvHeader&) {}), "");
  EXPECT_NE(errorAfter(dimensions({0, 2, 2})).find("dimensions"), std::string::npos);
  EXPECT_NE(errorAfter(dimensions({-2, -2, 1})).find("dimensions"), std::string::npos);
  EXPECT_NE(errorAfter(dimensions({65'536, 65'536, 1})).find("dimensions"), std::string::npos);
  EXPECT_NE(errorAfter([](NxvHeader& header) { header.volume.grid.spacing[1] = 0.0; }), "");
  EXPECT_NE(errorAfter([](NxvHeader& header) { header.volume.grid.centreLatitude = 91.0; }), "");
  EXPECT_NE(errorAfter([](NxvHeader& header) { header.arrays[0].name = "XYZ"; }), "");
  EXPECT_NE(errorAfter([](NxvHeader& header) { header.arrays[0].scale = 0.0; }), "");
  EXPECT_NE(errorAfter([](NxvHeader& header) { header.arrays[0].fill = 1e300; }), "");
  EXPECT_NE(
    errorAfter([](NxvHeader& header) { header.arrays[0].storage = NxvStorage::Deflated; }), "");
}

// Earlier versions could deflate the thesis's stream.
TEST(NxvDamage, AnEncodingOfEarlierVersionsIsNamed)
{
  const Damaged file;
  std::string content = FileOf(SmallHeader(), {"\x81\x82\x83\x84"});
  content.replace(content.find("\"rle\""), 5, "\"rle+deflate\"");
  content.replace(content.find("\"header_crc32\""), 14, "\"other\"");
  content[4] = static_cast<char>(content[4] + 8 - 7);
  EXPECT_NE(file.ErrorOf(content).find("encoding \"rle+deflate\" is not known"), std::string::npos)
    << file.ErrorOf(content);
}

TEST(NxvDamage, HeadersThatAreNoHeadersAreErrors)
{
  for (const std::string& text :
    {std::string(), std::string("{"), std::string("[]"), std::string("{}"), std::string("null"),
      std::string("\xFF\xFE"), std::string(100'000, '['), std::string("{\"dimensions\":\"all\"}"),
      std::string("{\"dimensions\":[1,2]}"), std::string("{\"dimensions\":[1,2,1e400]}")})
  {
    EXPECT_THROW(ParseNxvHeader(text), Error) << text.substr(0, 40);
  }
}

// Such a header was written out again for the message, one call within the other.
TEST(NxvDamage, AHeaderTooDeepIsAnError)
{
  const std::string deep(80'000, '[');
  const std::string text = "{\"dimensions\":" + deep + std::string(80'000, ']') + "}";
  const std::string problem = MessageOf([&] { ParseNxvHeader(text); });
  EXPECT_EQ(
    problem, "byte 29 of the JSON text: lists and objects more than 16 deep within each other");
  // Brackets in strings are letters.
  EXPECT_THROW(ParseNxvHeader("{\"dimensions\":\"" + deep + "\"}"), Error);
  RequireShallowJson("[\"" + deep + "\\\"[[\", 1]");
}

TEST(NxvDamage, AnErrorShowsNoMoreOfAValueThanFitsALine)
{
  const Damaged file;
  NxvHeader header = SmallHeader();
  header.volume.grid.dimensions = {0, 1, 1};
  std::string text = FormatNxvHeader(header);
  text.resize(text.rfind(",\"header_crc32\""));
  text.insert(text.find("[0,1,1]") + 1, "\"" + std::string(1'000, 'x') + "\",");
  text.replace(text.find(",0,1,1]"), 7, ",0,1]");
  const std::string problem = MessageOf([&] { ParseNxvHeader(text + "}"); });
  EXPECT_NE(problem, "");
  EXPECT_LT(problem.size(), 200U) << problem;
}

TEST(NxvDamage, WhatTheCallerMakesOfAVoxelCounts)
{
  const Damaged file;
  file.Write(FileOf(SmallHeader(), {"\x81\x82\x83\x84"}));
  NxvReadOptions options;
  options.maximumBytes = 4 * 6;
  EXPECT_NO_THROW(ReadNxv(file.Path(), options));
  options.bytesBesides = 1;
  EXPECT_THROW(ReadNxv(file.Path(), options), Error);
}

TEST(NxvDamage, NoFileIsOneClearLine)
{
  const TemporaryFolder folder;
  const std::string problem = MessageOf([&] { ReadNxv(folder.Path() / "none.nxv"); });
  EXPECT_EQ(
    problem, (folder.Path() / "none.nxv").string() + ": cannot be read: No such file or directory");
  EXPECT_THROW(ReadNxv(folder.Path()), Error);
  EXPECT_THROW(ReadNxvHeader("/dev/null"), Error);
}
