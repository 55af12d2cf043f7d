// SPDX-License-Identifier: BSD-3-Clause
// How long the scene takes to show a map of columns in place of another one, without drawing it:
// what a window that shows the scene waits for. Of codes, as volume files are read, and of values,
// as radar files are merged. Usage: BenchmarkMaps INPUT, a volume as `nexrad3d grid` writes it, for
// example with `--dims 256x256x128`. Needs no X server.
#include "nexrad/Codec/NxvReader.h"
#include "vtkNexradImageConversion.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkNexradVolumeScene.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

namespace
{

constexpr int rounds = 11;
using Clock = std::chrono::steady_clock;

double UpdateTime(vtkNexradVolumeScene* scene, const char* map)
{
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round)
  {
    scene->SetOption("map", "3km");
    scene->Update();
    const auto begin = Clock::now();
    scene->SetOption("map", map);
    scene->Update();
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  }
  std::nth_element(times.begin(), times.begin() + rounds / 2, times.end());
  return times[rounds / 2];
}

void MeasureMaps(const char* path, bool codes)
{
  vtkNew<vtkImageData> volume;
  vtkNexradReadVolumeFile(path, {}, codes, volume);
  vtkNew<vtkNexradVolumeScene> scene;
  scene->SetVolume(volume);
  std::printf("| %s |", codes ? "codes" : "values");
  for (const char* map : {"composite", "lowest", "echo-top", "vil"})
  {
    std::printf(" %.1f |", UpdateTime(scene, map));
  }
  std::printf("\n");
}

} // namespace

int main(int count, char** arguments)
{
  if (count != 2)
  {
    std::fprintf(stderr, "usage: BenchmarkMaps INPUT\n");
    return 2;
  }
  std::printf("Median time of a map in ms:\n\n| volume | composite | lowest | echo top | liquid |\n"
              "|---|---|---|---|---|\n");
  MeasureMaps(arguments[1], true);
  MeasureMaps(arguments[1], false);
  return 0;
}
