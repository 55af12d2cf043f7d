// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Render.h"
#include "Libraries/LibraryCall.h"
#include "Web/WebPage.h"

/// The functions that the program looks for in this library.
extern "C" __attribute__((visibility("default"))) void nexrad3dRender(
  const nexrad::scene::RenderRequest* request, nexrad::scene::RenderReport* report)
{
  nexrad::application::AnswerCall(nexrad::scene::Render, request, report);
}

extern "C" __attribute__((visibility("default"))) void nexrad3dWeb(
  const nexrad::scene::WebRequest* request, nexrad::scene::WebReport* report)
{
  nexrad::application::AnswerCall(nexrad::application::MakeWebPage, request, report);
}
