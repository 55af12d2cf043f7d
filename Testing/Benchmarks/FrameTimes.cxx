// SPDX-License-Identifier: BSD-3-Clause
#include "FrameTimes.h"

#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkRenderWindow.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>

namespace nexrad::benchmarks
{

namespace
{

using SliceMapper = vtkOpenGLTextureSliceVolumeMapper;
using TimedSlices = TimedMapper<SliceMapper>;
using TimedRays = TimedMapper<vtkOpenGLGPUVolumeRayCastMapper>;

constexpr const char* RayCaster = "GPU ray caster";

bool HasTimer()
{
  GLint bits = 0;
  glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
  return bits > 0;
}

std::string ToText(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), value < 10.0 ? "%.2f" : "%.1f", value);
  return std::isnan(value) ? "–" : text;
}

} // namespace

const char* const TimesHeading =
  "drawn by | frame | processor | card, volume alone | frame / GPU ray caster | "
  "processor / GPU ray caster | card / GPU ray caster";

void CardTimer::Begin()
{
  if (HasTimer())
  {
    glGenQueries(1, &this->Query);
    glBeginQuery(GL_TIME_ELAPSED, this->Query);
  }
}

void CardTimer::End()
{
  if (this->Query != 0)
  {
    glEndQuery(GL_TIME_ELAPSED);
  }
}

double CardTimer::Take()
{
  if (this->Query == 0)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(this->Query, GL_QUERY_RESULT, &nanoseconds);
  glDeleteQueries(1, &this->Query);
  this->Query = 0;
  return 1e-6 * static_cast<double>(nanoseconds);
}

double Median(std::vector<double>& times)
{
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

void Contender::Draw(vtkRenderWindow* window, vtkVolume* volume)
{
  volume->SetMapper(this->Mapper);
  volume->SetProperty(this->Property);
  const std::clock_t processorBegin = std::clock();
  const auto begin = std::chrono::steady_clock::now();
  window->Render();
  window->WaitForCompletion();
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - begin;
  this->Wall.push_back(wall.count());
  this->Processor.push_back(
    1e3 * static_cast<double>(std::clock() - processorBegin) / CLOCKS_PER_SEC);
  this->Card.push_back(
    this->Timer != nullptr ? this->Timer->Take() : std::numeric_limits<double>::quiet_NaN());
}

void Contender::ForgetTimes()
{
  this->Wall.clear();
  this->Processor.clear();
  this->Card.clear();
}

std::vector<Contender> MakeContenders(int slices, bool integrated,
  const std::function<vtkSmartPointer<vtkVolumeProperty>()>& makeProperty)
{
  std::vector<Contender> contenders;
  for (const bool slabs : {false, true})
  {
    for (const auto& [way, name] :
      {std::pair(SliceMapper::FRAGMENTS, "fragments"), {SliceMapper::COMPUTE, "compute"}})
    {
      if (!slabs || integrated)
      {
        auto mapper = vtkSmartPointer<TimedSlices>::New();
        mapper->SetNumberOfSlices(slices);
        mapper->SetPreIntegration(slabs);
        mapper->SetWay(way);
        contenders.push_back({std::string(name) + (slabs ? ", pre-integrated" : ""), mapper,
          &mapper->Timer, makeProperty(), {}, {}, {}});
      }
    }
  }
  auto rays = vtkSmartPointer<TimedRays>::New();
  rays->AutoAdjustSampleDistancesOff();
  contenders.push_back({RayCaster, rays, &rays->Timer, makeProperty(), {}, {}, {}});
  return contenders;
}

void RemoveMissing(std::vector<Contender>& contenders)
{
  const auto isMissing = [](const Contender& contender)
  {
    auto* slices = SliceMapper::SafeDownCast(contender.Mapper);
    return slices != nullptr && slices->GetDrawnWay() != slices->GetWay();
  };
  contenders.erase(
    std::remove_if(contenders.begin(), contenders.end(), isMissing), contenders.end());
}

void PrintTimes(const std::string& drawn, std::vector<Contender>& contenders)
{
  const auto rays = std::find_if(contenders.begin(), contenders.end(),
    [](const Contender& contender) { return contender.Name == RayCaster; });
  const auto findMedians = [](Contender& contender)
  {
    return std::array<double, 3>{
      Median(contender.Wall), Median(contender.Processor), Median(contender.Card)};
  };
  const std::array<double, 3> ofRays = findMedians(*rays);
  for (Contender& contender : contenders)
  {
    const std::array<double, 3> times = findMedians(contender);
    std::printf("| %s | %s |", drawn.c_str(), contender.Name.c_str());
    for (const double time : times)
    {
      std::printf(" %s |", ToText(time).c_str());
    }
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      std::printf(" %s |", ToText(times[i] / ofRays[i]).c_str());
    }
    std::printf("\n");
  }
  std::fflush(stdout);
}

void PrintRenderer(vtkRenderWindow* window)
{
  window->Render();
  window->MakeCurrent();
  std::printf("%s, OpenGL %s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)),
    reinterpret_cast<const char*>(glGetString(GL_VERSION)));
}

} // namespace nexrad::benchmarks
