// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

#include <array>
#include <filesystem>
#include <memory>

class vtkImageData;

namespace nexrad::scene
{

/// Writes pictures of one size as a movie. The file appears under its name when Finish returns; a
/// movie that is not finished leaves nothing.
class MovieWriter
{
public:
  virtual ~MovieWriter() = default;

  /// Throws Error when the frame cannot be written.
  virtual void AddFrame(vtkImageData* picture) = 0;
  /// Throws Error when the movie cannot be completed.
  virtual void Finish() = 0;
};

/// A movie of the kind that the name says: .mp4, through ffmpeg; else Ogg Theora, through VTK.
/// Throws Error when it cannot be begun.
std::unique_ptr<MovieWriter> MakeMovieWriter(
  const std::filesystem::path& output, const std::array<int, 2>& size, int framesPerSecond);

/// "out.png" for one picture, "out-20060312T180000Z.png" for one of several.
std::filesystem::path PictureName(const std::filesystem::path& output, Time time, bool several);

} // namespace nexrad::scene
