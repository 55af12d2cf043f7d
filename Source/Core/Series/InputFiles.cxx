// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/InputFiles.h"

#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Level2/Level2File.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>
#include <system_error>

namespace nexrad
{

namespace fs = std::filesystem;

namespace
{

class Finder
{
public:
  void AddInput(const fs::path& input)
  {
    const StoredKind kind = KindOf(input);
    if (kind == StoredKind::Nothing)
    {
      throw InputError(input.string() + ": no such file or folder", true);
    }
    if (kind != StoredKind::Folder)
    {
      this->Add(input);
      return;
    }
    const std::size_t seenBefore = this->seen;
    this->AddFolder(input, 0);
    if (this->seen == seenBefore)
    {
      throw InputError(input.string() + ": the folder holds no file", true);
    }
  }

  InputFiles found;

private:
  // Deep enough for an archive's year/month/day/site.
  static constexpr int MaximumDepth = 16;

  void AddFolder(const fs::path& folder, int depth)
  {
    // Links may lead to one folder by several ways, or back up: each folder is listed once.
    std::error_code failure;
    const fs::path canonical = fs::canonical(folder, failure);
    if (!this->listed.insert(failure ? folder : canonical).second)
    {
      ++this->seen;
      return;
    }
    this->AddProblemsOfArchive(folder);
    if (IsChunkFolder(folder))
    {
      ++this->seen;
      this->Add(folder);
      return;
    }
    std::vector<fs::path> entries = ListFolder(folder, failure);
    std::sort(entries.begin(), entries.end());
    if (failure)
    {
      const std::string what = "the folder cannot be read: " + failure.message();
      if (depth == 0)
      {
        throw InputError(folder.string() + ": " + what, true);
      }
      // What is wrong with a folder in a folder that was named does not hold up the rest.
      ++this->seen;
      this->Refuse(folder, what);
    }
    for (const fs::path& entry : entries)
    {
      if (KindOf(entry) != StoredKind::Folder)
      {
        ++this->seen;
        this->AddEntry(entry);
      }
      else if (depth < MaximumDepth)
      {
        this->AddFolder(entry, depth + 1);
      }
      else
      {
        this->Refuse(entry, "more than " + std::to_string(MaximumDepth) + " folders deep");
      }
    }
  }

  // An archive is a folder of its members.
  void AddProblemsOfArchive(const fs::path& path)
  {
    const auto archive = FindArchive(path);
    for (const ArchiveProblem& problem :
      archive ? archive->problems : std::vector<ArchiveProblem>())
    {
      ++this->seen;
      const std::string member = problem.member.empty() ? "" : '/' + problem.member;
      const auto offset = problem.leftOut ? std::nullopt : std::optional(problem.offset);
      found.problems.push_back({path.string() + member, offset, problem.what, problem.leftOut});
    }
  }

  // What stands in a folder and is none.
  void AddEntry(const fs::path& entry)
  {
    std::error_code failure;
    const StoredKind kind = KindOf(entry);
    if (kind != StoredKind::File) // opening a pipe would wait for a writer
    {
      const fs::file_status status = fs::status(entry, failure);
      this->Refuse(entry, fs::exists(status) ? "neither a file nor a folder" : failure.message());
    }
    else if (access(entry.c_str(), R_OK) != 0 && errno != ENOTDIR && errno != ENAMETOOLONG)
    {
      this->Refuse(entry, std::string("cannot be read: ") + std::strerror(errno));
    }
    else if (!LooksLikeLevel2(entry))
    {
      this->Refuse(entry, WhyNotLevel2(entry));
    }
    else
    {
      this->Add(entry);
    }
  }

  void Refuse(const fs::path& entry, const std::string& why)
  {
    this->found.problems.push_back({entry.string(), {}, why + ": left out", true});
  }

  void Add(const fs::path& path)
  {
    std::error_code failure;
    const fs::path canonical = fs::canonical(path, failure);
    if (this->known.insert(failure ? path : canonical).second)
    {
      this->found.paths.push_back(path);
    }
  }

  std::set<fs::path> known;
  std::set<fs::path> listed; // folders
  std::size_t seen = 0;
};

} // namespace

std::string InputProblem::Line() const
{
  return file + (offset ? ": offset " + std::to_string(*offset) : std::string()) + ": " + what;
}

std::vector<std::string> ProblemLines(const std::vector<InputProblem>& problems)
{
  std::vector<std::string> lines;
  for (const InputProblem& problem : problems)
  {
    lines.push_back(problem.Line());
  }
  return lines;
}

bool IsChunkFolder(const fs::path& path)
{
  std::error_code failure;
  const std::vector<fs::path> entries = ListFolder(path, failure);
  return std::any_of(entries.begin(), entries.end(),
    [](const fs::path& entry) { return ParseChunkName(entry).has_value(); });
}

InputFiles FindInputFiles(const std::vector<fs::path>& inputs)
{
  Finder finder;
  for (const fs::path& input : inputs)
  {
    finder.AddInput(input);
  }
  return finder.found;
}

std::optional<FilesByRadar> ListByHeaders(
  const std::vector<std::filesystem::path>& paths, const std::string& siteName)
{
  FilesByRadar radars;
  for (std::size_t index = 0; index < paths.size(); ++index)
  {
    const std::optional<VolumeHeader> header = PeekVolumeHeader(paths[index]);
    const std::string name = header && siteName.empty() ? header->siteName : siteName;
    if (!header || !header->time || name.empty())
    {
      return std::nullopt;
    }
    radars[name].push_back({index, *header->time});
  }
  for (auto& [name, files] : radars)
  {
    std::stable_sort(files.begin(), files.end(), IsEarlier);
  }
  return radars;
}

} // namespace nexrad
