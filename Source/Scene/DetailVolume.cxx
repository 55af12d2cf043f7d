// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/DetailVolume.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>

#include <algorithm>

namespace nexrad::scene
{
namespace
{

void Crop(vtkVolumeMapper* mapper, const std::array<double, 6>& box, int regions)
{
  mapper->SetCropping(1);
  mapper->SetCroppingRegionPlanes(box[0], box[1], box[2], box[3], box[4], box[5]);
  mapper->SetCroppingRegionFlags(regions);
}

// The side of the box along an axis on which the camera is: 0 below, 2 above, 1 neither. A ray from
// the camera comes through the regions of that side before those of the box.
std::array<int, 3> SidesOfCamera(const std::array<double, 6>& box, vtkCamera* camera)
{
  const double* position = camera->GetPosition();
  const double* direction = camera->GetDirectionOfProjection();
  std::array<int, 3> sides{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const bool parallel = camera->GetParallelProjection() != 0;
    const bool below = parallel ? direction[axis] > 0.0 : position[axis] < box[2 * axis];
    const bool above = parallel ? direction[axis] < 0.0 : position[axis] > box[2 * axis + 1];
    sides[axis] = below ? 0 : above ? 2 : 1;
  }
  return sides;
}

bool IsWithin(const std::array<double, 4>& faces, const std::array<double, 6>& box)
{
  return faces[0] >= box[0] && faces[1] <= box[1] && faces[2] >= box[2] && faces[3] <= box[3];
}

} // namespace

RegionsAbout DivideAbout(const std::array<double, 6>& box, vtkCamera* camera)
{
  const std::array<int, 3> sides = SidesOfCamera(box, camera);
  RegionsAbout regions;
  for (int region = 0; region < 27; ++region)
  {
    const std::array<int, 3> part = {region % 3, region / 3 % 3, region / 9};
    const bool within = part == std::array<int, 3>{1, 1, 1};
    bool before = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      before = before && (part[axis] == 1 || part[axis] == sides[axis]);
    }
    if (!within)
    {
      (before ? regions.before : regions.behind) |= 1 << region;
    }
  }
  return regions;
}

DetailVolume::DetailVolume(vtkRenderer* theRenderer)
  : renderer(theRenderer)
{
}

DetailVolume::~DetailVolume()
{
  renderer->RemoveVolume(inner);
  renderer->RemoveVolume(front);
}

std::vector<vtkVolumeMapper*> DetailVolume::Mappers() const
{
  if (!shown)
  {
    return {};
  }
  return {vtkVolumeMapper::SafeDownCast(inner->GetMapper()),
    vtkVolumeMapper::SafeDownCast(front->GetMapper())};
}

void DetailVolume::Show(vtkImageData* detail, vtkVolume* whole, vtkVolumeMapper* detailMapper,
  vtkVolumeMapper* frontMapper)
{
  shown = true;
  detailMapper->SetInputDataObject(detail);
  frontMapper->SetInputDataObject(whole->GetMapper()->GetDataSetInput());
  inner->SetMapper(detailMapper);
  front->SetMapper(frontMapper);
  for (vtkVolume* part : {inner.Get(), front.Get()})
  {
    part->SetProperty(whole->GetProperty());
    renderer->RemoveVolume(part); // volumes are drawn in the order in which they were added
    renderer->AddVolume(part);
  }
}

void DetailVolume::Hide(vtkVolume* whole)
{
  shown = false;
  for (vtkVolume* part : {inner.Get(), front.Get()})
  {
    renderer->RemoveVolume(part);
    part->SetMapper(nullptr);
  }
  if (auto* mapper = vtkVolumeMapper::SafeDownCast(whole->GetMapper()))
  {
    mapper->SetCropping(0);
  }
}

void DetailVolume::Follow(vtkVolume* whole, const std::optional<SeenPart>& seen)
{
  if (!shown)
  {
    return;
  }
  std::array<double, 6> box{};
  std::copy_n(inner->GetMapper()->GetBounds(), box.size(), box.begin());
  const RegionsAbout regions = DivideAbout(box, renderer->GetActiveCamera());
  Crop(vtkVolumeMapper::SafeDownCast(whole->GetMapper()), box, regions.behind);
  Crop(vtkVolumeMapper::SafeDownCast(front->GetMapper()), box, regions.before);
  front->SetVisibility(regions.before != 0 && !(seen && IsWithin(seen->faces, box)));
}

} // namespace nexrad::scene
