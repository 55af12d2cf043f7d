// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradStepReader.h"

#include "nexrad/Grid/VoxelBlock.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/Progress.h"
#include "vtkNexradArrayChoice.h"
#include "vtkNexradExtent.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradVolumeSteps.h"

#include "vtkDataArraySelection.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <vector>

namespace
{

// The latest at or before the time that is asked for; before the first, and without a time, the
// first.
const vtkNexradVolumeStep& RequestedStep(
  const std::vector<vtkNexradVolumeStep>& steps, vtkInformation* info)
{
  if (!info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
  {
    return steps.front();
  }
  const auto next = std::upper_bound(steps.begin(), steps.end(),
    info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()),
    [](double wanted, const vtkNexradVolumeStep& step) { return wanted < step.Time; });
  return next == steps.begin() ? steps.front() : *(next - 1);
}

std::vector<std::string> AncillaryNames(const vtkNexradVolumeSteps& steps)
{
  std::vector<std::string> names = steps.Ancillary;
  if (steps.OfOneRadar)
  {
    names.insert(names.end(), {"azimuth", "elevation", "slant_range"});
  }
  return names;
}

} // namespace

vtkNexradStepReader::vtkNexradStepReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkNexradStepReader::~vtkNexradStepReader()
{
  this->SetFileName(nullptr);
}

vtkDataArraySelection* vtkNexradStepReader::GetAncillaryArraySelection()
{
  return this->AncillaryArraySelection;
}

vtkMTimeType vtkNexradStepReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->AncillaryArraySelection->GetMTime());
}

const vtkNexradVolumeSteps& vtkNexradStepReader::OpenedSteps() const
{
  return *this->Opened;
}

int vtkNexradStepReader::Fail(unsigned long code, const std::string& line)
{
  this->SetErrorCode(code);
  // What is wrong with a file that an index names is said of the index.
  const std::string name = this->FileName != nullptr ? this->FileName : "";
  return vtkNexradFail(this, line.rfind(name, 0) == 0 ? line : name + ": " + line);
}

int vtkNexradStepReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->Opened.reset();
  const unsigned long pathError = vtkNexradPathError(this->FileName);
  if (pathError != vtkErrorCode::NoError)
  {
    return this->Fail(pathError, vtkNexradPathErrorText(pathError, this->FileName));
  }
  try
  {
    this->Opened = std::make_unique<vtkNexradVolumeSteps>(this->ListSteps());
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::FileFormatError, error.what());
  }
  vtkNexradListArrays(AncillaryNames(*this->Opened), this->AncillaryArraySelection);
  this->Describe(output->GetInformationObject(0));
  return 1;
}

// Says what the output will be.
void vtkNexradStepReader::Describe(vtkInformation* info) const
{
  const nexrad::GridSpecification& grid = this->Opened->Grid;
  vtkNexradOfferExtent(info, grid.dimensions.data());
  info->Set(vtkDataObject::ORIGIN(), grid.origin.data(), 3);
  info->Set(vtkDataObject::SPACING(), grid.spacing.data(), 3);
  vtkDataObject::SetPointDataActiveScalarInfo(
    info, this->Opened->AsCodes ? VTK_UNSIGNED_CHAR : VTK_FLOAT, 1);
  if (!this->Opened->HasTimes)
  {
    return;
  }
  std::vector<double> times;
  for (const vtkNexradVolumeStep& step : this->Opened->Steps)
  {
    times.push_back(step.Time);
  }
  const double range[2] = {times.front(), times.back()};
  info->Set(
    vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
}

int vtkNexradStepReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  if (!this->Opened)
  {
    return 0; // the information request failed, and said why
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNexradForgetAbort(this);
  vtkInformation* info = output->GetInformationObject(0);
  const vtkNexradVolumeStep& step = RequestedStep(this->Opened->Steps, info);
  const nexrad::Progress progress = vtkNexradProgress(this);
  vtkImageData* image = vtkImageData::GetData(output);
  image->Initialize();
  const nexrad::VoxelBlock block = vtkNexradRequestedBlock(info, this->Opened->Grid);
  if (block.VoxelCount() == 0 || !progress(0.0))
  {
    return 1;
  }
  try
  {
    this->ReadStep(step, image);
    const int extent[6] = {block.begin[0], block.end[0] - 1, block.begin[1], block.end[1] - 1,
      block.begin[2], block.end[2] - 1};
    image->Crop(extent);
    vtkNexradAddRadarView(image, vtkNexradNamesToLeaveOut(this->AncillaryArraySelection));
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::FileFormatError, error.what());
  }
  image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step.Time);
  if (!progress(0.9))
  {
    image->Initialize();
  }
  return 1;
}

void vtkNexradStepReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Moments: " << this->Moments << "\n";
  os << indent << "AncillaryArraySelection:\n";
  this->AncillaryArraySelection->PrintSelf(os, indent.GetNextIndent());
}
