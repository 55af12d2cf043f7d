// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradMessages.h"

#include "nexrad/System/Error.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkObject.h"

#include <algorithm>

namespace
{

// VTK writes "ERROR: In FILE, line N\nCLASS (ADDRESS): TEXT\n\n".
std::string TextOf(const char* message)
{
  std::string text = message == nullptr ? "" : message;
  const std::size_t behindClass = text.find("): ");
  if (behindClass != std::string::npos)
  {
    text.erase(0, behindClass + 3);
  }
  text.erase(text.find_last_not_of(" \n") + 1);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

} // namespace

class vtkNexradMessages::Observer : public vtkCommand
{
public:
  static Observer* New() { return new Observer; }

  void Execute(vtkObject*, unsigned long event, void* data) override
  {
    auto& texts = event == vtkCommand::ErrorEvent ? errors : warnings;
    texts.push_back(TextOf(static_cast<const char*>(data)));
  }

  std::vector<std::string> errors;
  std::vector<std::string> warnings;
};

vtkNexradMessages::vtkNexradMessages()
  : observer(vtkSmartPointer<Observer>::New())
{
}

vtkNexradMessages::~vtkNexradMessages()
{
  for (const auto& object : watched)
  {
    object->RemoveObserver(observer);
  }
}

void vtkNexradMessages::Watch(vtkObject* object)
{
  object->AddObserver(vtkCommand::ErrorEvent, observer);
  object->AddObserver(vtkCommand::WarningEvent, observer);
  watched.emplace_back(object);
  // An algorithm's executive repeats the algorithm's error with a print of its own state.
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(object))
  {
    this->Watch(algorithm->GetExecutive());
  }
}

const std::vector<std::string>& vtkNexradMessages::Errors() const
{
  return observer->errors;
}

const std::vector<std::string>& vtkNexradMessages::Warnings() const
{
  return observer->warnings;
}

void vtkNexradMessages::Clear()
{
  observer->errors.clear();
  observer->warnings.clear();
}

void vtkNexradMessages::ThrowFirstError() const
{
  if (!observer->errors.empty())
  {
    throw nexrad::Error(observer->errors.front());
  }
}
