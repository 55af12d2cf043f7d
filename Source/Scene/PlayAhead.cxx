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
  ReadAheadOptions readAhead;
  readAhead.order = steps;
  if (options.mapper == MapperChoice::TextureSlice && !options.plan && options.colourBy.empty())
  {
    readAhead.prepare = Preparation();
  }
  return ReadAhead(std::move(series), std::move(readAhead));
}

} // namespace nexrad::scene
