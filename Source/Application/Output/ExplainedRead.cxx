// SPDX-License-Identifier: BSD-3-Clause
#include "Output/ExplainedRead.h"

#include "Output/MessageOutput.h"
#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Model/RadarVolume.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/System/Error.h"

#include <string>
#include <utility>

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

ExplainedReader::ExplainedReader(
  const std::vector<InputSubject>& theSubjects, const Level2Options& theOptions)
  : subjects(theSubjects)
  , options(theOptions)
{
}

ExplainedReader::Reading ExplainedReader::Read(std::size_t which) const
{
  const std::string& file = subjects[which].file;
  try
  {
    return {ReadLevel2(file, options)};
  }
  catch (const Error& error)
  {
    Reading reading;
    reading.failed = true;
    reading.volume.file = file;
    reading.volume.damage.push_back({0, error.what()});
    return reading;
  }
}

RadarVolume ExplainedReader::Next()
{
  Reading own = ahead ? std::move(*ahead) : this->Read(index);
  ahead.reset();
  ++index;
  if (LacksEnd(own.volume) && index < subjects.size())
  {
    ahead = this->Read(index);
    EndWithNext(own.volume, ahead->volume);
  }
  for (const Damage& damage : own.volume.damage)
  {
    PrintMessage(own.failed ? damage.what
                            : subjects[index - 1].file + ": offset " +
                                std::to_string(damage.offset) + ": " + damage.what);
  }
  return std::move(own.volume);
}

} // namespace nexrad::application
