// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradPipeline.h"

#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Grid/GridSpecification.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkSetGet.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace
{

// Whether the algorithm was asked to stop: CheckAbort where VTK has it (which also looks at the
// algorithms downstream), else AbortExecute. The overload for int is the better match; it exists
// only where vtkAlgorithm has CheckAbort.
template <class Algorithm>
auto ShouldAbort(Algorithm* algorithm, int) -> decltype(algorithm->CheckAbort())
{
  return algorithm->CheckAbort();
}

template <class Algorithm>
bool ShouldAbort(Algorithm* algorithm, long)
{
  return algorithm->GetAbortExecute() != 0;
}

// Takes the errors of an executive, and shows those of which its algorithm has said nothing.
class ExecutiveErrors : public vtkCommand
{
public:
  static ExecutiveErrors* New() { return new ExecutiveErrors; }
  vtkTypeMacro(ExecutiveErrors, vtkCommand);

  void Execute(vtkObject* caller, unsigned long, void* text) override
  {
    vtkAlgorithm* algorithm = vtkExecutive::SafeDownCast(caller)->GetAlgorithm();
    if (!algorithm || algorithm->GetErrorCode() == vtkErrorCode::NoError)
    {
      vtkOutputWindow::GetInstance()->DisplayErrorText(static_cast<const char*>(text));
    }
  }
};

} // namespace

void vtkNexradForgetAbort(vtkAlgorithm* algorithm)
{
  algorithm->AbortExecute = 0;
}

std::function<bool(double)> vtkNexradProgress(vtkAlgorithm* algorithm, double from, double to)
{
  constexpr double stepsInARun = 50.0;
  return [algorithm, from, to, next = from](double done) mutable
  {
    const double progress = from + (to - from) * done;
    if (progress >= next)
    {
      next = progress + 1.0 / stepsInARun;
      algorithm->UpdateProgress(progress);
    }
    return !ShouldAbort(algorithm, 0);
  };
}

int vtkNexradFail(vtkAlgorithm* algorithm, const std::string& line)
{
  static const vtkNew<ExecutiveErrors> errors;
  vtkExecutive* const executive = algorithm->GetExecutive();
  if (!executive->HasObserver(vtkCommand::ErrorEvent, errors))
  {
    executive->AddObserver(vtkCommand::ErrorEvent, errors);
  }
  vtkErrorWithObjectMacro(algorithm, << line);
  return 0;
}

void vtkNexradOfferTimes(vtkInformation* outputInformation, const double* times, int count)
{
  const double range[2] = {times[0], times[count - 1]};
  outputInformation->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, count);
  outputInformation->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
}

double vtkNexradRequestedTime(vtkInformation* outputInformation, double firstTimeStep)
{
  constexpr double day = 86400.0;
  vtkInformationDoubleKey* const key = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  const double asked = outputInformation->Has(key) ? outputInformation->Get(key) : firstTimeStep;
  return asked < firstTimeStep - day ? firstTimeStep : asked;
}

unsigned long vtkNexradPathError(const char* path)
{
  if (!path || !*path)
  {
    return vtkErrorCode::NoFileNameError;
  }
  const nexrad::StoredKind kind = nexrad::KindOf(path);
  if (kind == nexrad::StoredKind::Nothing)
  {
    return vtkErrorCode::FileNotFoundError;
  }
  // The members of archives can be read where they are found; a pipe waits for a writer.
  std::error_code failure;
  const bool onDisk = kind == nexrad::StoredKind::File && std::filesystem::exists(path, failure);
  if (kind == nexrad::StoredKind::Other || (onDisk && !std::ifstream(path, std::ios::binary)))
  {
    return vtkErrorCode::CannotOpenFileError;
  }
  return vtkErrorCode::NoError;
}

std::string vtkNexradPathErrorText(unsigned long code, const char* path)
{
  switch (code)
  {
  case vtkErrorCode::NoFileNameError:
    return "no file name was set";
  case vtkErrorCode::FileNotFoundError:
    return std::string(path) + ": no such file or folder";
  case vtkErrorCode::CannotOpenFileError:
    return std::string(path) + ": the file cannot be opened";
  default:
    return {};
  }
}

void vtkNexradOfferGrid(vtkInformation* outputInformation, const nexrad::GridSpecification& grid)
{
  const auto& [x, y, z] = grid.dimensions;
  const int extent[6] = {0, x - 1, 0, y - 1, 0, z - 1};
  outputInformation->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  outputInformation->Set(vtkDataObject::ORIGIN(), grid.origin.data(), 3);
  outputInformation->Set(vtkDataObject::SPACING(), grid.spacing.data(), 3);
  outputInformation->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
}

nexrad::VoxelBlock vtkNexradRequestedBlock(
  vtkInformation* outputInformation, const nexrad::GridSpecification& grid)
{
  nexrad::VoxelBlock block = nexrad::VoxelBlock::Of(grid);
  if (const int* extent = outputInformation->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()))
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      block.begin[axis] = extent[2 * axis];
      block.end[axis] = extent[2 * axis + 1] + 1;
    }
  }
  return block;
}

void vtkNexradPlaceBlock(
  const nexrad::GridSpecification& grid, const nexrad::VoxelBlock& block, vtkImageData* image)
{
  image->SetExtent(block.begin[0], block.end[0] - 1, block.begin[1], block.end[1] - 1,
    block.begin[2], block.end[2] - 1);
  image->SetOrigin(grid.origin.data());
}
