// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradSiteMerge.h"

#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/System/Error.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkNexradSiteMerge);

vtkNexradSiteMerge::vtkNexradSiteMerge() = default;

vtkNexradSiteMerge::~vtkNexradSiteMerge() = default;

int vtkNexradSiteMerge::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkNexradSiteMerge::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* info = output->GetInformationObject(0);
  this->SetOutputExtent(info);
  // The inputs' own times end here.
  const double range[2] = {this->Time, this->Time};
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), &this->Time, 1);
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  return 1;
}

int vtkNexradSiteMerge::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->BeginOutput(output);
  try
  {
    const std::vector<nexrad::PolarVolume> volumes = this->ReadSweeps(input[0]);
    if (volumes.empty())
    {
      throw nexrad::Error("no input holds a sweep with " + this->Moment);
    }
    this->MergeSweeps(volumes, this->Time, this->MaximumGap, output);
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::UserError, error.what());
  }
  return 1;
}

void vtkNexradSiteMerge::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "MaximumGap: " << this->MaximumGap << "\n";
}
