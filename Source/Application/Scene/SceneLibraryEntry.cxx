// SPDX-License-Identifier: BSD-3-Clause
#include "RenderRequest.h"

#include <exception>

/// The function that the program looks for in this library (RenderFunction). No exception may leave
/// it: what went wrong is in `report->error`.
extern "C" __attribute__((visibility("default"))) void nexrad3dRender(
  const nexrad::scene::RenderRequest* request, nexrad::scene::RenderReport* report)
{
  try
  {
    *report = nexrad::scene::Render(*request);
  }
  catch (const std::exception& error)
  {
    report->error = error.what();
  }
}
