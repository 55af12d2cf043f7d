// SPDX-License-Identifier: BSD-3-Clause
// Prints the elevation angle and the number of rays of each sweep: Sweeps FILE
#include <nexrad/Level2/Level2File.h>

#include <exception>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: Sweeps FILE\n";
    return 2;
  }
  try
  {
    const nexrad::RadarVolume volume = nexrad::ReadLevel2(argv[1]);
    for (const nexrad::Sweep& sweep : volume.sweeps)
    {
      std::cout << sweep.MedianElevation() << " degrees, " << sweep.rays.size() << " rays\n";
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
