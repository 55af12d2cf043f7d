// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramRun.h"

#include "TestData.h"

#include <fcntl.h>
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

// Starts a program, lets `wait` wait for its end, and returns what it left behind. `wait` takes the
// process and returns the status that waitpid gave.
ProgramRun Run(const std::string& program, const std::vector<std::string>& arguments,
  const std::function<int(pid_t)>& wait)
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
  const int status = wait(child);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, nexrad::testing::FileContent(output),
    nexrad::testing::FileContent(errors)};
}

int WaitForEnd(pid_t child)
{
  int status = 0;
  if (waitpid(child, &status, 0) != child)
  {
    throw std::runtime_error("the end of a process was missed");
  }
  return status;
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
      int status = 0;
      while (!now())
      {
        if (waitpid(child, &status, WNOHANG) == child)
        {
          return status;
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

} // namespace nexrad::testing
