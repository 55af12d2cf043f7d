// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <string>

namespace nexrad::testing
{

/// Takes the display away from this process and those that it runs, as it is on a machine without a
/// screen; gives it back at the end of its life.
class NoDisplay
{
public:
  NoDisplay()
    : had(std::getenv("DISPLAY") != nullptr)
    , before(had ? std::getenv("DISPLAY") : "")
  {
    unsetenv("DISPLAY");
  }
  ~NoDisplay()
  {
    if (had)
    {
      setenv("DISPLAY", before.c_str(), 1);
    }
  }
  NoDisplay(const NoDisplay&) = delete;
  NoDisplay& operator=(const NoDisplay&) = delete;

private:
  bool had;
  std::string before;
};

} // namespace nexrad::testing
