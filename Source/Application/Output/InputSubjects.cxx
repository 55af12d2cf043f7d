// SPDX-License-Identifier: BSD-3-Clause
#include "Output/InputSubjects.h"

#include "Output/MessageOutput.h"
#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/System/Error.h"

namespace nexrad::application
{

std::vector<InputSubject> FindSubjects(const std::vector<std::string>& arguments, bool& leftOut)
{
  std::vector<InputSubject> subjects;
  for (const std::string& argument : arguments)
  {
    if (KindOf(argument) != StoredKind::Folder || IsChunkFolder(argument))
    {
      subjects.push_back({argument});
      continue;
    }
    try
    {
      const InputFiles found = FindInputFiles({argument});
      for (const InputProblem& problem : found.problems)
      {
        PrintMessage(problem.Line());
        leftOut = true;
      }
      for (const std::filesystem::path& path : found.paths)
      {
        subjects.push_back({path.string(), true});
      }
    }
    catch (const Error&)
    {
      subjects.push_back({argument}); // reading it says why
    }
  }
  return subjects;
}

} // namespace nexrad::application
