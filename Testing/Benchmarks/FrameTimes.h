// SPDX-License-Identifier: BSD-3-Clause
// Mappers side by side, and the times of their frames.
#pragma once

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkRenderWindow;
class vtkRenderer;
class vtkVolume;
class vtkVolumeProperty;

namespace nexrad::benchmarks
{

/// What the card does between two places, by GL_TIME_ELAPSED.
class CardTimer
{
public:
  void Begin();
  void End();
  /// Milliseconds between the last Begin and End; NaN: they were not called, or the context has no
  /// such timer.
  double Take();

private:
  unsigned int Query = 0;
};

/// A mapper that measures its own drawing.
template <class Mapper>
class TimedMapper : public Mapper
{
public:
  static TimedMapper* New()
  {
    auto* mapper = new TimedMapper;
    mapper->InitializeObjectBase();
    return mapper;
  }

  void GPURender(vtkRenderer* renderer, vtkVolume* volume) override
  {
    this->Timer.Begin();
    Mapper::GPURender(renderer, volume);
    this->Timer.End();
  }

  CardTimer Timer;
};

/// Median of some times; they are put into another order.
double Median(std::vector<double>& times);

/// A mapper and the times of its frames in milliseconds.
struct Contender
{
  std::string Name;
  vtkSmartPointer<vtkVolumeMapper> Mapper;
  CardTimer* Timer = nullptr; ///< nullptr: it does not draw by the card
  /// Its own: VTK's fixed-point ray caster adds a gradient opacity to the property, which the
  /// others would then have to heed.
  vtkSmartPointer<vtkVolumeProperty> Property;
  std::vector<double> Wall; ///< from the call until the picture is complete
  /// Of all threads of the program in that time: what a software renderer takes, whatever else
  /// runs.
  std::vector<double> Processor;
  std::vector<double> Card; ///< of the volume alone

  /// Draws the volume with this mapper and adds the times.
  void Draw(vtkRenderWindow* window, vtkVolume* volume);
  void ForgetTimes();
};

/**
 * The mapper by fragments and by compute shaders, sampled and, if asked for, pre-integrated, and
 * VTK's GPU ray caster, which is the last. Whether a context has compute shaders is known after a
 * frame: see RemoveMissing.
 * @param makeProperty makes a property for each
 */
std::vector<Contender> MakeContenders(int slices, bool integrated,
  const std::function<vtkSmartPointer<vtkVolumeProperty>()>& makeProperty);
/// Takes those away that were drawn in another way than theirs.
void RemoveMissing(std::vector<Contender>& contenders);

/// Rows of a table: what was drawn, the name, the times, and those over those of the one called
/// "GPU ray caster".
void PrintTimes(const std::string& drawn, std::vector<Contender>& contenders);
/// What stands above the last seven columns.
extern const char* const TimesHeading;
/// Prints the renderer of the context that is current.
void PrintRenderer(vtkRenderWindow* window);

} // namespace nexrad::benchmarks
