// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/SeenVoxels.h"

#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"

#include <vtkNexradVolumeScene.h>

namespace nexrad::viewer
{

SeenVoxels::SeenVoxels(SceneView& sceneView, Playback& thePlayback)
  : QObject(&sceneView)
  , view(sceneView)
  , playback(thePlayback)
{
  constexpr int milliseconds = 250; // without another picture: it rests
  rest.setSingleShot(true);
  rest.setInterval(milliseconds);
  connect(&rest, &QTimer::timeout, this, &SeenVoxels::Look);
  const auto wait = [this] { rest.start(); };
  connect(&view, &SceneView::PictureDrawn, this, wait);
  connect(&view, &SceneView::CameraMoved, this, wait);
}

void SeenVoxels::Look()
{
  if (playback.State().leavesOutFiner)
  {
    playback.SetSeen(view.Scene()->SeenBox());
  }
}

} // namespace nexrad::viewer
