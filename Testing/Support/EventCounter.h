// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <string>
#include <vector>

namespace nexrad::testing
{

/// Counts the errors, warnings and progress events of objects, and keeps the texts, so that a test
/// can expect them; what is observed is not printed.
class EventCounter : public vtkCommand
{
public:
  static EventCounter* New() { return new EventCounter; }

  /// From now on the object's events are counted here.
  void Observe(vtkObject* object)
  {
    for (const unsigned long event :
      {vtkCommand::ErrorEvent, vtkCommand::WarningEvent, vtkCommand::ProgressEvent})
    {
      object->AddObserver(event, this);
    }
  }

  void Execute(vtkObject*, unsigned long event, void* data) override
  {
    if (event == vtkCommand::ProgressEvent)
    {
      this->progress.push_back(*static_cast<double*>(data));
      return;
    }
    const std::string text = static_cast<const char*>(data);
    (event == vtkCommand::ErrorEvent ? this->errors : this->warnings).push_back(text);
  }

  std::vector<std::string> errors;
  std::vector<std::string> warnings;
  std::vector<double> progress; ///< 0…1
};

/// True when one of the texts holds the part.
inline bool AnyHolds(const std::vector<std::string>& texts, const std::string& part)
{
  for (const std::string& text : texts)
  {
    if (text.find(part) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

} // namespace nexrad::testing
