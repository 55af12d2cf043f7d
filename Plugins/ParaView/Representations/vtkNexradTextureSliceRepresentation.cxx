// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradTextureSliceRepresentation.h"

#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkNexradTextureSliceRepresentation);

vtkNexradTextureSliceRepresentation::vtkNexradTextureSliceRepresentation()
{
  this->VolumeMapper = vtkSmartPointer<vtkOpenGLTextureSliceVolumeMapper>::New();
  this->SetPreIntegration(true);
}

vtkNexradTextureSliceRepresentation::~vtkNexradTextureSliceRepresentation() = default;

int vtkNexradTextureSliceRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // on processes without the data
  return 1;
}

vtkOpenGLTextureSliceVolumeMapper* vtkNexradTextureSliceRepresentation::GetSliceMapper()
{
  return vtkOpenGLTextureSliceVolumeMapper::SafeDownCast(this->VolumeMapper);
}

void vtkNexradTextureSliceRepresentation::SetNumberOfSlices(int slices)
{
  this->GetSliceMapper()->SetNumberOfSlices(slices);
}

int vtkNexradTextureSliceRepresentation::GetNumberOfSlices()
{
  return this->GetSliceMapper()->GetNumberOfSlices();
}

void vtkNexradTextureSliceRepresentation::SetPreIntegration(bool on)
{
  this->GetSliceMapper()->SetPreIntegration(on);
}

void vtkNexradTextureSliceRepresentation::SetBlendMode(int mode)
{
  this->GetSliceMapper()->SetBlendMode(mode);
}

void vtkNexradTextureSliceRepresentation::SetImageSampleDistance(double pixels)
{
  this->GetSliceMapper()->SetImageSampleDistance(static_cast<float>(pixels));
}

void vtkNexradTextureSliceRepresentation::SetAutoAdjustSampleDistances(bool automatic)
{
  this->GetSliceMapper()->SetAutoAdjustSampleDistances(automatic ? 1 : 0);
}

void vtkNexradTextureSliceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SliceMapper:\n";
  this->GetSliceMapper()->PrintSelf(os, indent.GetNextIndent());
}
