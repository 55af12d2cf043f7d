// SPDX-License-Identifier: BSD-3-Clause
// Feeds bytes to the reader of tar archives, and looks at all members and at what is said of them.
#include "FuzzTarget.h"

#include "Feed/TarMaker.h"
#include "nexrad/Archives/Archive.h"

#include <algorithm>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;

namespace nexrad::testing
{

std::vector<Bytes> FuzzSeeds()
{
  const Bytes volume = MakeSmallVolume(31);
  const Bytes pax = BytesOf("14 path=other\n9 size=9\n");
  const Bytes tar = MakeTar({{"day/", {}, '5'}, {"day/KTLX1", volume}, {"KTLX2.gz", Gzip(volume)},
    {"././@LongLink", BytesOf(std::string(120, 'n')), 'L'}, {"long", BytesOf("1")},
    {"PaxHeaders/1", pax, 'x'}, {"short", BytesOf("1")}, {"holes", BytesOf("1"), 'S'}});
  const Bytes nested = MakeTar({{"inner.tar", tar}, {"inner.tgz", Gzip(tar)}});
  return {tar, nested, Gzip(tar), Compress(tar), Bzip2(tar, 1)};
}

} // namespace nexrad::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const InputFile input("some.tar");
  input.Write(data, size);
  const auto file = FilePart::Open(input.Path());
  Require(file.has_value(), "the file can be opened");
  if (!IsArchive(*file, "some.tar"))
  {
    return 0;
  }
  const Archive archive = ReadArchive(*file);
  for (const auto& [name, content] : archive.members)
  {
    Require(!name.empty() && name.front() != '/', "names are relative");
    Require(('/' + name + '/').find("/../") == std::string::npos, "names lead nowhere");
    const std::size_t most = 100;
    Require(content.Start(most).size() == std::min<std::uint64_t>(content.Size(), most),
      "members lie within the file");
  }
  for (const ArchiveProblem& problem : archive.problems)
  {
    RequireMessage(problem.what);
  }
  return 0;
}
