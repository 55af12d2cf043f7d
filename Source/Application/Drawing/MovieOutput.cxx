// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/MovieOutput.h"

#include "Drawing/FfmpegWriter.h"
#include "Drawing/TheoraWriter.h"

namespace fs = std::filesystem;

namespace nexrad::scene
{

fs::path PictureName(const fs::path& output, Time time, bool several)
{
  if (!several)
  {
    return output;
  }
  return output.parent_path() /
         (output.stem().string() + "-" + FormatForFileName(time) + output.extension().string());
}

std::unique_ptr<MovieWriter> MakeMovieWriter(
  const fs::path& output, const std::array<int, 2>& size, int framesPerSecond)
{
  return output.extension() == ".mp4" ? MakeFfmpegWriter(output, size.data(), framesPerSecond)
                                      : MakeTheoraWriter(output, framesPerSecond);
}

} // namespace nexrad::scene
