// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradTextureSliceRepresentation.h"

#include "VolumeGround.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkNexradTextureSliceRepresentation);

vtkNexradTextureSliceRepresentation::vtkNexradTextureSliceRepresentation()
  : DrawnGround(std::make_unique<VolumeGround>())
{
  this->VolumeMapper = vtkSmartPointer<vtkOpenGLTextureSliceVolumeMapper>::New();
  this->SetPreIntegration(true);
  this->SetNumberOfSlices(0);
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

void vtkNexradTextureSliceRepresentation::SetShadowStrength(double strength)
{
  this->GetSliceMapper()->SetShadowStrength(strength);
}

void vtkNexradTextureSliceRepresentation::SetOcclusionStrength(double strength)
{
  this->GetSliceMapper()->SetOcclusionStrength(strength);
}

void vtkNexradTextureSliceRepresentation::SetShadowDensity(double density)
{
  this->GetSliceMapper()->SetShadowDensity(density);
}

void vtkNexradTextureSliceRepresentation::SetExposure(double exposure)
{
  this->GetSliceMapper()->SetExposure(exposure);
}

void vtkNexradTextureSliceRepresentation::SetLightDirection(double x, double y, double z)
{
  this->GetSliceMapper()->SetLightDirection(x, y, z);
}

void vtkNexradTextureSliceRepresentation::SetGround(bool shown)
{
  this->Ground = shown;
}

bool vtkNexradTextureSliceRepresentation::AddToView(vtkView* view)
{
  auto* drawing = vtkPVRenderView::SafeDownCast(view);
  if (drawing == nullptr || !this->Superclass::AddToView(view))
  {
    return false;
  }
  vtkRenderer* renderer = drawing->GetRenderer();
  this->DrawnGround->AddTo(renderer);
  this->FrameTag = renderer->AddObserver(
    vtkCommand::StartEvent, this, &vtkNexradTextureSliceRepresentation::UpdateGround);
  return true;
}

bool vtkNexradTextureSliceRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* drawing = vtkPVRenderView::SafeDownCast(view))
  {
    drawing->GetRenderer()->RemoveObserver(this->FrameTag);
  }
  this->DrawnGround->Remove();
  return this->Superclass::RemoveFromView(view);
}

// The ground is drawn before the volume, and shows the shadow that this frame has.
void vtkNexradTextureSliceRepresentation::UpdateGround()
{
  this->DrawnGround->Update(this->GetSliceMapper(), this->Actor, this->Ground);
}

void vtkNexradTextureSliceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Ground: " << this->Ground << "\n";
  os << indent << "SliceMapper:\n";
  this->GetSliceMapper()->PrintSelf(os, indent.GetNextIndent());
}
