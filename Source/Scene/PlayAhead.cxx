// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/PlayAhead.h"

#include "Scene/Series/ReadAhead.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include <vtkImageData.h>

#include <utility>

namespace nexrad::scene
{
namespace
{

// Does for each volume what the slices need of it before they are drawn.
class Preparation
{
public:
  void operator()(vtkImageData* volume, vtkImageData* before)
  {
    prepared = vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(
      volume, before != nullptr && before == last ? prepared : nullptr);
    last = volume;
  }

private:
  vtkImageData* last = nullptr; // compared, never followed
  vtkSmartPointer<vtkObject> prepared;
};

} // namespace

std::unique_ptr<VolumeSeries> PlayAhead(std::unique_ptr<VolumeSeries> series,
  const std::vector<std::size_t>& steps, const SceneOptions& options)
{
  // Of what is drawn, the slices of one moment alone know codes, and what is prepared.
  const bool slices =
    options.mapper == MapperChoice::TextureSlice && !options.plan && options.colourBy.empty();
  series->AllowCodes(options.scalarsAsCodes && slices);
  ReadAheadOptions readAhead;
  readAhead.order = steps;
  if (slices)
  {
    readAhead.prepare = Preparation();
  }
  return ReadAhead(std::move(series), std::move(readAhead));
}

} // namespace nexrad::scene
