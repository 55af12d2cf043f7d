// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::application
{

/// Draws pictures by `nexrad3d render` in a process of its own, one at a time: what a driver of
/// OpenGL does with memory over days does not stay, and merging does not wait for it. The process
/// gives way to others (nice).
class PictureProcess
{
public:
  PictureProcess() = default;
  /// Ends a picture that is being drawn.
  ~PictureProcess();
  PictureProcess(const PictureProcess&) = delete;
  PictureProcess& operator=(const PictureProcess&) = delete;

  /// True while a picture is being drawn.
  bool IsRunning();
  /// Begins to draw with these words of a command line, "render" first. Where no
  /// process can be started, LastStatus is not 0.
  void Start(const std::vector<std::string>& words);
  /// Exit status of the last one that ended; below 0: a signal.
  int LastStatus() const { return status; }

private:
  int process = 0; ///< 0: none
  int status = 0;
};

} // namespace nexrad::application
