// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/UnfinishedRun.h"

#include "Output/OutputFile.h"
#include "nexrad/System/Error.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

constexpr const char* JournalName = "run.json";
constexpr const char* RecordsName = "records";

void Rename(const fs::path& from, const fs::path& to)
{
  std::error_code problem;
  fs::rename(from, to, problem);
  if (problem)
  {
    throw Error(to.string() + ": cannot be written: " + problem.message());
  }
}

// Of the names in the hidden folder, those of files that will get the same name in the folder.
std::set<std::string> WaitingIn(const fs::path& hidden)
{
  std::set<std::string> waiting;
  for (const std::string& name : FilesIn(hidden))
  {
    if (name.front() != '.' && name != JournalName && name != UnfinishedRun::LockName &&
        name != RecordsName)
    {
      waiting.insert(name);
    }
  }
  return waiting;
}

// Throws Error for a folder of that name that no run made: it would lose its files.
void RequireOwnFolder(const fs::path& hidden)
{
  if (fs::is_symlink(hidden))
  {
    throw Error(hidden.string() + ": is a symbolic link; remove it");
  }
  std::error_code failure;
  const bool isEmpty = fs::is_empty(hidden, failure);
  if (!failure && !isEmpty && !fs::exists(hidden / UnfinishedRun::LockName, failure) &&
      !fs::exists(hidden / JournalName, failure))
  {
    throw Error(hidden.string() +
                ": is not of a run of grid, whose notes need this name; rename it, or name another "
                "folder (-o)");
  }
}

// Null when there is none that can be read.
nlohmann::json ReadJson(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return nlohmann::json::parse(file, nullptr, false);
}

} // namespace

std::set<std::string> FilesIn(const fs::path& folder)
{
  std::set<std::string> names;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure))
  {
    std::error_code ignored;
    if (entry->is_regular_file(ignored))
    {
      names.insert(entry->path().filename().string());
    }
  }
  return names;
}

UnfinishedRun::UnfinishedRun(
  const fs::path& theFolder, const std::string& recipe, const Processes& theProcesses)
  : folder(theFolder)
  , hidden(theFolder / HiddenName)
  , processes(theProcesses)
  , canGoOn(!recipe.empty())
{
  processes.Together(
    [&]
    {
      if (processes.IsFirst())
      {
        this->Open(recipe);
      }
    });
  processes.Together([&] { this->ReadJournal(); });
}

UnfinishedRun::~UnfinishedRun()
{
  if (lock.IsOpen() && (!canGoOn || (written.empty() && WaitingIn(hidden).empty())))
  {
    this->RemoveHidden();
  }
}

// Called by the first process.
void UnfinishedRun::Open(const std::string& recipe)
{
  constexpr int attempts = 10;
  for (int attempt = 0; attempt < attempts; ++attempt)
  {
    MakeFolder(folder);
    MakeFolder(hidden);
    RequireOwnFolder(hidden);
    lock = FileDescriptor(
      open((hidden / LockName).c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (!lock.IsOpen() && errno != ENOENT) // a run that ends removes the hidden folder
    {
      throw Error(folder.string() + ": cannot be written to: " + std::strerror(errno));
    }
    if (lock.IsOpen() && TryLock(lock))
    {
      if (!this->Continues(recipe))
      {
        this->Begin(recipe);
      }
      return;
    }
  }
  throw Error(folder.string() +
              ": another run writes volumes into this folder; wait until it has ended, or name "
              "another folder");
}

bool UnfinishedRun::Continues(const std::string& recipe) const
{
  const nlohmann::json journal = ReadJson(hidden / JournalName);
  return !recipe.empty() && journal.is_object() &&
         journal.value("recipe", nlohmann::json()) == recipe &&
         journal.value("replaced", nlohmann::json()).is_array();
}

void UnfinishedRun::Begin(const std::string& recipe)
{
  this->RemoveWaiting();
  const nlohmann::json journal = {{"recipe", recipe}, {"replaced", FilesIn(folder)}};
  const std::string text =
    journal.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
  try
  {
    WriteFileAtomically(hidden / JournalName, text.data(), text.size());
  }
  catch (const Error&)
  {
    this->RemoveHidden();
    throw;
  }
}

void UnfinishedRun::ReadJournal()
{
  const nlohmann::json journal = ReadJson(hidden / JournalName);
  if (!journal.is_object())
  {
    throw Error((hidden / JournalName).string() + ": cannot be read");
  }
  for (const nlohmann::json& name : journal.at("replaced"))
  {
    replaced.insert(name.get<std::string>());
  }
}

void UnfinishedRun::RemoveWaiting()
{
  std::error_code ignored;
  for (const std::string& name : FilesIn(hidden))
  {
    if (name != LockName)
    {
      fs::remove(hidden / name, ignored);
    }
  }
}

// The files of the run, and the folder; what others put into folders of their own in it stays, and
// keeps it. The lock comes last: it tells whose folder it is.
void UnfinishedRun::RemoveHidden()
{
  this->RemoveWaiting();
  std::error_code ignored;
  fs::remove(hidden / LockName, ignored);
  fs::remove(hidden, ignored);
}

fs::path UnfinishedRun::PathOf(const std::string& name) const
{
  return this->Waits(name) ? hidden / name : folder / name;
}

bool UnfinishedRun::Has(const std::string& name)
{
  std::error_code ignored;
  const bool there = fs::is_regular_file(this->PathOf(name), ignored);
  if (there)
  {
    written.insert(name);
  }
  return there;
}

std::uintmax_t UnfinishedRun::SizeOf(const std::string& name) const
{
  std::error_code problem;
  const std::uintmax_t size = fs::file_size(this->PathOf(name), problem);
  if (problem)
  {
    throw Error(this->PathOf(name).string() + ": cannot be read: " + problem.message());
  }
  return size;
}

fs::path UnfinishedRun::PlaceFor(const std::string& name) const
{
  return hidden / name;
}

void UnfinishedRun::Add(const std::string& name)
{
  written.insert(name);
  if (!this->Waits(name))
  {
    Rename(hidden / name, folder / name);
  }
}

void UnfinishedRun::Keep(const std::string& bytes) const
{
  if (!canGoOn)
  {
    return;
  }
  const std::uint64_t size = bytes.size();
  const std::string record = std::string(reinterpret_cast<const char*>(&size), sizeof size) + bytes;
  const fs::path path = hidden / RecordsName;
  const FileDescriptor file(
    open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0666));
  // At once, so that records of several processes do not mix.
  if (!file.IsOpen() ||
      write(file.Number(), record.data(), record.size()) != static_cast<ssize_t>(record.size()))
  {
    throw Error(path.string() + ": cannot be written: " + std::strerror(errno));
  }
}

std::vector<std::string> UnfinishedRun::Kept() const
{
  std::ifstream file(hidden / RecordsName, std::ios::binary);
  const std::string all{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::vector<std::string> records;
  std::uint64_t size = 0;
  for (std::size_t at = 0; all.size() - at > sizeof size; at += size)
  {
    std::memcpy(&size, all.data() + at, sizeof size);
    at += sizeof size;
    size = std::min<std::uint64_t>(size, all.size() - at);
    records.push_back(all.substr(at, size));
  }
  return records;
}

void UnfinishedRun::Remove(const std::string& name)
{
  if (this->Has(name))
  {
    std::error_code ignored;
    fs::remove(this->PathOf(name), ignored);
    written.erase(name);
  }
}

void UnfinishedRun::KeepOnly(const std::set<std::string>& names)
{
  std::error_code ignored;
  for (const std::string& name : WaitingIn(hidden))
  {
    if (names.count(name) == 0)
    {
      fs::remove(hidden / name, ignored);
    }
  }
}

void UnfinishedRun::Discard()
{
  for (const std::string& name : std::set<std::string>(written))
  {
    this->Remove(name);
  }
}

void UnfinishedRun::End(const std::function<void()>& last)
{
  processes.Together(
    [&]
    {
      if (processes.IsFirst())
      {
        for (const std::string& name : WaitingIn(hidden))
        {
          Rename(hidden / name, folder / name);
        }
        last();
        // First, since a run without journal has ended, and one that lost only its notes has not.
        std::error_code ignored;
        fs::remove(hidden / JournalName, ignored);
        this->RemoveHidden();
        lock.Close();
      }
    });
}

} // namespace nexrad::application
