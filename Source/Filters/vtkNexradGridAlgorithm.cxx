// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradGridAlgorithm.h"

#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/Moments/MomentMaker.h"
#include "nexrad/System/Error.h"
#include "vtkNexradPipeline.h"

#include <algorithm>

namespace
{

nexrad::OverlapStrategy StrategyOf(int strategy)
{
  switch (strategy)
  {
  case vtkNexradGridAlgorithm::MEAN:
    return nexrad::OverlapStrategy::Mean;
  case vtkNexradGridAlgorithm::NEAREST:
    return nexrad::OverlapStrategy::Nearest;
  case vtkNexradGridAlgorithm::MAXIMUM:
    return nexrad::OverlapStrategy::Maximum;
  default:
    return nexrad::OverlapStrategy::Distance;
  }
}

} // namespace

vtkNexradGridAlgorithm::vtkNexradGridAlgorithm() = default;

vtkNexradGridAlgorithm::~vtkNexradGridAlgorithm() = default;

void vtkNexradGridAlgorithm::SetMethod(int method)
{
  if (method != THESIS && method != BEAM)
  {
    vtkErrorMacro("method " << method << " is unknown: it can be THESIS (" << THESIS
                            << ") or BEAM (" << BEAM << ")");
    return;
  }
  if (this->Method != method)
  {
    this->Method = method;
    this->Modified();
  }
}

std::vector<nexrad::MomentName> vtkNexradGridAlgorithm::CheckMoments() const
{
  std::vector<nexrad::MomentName> moments = nexrad::ParseMomentNames(this->Moment);
  if (moments.empty())
  {
    throw nexrad::Error("moment " + this->Moment + " is unknown: set " + nexrad::MomentNameList());
  }
  for (const nexrad::MomentName moment : moments)
  {
    nexrad::RequireMoment(
      this->Method == THESIS ? nexrad::MergeMethod::Thesis : nexrad::MergeMethod::Beam, moment);
  }
  return moments;
}

nexrad::GridRequest vtkNexradGridAlgorithm::MakeGridRequest() const
{
  nexrad::GridRequest request;
  std::copy_n(this->Dimensions, 3, request.dimensions.begin());
  request.range = this->Range;
  request.bottom = this->HeightRange[0];
  request.top = this->HeightRange[1];
  if (this->UseGeographicBounds)
  {
    request.bounds = nexrad::GeographicBounds{this->GeographicBounds[0], this->GeographicBounds[1],
      this->GeographicBounds[2], this->GeographicBounds[3]};
  }
  request.axes =
    this->Axes == GEOGRAPHIC ? nexrad::GridAxes::Geographic : nexrad::GridAxes::Projected;
  return request;
}

nexrad::MergeOptions vtkNexradGridAlgorithm::MakeMergeOptions() const
{
  nexrad::MergeOptions options;
  options.furtherMoments = this->CheckMoments();
  options.moment = options.furtherMoments.front();
  options.furtherMoments.erase(options.furtherMoments.begin());
  options.grid = this->MakeGridRequest();
  options.method = this->Method == THESIS ? nexrad::MergeMethod::Thesis : nexrad::MergeMethod::Beam;
  options.quality.level = static_cast<nexrad::QualityLevel>(this->Quality);
  options.quality.neighbours = this->FewestNeighbours;
  options.dealias = this->Dealiasing;
  if (this->UseStormMotion)
  {
    options.stormMotion = nexrad::Wind{this->StormMotion[0], this->StormMotion[1]};
  }
  const nexrad::BiasRequest bias = nexrad::ParseBiasRequest(this->Bias);
  options.measureBiases = bias.measured;
  options.beam.biases = bias.given;
  options.beam.strategy = StrategyOf(this->OverlapStrategy);
  options.beam.overlapLength = this->OverlapLength;
  options.beam.linearReflectivity = this->LinearReflectivity;
  options.beam.sharpen = this->Sharpening;
  options.beam.fillColumns = this->ColumnFilling;
  options.beam.ancillary = this->AncillaryArrays;
  options.interpolation = this->TimeInterpolation == LINEAR
                            ? nexrad::TimeInterpolationMethod::Linear
                            : nexrad::TimeInterpolationMethod::AlongMotion;
  if (this->UseGivenMotion)
  {
    options.motion = nexrad::Velocity{this->GivenMotion[0], this->GivenMotion[1]};
  }
  return options;
}

int vtkNexradGridAlgorithm::Fail(unsigned long code, const std::string& line)
{
  this->SetErrorCode(code);
  return vtkNexradFail(this, line);
}

void vtkNexradGridAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimensions: " << this->Dimensions[0] << ", " << this->Dimensions[1] << ", "
     << this->Dimensions[2] << "\n";
  os << indent << "Range: " << this->Range << "\n";
  os << indent << "HeightRange: " << this->HeightRange[0] << ", " << this->HeightRange[1] << "\n";
  os << indent << "UseGeographicBounds: " << this->UseGeographicBounds << "\n";
  os << indent << "GeographicBounds: " << this->GeographicBounds[0] << ", "
     << this->GeographicBounds[1] << ", " << this->GeographicBounds[2] << ", "
     << this->GeographicBounds[3] << "\n";
  os << indent << "Axes: " << this->Axes << "\n";
  os << indent << "Moment: " << this->Moment << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "FewestNeighbours: " << this->FewestNeighbours << "\n";
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "Dealiasing: " << this->Dealiasing << "\n";
  os << indent << "UseStormMotion: " << this->UseStormMotion << "\n";
  os << indent << "StormMotion: " << this->StormMotion[0] << ", " << this->StormMotion[1] << "\n";
  os << indent << "Bias: " << this->Bias << "\n";
  os << indent << "OverlapStrategy: " << this->OverlapStrategy << "\n";
  os << indent << "OverlapLength: " << this->OverlapLength << "\n";
  os << indent << "TimeInterpolation: " << this->TimeInterpolation << "\n";
  os << indent << "GivenMotion: " << this->GivenMotion[0] << ", " << this->GivenMotion[1] << "\n";
  os << indent << "UseGivenMotion: " << this->UseGivenMotion << "\n";
  os << indent << "LinearReflectivity: " << this->LinearReflectivity << "\n";
  os << indent << "Sharpening: " << this->Sharpening << "\n";
  os << indent << "ColumnFilling: " << this->ColumnFilling << "\n";
  os << indent << "AncillaryArrays: " << this->AncillaryArrays << "\n";
}
