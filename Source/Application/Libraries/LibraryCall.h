// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Libraries/ProgramLibrary.h"
#include "nexrad/System/Error.h"

#include <exception>

/// Calls from the program into a library that it loads, by a function of C that takes a request and
/// fills a report. A report has a text `error`: why the work failed, or "".
namespace nexrad::application
{

/// A library of the program, for LoadProgramFunction.
struct LibraryName
{
  const char* file;
  const char* does;
  const char* target;
};

/// Loads the library and has its function do the request. Throws Error when there is no such
/// library, and for what the report says went wrong.
template <typename Report, typename Request>
Report CallLibrary(const LibraryName& library, const char* function, const Request& request)
{
  const auto work = reinterpret_cast<void (*)(const Request*, Report*)>(
    LoadProgramFunction(library.file, function, library.does, library.target));
  Report report;
  work(&request, &report);
  if (!report.error.empty())
  {
    throw Error(report.error);
  }
  return report;
}

/// The other side: does the work of such a function. No exception may leave the library.
template <typename Report, typename Request>
void AnswerCall(Report (*work)(const Request&), const Request* request, Report* report)
{
  try
  {
    *report = work(*request);
  }
  catch (const std::exception& error)
  {
    report->error = error.what();
  }
}

} // namespace nexrad::application
