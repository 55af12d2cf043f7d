// SPDX-License-Identifier: BSD-3-Clause
#include "Libraries/LibraryCall.h"
#include "Viewer/RunWindow.h"

/// The function that the program looks for in this library.
extern "C" __attribute__((visibility("default"))) void nexrad3dWindow(
  const nexrad::scene::ViewRequest* request, nexrad::scene::ViewReport* report)
{
  nexrad::application::AnswerCall(nexrad::viewer::RunWindow, request, report);
}
