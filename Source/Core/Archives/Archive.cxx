// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Archives/Archive.h"

#include "nexrad/Archives/TarMembers.h"
#include "nexrad/Compression/PiecewiseUnpack.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

namespace nexrad
{

namespace
{

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
    ListTar(*tar, receiver);
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
      scratch = scratch ? std::move(scratch) : std::make_optional<ScratchFile>();
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
