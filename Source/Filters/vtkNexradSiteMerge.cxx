// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradSiteMerge.h"

#include "nexrad/Model/SiteKey.h"
#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/System/Error.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace
{

std::string PlaceOf(const nexrad::Position& position)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.3f, %.3f", position.latitude, position.longitude);
  return text;
}

// Two radars of one name at two places are two radars, or one position is wrong.
void RequireOnePlaceForEachRadar(const std::vector<nexrad::PolarVolume>& volumes)
{
  std::map<nexrad::SiteKey, nexrad::Site> sites;
  for (const nexrad::PolarVolume& volume : volumes)
  {
    nexrad::Site& first = sites.emplace(nexrad::KeyOf(volume.site), volume.site).first->second;
    first = first.position ? first : volume.site;
    if (nexrad::StandApart(first, volume.site))
    {
      throw nexrad::Error("one input has a radar " + volume.site.name + " at " +
                          PlaceOf(*first.position) + " degrees, and another at " +
                          PlaceOf(*volume.site.position) +
                          " degrees: give one of them another name (SiteName of its reader)");
    }
  }
}

} // namespace

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
    RequireOnePlaceForEachRadar(volumes);
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
