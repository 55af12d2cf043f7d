// SPDX-License-Identifier: BSD-3-Clause
#include "Live/PictureProcess.h"

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace nexrad::application
{

PictureProcess::~PictureProcess()
{
  if (this->IsRunning())
  {
    kill(process, SIGTERM);
    waitpid(process, nullptr, 0);
  }
}

bool PictureProcess::IsRunning()
{
  int ended = 0;
  if (process != 0 && waitpid(process, &ended, WNOHANG) != 0)
  {
    process = 0;
    status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
  }
  return process != 0;
}

void PictureProcess::Start(const std::vector<std::string>& words)
{
  std::string program = "nexrad3d";
  std::vector<char*> arguments = {program.data()};
  std::vector<std::string> own = words;
  for (std::string& word : own)
  {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  pid_t started = 0;
  const int failure =
    posix_spawn(&started, "/proc/self/exe", nullptr, nullptr, arguments.data(), environ);
  if (failure != 0) // too many processes, or too little memory
  {
    status = failure;
    return;
  }
  constexpr int gently = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(started), gently);
  process = started;
}

} // namespace nexrad::application
