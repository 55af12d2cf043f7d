// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/MovieWriter.h"
#include "nexrad/Model/Time.h"

#include <array>
#include <filesystem>
#include <memory>

namespace nexrad::scene
{

/// "out.png" for one picture, "out-20060312T180000Z.png" for one of several.
std::filesystem::path PictureName(const std::filesystem::path& output, Time time, bool several);

/// A movie of the kind that the name says: .mp4, through ffmpeg; else Ogg Theora. Throws Error when
/// it cannot be begun.
std::unique_ptr<MovieWriter> MakeMovieWriter(
  const std::filesystem::path& output, const std::array<int, 2>& size, int framesPerSecond);

} // namespace nexrad::scene
