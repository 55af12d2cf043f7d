// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// Ogg Theora, through VTK.
std::unique_ptr<MovieWriter> MakeTheoraWriter(
  const std::filesystem::path& path, int framesPerSecond);

/// H.264 in an .mp4, through the program ffmpeg. Throws Error when it is not installed.
std::unique_ptr<MovieWriter> MakeFfmpegWriter(
  const std::filesystem::path& path, const int size[2], int framesPerSecond);

} // namespace nexrad::scene
