// SPDX-License-Identifier: BSD-3-Clause
// A window whose pictures are compared with those of the program without it.
#pragma once

#include "WindowTest.h"

#include <QImage>

#include <filesystem>

namespace nexrad::testing
{

/// Bound of MeanDifference between a picture of the window and one of the program: they draw with
/// different OpenGL contexts, which round a few pixels of lines differently. Measured: 0.002 to
/// 0.015.
constexpr double contextBound = 0.03;
constexpr char contextReason[] =
  "how many pixels of lines two contexts of OpenGL round differently "
  "depends on the size of the picture";

/// Mean over all pixels and colours of the absolute difference, 0 to 255.
double MeanDifference(const QImage& a, const QImage& b);

class WindowPictureTest : public WindowTest
{
protected:
  QImage TakePicture();

  /// The command that the window copies.
  std::string CopyCommand();

  /// Runs that command in a folder of its own.
  QImage DrawWithoutTheWindow();

  /// Writes a number into a box, and leaves it.
  void Enter(const char* box, const char* number);

  void Tick(const char* box);

  /// Saves a session through its dialog, and opens it in a new window.
  void Reopen();
};

} // namespace nexrad::testing
