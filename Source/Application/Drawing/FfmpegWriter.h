// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/MovieWriter.h"

#include <filesystem>
#include <memory>

namespace nexrad::scene
{

/// H.264 in an .mp4, through the program ffmpeg. Throws Error when it is not installed.
std::unique_ptr<MovieWriter> MakeFfmpegWriter(
  const std::filesystem::path& path, const int size[2], int framesPerSecond);

} // namespace nexrad::scene
