// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramRun.h"

#include "TestData.h"
#include "nexrad/Codec/NxvFile.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <stdexcept>
#include <thread>

namespace nexrad::testing
{

namespace
{

// In the child: files in place of the standard output and error, then the program. Returns only
// when that failed.
void Execute(
  const std::vector<char*>& arguments, const std::string& output, const std::string& errors)
{
  const int outputFile = open(output.c_str(), O_WRONLY | O_CREAT, 0600);
  const int errorFile = open(errors.c_str(), O_WRONLY | O_CREAT, 0600);
  dup2(outputFile, STDOUT_FILENO);
  dup2(errorFile, STDERR_FILENO);
  execv(arguments.front(), arguments.data());
}

// What the system tells of a process that ended.
struct Ended
{
  int status = 0; // as waitpid gives it
  rusage usage{};
};

// Starts a program, lets `wait` wait for its end, and returns what it left behind. `wait` takes the
// process.
ProgramRun Run(const std::string& program, const std::vector<std::string>& arguments,
  const std::function<Ended(pid_t)>& wait)
{
  const TemporaryFolder folder;
  const std::string output = folder.Path() / "output";
  const std::string errors = folder.Path() / "errors";
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words)
  {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0)
  {
    Execute(pointers, output, errors);
    _exit(127);
  }
  if (child < 0)
  {
    throw std::runtime_error("cannot run " + program);
  }
  const Ended ended = wait(child);
  constexpr std::size_t kibibyte = 1024;
  return {WIFEXITED(ended.status) ? WEXITSTATUS(ended.status) : -1,
    nexrad::testing::FileContent(output), nexrad::testing::FileContent(errors),
    static_cast<std::size_t>(ended.usage.ru_maxrss) * kibibyte};
}

Ended WaitForEnd(pid_t child)
{
  Ended ended;
  if (wait4(child, &ended.status, 0, &ended.usage) != child)
  {
    throw std::runtime_error("the end of a process was missed");
  }
  return ended;
}

} // namespace

ProgramRun RunProgram(const std::string& program, const std::vector<std::string>& arguments)
{
  return Run(program, arguments, WaitForEnd);
}

ProgramRun InterruptProgram(const std::string& program, const std::vector<std::string>& arguments,
  const std::function<bool()>& now, int signal)
{
  return Run(program, arguments,
    [&now, signal](pid_t child)
    {
      Ended ended;
      while (!now())
      {
        if (wait4(child, &ended.status, WNOHANG, &ended.usage) == child)
        {
          return ended;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      kill(child, signal);
      return WaitForEnd(child);
    });
}

std::string Nexrad3dPath()
{
  return NEXRAD3D_PROGRAM;
}

ProgramRun RunNexrad3d(const std::vector<std::string>& arguments)
{
  return RunProgram(Nexrad3dPath(), arguments);
}

GriddedVolume ReadOnlyVolume(const std::filesystem::path& folder, std::optional<MomentName> moment)
{
  NxvReadOptions options;
  if (moment)
  {
    options.moments = {*moment};
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    if (entry.path().extension() == ".nxv")
    {
      return ReadNxv(entry.path(), options);
    }
  }
  ADD_FAILURE() << folder << " has no volume";
  return {};
}

} // namespace nexrad::testing
