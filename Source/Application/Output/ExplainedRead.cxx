// SPDX-License-Identifier: BSD-3-Clause
#include "Output/ExplainedRead.h"

#include "nexrad/System/Error.h"

#include <iostream>

namespace nexrad::application
{

RadarVolume ReadOrExplain(const std::string& file, const Level2Options& options)
{
  try
  {
    RadarVolume volume = ReadLevel2(file, options);
    for (const Damage& damage : volume.damage)
    {
      std::cerr << file << ": offset " << damage.offset << ": " << damage.what << '\n';
    }
    return volume;
  }
  catch (const Error& error)
  {
    std::cerr << error.what() << '\n';
    RadarVolume volume;
    volume.file = file;
    volume.damage.push_back({0, error.what()});
    return volume;
  }
}

} // namespace nexrad::application
