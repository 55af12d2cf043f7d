// SPDX-License-Identifier: BSD-3-Clause
#include "WholeVolume.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

void AskForOwnPart(vtkInformation* input, vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (vtkInformationIntegerKey* key :
    {Pipeline::UPDATE_NUMBER_OF_PIECES(), Pipeline::UPDATE_PIECE_NUMBER()})
  {
    input->Set(key, output->Get(key));
  }
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

vtkSmartPointer<vtkImageData> DescribeWhole(vtkInformation* input)
{
  vtkImageData* part = vtkImageData::GetData(input);
  auto whole = vtkSmartPointer<vtkImageData>::New();
  whole->SetExtent(input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  whole->SetOrigin(part->GetOrigin());
  whole->SetSpacing(part->GetSpacing());
  whole->SetFieldData(part->GetFieldData());
  return whole;
}
