// SPDX-License-Identifier: BSD-3-Clause
#include "VtkMessages.h"

#include "nexrad/System/Error.h"

#include <vtkAlgorithm.h>
#include <vtkExecutive.h>
#include <vtkObject.h>

#include <algorithm>

namespace nexrad::application
{
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

class VtkMessages::Observer : public vtkCommand
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

VtkMessages::VtkMessages()
  : observer(vtkSmartPointer<Observer>::New())
{
}

VtkMessages::~VtkMessages()
{
  for (const auto& object : watched)
  {
    object->RemoveObserver(observer);
  }
}

void VtkMessages::Watch(vtkObject* object)
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

const std::vector<std::string>& VtkMessages::Errors() const
{
  return observer->errors;
}

const std::vector<std::string>& VtkMessages::Warnings() const
{
  return observer->warnings;
}

void VtkMessages::Clear()
{
  observer->errors.clear();
  observer->warnings.clear();
}

void VtkMessages::ThrowFirstError() const
{
  if (!observer->errors.empty())
  {
    throw Error(observer->errors.front());
  }
}

} // namespace nexrad::application
