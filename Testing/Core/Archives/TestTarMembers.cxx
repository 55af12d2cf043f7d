// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Archives/Archive.h"

#include "Feed/TarMaker.h"
#include "TestData.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

struct Listing
{
  std::map<std::string, std::string> members; // contents by name
  std::vector<ArchiveProblem> problems;
};

Listing ListBytes(const Bytes& bytes)
{
  static const TemporaryFolder folder;
  const auto file = FilePart::Open(WriteBytes(folder.Path() / "some.tar", bytes));
  const Archive archive = ReadArchive(*file);
  Listing listing;
  for (const auto& [name, content] : archive.members)
  {
    const std::vector<std::uint8_t> found = content.Start(1U << 20);
    listing.members[name] = std::string(found.begin(), found.end());
  }
  listing.problems = archive.problems;
  return listing;
}

Bytes BytesOf(const std::string& text)
{
  return {text.begin(), text.end()};
}

// A header with these bytes in place of its size.
Bytes HeaderWithSize(const Bytes& size)
{
  Bytes header = MakeTarHeader("sized", 0);
  std::copy(size.begin(), size.end(), header.begin() + 124);
  SetTarCheckSum(header);
  return header;
}

} // namespace

TEST(TarMembers, FilesComeByTheirNames)
{
  const Listing listing = ListBytes(MakeTar({{"day/", {}, '5'}, {"day/KTLX1", BytesOf("one")},
    {"./KTLX2", BytesOf(std::string(600, '2'))}, {"link", {}, '2'}, {"/tmp/../KTLX3", BytesOf("3")},
    {"two\nlines", BytesOf("4")}, {"old", BytesOf("5"), '\0'}}));
  EXPECT_EQ(listing.members,
    (std::map<std::string, std::string>{{"day/KTLX1", "one"}, {"KTLX2", std::string(600, '2')},
      {"tmp/KTLX3", "3"}, {"two\nlines", "4"}, {"old", "5"}}));
  EXPECT_TRUE(listing.problems.empty());
}

TEST(TarMembers, LongNamesOfEachFormat)
{
  const std::string name = std::string(150, 'a') + '/' + std::string(90, 'b');
  const std::string record = " path=" + name + '\n';
  const std::string length = std::to_string(record.size() + 3);
  Bytes prefixed = MakeTarHeader(std::string(90, 'b'), 3);
  const std::string prefix(150, 'a');
  std::copy(prefix.begin(), prefix.end(), prefixed.begin() + 345);
  SetTarCheckSum(prefixed);
  const Bytes content = Bytes({'x', 'y', 'z'});
  Bytes block = content;
  block.resize(512);
  const std::vector<Bytes> formats = {
    MakeTar({{"././@LongLink", BytesOf(name + '\0'), 'L'}, {name, content}}),
    MakeTar({{"PaxHeaders/1", BytesOf(length + record), 'x'}, {name, content}}),
    Join({prefixed, block, Bytes(1024)})};
  for (const Bytes& tar : formats)
  {
    const Listing listing = ListBytes(tar);
    EXPECT_EQ(listing.members, (std::map<std::string, std::string>{{name, "xyz"}}));
    EXPECT_TRUE(listing.problems.empty());
  }
}

TEST(TarMembers, SizesOfEachFormat)
{
  const Bytes binary = {0x80, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3};
  Bytes block = {'x', 'y', 'z'};
  block.resize(512);
  EXPECT_EQ(
    ListBytes(Join({HeaderWithSize(binary), block, Bytes(1024)})).members.at("sized"), "xyz");
  const Bytes pax = MakeTarMember({"PaxHeaders/1", BytesOf("9 size=3\n"), 'x'});
  EXPECT_EQ(
    ListBytes(Join({pax, MakeTarHeader("sized", 0), block, Bytes(1024)})).members.at("sized"),
    "xyz");
}

TEST(TarMembers, SizesThatAreNoneAreDamage)
{
  const Bytes first = MakeTarMember({"first", BytesOf("first")});
  const Bytes good = MakeTarMember({"good", BytesOf("good")});
  Bytes negative(12, 0xFF);
  Bytes huge(12, 0xFE);
  huge[0] = 0x80;
  for (const Bytes& size : {negative, huge, BytesOf("zzzzzzzzzzz"), BytesOf("77777777777777")})
  {
    const Listing listing = ListBytes(Join({first, HeaderWithSize(size), good, Bytes(1024)}));
    EXPECT_EQ(listing.members.count("first"), 1U);
    EXPECT_EQ(listing.members.count("good"), size.size() == 14 ? 0U : 1U);
    ASSERT_EQ(listing.problems.size(), 1U);
  }
}

TEST(TarMembers, AFileThatTheEndCutsOffIsAsLongAsWhatIsThere)
{
  Bytes tar =
    Join({MakeTarMember({"whole", BytesOf("whole")}), MakeTarHeader("cut", 5000), Bytes(700, 'c')});
  const Listing listing = ListBytes(tar);
  EXPECT_EQ(listing.members.at("whole"), "whole");
  EXPECT_EQ(listing.members.at("cut"), std::string(700, 'c'));
  ASSERT_EQ(listing.problems.size(), 1U);
  EXPECT_EQ(listing.problems[0].member, "cut");
  EXPECT_EQ(
    listing.problems[0].what, "the archive ends within this file: 700 of its 5000 bytes are there");
}

// Whatever the number of bytes that are there, the members that are whole are read, and what is
// missing is named.
TEST(TarMembers, ThatAreCutAtEachByte)
{
  const Bytes tar = MakeTar({{"one", BytesOf(std::string(513, '1'))}, {"two", BytesOf("22")}});
  for (std::size_t size = 512; size < tar.size(); ++size)
  {
    const Listing listing =
      ListBytes(Bytes(tar.begin(), tar.begin() + static_cast<std::ptrdiff_t>(size)));
    const std::size_t whole = size >= 512 + 513 ? 513 : size - 512;
    EXPECT_EQ(listing.members.at("one").size(), whole) << size;
    EXPECT_EQ(listing.members.count("two"), size >= 1536 + 512 ? 1U : 0U) << size;
    const bool isCutInTheFile = size < 512 + 513 || (size >= 2048 && size < 2050);
    ASSERT_EQ(listing.problems.size(), 1U) << size;
    EXPECT_EQ(listing.problems[0].member.empty(), !isCutInTheFile) << size;
  }
  EXPECT_TRUE(ListBytes(tar).problems.empty());
}

TEST(TarMembers, ReadingGoesOnAfterADamagedHeader)
{
  Bytes tar = MakeTar(
    {{"one", BytesOf("1")}, {"two", BytesOf(std::string(1500, '2'))}, {"three", BytesOf("3")}});
  tar[1024 + 130] ^= 1;
  const Listing listing = ListBytes(tar);
  EXPECT_EQ(listing.members, (std::map<std::string, std::string>{{"one", "1"}, {"three", "3"}}));
  ASSERT_EQ(listing.problems.size(), 1U);
  EXPECT_EQ(listing.problems[0].offset, 1024U);
}

TEST(TarMembers, SparseFilesAreLeftOut)
{
  const Listing gnu = ListBytes(MakeTar({{"holes", BytesOf("1"), 'S'}, {"two", BytesOf("2")}}));
  const Listing pax = ListBytes(MakeTar({{"PaxHeaders/1", BytesOf("22 GNU.sparse.major=1\n"), 'x'},
    {"holes", BytesOf("1")}, {"two", BytesOf("2")}}));
  for (const Listing& listing : {gnu, pax})
  {
    EXPECT_EQ(listing.members, (std::map<std::string, std::string>{{"two", "2"}}));
    ASSERT_EQ(listing.problems.size(), 1U);
    EXPECT_TRUE(listing.problems[0].leftOut);
    EXPECT_EQ(listing.problems[0].member, "holes");
  }
}

TEST(TarMembers, ArchivesJoinedEndToEnd)
{
  const Listing listing = ListBytes(
    Join({MakeTar({{"one", BytesOf("1")}}), Bytes(8192), MakeTar({{"two", BytesOf("2")}})}));
  EXPECT_EQ(listing.members.size(), 2U);
  EXPECT_TRUE(listing.problems.empty());
}
