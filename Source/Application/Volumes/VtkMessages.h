// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkCommand.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkObject;

namespace nexrad::application
{

/// Collects the errors and warnings of VTK objects in place of VTK's several lines on standard
/// error. An object is watched as long as this lives.
class VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// Of an algorithm, its executive is watched as well.
  void Watch(vtkObject* object);

  /// The text alone, without VTK's file, line and class.
  const std::vector<std::string>& Errors() const;
  const std::vector<std::string>& Warnings() const;
  void Clear();

  /// Throws nexrad::Error with the first error, if there is one.
  void ThrowFirstError() const;

private:
  class Observer;
  vtkSmartPointer<Observer> observer;
  std::vector<vtkSmartPointer<vtkObject>> watched;
};

} // namespace nexrad::application
