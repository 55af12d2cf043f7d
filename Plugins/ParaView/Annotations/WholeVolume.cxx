// SPDX-License-Identifier: BSD-3-Clause
#include "WholeVolume.h"

#include "Scene/Frame/VolumeInformation.h"

#include "vtkCommunicator.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <array>
#include <cmath>
#include <limits>

namespace
{

// The place of a voxel along an axis: the middle one of `step` of them.
int Middle(int cell, int step)
{
  return cell * step + (step - 1) / 2;
}

// The volume with at most 128 voxels along x and y, of which it keeps the middle ones, and no
// values yet.
vtkSmartPointer<vtkImageData> Thin(vtkImageData* whole, std::array<int, 3>& steps)
{
  constexpr int most = 128;
  auto thin = vtkSmartPointer<vtkImageData>::New();
  std::array<int, 3> size{};
  std::array<double, 3> spacing{};
  std::array<double, 3> origin{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const int voxels = whole->GetDimensions()[axis];
    steps[axis] = axis < 2 ? (voxels + most - 1) / most : 1;
    size[axis] = (voxels + steps[axis] - 1) / steps[axis];
    spacing[axis] = whole->GetSpacing()[axis] * steps[axis];
    origin[axis] =
      whole->GetOrigin()[axis] +
      whole->GetSpacing()[axis] * (whole->GetExtent()[2 * axis] + 0.5 * (steps[axis] - 1));
  }
  thin->SetDimensions(size.data());
  thin->SetSpacing(spacing.data());
  thin->SetOrigin(origin.data());
  thin->SetFieldData(whole->GetFieldData());
  return thin;
}

// The values of a part at the voxels of the thinned volume, a very low one where it has none.
void TakeValues(vtkImageData* part, vtkImageData* whole, const std::array<int, 3>& steps,
  vtkImageData* thin, vtkFloatArray* taken)
{
  const vtkIdType count = thin->GetNumberOfPoints();
  const int* size = thin->GetDimensions();
  auto* values = vtkFloatArray::SafeDownCast(part->GetPointData()->GetScalars());
  taken->SetNumberOfTuples(count);
  taken->Fill(std::numeric_limits<float>::lowest());
  const int* has = part->GetExtent();
  for (vtkIdType id = 0; values != nullptr && id < count; ++id)
  {
    const std::array<vtkIdType, 3> cell = {
      id % size[0], id / size[0] % size[1], id / size[0] / size[1]};
    std::array<int, 3> voxel{};
    bool within = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      voxel[axis] =
        whole->GetExtent()[2 * axis] + Middle(static_cast<int>(cell[axis]), steps[axis]);
      within = within && voxel[axis] >= has[2 * axis] && voxel[axis] <= has[2 * axis + 1];
    }
    const float value = within ? values->GetValue(part->ComputePointId(voxel.data())) : 0.0F;
    if (within && !std::isnan(value))
    {
      taken->SetValue(id, value);
    }
  }
}

} // namespace

void AskForOwnPart(vtkInformation* input, vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (vtkInformationIntegerKey* key :
    {Pipeline::UPDATE_NUMBER_OF_PIECES(), Pipeline::UPDATE_PIECE_NUMBER()})
  {
    input->Set(key, output->Get(key));
  }
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

vtkSmartPointer<vtkImageData> DescribeWhole(vtkInformation* input)
{
  vtkImageData* part = vtkImageData::GetData(input);
  auto whole = vtkSmartPointer<vtkImageData>::New();
  whole->SetExtent(input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  whole->SetOrigin(part->GetOrigin());
  whole->SetSpacing(part->GetSpacing());
  whole->SetFieldData(part->GetFieldData());
  return whole;
}

vtkSmartPointer<vtkImageData> GatherThinned(vtkImageData* part, vtkImageData* whole)
{
  std::array<int, 3> steps{};
  auto thin = Thin(whole, steps);
  vtkNew<vtkFloatArray> own;
  TakeValues(part, whole, steps, thin, own);
  vtkNew<vtkFloatArray> all;
  all->SetNumberOfTuples(own->GetNumberOfTuples());
  vtkMultiProcessController::GetGlobalController()->AllReduce(own, all, vtkCommunicator::MAX_OP);
  all->SetName(nexrad::scene::ArrayOf(part).c_str());
  thin->GetPointData()->SetScalars(all);
  return thin;
}
