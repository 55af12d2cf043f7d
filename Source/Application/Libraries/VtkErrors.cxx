// SPDX-License-Identifier: BSD-3-Clause
#include "Libraries/VtkErrors.h"

#include "Output/MessageOutput.h"
#include "nexrad/System/MessageText.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <mutex>
#include <string>
#include <utility>

namespace nexrad::application
{
namespace
{

// VTK writes "ERROR: In FILE, line N", then "CLASS (ADDRESS): TEXT" and empty lines.
std::string TextOf(const char* message)
{
  std::string text = message == nullptr ? "" : message;
  const std::size_t behindClass = text.find("): ");
  text.erase(0, behindClass == std::string::npos ? 0 : behindClass + 3);
  text.erase(text.find_last_not_of(" \n") + 1);
  return text;
}

// Takes the place of VTK's own window of messages. Each library of the program has a copy of this
// code, and all of them use the one object that the program made.
class ErrorWindow : public vtkOutputWindow
{
public:
  static ErrorWindow* New();
  vtkTypeMacro(ErrorWindow, vtkOutputWindow);

  static ErrorWindow* Get() { return SafeDownCast(vtkOutputWindow::GetInstance()); }

  void DisplayErrorText(const char* message) override
  {
    const std::lock_guard<std::mutex> lock(mutex); // volumes are read ahead on a thread
    anyError = true;
    error = error.empty() ? TextOf(message) : error;
  }
  void DisplayWarningText(const char* message) override { this->Warn(message); }
  void DisplayGenericWarningText(const char* message) override { this->Warn(message); }
  void DisplayText(const char* message) override { this->Warn(message); }
  void DisplayDebugText(const char* message) override { this->Warn(message); }

  std::string Next()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    return std::exchange(error, {});
  }
  bool HasFailed()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    return anyError;
  }

private:
  std::mutex mutex;
  std::string error; // the first one that nobody has asked for
  bool anyError = false;

  void Warn(const char* message) { PrintMessage("nexrad3d: " + TextOf(message)); }
};
vtkStandardNewMacro(ErrorWindow);

} // namespace

void TakeVtkErrors()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // it prints what the window gets
  const vtkNew<ErrorWindow> window;
  vtkOutputWindow::SetInstance(window);
}

std::string NextVtkError()
{
  ErrorWindow* window = ErrorWindow::Get();
  return window != nullptr ? window->Next() : std::string();
}

void ThrowVtkErrors()
{
  const std::string error = NextVtkError();
  if (!error.empty())
  {
    throw Error(Shortened(error));
  }
}

int FailOnVtkErrors(const std::function<int()>& work)
{
  TakeVtkErrors();
  const int status = work();
  ErrorWindow* window = ErrorWindow::Get();
  const std::string error = NextVtkError();
  if (!error.empty())
  {
    PrintMessage("nexrad3d: " + error);
  }
  return window != nullptr && window->HasFailed() ? 1 : status;
}

} // namespace nexrad::application
