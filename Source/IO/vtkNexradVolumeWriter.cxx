// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeWriter.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradPipeline.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>

vtkStandardNewMacro(vtkNexradVolumeWriter);

namespace
{

/// A write that failed, with its error code.
struct WriteFailure
{
  unsigned long Code;
  std::string Line;
};

/// Runs a write of the core; what it throws comes out with the code of its cause.
template <class Write>
void Attempt(Write write)
{
  errno = 0;
  try
  {
    write();
  }
  catch (const nexrad::Error& error)
  {
    throw WriteFailure{errno == ENOSPC
                         ? static_cast<unsigned long>(vtkErrorCode::OutOfDiskSpaceError)
                         : static_cast<unsigned long>(vtkErrorCode::CannotOpenFileError),
      error.what()};
  }
}

} // namespace

vtkNexradVolumeWriter::vtkNexradVolumeWriter() = default;

vtkNexradVolumeWriter::~vtkNexradVolumeWriter()
{
  this->SetFileName(nullptr);
}

int vtkNexradVolumeWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkNexradVolumeWriter::GetNumberOfWrittenFiles() const
{
  return static_cast<int>(this->Written.size());
}

const char* vtkNexradVolumeWriter::GetWrittenFile(int index) const
{
  return index >= 0 && index < this->GetNumberOfWrittenFiles()
           ? this->Written[static_cast<std::size_t>(index)].c_str()
           : nullptr;
}

bool vtkNexradVolumeWriter::IsSeries() const
{
  return this->FileName && std::filesystem::path(this->FileName).extension() == ".series";
}

nexrad::NxvWriteOptions vtkNexradVolumeWriter::MakeOptions() const
{
  nexrad::NxvWriteOptions options;
  options.offset = this->CodeOffset;
  options.scale = this->CodeScale;
  switch (this->Encoding)
  {
  case RADAR_STEPS:
    options.encoding = nexrad::NxvEncoding::RadarSteps;
    break;
  case RUN_LENGTH:
    options.encoding = nexrad::NxvEncoding::RunLength;
    break;
  case RUN_LENGTH_DEFLATED:
    options.encoding = nexrad::NxvEncoding::RunLengthDeflated;
    break;
  case FLOAT:
    options.encoding = nexrad::NxvEncoding::Float;
    break;
  default:
    break;
  }
  return options;
}

void vtkNexradVolumeWriter::Fail(unsigned long code, const std::string& line)
{
  this->SetErrorCode(code);
  vtkErrorMacro(<< line);
}

void vtkNexradVolumeWriter::Begin()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNexradForgetAbort(this);
  this->Index.clear();
  this->Written.clear();
  this->Complete = false;
}

int vtkNexradVolumeWriter::Write()
{
  this->Begin();
  this->Superclass::Write();
  // When the input fails, the executive does not come back here.
  if (!this->Complete && this->GetErrorCode() == vtkErrorCode::NoError && !this->AbortExecute)
  {
    this->Fail(vtkErrorCode::UserError, "the input could not be made: not all is written");
  }
  return this->Complete ? 1 : 0;
}

vtkTypeBool vtkNexradVolumeWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    this->ReadTimeSteps(input[0]->GetInformationObject(0));
    return 1;
  }
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    if (this->IsSeries() && this->CurrentStep < this->TimeSteps.size())
    {
      input[0]->GetInformationObject(0)->Set(
        vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), this->TimeSteps[this->CurrentStep]);
    }
    return 1;
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return this->WriteStep(request);
  }
  return this->Superclass::ProcessRequest(request, input, output);
}

void vtkNexradVolumeWriter::ReadTimeSteps(vtkInformation* inputInformation)
{
  this->TimeSteps.clear();
  this->CurrentStep = 0;
  if (inputInformation->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()))
  {
    const double* steps = inputInformation->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    const int count = inputInformation->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    this->TimeSteps.assign(steps, steps + count);
  }
}

// One call a time step: the executive calls again as long as CONTINUE_EXECUTING is set.
int vtkNexradVolumeWriter::WriteStep(vtkInformation* request)
{
  const std::size_t steps = this->IsSeries() ? std::max<std::size_t>(1, this->TimeSteps.size()) : 1;
  if (this->CurrentStep == 0)
  {
    this->Begin();
  }
  const bool goOn =
    vtkNexradProgress(this)(static_cast<double>(this->CurrentStep) / static_cast<double>(steps));
  if (goOn)
  {
    this->WriteData();
  }
  ++this->CurrentStep;
  const bool failed = this->GetErrorCode() != vtkErrorCode::NoError;
  if (goOn && !failed && this->CurrentStep < steps)
  {
    request->Set(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING(), 1);
    return 1;
  }
  request->Remove(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
  this->CurrentStep = 0;
  if (goOn && !failed && this->IsSeries())
  {
    this->WriteIndex();
  }
  this->Complete = goOn && this->GetErrorCode() == vtkErrorCode::NoError;
  return 1; // Write tells the outcome; a failed request would print the executive's state as well
}

void vtkNexradVolumeWriter::WriteData()
{
  if (!this->FileName || !*this->FileName)
  {
    this->Fail(vtkErrorCode::NoFileNameError, "no file name was set");
    return;
  }
  try
  {
    this->WriteVolume(vtkNexradImageToVolume(vtkImageData::SafeDownCast(this->GetInput())));
  }
  catch (const WriteFailure& failure)
  {
    this->Fail(failure.Code, failure.Line);
  }
  catch (const nexrad::Error& error)
  {
    this->Fail(vtkErrorCode::UserError, error.what());
  }
}

void vtkNexradVolumeWriter::WriteVolume(const nexrad::GriddedVolume& volume)
{
  std::filesystem::path path = this->FileName;
  if (this->IsSeries())
  {
    if (this->RawStream)
    {
      throw nexrad::Error("a series of bare streams cannot be written: name one file");
    }
    const std::string name = nexrad::FormatForFileName(volume.time) + ".nxv";
    path = path.parent_path() / name;
    Attempt([&]() { nexrad::WriteNxv(path, volume, this->MakeOptions()); });
    this->Index.emplace_back(name, nexrad::ToSeconds(volume.time));
  }
  else if (this->RawStream)
  {
    Attempt([&]() { nexrad::WriteRaw(path, volume, this->MakeOptions()); });
  }
  else
  {
    Attempt([&]() { nexrad::WriteNxv(path, volume, this->MakeOptions()); });
  }
  this->Written.push_back(path.string());
}

void vtkNexradVolumeWriter::WriteIndex()
{
  try
  {
    Attempt([&]() { nexrad::WriteNxvSeries(this->FileName, this->Index); });
    this->Written.emplace_back(this->FileName);
  }
  catch (const WriteFailure& failure)
  {
    this->Fail(failure.Code, failure.Line);
  }
}

void vtkNexradVolumeWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Encoding: " << this->Encoding << "\n";
  os << indent << "CodeScale: " << this->CodeScale << "\n";
  os << indent << "CodeOffset: " << this->CodeOffset << "\n";
  os << indent << "RawStream: " << this->RawStream << "\n";
  os << indent << "WrittenFiles: " << this->Written.size() << "\n";
}
