// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"
#include "InfoCommand.h"

int main(int argc, char** argv)
{
  using namespace nexrad::application;
  return RunProgram(argc, argv, {AddInfoCommand});
}
