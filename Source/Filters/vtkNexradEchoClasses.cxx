// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradEchoClasses.h"

#include "nexrad/Quality/EchoClassification.h"
#include "nexrad/System/Error.h"
#include "vtkNexradFieldData.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradPolarConversion.h"
#include "vtkNexradThreads.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace
{

constexpr int classCount = static_cast<int>(nexrad::EchoClassCount);
constexpr int reasonCount = static_cast<int>(nexrad::EchoReasonCount);

void AddNames(vtkFieldData* field)
{
  const auto namesOf = [](int count, const char* (*nameOf)(int))
  {
    std::vector<std::string> names;
    for (int i = 0; i < count; ++i)
    {
      names.emplace_back(nameOf(i));
    }
    return names;
  };
  vtkNexradAddTexts(
    field, "EchoClassNames", namesOf(classCount, vtkNexradEchoClasses::GetEchoClassName));
  vtkNexradAddTexts(
    field, "EchoReasonNames", namesOf(reasonCount, vtkNexradEchoClasses::GetEchoReasonName));
}

// The sweeps with grids of their own, which share the arrays of the input.
void CopySweeps(vtkPartitionedDataSetCollection* input, vtkPartitionedDataSetCollection* output)
{
  output->CopyStructure(input);
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
  for (unsigned int i = 0; i < input->GetNumberOfPartitionedDataSets(); ++i)
  {
    vtkPartitionedDataSet* grids = input->GetPartitionedDataSet(i);
    for (unsigned int j = 0; grids && j < grids->GetNumberOfPartitions(); ++j)
    {
      if (vtkDataSet* grid = grids->GetPartition(j))
      {
        vtkSmartPointer<vtkDataSet> own = vtk::TakeSmartPointer(grid->NewInstance());
        own->ShallowCopy(grid);
        output->SetPartition(i, j, own);
      }
    }
  }
}

vtkNew<vtkUnsignedCharArray> MakeArray(vtkStructuredGrid* grid, const char* name)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(grid->GetNumberOfPoints());
  array->FillValue(0);
  return array;
}

// The row after the last ray shows the first ray again, where the grid has one.
void RepeatFirstRow(vtkStructuredGrid* grid, vtkIdType rays, vtkUnsignedCharArray* array)
{
  int dimensions[3];
  grid->GetDimensions(dimensions);
  for (vtkIdType gate = 0; dimensions[1] > rays && gate < dimensions[0]; ++gate)
  {
    array->SetValue(rays * dimensions[0] + gate, array->GetValue(gate));
  }
}

// `reasons` of the gates of a sweep, in the order of its rays.
void AddArrays(const vtkNexradSweepOrigin& origin, std::size_t gates,
  const std::vector<nexrad::EchoReason>& reasons)
{
  vtkStructuredGrid* grid = origin.Grid;
  int dimensions[3];
  grid->GetDimensions(dimensions);
  const vtkIdType columns = dimensions[0];
  const auto classes = MakeArray(grid, "REF_class");
  const auto numbers = MakeArray(grid, "REF_reason");
  for (std::size_t ray = 0; ray < origin.Rows.size(); ++ray)
  {
    const vtkIdType first = origin.Rows[ray] * columns;
    for (std::size_t gate = 0; gate < gates; ++gate)
    {
      const nexrad::EchoReason reason = reasons[ray * gates + gate];
      const vtkIdType point = first + static_cast<vtkIdType>(gate);
      classes->SetValue(point, static_cast<unsigned char>(nexrad::ClassOf(reason)));
      numbers->SetValue(point, static_cast<unsigned char>(reason));
    }
  }
  const vtkIdType rays = grid->GetFieldData()->GetArray("RayTime")->GetNumberOfTuples();
  for (vtkUnsignedCharArray* array : {classes.Get(), numbers.Get()})
  {
    RepeatFirstRow(grid, rays, array);
    grid->GetPointData()->AddArray(array);
  }
  AddNames(grid->GetFieldData());
}

// The one of the same radar and the same start; one without sweeps where there is none.
nexrad::PolarVolume SameVolume(
  const std::vector<nexrad::PolarVolume>& volumes, const nexrad::PolarVolume& volume)
{
  const auto found = std::find_if(volumes.begin(), volumes.end(),
    [&](const nexrad::PolarVolume& each)
    { return each.site.name == volume.site.name && each.start == volume.start; });
  return found == volumes.end() ? nexrad::PolarVolume() : *found;
}

// False when `progress` asked to stop.
bool ClassifySweeps(
  vtkPartitionedDataSetCollection* sweeps, const std::function<bool(double)>& progress)
{
  std::vector<std::vector<vtkNexradSweepOrigin>> origins;
  const std::vector<nexrad::PolarVolume> volumes =
    vtkNexradSweepsToPolar(sweeps, nexrad::MomentName::REF, &origins);
  std::map<nexrad::MomentName, std::vector<nexrad::PolarVolume>> others;
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    const nexrad::PolarVolume& volume = volumes[i];
    std::mutex oneAtATime;
    const auto measured = [&](nexrad::MomentName moment, const nexrad::WantedRange&)
    {
      const std::lock_guard<std::mutex> lock(oneAtATime);
      const auto [found, isNew] = others.try_emplace(moment);
      if (isNew)
      {
        found->second = vtkNexradSweepsToPolar(sweeps, moment);
      }
      return SameVolume(found->second, volume);
    };
    const nexrad::EchoClassification found =
      nexrad::ClassifyEcho(volume, measured, vtkNexradRangeLoop());
    for (std::size_t sweep = 0; sweep < volume.sweeps.size(); ++sweep)
    {
      AddArrays(origins[i][sweep], volume.sweeps[sweep].gates, found.sweeps[sweep]);
    }
    if (!progress(static_cast<double>(i + 1) / static_cast<double>(volumes.size())))
    {
      return false;
    }
  }
  return true;
}

} // namespace

vtkStandardNewMacro(vtkNexradEchoClasses);

vtkNexradEchoClasses::vtkNexradEchoClasses() = default;

vtkNexradEchoClasses::~vtkNexradEchoClasses() = default;

int vtkNexradEchoClasses::GetNumberOfEchoClasses()
{
  return classCount;
}

int vtkNexradEchoClasses::GetNumberOfEchoReasons()
{
  return reasonCount;
}

const char* vtkNexradEchoClasses::GetEchoClassName(int echoClass)
{
  return echoClass >= 0 && echoClass < classCount
           ? nexrad::ToString(static_cast<nexrad::EchoClass>(echoClass))
           : nullptr;
}

const char* vtkNexradEchoClasses::GetEchoReasonName(int reason)
{
  return reason >= 0 && reason < reasonCount
           ? nexrad::ToString(static_cast<nexrad::EchoReason>(reason))
           : nullptr;
}

int vtkNexradEchoClasses::GetClassOfReason(int reason)
{
  return reason >= 0 && reason < reasonCount
           ? static_cast<int>(nexrad::ClassOf(static_cast<nexrad::EchoReason>(reason)))
           : -1;
}

bool vtkNexradEchoClasses::IsTakenOut(int quality, int echoClass)
{
  return quality >= 0 && quality <= static_cast<int>(nexrad::QualityLevel::Strict) &&
         echoClass >= 0 && echoClass < classCount &&
         nexrad::RemovesClass(
           static_cast<nexrad::QualityLevel>(quality), static_cast<nexrad::EchoClass>(echoClass));
}

int vtkNexradEchoClasses::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // A gate's class depends on the tilts above it, so that no part of the sweeps is enough.
  vtkInformation* info = input[0]->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  return 1;
}

int vtkNexradEchoClasses::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNexradForgetAbort(this);
  auto* sweeps = vtkPartitionedDataSetCollection::GetData(output);
  CopySweeps(vtkPartitionedDataSetCollection::GetData(input[0]), sweeps);
  try
  {
    AddNames(sweeps->GetFieldData());
    if (!ClassifySweeps(sweeps, vtkNexradProgress(this)))
    {
      sweeps->Initialize();
    }
  }
  catch (const nexrad::Error& error)
  {
    sweeps->Initialize();
    this->SetErrorCode(vtkErrorCode::UserError);
    return vtkNexradFail(this, error.what());
  }
  return 1;
}

void vtkNexradEchoClasses::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
