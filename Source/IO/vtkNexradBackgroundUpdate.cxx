// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradBackgroundUpdate.h"

#include "vtkNexradMessages.h"

#include "nexrad/System/RangeLoop.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkNexradBackgroundUpdate);

struct vtkNexradBackgroundUpdate::Run
{
  vtkSmartPointer<vtkAlgorithm> algorithm;
  vtkNew<vtkStringArray> errors;
  vtkNew<vtkStringArray> warnings;
  std::atomic<bool> done = true;
  nexrad::ThreadGroup thread; // waits when it goes

  void Start(vtkAlgorithm* ofAlgorithm, const std::function<void(vtkAlgorithm*)>& work)
  {
    thread.Join();
    algorithm = ofAlgorithm;
    algorithm->SetAbortExecute(0);
    done = false;
    const auto update = [this, work]
    {
      vtkNexradMessages messages;
      messages.Watch(algorithm);
      work(algorithm);
      Fill(messages.Errors(), errors);
      Fill(messages.Warnings(), warnings);
      done = true;
    };
    thread.Start(1, update);
    if (thread.Count() == 0) // the system gives none
    {
      update();
    }
  }

  static void Fill(const std::vector<std::string>& lines, vtkStringArray* array)
  {
    array->SetNumberOfValues(0);
    for (const std::string& line : lines)
    {
      array->InsertNextValue(line);
    }
  }
};

vtkNexradBackgroundUpdate::vtkNexradBackgroundUpdate()
  : run(std::make_unique<Run>())
{
}

vtkNexradBackgroundUpdate::~vtkNexradBackgroundUpdate() = default;

void vtkNexradBackgroundUpdate::StartInformation(vtkAlgorithm* algorithm)
{
  run->Start(algorithm, [](vtkAlgorithm* of) { of->UpdateInformation(); });
}

void vtkNexradBackgroundUpdate::StartUpdate(vtkAlgorithm* algorithm)
{
  run->Start(algorithm, [](vtkAlgorithm* of) { of->Update(); });
}

void vtkNexradBackgroundUpdate::StartTimeStep(vtkAlgorithm* algorithm, double time)
{
  run->Start(algorithm, [time](vtkAlgorithm* of) { of->UpdateTimeStep(time); });
}

void vtkNexradBackgroundUpdate::StartExtent(vtkAlgorithm* algorithm, const int extent[6])
{
  std::array<int, 6> points{};
  std::copy_n(extent, points.size(), points.begin());
  run->Start(algorithm, [points](vtkAlgorithm* of) { of->UpdateExtent(points.data()); });
}

bool vtkNexradBackgroundUpdate::IsDone() const
{
  return run->done;
}

void vtkNexradBackgroundUpdate::Stop()
{
  if (run->algorithm != nullptr)
  {
    run->algorithm->SetAbortExecute(1);
  }
  run->thread.Join();
}

vtkStringArray* vtkNexradBackgroundUpdate::GetErrors()
{
  run->thread.Join();
  return run->errors;
}

vtkStringArray* vtkNexradBackgroundUpdate::GetWarnings()
{
  run->thread.Join();
  return run->warnings;
}

void vtkNexradBackgroundUpdate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Done: " << (this->IsDone() ? "yes" : "no") << '\n';
}
