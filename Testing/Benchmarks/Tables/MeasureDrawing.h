// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Tables/BenchReport.h"
#include "Tables/Measurement.h"

#include <array>
#include <filesystem>
#include <vector>

namespace nexrad::application
{

/// Volume files of one size, whose times ascend; at least two.
struct VolumesOfSize
{
  std::array<int, 3> dimensions;
  std::vector<std::filesystem::path> files;
};

/// What drawing is measured with.
struct DrawingRequest
{
  std::vector<VolumesOfSize> volumes;
  std::vector<int> slices;              ///< numbers of slices, from 1 on
  std::array<int, 2> size = {796, 532}; ///< of the picture in pixels, as in the thesis
  int runs = 3;                         ///< of each measurement; frames are seen from as many sides
};

/// Seconds from the call that draws a frame to its end, all samples of the volume's box taken.
struct FrameTimes
{
  int slices = 0;
  Measurement slicing;    ///< by vtkOpenGLTextureSliceVolumeMapper
  Measurement rayCasting; ///< by VTK's GPU ray caster with samples as far apart
};

/// The thesis's t1, t2 and t3 of one size, in seconds.
struct DrawingOfSize
{
  std::array<int, 3> dimensions{};
  Measurement read;   ///< t1: a volume from its file, decompressed, as codes where it has them
  Measurement upload; ///< t2: a frame of a new volume less one of the same again, with one
                      ///< slice each
  Measurement rayCastingRead;     ///< the same for the ray caster, as values
  Measurement rayCastingUpload;   ///< the same for the ray caster, with one sample
  std::vector<FrameTimes> frames; ///< t3, in the order of the request's slices
};

struct DrawingReport
{
  OpenGLNames opengl;
  std::vector<DrawingOfSize> sizes;
};

} // namespace nexrad::application

namespace nexrad::scene
{

/// Measures the thesis's t1, t2 and t3, the mappers in turn. The camera looks 20° from the
/// vertical, as in the thesis. Files are read again and again, so they come from the system's
/// cache. Throws Error when there is no display or a volume cannot be read.
application::DrawingReport MeasureDrawing(const application::DrawingRequest& request);

} // namespace nexrad::scene
