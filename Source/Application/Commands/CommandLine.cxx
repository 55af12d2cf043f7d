// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/CommandLine.h"

#include "Output/MessageOutput.h"
#include "Parallel/LaunchedProcess.h"
#include "nexrad/System/MessageText.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <system_error>
#include <unistd.h>

namespace nexrad::application
{
namespace
{

/// As long as it lives, control characters that are written to a stream appear as text: a file's
/// name can neither move the cursor nor colour or clear the terminal. "\x1b" takes the place of the
/// escape character. Line ends, tabs and carriage returns, and all bytes of other characters, stay.
class PrintableOutput : private std::streambuf
{
public:
  /// `theStream` is not owned, and must outlive this.
  explicit PrintableOutput(std::ostream& theStream)
    : stream(theStream)
    , target(theStream.rdbuf(this))
  {
  }

  ~PrintableOutput() override
  {
    stream.flush();
    stream.rdbuf(target);
  }

  PrintableOutput(const PrintableOutput&) = delete;
  PrintableOutput& operator=(const PrintableOutput&) = delete;

private:
  int_type overflow(int_type value) override
  {
    if (traits_type::eq_int_type(value, traits_type::eof()))
    {
      return traits_type::not_eof(value);
    }
    const auto byte = static_cast<unsigned char>(traits_type::to_char_type(value));
    const bool layout = byte == '\n' || byte == '\r' || byte == '\t';
    const bool control = !layout && IsControlByte(byte, before);
    before = byte;
    return (control ? this->PutCode(byte) : this->PutByte(byte)) ? value : traits_type::eof();
  }

  int sync() override { return target->pubsync(); }

  bool PutByte(unsigned char byte)
  {
    const int_type put = target->sputc(static_cast<char>(byte));
    return !traits_type::eq_int_type(put, traits_type::eof());
  }

  bool PutCode(unsigned char byte)
  {
    const std::string code = ControlText(byte);
    const auto length = static_cast<std::streamsize>(code.size());
    return target->sputn(code.data(), length) == length;
  }

  std::ostream& stream;
  std::streambuf* const target;
  unsigned char before = 0;
};

// "nexrad3d grid": what the user called.
std::string CalledName(const CLI::App& program)
{
  const auto chosen = program.get_subcommands();
  return chosen.empty() ? program.get_name()
                        : program.get_name() + ' ' + chosen.front()->get_name();
}

// CLI11 says only that a command is missing, even when the first word is a misspelt one.
std::string ExplainMissingCommand(const CLI::App& program)
{
  std::string names;
  for (const CLI::App* command : program.get_subcommands({}))
  {
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  const auto unknown = program.remaining();
  return (unknown.empty() ? "a command is missing" : "unknown command '" + unknown.front() + "'") +
         "; the commands are " + names;
}

// One line on standard error. Of several processes that were launched together, one speaks.
void Complain(const CLI::App& program, const std::string& message)
{
  if (FindLaunchedProcess().Speaks())
  {
    PrintMessage(CalledName(program) + ": " + message);
  }
}

int ReportParseError(const CLI::App& program, const CLI::ParseError& error)
{
  if (error.get_exit_code() == 0)
  {
    return program.exit(error); // --help and --version print to standard output
  }
  std::string message =
    program.get_subcommands().empty() ? ExplainMissingCommand(program) : error.what();
  std::replace(message.begin(), message.end(), '\n', ' ');
  Complain(program, message + " (see " + CalledName(program) + " --help)");
  // The processes that mpiexec launched all read the same words. One that ended with an error would
  // make mpiexec end the others, and the first of them may not have spoken yet.
  return FindLaunchedProcess().Speaks() ? WrongUsage : Done;
}

int RunAction(const CLI::App& program, const CommandAction& action)
{
  try
  {
    const int status = action();
    // Standard output may be a full disk; what was printed counts only when it arrived.
    if (!std::cout.flush())
    {
      Complain(program, "cannot write to standard output");
      return Failed;
    }
    return status;
  }
  catch (const std::bad_alloc&)
  {
    Complain(program,
      "not enough memory; fewer voxels (--dims) need less, and --memory refuses beforehand what "
      "does not fit");
  }
  catch (const std::system_error& error)
  {
    const bool lacksThreads = error.code() == std::errc::resource_unavailable_try_again;
    Complain(program, lacksThreads ? "no thread can be started; raise the limit on processes "
                                     "(ulimit -u) or on memory (ulimit -v)"
                                   : error.what());
  }
  catch (const std::exception& error)
  {
    Complain(program, error.what());
  }
  return Failed;
}

} // namespace

int RunProgram(int argc, const char* const* argv, const std::vector<AddCommand>& commands)
{
  CLI::App program("Weather radar volumes: from NEXRAD Level II files to a moving picture");
  program.name("nexrad3d");
  program.set_version_flag("--version", "nexrad3d " NEXRAD_VERSION);
  program.require_subcommand(1);
  program.footer("Exit status: 0 done; 1 failed; 2 wrong usage; 3 done, but some input was damaged "
                 "or left out.");
  const PrintableOutput printableErrors(std::cerr);
  std::optional<PrintableOutput> printable;
  if (isatty(STDOUT_FILENO) == 1) // a script gets file names as they are
  {
    printable.emplace(std::cout);
  }
  // A limit on the size of files shall be an error of writing, as a full disk is.
  std::signal(SIGXFSZ, SIG_IGN);
  // A shell script starts what runs in the background with SIGINT ignored; it ends every command.
  std::signal(SIGINT, SIG_DFL);
  CommandAction action;
  for (const AddCommand add : commands)
  {
    add(program, action);
  }
  try
  {
    program.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return ReportParseError(program, error);
  }
  return RunAction(program, action);
}

} // namespace nexrad::application
