// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Archives/StoredFiles.h"

#include "Feed/TarMaker.h"
#include "TestData.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

const Bytes someBytes = {'A', 'B', 'C'};

std::vector<std::string> NamesListed(const fs::path& folder)
{
  std::error_code failure;
  std::vector<std::string> names;
  for (const fs::path& entry : ListFolder(folder, failure))
  {
    names.push_back(entry.filename().string());
  }
  EXPECT_FALSE(failure);
  std::sort(names.begin(), names.end());
  return names;
}

using Names = std::vector<std::string>;

} // namespace

TEST(StoredFiles, AnArchiveIsAFolder)
{
  const TemporaryFolder folder;
  const fs::path tar = WriteBytes(folder.Path() / "day.tar",
    MakeTar(
      {{"KTLX1", someBytes}, {"more/KTLX2", {}}, {"more/KTLX3", someBytes}, {".hidden", {}}}));
  EXPECT_EQ(KindOf(tar), StoredKind::Folder);
  EXPECT_EQ(KindOf(tar / "KTLX1"), StoredKind::File);
  EXPECT_EQ(KindOf(tar / "more"), StoredKind::Folder);
  EXPECT_EQ(KindOf(tar / "mor"), StoredKind::Nothing);
  EXPECT_EQ(KindOf(tar / "KTLX1" / "x"), StoredKind::Nothing);
  EXPECT_EQ(NamesListed(tar), (Names{"KTLX1", "more"}));
  EXPECT_EQ(NamesListed(tar / "more"), (Names{"KTLX2", "KTLX3"}));
  EXPECT_EQ(ReadStart(tar / "KTLX1", 2), (Bytes{'A', 'B'}));
  EXPECT_EQ(StoredSize(tar / "KTLX1"), 3U);
  EXPECT_EQ(ChangedAt(tar / "KTLX1"), fs::last_write_time(tar));
  EXPECT_EQ(KindOf(folder.Path() / "none.tar" / "KTLX1"), StoredKind::Nothing);
}

TEST(StoredFiles, FilesThatAreNoArchive)
{
  const TemporaryFolder folder;
  const fs::path file = WriteBytes(folder.Path() / "KTLX1.tar", MakeSmallVolume(31));
  EXPECT_EQ(KindOf(file), StoredKind::File);
  EXPECT_EQ(
    KindOf(WriteBytes(folder.Path() / "tar.gz", Gzip(MakeSmallVolume(31)))), StoredKind::File);
  EXPECT_EQ(KindOf(WriteBytes(folder.Path() / "zeros.tar", Bytes(10'240))), StoredKind::File);
  EXPECT_EQ(KindOf(file / "x"), StoredKind::Nothing);
  EXPECT_EQ(KindOf(folder.Path()), StoredKind::Folder);
}

TEST(StoredFiles, CompressedArchivesAndArchivesInArchives)
{
  const TemporaryFolder folder;
  const Bytes inner = MakeTar({{"KTLX1", someBytes}});
  const Bytes middle = MakeTar({{"inner.tgz", Gzip(inner)}, {"KTLX2", someBytes}});
  for (const auto& [name, bytes] :
    std::vector<std::pair<std::string, Bytes>>{{"day", MakeTar({{"middle.tar", middle}})},
      {"day.gz", Gzip(MakeTar({{"middle.tar", middle}}))},
      {"day.tar.bz2", Bzip2(MakeTar({{"middle.tar", middle}}))},
      {"day.Z", Compress(MakeTar({{"middle.tar", middle}}))}})
  {
    const fs::path tar = WriteBytes(folder.Path() / name, bytes);
    EXPECT_EQ(NamesListed(tar), Names{"middle.tar"}) << name;
    EXPECT_EQ(NamesListed(tar / "middle.tar"), (Names{"KTLX2", "inner.tgz"})) << name;
    EXPECT_EQ(ReadStart(tar / "middle.tar" / "inner.tgz" / "KTLX1", 10), someBytes) << name;
    EXPECT_TRUE(FindArchive(tar)->problems.empty()) << name;
  }
}

TEST(StoredFiles, TooDeepArchivesAreLeftOut)
{
  const TemporaryFolder folder;
  Bytes tar = MakeTar({{"KTLX1", someBytes}});
  for (int depth = 0; depth < 5; ++depth)
  {
    tar = MakeTar({{"in.tar", tar}});
  }
  const auto archive = FindArchive(WriteBytes(folder.Path() / "deep.tar", tar));
  EXPECT_TRUE(archive->members.empty());
  ASSERT_EQ(archive->problems.size(), 1U);
  EXPECT_EQ(archive->problems[0].member, "in.tar/in.tar/in.tar");
  EXPECT_TRUE(archive->problems[0].leftOut);
}

// A name leads nowhere but into the archive, and the last of two members of one name counts, as
// where tar unpacks them.
TEST(StoredFiles, HostileNames)
{
  const TemporaryFolder folder;
  const fs::path tar = WriteBytes(
    folder.Path() / "names.tar", MakeTar({{"../../KTLX1", someBytes}, {"a\nb", someBytes},
                                   {"twice", {}}, {"twice", someBytes}, {"", someBytes}}));
  EXPECT_EQ(NamesListed(tar), (Names{"KTLX1", "a\nb", "twice"}));
  EXPECT_EQ(StoredSize(tar / "twice"), 3U);
  EXPECT_EQ(KindOf(tar / ".." / "names.tar"), StoredKind::Nothing);
  EXPECT_EQ(FindArchive(tar)->problems.size(), 1U); // the one without a name
}

TEST(StoredFiles, AnArchiveThatChangedIsListedAnew)
{
  const TemporaryFolder folder;
  const fs::path tar = WriteBytes(folder.Path() / "day.tar", MakeTar({{"one", someBytes}}));
  EXPECT_EQ(NamesListed(tar), Names{"one"});
  WriteBytes(tar, MakeTar({{"one", someBytes}, {"two", someBytes}}));
  EXPECT_EQ(NamesListed(tar), (Names{"one", "two"}));
}

// A megabyte of gzip that would be a gigabyte: decompressed as far as radar data compress.
TEST(StoredFiles, AnArchiveThatDecompressesTooFar)
{
  const TemporaryFolder folder;
  const Bytes header = MakeTarHeader("big", 200U << 20);
  const Bytes bomb = Gzip(Join({header, Bytes(std::size_t(100) << 20)}));
  const fs::path tar = WriteBytes(folder.Path() / "bomb.tar.gz", bomb);
  EXPECT_LT(StoredSize(tar / "big"), (std::size_t(64) << 20) + 40 * bomb.size());
  EXPECT_EQ(FindArchive(tar)->problems.size(), 2U);
}

TEST(StoredFiles, OrdinaryOnesAreNeitherPipesNorDevices)
{
  const TemporaryFolder folder;
  const fs::path pipe = folder.Path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const fs::path file = WriteBytes(folder.Path() / "file", someBytes);
  for (const fs::path& path : {pipe, fs::path("/dev/zero"), fs::path("/dev/null")})
  {
    EXPECT_THROW(RequireOrdinaryFile(path), Error) << path;
    EXPECT_FALSE(IsOrdinaryFile(path)) << path;
  }
  EXPECT_TRUE(IsOrdinaryFile(file));
  EXPECT_FALSE(IsOrdinaryFile(folder.Path()));
  EXPECT_NO_THROW(RequireOrdinaryFile(file));
  EXPECT_NO_THROW(RequireOrdinaryFile(folder.Path()));
  EXPECT_NO_THROW(RequireOrdinaryFile(folder.Path() / "none")) << "opening it says why";
}
