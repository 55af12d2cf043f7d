// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QTimer>

namespace nexrad::viewer
{

class Playback;
class SceneView;

/// Shows a volume in voxels as fine as the pixels, where its file has them: once the picture rests,
/// the part of the volume that is seen is read in them, and drawn in place of that part. A box that
/// the user makes goes first.
class SeenVoxels : public QObject
{
  Q_OBJECT

public:
  /// It goes with the view. The playback must outlive it.
  SeenVoxels(SceneView& view, Playback& playback);

private:
  void Look();

  SceneView& view;
  Playback& playback;
  QTimer rest;
};

} // namespace nexrad::viewer
