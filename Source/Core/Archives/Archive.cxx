// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Archives/Archive.h"

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Compression/Container.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <optional>
#include <utility>

namespace nexrad
{

namespace
{

// Headers and contents of a tar archive stand in blocks of this size.
constexpr std::size_t tarBlockBytes = 512;

// The header of one member of a tar archive (POSIX.1-1988 "ustar", and the formats before it):
//
//     0 name   100 mode, owner   124 size   136 time   148 check sum   156 type   157 link
//     257 "ustar"   263 version   265 owner's names   345 first part of the name   500 end
struct TarHeader
{
  std::string name;       // as it is written, "" when it is empty
  std::uint64_t size = 0; // of what follows the header, bytes
  char type = '0';        // '0' or a zero byte: a file; 'L', 'x': about the next member
};

constexpr std::uint64_t largestSize = std::uint64_t(1) << 62;

// A text that fills its field, or ends with a zero byte.
std::string TextAt(ByteView block, std::size_t offset, std::size_t size)
{
  const ByteView field = block.Sub(offset, size);
  return {field.Data(), std::find(field.Data(), field.Data() + field.Size(), 0)};
}

// Digits to a base, after and before spaces and zero bytes; empty for anything else.
std::optional<std::uint64_t> ParseDigits(const std::string& text, unsigned base)
{
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  const std::size_t end = std::min(text.find(' ', begin), text.size());
  std::uint64_t value = 0;
  for (std::size_t place = begin; place < end; ++place)
  {
    const unsigned digit = static_cast<unsigned char>(text[place]) - unsigned('0');
    if (digit >= base || value > largestSize / base)
    {
      return std::nullopt;
    }
    value = value * base + digit;
  }
  return value <= largestSize ? std::optional(value) : std::nullopt;
}

// Octal digits; or, with the first bit set, a number to the base of 256 (GNU, star).
std::optional<std::uint64_t> ParseNumber(ByteView block, std::size_t offset, std::size_t size)
{
  constexpr unsigned binaryMark = 0x80;
  if ((block.U8(offset) & binaryMark) == 0)
  {
    return ParseDigits(TextAt(block, offset, size), 8);
  }
  std::uint64_t value = block.U8(offset) & ~binaryMark; // 0x7F for negative numbers: too large
  for (std::size_t place = offset + 1; place < offset + size; ++place)
  {
    if (value > largestSize >> 8)
    {
      return std::nullopt;
    }
    value = value << 8 | block.U8(place);
  }
  return value <= largestSize ? std::optional(value) : std::nullopt;
}

// The sum of the bytes, with spaces in place of the sum itself. Some old systems took bytes as
// signed.
bool HasItsCheckSum(ByteView block)
{
  constexpr std::size_t place = 148;
  constexpr std::size_t size = 8;
  const auto stated = ParseNumber(block, place, size);
  std::int64_t sum = 0;
  std::int64_t ofSigned = 0;
  for (std::size_t offset = 0; offset < tarBlockBytes; ++offset)
  {
    const bool isSum = offset >= place && offset < place + size;
    const std::uint8_t byte = isSum ? std::uint8_t(' ') : block.U8(offset);
    sum += byte;
    ofSigned += static_cast<std::int8_t>(byte);
  }
  const auto is = [&stated](std::int64_t value)
  { return value > 0 && stated == static_cast<std::uint64_t>(value); };
  return is(sum) || is(ofSigned);
}

// Empty when its check sum is wrong or its size is no size: base-256 numbers may be negative or
// larger than any file.
std::optional<TarHeader> ParseTarHeader(ByteView block)
{
  if (block.Size() < tarBlockBytes || !HasItsCheckSum(block))
  {
    return std::nullopt;
  }
  const auto size = ParseNumber(block, 124, 12);
  if (!size)
  {
    return std::nullopt;
  }
  TarHeader header;
  header.name = TextAt(block, 0, 100);
  header.size = *size;
  header.type = static_cast<char>(block.U8(156));
  // GNU's own format, "ustar" and two spaces, has other things in place of the first part.
  const std::string prefix =
    block.StartsWith("ustar", 257) && block.U8(262) == 0 ? TextAt(block, 345, 155) : "";
  header.name = prefix.empty() ? header.name : prefix + '/' + header.name;
  return header;
}

// What the member of type 'x' before a file says of the file (POSIX.1-2001, extended header).
struct TarExtension
{
  std::optional<std::string> name;
  std::optional<std::uint64_t> size;
  bool sparse = false; // GNU's formats of files with holes
};

// Reads records "LENGTH KEY=VALUE\n" as far as they are whole.
TarExtension ParseTarExtension(const std::string& records)
{
  constexpr std::size_t mostDigits = 7;
  TarExtension extension;
  std::size_t begin = 0;
  while (begin < records.size())
  {
    const std::size_t space = records.find(' ', begin);
    const auto length = space - begin <= mostDigits && space > begin
                          ? ParseDigits(records.substr(begin, space - begin), 10)
                          : std::nullopt;
    if (!length || *length > records.size() - begin || *length < space - begin + 2)
    {
      break;
    }
    const std::string record = records.substr(space + 1, begin + *length - space - 2);
    const std::size_t equals = std::min(record.find('='), record.size());
    const std::string key = record.substr(0, equals);
    const std::string value = equals < record.size() ? record.substr(equals + 1) : "";
    if (key == "path")
    {
      extension.name = value;
    }
    else if (key == "size")
    {
      extension.size = ParseDigits(value, 10);
    }
    extension.sparse = extension.sparse || key.rfind("GNU.sparse.", 0) == 0;
    begin += *length;
  }
  return extension;
}

// Takes what a TarWalk finds.
struct TarReceiver
{
  // A file of the archive. False when no more are wanted.
  std::function<bool(std::string name, FilePart content)> member;
  std::function<void(ArchiveProblem&& problem)> problem;
};

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

// Goes through a tar archive from member to member and reads nothing of the files. Names lose the
// parts "", "." and "..", so that they lead nowhere but into the archive. Folders and links are
// passed over. Behind damage it goes on at the next header; a file that the archive's end cuts off
// is as long as what is there.
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

// Whether the part begins with the header of a tar archive.
bool IsTar(const FilePart& part)
{
  Block block{};
  const std::size_t size = part.Read(0, block.data(), block.size());
  return ParseTarHeader(ByteView(block.data(), size)).has_value();
}

constexpr int deepest = 3; // archives in archives
constexpr std::size_t mostMembers = 100'000;
constexpr std::size_t mostNameBytes = std::size_t(4) << 20;
constexpr std::size_t mostProblems = 1000;
constexpr std::uint64_t smallestScratch = std::uint64_t(64) << 20;
constexpr std::uint64_t strongestCompression = 40; // of radar data

StreamFormat FormatOf(const FilePart& file)
{
  const std::vector<std::uint8_t> start = file.Start(4);
  return DetectStream(ByteView(start.data(), start.size()));
}

// Hands out at most the first `most` bytes of a part.
PieceReader ReaderOf(const FilePart& file, std::uint64_t most)
{
  return [part = file.Sub(0, most), offset = std::uint64_t(0)](
           std::uint8_t* target, std::size_t size) mutable
  {
    const std::size_t count = part.Read(offset, target, size);
    offset += count;
    return count;
  };
}

// Whether a compressed file has a tar archive in it.
bool HoldsTar(StreamFormat format, const FilePart& file)
{
  const std::uint64_t enough = format == StreamFormat::Bzip2 ? 1'000'000 : 65'536; // for a block
  std::vector<std::uint8_t> block;
  UnpackInPieces(
    format, ReaderOf(file, enough),
    [&block](const std::uint8_t* data, std::size_t size)
    { block.insert(block.end(), data, data + size); },
    tarBlockBytes);
  return ParseTarHeader(ByteView(block.data(), block.size())).has_value();
}

bool IsNamedTar(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return name.find("tar") != std::string::npos || name.find("tb") != std::string::npos;
}

class ArchiveLister
{
public:
  explicit ArchiveLister(const FilePart& file)
    : scratchLeft(smallestScratch + strongestCompression * file.Size())
  {
    this->Add(file, "", 1);
  }

  Archive archive;

private:
  void Add(const FilePart& file, const std::string& name, int depth)
  {
    const std::optional<FilePart> tar = this->Plain(file, name);
    if (!tar)
    {
      return;
    }
    const std::string prefix = name.empty() ? "" : name + '/';
    TarReceiver receiver;
    receiver.member = [&](const std::string& member, const FilePart& content)
    { return this->AddMember(prefix + member, content, depth); };
    receiver.problem = [&](ArchiveProblem&& problem)
    {
      problem.member = problem.member.empty() ? name : prefix + problem.member;
      this->AddProblem(std::move(problem));
    };
    TarWalk(*tar, receiver).Run();
  }

  // False when there are too many.
  bool AddMember(const std::string& name, const FilePart& content, int depth)
  {
    if (IsArchive(content, name))
    {
      if (depth == deepest)
      {
        this->AddProblem({name, 0,
          "an archive more than " + std::to_string(deepest) + " archives deep: left out", true});
        return true;
      }
      this->Add(content, name, depth + 1);
      return !full;
    }
    nameBytes += name.size();
    full = full || nameBytes > mostNameBytes || archive.members.size() == mostMembers;
    if (full)
    {
      this->AddProblem({"", 0,
        "more than " + std::to_string(mostMembers) + " members, or " +
          std::to_string(mostNameBytes) + " bytes of names; the rest is left",
        false});
      return false;
    }
    archive.members.insert_or_assign(name, content);
    return true;
  }

  // The file itself, or what it is when decompressed. Empty when that cannot be kept.
  std::optional<FilePart> Plain(const FilePart& file, const std::string& name)
  {
    if (IsTar(file))
    {
      return file;
    }
    try
    {
      if (!scratch)
      {
        scratch.emplace();
      }
      const std::uint64_t begin = scratch->Size();
      const std::string problem = UnpackInPieces(
        FormatOf(file), ReaderOf(file, file.Size()),
        [this](const std::uint8_t* data, std::size_t size) { scratch->Append(data, size); },
        scratchLeft);
      scratchLeft -= std::min(scratchLeft, scratch->Size() - begin);
      if (!problem.empty())
      {
        this->AddProblem({name, file.Size(), problem, false});
      }
      return scratch->From(begin);
    }
    catch (const Error& error)
    {
      this->AddProblem({name, 0, error.what(), true});
      return std::nullopt;
    }
  }

  void AddProblem(ArchiveProblem&& problem)
  {
    if (archive.problems.size() < mostProblems)
    {
      archive.problems.push_back(std::move(problem));
    }
  }

  std::optional<ScratchFile> scratch;
  std::uint64_t scratchLeft;
  std::size_t nameBytes = 0;
  bool full = false;
};

} // namespace

bool IsArchive(const FilePart& file, const std::string& name)
{
  if (IsTar(file))
  {
    return true;
  }
  const StreamFormat format = FormatOf(file);
  const bool isLookedInto =
    format != StreamFormat::None && (format != StreamFormat::Bzip2 || IsNamedTar(name));
  return isLookedInto && HoldsTar(format, file);
}

Archive ReadArchive(const FilePart& file)
{
  return std::move(ArchiveLister(file).archive);
}

} // namespace nexrad
