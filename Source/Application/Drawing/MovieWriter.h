// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

} // namespace nexrad::scene
