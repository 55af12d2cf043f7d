// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/BenchCommand.h"

#include "Libraries/ProgramLibrary.h"
#include "nexrad/System/Error.h"

#include <CLI/CLI.hpp>

namespace nexrad::application
{
namespace
{

void LoadBench(CLI::App& command, CommandAction& action)
{
  try
  {
    const auto add = reinterpret_cast<BenchFunction>(
      LoadProgramFunction("nexrad3d-bench.so", benchFunctionName, "measures", "nexrad3d-bench"));
    add(&command, &action);
  }
  catch (const Error& error)
  {
    // Without the library no option is known; what is wrong is said when the command runs.
    command.allow_extras();
    action = [error]() -> int { throw error; };
  }
}

} // namespace

void AddBenchCommand(CLI::App& program, CommandAction& action)
{
  CLI::App* command = program.add_subcommand("bench",
    "Measure decoding, merging and drawing on this machine, beside bare decompression, VTK's ray "
    "caster and the thesis's figures");
  command->preparse_callback([command, &action](std::size_t) { LoadBench(*command, action); });
}

} // namespace nexrad::application
