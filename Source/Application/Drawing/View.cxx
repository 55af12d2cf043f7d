// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/View.h"

#include "Drawing/PictureWindow.h"
#include "Drawing/Viewer.h"
#include "Scene/RadarSession.h"
#include "Scene/VolumeAppearance.h"

namespace nexrad::scene
{

ViewReport View(const ViewRequest& request)
{
  RequireDisplay();
  auto series = OpenInputs(request.input, request.progress);
  std::vector<std::size_t> chosen = ChooseTimes(*series, request.input);
  RadarSession session(std::move(series), std::move(chosen), request.scene, request.input.box);
  Viewer viewer(session, {request.size, request.camera, request.interval, request.pictures});
  if (request.progress)
  {
    request.progress(1.0);
  }
  viewer.Run();
  ViewReport report;
  report.pictures = viewer.Pictures();
  report.notes = LinesPassedOver(request.scene);
  report.problems = session.Problems();
  report.problems.insert(report.problems.end(), viewer.Problems().begin(), viewer.Problems().end());
  return report;
}

} // namespace nexrad::scene
