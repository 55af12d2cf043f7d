// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeResampler.h"

#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/System/Error.h"

#include "vtkErrorCode.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkNexradVolumeResampler);

vtkNexradVolumeResampler::vtkNexradVolumeResampler() = default;

vtkNexradVolumeResampler::~vtkNexradVolumeResampler() = default;

int vtkNexradVolumeResampler::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->BeginOutput(output);
  try
  {
    const std::vector<nexrad::PolarVolume> volumes = this->ReadSweeps(input[0]);
    if (volumes.size() != 1)
    {
      throw nexrad::Error("the input holds " + std::to_string(volumes.size()) + " volumes with " +
                          this->Moment + ": one is needed (vtkNexradSiteMerge takes several)");
    }
    constexpr double wholeDay = 86400.0; // no ray of the volume is too far from its start
    this->MergeSweeps(volumes, nexrad::ToSeconds(volumes.front().start), wholeDay, output);
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::UserError, error.what());
  }
  return 1;
}

void vtkNexradVolumeResampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
