// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Archives/TarMembers.h"

#include "nexrad/Archives/TarHeader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace nexrad
{

namespace
{

constexpr std::size_t longestName = 4096;          // bytes; that of a path in Linux
constexpr std::size_t longestExtension = 1U << 16; // bytes; two texts and some numbers
constexpr std::uint64_t longestPadding =
  1U << 20; // bytes of zeros after the end; tapes have blocks of 10 kB
constexpr std::uint64_t zeroBlocksOfEnd = 2;

using Block = std::array<std::uint8_t, tarBlockBytes>;

std::string WithoutEmptyParts(const std::string& name)
{
  std::string clean;
  for (std::size_t begin = 0; begin < name.size();)
  {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string part = name.substr(begin, end - begin);
    if (!part.empty() && part != "." && part != "..")
    {
      clean += (clean.empty() ? "" : "/") + part;
    }
    begin = end + 1;
  }
  return clean;
}

bool IsFile(const TarHeader& header)
{
  const bool endsAsFolder = !header.name.empty() && header.name.back() == '/'; // before 1988
  const bool isFile = header.type == '0' || header.type == '\0' || header.type == '7';
  return isFile && !endsAsFolder;
}

class TarWalk
{
public:
  TarWalk(const FilePart& theArchive, const TarReceiver& theReceiver)
    : archive(theArchive)
    , receiver(theReceiver)
  {
  }

  void Run()
  {
    Block block{};
    while (!finished && archive.Read(position, block.data(), block.size()) == block.size())
    {
      this->Take(block);
    }
    if (!finished && zeroBlocks < zeroBlocksOfEnd && !isCut)
    {
      this->Tell(archive.Size(), "the archive has no end: members may be missing");
    }
  }

private:
  void Take(const Block& block)
  {
    if (std::all_of(block.begin(), block.end(), [](auto byte) { return byte == 0; }))
    {
      ++zeroBlocks;
      position += block.size();
      finished = zeroBlocks * block.size() > longestPadding;
      return;
    }
    const auto header = ParseTarHeader(ByteView(block.data(), block.size()));
    if (!header && zeroBlocks >= zeroBlocksOfEnd)
    {
      finished = true; // what stands on the rest of a tape
      return;
    }
    zeroBlocks = 0;
    if (!header)
    {
      if (!isLost)
      {
        this->Tell(position, "no header of a member, or a damaged one; the next one is looked for");
      }
      isLost = true;
      position += block.size();
      return;
    }
    isLost = false;
    this->TakeMember(*header);
  }

  void TakeMember(const TarHeader& header)
  {
    const std::uint64_t begin = position + tarBlockBytes;
    const std::uint64_t size = extension.size && IsFile(header) ? *extension.size : header.size;
    const FilePart content = archive.Sub(begin, size);
    isCut = content.Size() < size;
    if (header.type == 'L')
    {
      longName = this->TextOf(content, longestName);
      longName = longName.substr(0, longName.find('\0'));
    }
    else if (header.type == 'x' || header.type == 'X')
    {
      extension = ParseTarExtension(this->TextOf(content, longestExtension));
    }
    else if (header.type != 'K' && header.type != 'g')
    {
      this->TakeFile(header, content, size);
      longName.clear();
      extension = {};
    }
    const std::uint64_t blocks = (content.Size() + tarBlockBytes - 1) / tarBlockBytes;
    position = begin + blocks * tarBlockBytes;
    isLost = header.type == 'S'; // the map of its holes may follow
  }

  void TakeFile(const TarHeader& header, const FilePart& content, std::uint64_t size)
  {
    const std::string name =
      WithoutEmptyParts(extension.name && extension.name->size() <= longestName ? *extension.name
                        : longName.empty()                                      ? header.name
                                                                                : longName);
    if (header.type == 'S' || extension.sparse)
    {
      receiver.problem({name, 0, "a sparse file, which is not read: left out", true});
    }
    else if (header.type == 'M')
    {
      receiver.problem({name, 0, "goes on from another archive: left out", true});
    }
    else if (IsFile(header) && name.empty())
    {
      this->Tell(position, "a member has no name: left out");
    }
    else if (IsFile(header))
    {
      if (isCut)
      {
        receiver.problem({name, content.Size(),
          "the archive ends within this file: " + std::to_string(content.Size()) + " of its " +
            std::to_string(size) + " bytes are there",
          false});
      }
      finished = !receiver.member(name, content);
    }
  }

  std::string TextOf(const FilePart& content, std::size_t longest)
  {
    if (content.Size() > longest)
    {
      this->Tell(position, "a name or its like of " + std::to_string(content.Size()) +
                             " bytes is too long: the short one is used");
      return {};
    }
    const std::vector<std::uint8_t> bytes = content.Start(longest);
    return {bytes.begin(), bytes.end()};
  }

  void Tell(std::uint64_t offset, const std::string& what)
  {
    receiver.problem({"", offset, what, false});
  }

  const FilePart& archive;
  const TarReceiver& receiver;
  std::uint64_t position = 0;
  std::uint64_t zeroBlocks = 0; // one after the other
  bool finished = false;
  bool isLost = false;    // among bytes that are no header
  bool isCut = false;     // the archive ends within the member in hand
  std::string longName;   // of the next member
  TarExtension extension; // of the next member
};

} // namespace

bool IsTar(const FilePart& part)
{
  Block block{};
  const std::size_t size = part.Read(0, block.data(), block.size());
  return ParseTarHeader(ByteView(block.data(), size)).has_value();
}

void ListTar(const FilePart& archive, const TarReceiver& receiver)
{
  TarWalk(archive, receiver).Run();
}

} // namespace nexrad
