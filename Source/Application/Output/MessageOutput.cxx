// SPDX-License-Identifier: BSD-3-Clause
#include "Output/MessageOutput.h"

#include "nexrad/System/MessageText.h"

#include <iostream>

namespace nexrad::application
{

void PrintMessage(const std::string& message)
{
  std::cerr << MessageLine(message) + '\n' << std::flush;
}

void PrintMessages(const std::vector<std::string>& messages)
{
  for (const std::string& message : messages)
  {
    PrintMessage(message);
  }
}

} // namespace nexrad::application
