// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradSweepReader.h"

#include "nexrad/Level2/Level2File.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradSweepConversion.h"

#include "vtkDataArraySelection.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <algorithm>

vtkNexradSweepReader::vtkNexradSweepReader()
{
  this->SetNumberOfInputPorts(0);
  for (const nexrad::MomentName moment : nexrad::AllMoments)
  {
    this->MomentSelection->EnableArray(nexrad::ToString(moment));
  }
}

vtkNexradSweepReader::~vtkNexradSweepReader() = default;

vtkDataArraySelection* vtkNexradSweepReader::GetMomentSelection()
{
  return this->MomentSelection;
}

vtkStringArray* vtkNexradSweepReader::GetDamage()
{
  return this->Damage;
}

vtkMTimeType vtkNexradSweepReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->MomentSelection->GetMTime());
}

nexrad::Level2Options vtkNexradSweepReader::MakeLevel2Options() const
{
  nexrad::Level2Options options;
  options.siteName = this->SiteName;
  if (this->UseSitePosition)
  {
    options.position =
      nexrad::Position{this->SitePosition[0], this->SitePosition[1], this->SitePosition[2]};
  }
  return options;
}

vtkNexradSweepOptions vtkNexradSweepReader::MakeSweepOptions(vtkInformation* outputInformation)
{
  vtkNexradSweepOptions options;
  options.Coordinates = static_cast<vtkNexradCoordinates>(this->Coordinates);
  if (this->UseProjectionCenter)
  {
    options.Center = {this->ProjectionCenter[0], this->ProjectionCenter[1]};
  }
  options.EffectiveRadiusFactor = this->EffectiveRadiusFactor;
  for (const nexrad::MomentName moment : nexrad::AllMoments)
  {
    if (this->MomentSelection->ArrayIsEnabled(nexrad::ToString(moment)))
    {
      options.Moments.push_back(moment);
    }
  }
  if (outputInformation->Has(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()))
  {
    const int pieces =
      outputInformation->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
    const int piece =
      outputInformation->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
    options.Pieces = static_cast<unsigned int>(std::max(1, pieces));
    options.Piece = static_cast<unsigned int>(std::max(0, piece));
  }
  return options;
}

void vtkNexradSweepReader::AddDamage(const std::string& line)
{
  this->Damage->InsertNextValue(line);
  vtkWarningMacro(<< line);
}

int vtkNexradSweepReader::Fail(unsigned long code, const std::string& line)
{
  this->SetErrorCode(code);
  return vtkNexradFail(this, line);
}

void vtkNexradSweepReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Coordinates: " << this->Coordinates << "\n";
  os << indent << "UseProjectionCenter: " << this->UseProjectionCenter << "\n";
  os << indent << "ProjectionCenter: " << this->ProjectionCenter[0] << ", "
     << this->ProjectionCenter[1] << "\n";
  os << indent << "EffectiveRadiusFactor: " << this->EffectiveRadiusFactor << "\n";
  os << indent << "SiteName: " << this->SiteName << "\n";
  os << indent << "UseSitePosition: " << this->UseSitePosition << "\n";
  os << indent << "SitePosition: " << this->SitePosition[0] << ", " << this->SitePosition[1] << ", "
     << this->SitePosition[2] << "\n";
  os << indent << "MomentSelection:\n";
  this->MomentSelection->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Damage: " << this->Damage->GetNumberOfValues() << " lines\n";
}
