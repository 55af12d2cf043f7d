// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

class QVTKOpenGLNativeWidget;
class vtkNexradVolumeScene;

namespace nexrad::viewer
{

/// A scene in a part of the window. What is pointed at must outlive those who have it.
struct ShownScene
{
  QVTKOpenGLNativeWidget* widget = nullptr;
  vtkNexradVolumeScene* scene = nullptr;
  std::function<void()> drawSoon; ///< draws once the events that wait are done with
};

} // namespace nexrad::viewer
