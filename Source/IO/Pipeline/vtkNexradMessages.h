// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradMessages.h
 * @brief  the errors and warnings of VTK objects as text
 */
#ifndef vtkNexradMessages_h
#define vtkNexradMessages_h

#include "vtkNexradIOModule.h" // For export macro

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkObject;

/**
 * Collects the errors and warnings of VTK objects, which VTK otherwise prints on standard error,
 * several lines each. An object is watched as long as this lives.
 */
class VTKNEXRADIO_EXPORT vtkNexradMessages
{
public:
  vtkNexradMessages();
  ~vtkNexradMessages();
  vtkNexradMessages(const vtkNexradMessages&) = delete;
  vtkNexradMessages& operator=(const vtkNexradMessages&) = delete;

  /**
   * Of an algorithm, its executive is watched as well.
   */
  void Watch(vtkObject* object);

  ///@{
  /**
   * The text alone, without VTK's file, line and class.
   */
  const std::vector<std::string>& Errors() const;
  const std::vector<std::string>& Warnings() const;
  ///@}

  void Clear();

  /**
   * Throws nexrad::Error with the first error, if there is one.
   */
  void ThrowFirstError() const;

private:
  class Observer;
  vtkSmartPointer<Observer> observer;
  std::vector<vtkSmartPointer<vtkObject>> watched;
};

#endif
// VTK-HeaderTest-Exclude: vtkNexradMessages.h
