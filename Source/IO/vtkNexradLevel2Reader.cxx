// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradLevel2Reader.h"

#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/System/Error.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradSweepConversion.h"

#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStringArray.h"

#include <array>
#include <filesystem>
#include <tuple>

vtkStandardNewMacro(vtkNexradLevel2Reader);

/// The decoded file, and what it was decoded from: it is decoded again when one of these differs.
struct vtkNexradLevel2Reader::Decoded
{
  using Origin = std::tuple<std::string, std::filesystem::file_time_type, std::string, bool,
    std::array<double, 3>>;

  Origin From;
  nexrad::RadarVolume Volume;
};

vtkNexradLevel2Reader::vtkNexradLevel2Reader() = default;

vtkNexradLevel2Reader::~vtkNexradLevel2Reader()
{
  this->SetFileName(nullptr);
}

int vtkNexradLevel2Reader::CanReadFile(const char* path)
{
  if (vtkNexradPathError(path) != vtkErrorCode::NoError)
  {
    return 0;
  }
  const bool folder = nexrad::KindOf(path) == nexrad::StoredKind::Folder;
  return (folder ? nexrad::IsChunkFolder(path) : nexrad::LooksLikeLevel2(path)) ? 1 : 0;
}

int vtkNexradLevel2Reader::ReadFile()
{
  const unsigned long pathError = vtkNexradPathError(this->FileName);
  if (pathError != vtkErrorCode::NoError)
  {
    this->File.reset();
    return this->Fail(pathError, vtkNexradPathErrorText(pathError, this->FileName));
  }
  const Decoded::Origin from = {this->FileName, nexrad::ChangedAt(this->FileName), this->SiteName,
    this->UseSitePosition, {this->SitePosition[0], this->SitePosition[1], this->SitePosition[2]}};
  if (this->File && this->File->From == from)
  {
    return 1;
  }
  this->File.reset();
  this->Damage->Initialize();
  auto decoded = std::make_unique<Decoded>();
  decoded->From = from;
  try
  {
    decoded->Volume = nexrad::ReadLevel2(this->FileName, this->MakeLevel2Options());
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::FileFormatError, error.what());
  }
  for (const nexrad::Damage& damage : decoded->Volume.damage)
  {
    this->AddDamage(nexrad::InputProblem{this->FileName, damage.offset, damage.what}.Line());
  }
  if (decoded->Volume.sweeps.empty())
  {
    const bool known = vtkNexradLevel2Reader::CanReadFile(this->FileName) != 0;
    return this->Fail(
      known ? vtkErrorCode::FileFormatError : vtkErrorCode::UnrecognizedFileTypeError,
      std::string(this->FileName) + (known ? ": no ray could be read" : ": not a Level II file"));
  }
  this->File = std::move(decoded);
  return 1;
}

int vtkNexradLevel2Reader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->ReadFile())
  {
    return 0;
  }
  const double time = nexrad::ToSeconds(*this->File->Volume.Start());
  vtkInformation* info = output->GetInformationObject(0);
  vtkNexradOfferTimes(info, &time, 1);
  info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkNexradLevel2Reader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  if (!this->File)
  {
    return 0; // the information request failed, and said why
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNexradForgetAbort(this);
  auto* sweeps = vtkPartitionedDataSetCollection::GetData(output, 0);
  try
  {
    if (!vtkNexradAppendSweeps(this->File->Volume,
          this->MakeSweepOptions(output->GetInformationObject(0)), sweeps, vtkNexradProgress(this)))
    {
      sweeps->Initialize();
      return 1;
    }
  }
  catch (const nexrad::Error& error)
  {
    sweeps->Initialize();
    return this->Fail(vtkErrorCode::UserError, std::string(this->FileName) + ": " + error.what());
  }
  sweeps->GetInformation()->Set(
    vtkDataObject::DATA_TIME_STEP(), nexrad::ToSeconds(*this->File->Volume.Start()));
  return 1;
}

void vtkNexradLevel2Reader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
