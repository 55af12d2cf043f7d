// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradStepWriter.h"

#include "nexrad/Codec/NxvSeries.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradPipeline.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>

namespace
{

struct WriteFailure
{
  unsigned long Code;
  std::string Line;
};

} // namespace

vtkNexradStepWriter::vtkNexradStepWriter() = default;

vtkNexradStepWriter::~vtkNexradStepWriter()
{
  this->SetFileName(nullptr);
}

void vtkNexradStepWriter::Attempt(const std::function<void()>& write)
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

int vtkNexradStepWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkNexradStepWriter::GetNumberOfWrittenFiles() const
{
  return static_cast<int>(this->Written.size());
}

const char* vtkNexradStepWriter::GetWrittenFile(int index) const
{
  return index >= 0 && index < this->GetNumberOfWrittenFiles()
           ? this->Written[static_cast<std::size_t>(index)].c_str()
           : nullptr;
}

bool vtkNexradStepWriter::IsSeries() const
{
  return this->FileName && std::filesystem::path(this->FileName).extension() == ".series";
}

std::string vtkNexradStepWriter::FileOf(const nexrad::GriddedVolume& volume, const char* extension)
{
  if (!this->IsSeries())
  {
    return this->FileName;
  }
  const std::string name = nexrad::FormatForFileName(volume.time) + extension;
  this->Index.emplace_back(name, nexrad::ToSeconds(volume.time));
  return std::filesystem::path(this->FileName).parent_path() / name;
}

void vtkNexradStepWriter::Fail(unsigned long code, const std::string& line)
{
  this->SetErrorCode(code);
  vtkErrorMacro(<< line);
}

void vtkNexradStepWriter::Begin()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNexradForgetAbort(this);
  this->Written.clear();
  this->Index.clear();
  this->Complete = false;
  this->GiveUp();
}

void vtkNexradStepWriter::End()
{
  if (!this->IsSeries())
  {
    this->CompleteFile();
    return;
  }
  Attempt([this] { nexrad::WriteNxvSeries(this->FileName, this->Index); });
  this->Written.emplace_back(this->FileName);
}

int vtkNexradStepWriter::Write()
{
  this->Begin();
  this->Superclass::Write();
  if (!this->Complete)
  {
    this->GiveUp();
  }
  // When the input fails, the executive does not come back here.
  if (!this->Complete && this->GetErrorCode() == vtkErrorCode::NoError && !this->AbortExecute)
  {
    this->Fail(vtkErrorCode::UserError, "the input could not be made: not all is written");
  }
  return this->Complete ? 1 : 0;
}

vtkTypeBool vtkNexradStepWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    this->ReadTimeSteps(input[0]->GetInformationObject(0));
    return 1;
  }
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    if (this->WritesAllSteps() && this->CurrentStep < this->TimeSteps.size())
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

void vtkNexradStepWriter::ReadTimeSteps(vtkInformation* inputInformation)
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
int vtkNexradStepWriter::WriteStep(vtkInformation* request)
{
  const std::size_t steps =
    this->WritesAllSteps() ? std::max<std::size_t>(1, this->TimeSteps.size()) : 1;
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
  if (goOn && !failed)
  {
    this->Guarded([this] { this->End(); });
  }
  this->Complete = goOn && this->GetErrorCode() == vtkErrorCode::NoError;
  return 1; // Write tells the outcome; a failed request would print the executive's state as well
}

void vtkNexradStepWriter::Guarded(const std::function<void()>& work)
{
  try
  {
    work();
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

void vtkNexradStepWriter::WriteData()
{
  if (!this->FileName || !*this->FileName)
  {
    this->Fail(vtkErrorCode::NoFileNameError, "no file name was set");
    return;
  }
  this->Guarded([this]
    { this->WriteVolume(vtkNexradImageToVolume(vtkImageData::SafeDownCast(this->GetInput()))); });
}

void vtkNexradStepWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "WrittenFiles: " << this->Written.size() << "\n";
}
