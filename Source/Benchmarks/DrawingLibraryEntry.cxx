// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/MeasureDrawing.h"
#include "Libraries/LibraryCall.h"
#include "Sheets/Sheets.h"

/// The functions that the benchmark looks for in this library (DrawingLibrary.h).
extern "C" __attribute__((visibility("default"))) void nexrad3dMeasureDrawing(
  const nexrad::application::DrawingRequest* request, nexrad::application::DrawingReport* report)
{
  nexrad::application::AnswerCall(nexrad::scene::MeasureDrawing, request, report);
}

extern "C" __attribute__((visibility("default"))) void nexrad3dDrawSheets(
  const nexrad::scene::SheetRequest* request, nexrad::scene::SheetReport* report)
{
  nexrad::application::AnswerCall(nexrad::scene::DrawSheets, request, report);
}
