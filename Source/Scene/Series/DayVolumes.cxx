// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Series/DayVolumes.h"

#include "nexrad/System/Error.h"
#include "vtkNexradDayReader.h"
#include "vtkNexradMessages.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkStringArray.h>

namespace nexrad::scene
{
namespace
{

class DayVolumes : public VolumeSeries
{
public:
  explicit DayVolumes(vtkNexradDayReader* dayReader)
    : reader(dayReader)
  {
    vtkNexradMessages messages;
    messages.Watch(reader);
    reader->UpdateInformation();
    messages.ThrowFirstError();
    vtkDoubleArray* steps = reader->GetTimeSteps();
    for (vtkIdType i = 0; i < steps->GetNumberOfValues(); ++i)
    {
      times.push_back(FromSeconds(steps->GetValue(i)));
    }
    if (times.empty())
    {
      throw Error("the radar files give no time step");
    }
  }

  const std::vector<Time>& Times() const override { return times; }

  vtkSmartPointer<vtkImageData> Load(std::size_t index, const Progress&) override
  {
    vtkNexradMessages messages;
    messages.Watch(reader);
    reader->UpdateTimeStep(reader->GetTimeSteps()->GetValue(static_cast<vtkIdType>(index)));
    messages.ThrowFirstError();
    // The reader writes its next volume into the same object.
    auto volume = vtkSmartPointer<vtkImageData>::New();
    volume->ShallowCopy(reader->GetOutput());
    return volume;
  }

  vtkSmartPointer<vtkImageData> LoadCoarse(std::size_t index) override
  {
    if (reader->GetMethod() != vtkNexradGridAlgorithm::BEAM)
    {
      return this->Load(index, {});
    }
    vtkNexradMessages messages;
    messages.Watch(reader);
    auto volume = vtkSmartPointer<vtkImageData>::New();
    reader->MergeCoarse(reader->GetTimeSteps()->GetValue(static_cast<vtkIdType>(index)), volume);
    messages.ThrowFirstError();
    return volume;
  }

  std::vector<std::string> Problems() const override
  {
    std::vector<std::string> lines;
    vtkStringArray* damage = reader->GetDamage();
    for (vtkIdType i = 0; i < damage->GetNumberOfValues(); ++i)
    {
      lines.push_back(damage->GetValue(i));
    }
    return lines;
  }

private:
  vtkSmartPointer<vtkNexradDayReader> reader;
  std::vector<Time> times;
};

} // namespace

std::unique_ptr<VolumeSeries> OpenDayVolumes(vtkNexradDayReader* reader)
{
  return std::make_unique<DayVolumes>(reader);
}

} // namespace nexrad::scene
