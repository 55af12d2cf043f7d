// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <functional>

namespace nexrad::testing
{

/// Runs a check in a process of its own, which has no more rights than the user "nobody" when the
/// tests run as root. Returns what the check returned; false when it did not come to an end.
inline bool HoldsUnprivileged(const std::function<bool()>& check)
{
  constexpr unsigned nobody = 65534;
  const pid_t child = fork();
  if (child == 0)
  {
    bool holds = geteuid() != 0 || (setgid(nobody) == 0 && setuid(nobody) == 0);
    try
    {
      holds = holds && check();
    }
    catch (...)
    {
      holds = false;
    }
    _exit(holds ? 0 : 1);
  }
  int status = 1;
  return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) &&
         WEXITSTATUS(status) == 0;
}

} // namespace nexrad::testing
