// SPDX-License-Identifier: BSD-3-Clause
#include "Output/ExplainedRead.h"

#include "Output/MessageOutput.h"
#include "nexrad/System/Error.h"

namespace nexrad::application
{

RadarVolume ReadOrExplain(const std::string& file, const Level2Options& options)
{
  try
  {
    RadarVolume volume = ReadLevel2(file, options);
    for (const Damage& damage : volume.damage)
    {
      PrintMessage(file + ": offset " + std::to_string(damage.offset) + ": " + damage.what);
    }
    return volume;
  }
  catch (const Error& error)
  {
    PrintMessage(error.what());
    RadarVolume volume;
    volume.file = file;
    volume.damage.push_back({0, error.what()});
    return volume;
  }
}

} // namespace nexrad::application
