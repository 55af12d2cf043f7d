// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVerticalSection.h"

#include "nexrad/Products/VerticalSection.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradVoxels.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkNexradVerticalSection);

namespace
{

void Fill(const nexrad::VerticalSection& section, const std::string& name, vtkImageData* image)
{
  const auto [along, upward] = section.dimensions;
  const double width = section.length / along;
  const double depth = (section.top - section.bottom) / upward;
  image->SetExtent(0, along - 1, 0, upward - 1, 0, 0);
  image->SetSpacing(width, depth, 1.0);
  image->SetOrigin(0.5 * width, section.bottom + 0.5 * depth, 0.0);
  vtkNew<vtkFloatArray> values;
  values->SetName(name.c_str());
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  std::copy(section.values.begin(), section.values.end(), values->GetPointer(0));
  vtkNew<vtkUnsignedCharArray> states;
  states->SetName((name + "_state").c_str());
  states->SetNumberOfTuples(image->GetNumberOfPoints());
  std::transform(section.states.begin(), section.states.end(), states->GetPointer(0),
    [](nexrad::VoxelState state) { return static_cast<unsigned char>(state); });
  image->GetPointData()->SetScalars(values);
  image->GetPointData()->AddArray(states);
}

} // namespace

int vtkNexradVerticalSection::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  const int extent[6] = {0, this->SamplesAlong - 1, 0, this->SamplesUpward - 1, 0, 0};
  vtkInformation* information = output->GetInformationObject(0);
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);
  return 1;
}

// A section needs all levels under its line, and is small: it is made whole of the whole volume.
int vtkNexradVerticalSection::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  vtkInformation* information = input[0]->GetInformationObject(0);
  int extent[6];
  information->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  information->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  return 1;
}

void vtkNexradVerticalSection::Cut(vtkImageData* volume, vtkImageData* section)
{
  const nexrad::MomentName moment = vtkNexradScalarsMoment(volume);
  const std::string name = nexrad::ToString(moment);
  nexrad::SectionSampling sampling;
  sampling.line = {{this->A[0], this->A[1]}, {this->B[0], this->B[1]}};
  sampling.dimensions = {this->SamplesAlong, this->SamplesUpward};
  sampling.moment = moment;
  const auto voxels = vtkNexradVoxels::Require(volume, name);
  const nexrad::VoxelSource source{[voxels](std::size_t voxel) { return voxels.State(voxel); },
    [voxels](std::size_t voxel) { return voxels.Value(voxel); }};
  const nexrad::VerticalSection cut =
    nexrad::MakeVerticalSection(vtkNexradImageToGrid(volume), source, sampling);
  if (!(cut.length > 0.0))
  {
    throw nexrad::Error("the line of the section has no length: A and B are one place");
  }
  Fill(cut, name, section);
  section->GetFieldData()->ShallowCopy(volume->GetFieldData());
}

int vtkNexradVerticalSection::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkImageData* volume = vtkImageData::GetData(input[0]);
  vtkImageData* section = vtkImageData::GetData(output);
  if (volume->GetNumberOfPoints() == 0)
  {
    section->Initialize();
    return 1;
  }
  try
  {
    this->Cut(volume, section);
  }
  catch (const nexrad::Error& error)
  {
    section->Initialize();
    this->SetErrorCode(vtkErrorCode::UserError);
    return vtkNexradFail(this, error.what());
  }
  return 1;
}

void vtkNexradVerticalSection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "A: " << this->A[0] << " " << this->A[1] << "\n";
  os << indent << "B: " << this->B[0] << " " << this->B[1] << "\n";
  os << indent << "SamplesAlong: " << this->SamplesAlong << "\n";
  os << indent << "SamplesUpward: " << this->SamplesUpward << "\n";
}
