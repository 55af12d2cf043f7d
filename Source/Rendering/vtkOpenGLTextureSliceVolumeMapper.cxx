// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceGeometry.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceProgram.h"
#include "vtkTextureSliceTable.h"
#include "vtkTextureSliceTarget.h"
#include "vtkTextureSliceTexture.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <string>

vtkStandardNewMacro(vtkOpenGLTextureSliceVolumeMapper);

/// The helpers, one job each; every one decides for itself what a change makes it do anew.
class vtkOpenGLTextureSliceVolumeMapper::Internals
{
public:
  vtkTextureSliceTexture Texture;
  vtkTextureSliceTable Table;
  vtkTextureSliceFrame Frame;
  vtkTextureSliceGeometry Geometry;
  vtkTextureSliceTarget Target;
  vtkTextureSliceProgram Program;
  /// The window whose context owns the graphics resources.
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;

  void Release(vtkWindow* window)
  {
    this->Texture.ReleaseGraphicsResources(window);
    this->Table.ReleaseGraphicsResources(window);
    this->Target.ReleaseGraphicsResources(window);
    this->Program.ReleaseGraphicsResources();
    this->Window = nullptr;
  }

  /// Makes that window the owner; another one gives its resources up first.
  void Use(vtkOpenGLRenderWindow* window)
  {
    if (this->Window != nullptr && this->Window != window)
    {
      this->Window->MakeCurrent();
      this->Release(this->Window);
    }
    this->Window = window;
    window->MakeCurrent();
  }

  /// Draws the slices into the target. @return false with one line in @a error
  bool Draw(vtkRenderer* renderer, double unitDistance, int cropFlags, std::string& error);
};

namespace
{

/// Keeps what drawing changes in VTK's record of the OpenGL state, and puts it back.
class StateKeeper
{
public:
  explicit StateKeeper(vtkOpenGLState* state)
    : Viewport(state)
    , Scissor(state)
    , ClearColor(state)
    , ColorMask(state)
    , DepthMask(state)
    , DepthFunc(state)
    , BlendFunc(state)
    , ScissorTest(state, GL_SCISSOR_TEST)
    , DepthTest(state, GL_DEPTH_TEST)
    , Blend(state, GL_BLEND)
    , CullFace(state, GL_CULL_FACE)
  {
  }

private:
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglClearColor ClearColor;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
};

} // namespace

bool vtkOpenGLTextureSliceVolumeMapper::Internals::Draw(
  vtkRenderer* renderer, double unitDistance, int cropFlags, std::string& error)
{
  vtkTextureSliceUniforms uniforms;
  uniforms.BoxToClip = this->Frame.GetBoxToClip();
  uniforms.TextureScale = this->Frame.GetTextureScale();
  uniforms.TextureBias = this->Frame.GetTextureBias();
  uniforms.Volume = this->Texture.GetTexture();
  uniforms.Masked = this->Texture.IsMasked();
  uniforms.Table = this->Table.GetTexture();
  uniforms.TableScale = this->Texture.GetScale() * this->Table.GetScale();
  uniforms.TableBias = this->Texture.GetBias() * this->Table.GetScale() + this->Table.GetBias();
  uniforms.UnitDistance = unitDistance;
  uniforms.CropTest = this->Frame.NeedsCropTest();
  uniforms.CropLow = this->Frame.GetCropLow();
  uniforms.CropHigh = this->Frame.GetCropHigh();
  uniforms.CropFlags = cropFlags;

  if (!this->Target.Begin(renderer, error))
  {
    return false;
  }
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_BLEND);
  // Formulas T9, R3: associated colour, back to front.
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const bool drawn = this->Program.Draw(this->Window, this->Geometry, uniforms);
  this->Target.End();
  if (!drawn)
  {
    error = "OpenGL could not compile the shaders of the slices";
  }
  return drawn;
}

vtkOpenGLTextureSliceVolumeMapper::vtkOpenGLTextureSliceVolumeMapper()
  : Parts(std::make_unique<Internals>())
{
}

vtkOpenGLTextureSliceVolumeMapper::~vtkOpenGLTextureSliceVolumeMapper()
{
  if (this->Parts->Window != nullptr)
  {
    this->Parts->Window->MakeCurrent();
    this->Parts->Release(this->Parts->Window);
  }
}

int vtkOpenGLTextureSliceVolumeMapper::GetNumberOfDrawnSlices() const
{
  return this->Parts->Geometry.GetNumberOfSlices();
}

const char* vtkOpenGLTextureSliceVolumeMapper::FindUnsupported(vtkVolumeProperty* property)
{
  if (this->BlendMode != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    return "only composite blending is supported: call SetBlendModeToComposite";
  }
  if (this->MaskInput != nullptr)
  {
    return "a mask is not supported: call SetMaskInput with nullptr";
  }
  if (property == nullptr)
  {
    return nullptr;
  }
  if (property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D)
  {
    return "only one-dimensional transfer functions are supported: use TF_1D";
  }
  if (property->GetShade(0) != 0)
  {
    return "shading is not supported: call ShadeOff on the volume's property";
  }
  if (property->HasGradientOpacity(0))
  {
    return "gradient opacity is not supported: call DisableGradientOpacityOn on the property";
  }
  return nullptr;
}

int vtkOpenGLTextureSliceVolumeMapper::IsRenderSupported(
  vtkRenderWindow* window, vtkVolumeProperty* property)
{
  return vtkOpenGLRenderWindow::SafeDownCast(window) != nullptr &&
         this->FindUnsupported(property) == nullptr;
}

void vtkOpenGLTextureSliceVolumeMapper::GetReductionRatio(double ratio[3])
{
  ratio[0] = ratio[1] = ratio[2] = 1.0;
  auto* image = vtkImageData::SafeDownCast(this->GetTransformedInput(0));
  GLint limit = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limit);
  if (image == nullptr || limit <= 0)
  {
    return;
  }
  const auto size = vtkTextureSliceTexture::GetSize(image, this->CellFlag == 1);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    ratio[axis] = std::min(1.0, static_cast<double>(limit) / std::max(1, size[axis]));
  }
}

double vtkOpenGLTextureSliceVolumeMapper::ChooseSampleDistance(
  vtkImageData* image, double shortestVoxelEdge)
{
  if (this->AutoAdjustSampleDistances)
  {
    return shortestVoxelEdge;
  }
  return this->LockSampleDistanceToInputSpacing
           ? this->SpacingAdjustedSampleDistance(image->GetSpacing(), image->GetExtent())
           : static_cast<double>(this->SampleDistance);
}

void vtkOpenGLTextureSliceVolumeMapper::GPURender(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* image = vtkImageData::SafeDownCast(this->GetTransformedInput(0));
  if (const char* unsupported = this->FindUnsupported(volume->GetProperty()))
  {
    vtkErrorMacro(<< unsupported);
    return;
  }
  if (image == nullptr)
  {
    vtkErrorMacro("the input must be a vtkImageData");
    return;
  }
  vtkDataArray* scalars = this->GetScalars(
    image, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, this->CellFlag);
  if (scalars->GetNumberOfComponents() != 1)
  {
    vtkErrorMacro("the scalars have " << scalars->GetNumberOfComponents()
                                      << " components, only 1 is supported");
    return;
  }
  // A selection pass paints identifiers, which a blended volume would spoil.
  if (renderer->GetSelector() == nullptr)
  {
    this->RenderSlices(renderer, volume, image, scalars);
  }
}

bool vtkOpenGLTextureSliceVolumeMapper::PlaceSlices(
  vtkRenderer* renderer, vtkVolume* volume, vtkImageData* image)
{
  vtkTextureSliceFrame& frame = this->Parts->Frame;
  frame.SetVolume(image, this->CellFlag == 1, volume);
  if (frame.IsFlat())
  {
    vtkErrorMacro("the volume has no thickness: every axis needs at least two points and an "
                  "invertible matrix");
    return false;
  }
  vtkTextureSliceCropping cropping;
  cropping.On = this->Cropping != 0;
  cropping.RegionFlags = this->CroppingRegionFlags;
  std::copy(this->CroppingRegionPlanes, this->CroppingRegionPlanes + 6, cropping.Planes.begin());
  frame.SetCamera(renderer);
  frame.SetCropping(cropping);
  frame.SetClippingPlanes(this->GetClippingPlanes());

  vtkTextureSliceView view = frame.GetView();
  view.NumberOfSlices = this->NumberOfSlices;
  view.SampleDistance = this->ChooseSampleDistance(image, frame.GetShortestVoxelEdge());
  this->Parts->Geometry.Build(view);
  return this->Parts->Geometry.GetNumberOfVertices() > 0;
}

void vtkOpenGLTextureSliceVolumeMapper::RenderSlices(
  vtkRenderer* renderer, vtkVolume* volume, vtkImageData* image, vtkDataArray* scalars)
{
  if (!this->PlaceSlices(renderer, volume, image))
  {
    return;
  }
  Internals& parts = *this->Parts;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  parts.Use(window);
  vtkVolumeProperty* property = volume->GetProperty();
  std::string error;
  if (!parts.Texture.Update(window, image, scalars, this->CellFlag == 1, error))
  {
    vtkErrorMacro(<< error);
    return;
  }
  parts.Texture.SetNearest(property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION);
  parts.Table.Update(
    window, {property, parts.Texture.GetScalarRange(), this->ColorRangeType == NATIVE,
              this->ScalarOpacityRangeType == NATIVE});

  const StateKeeper keeper(window->GetState());
  if (!parts.Draw(
        renderer, property->GetScalarOpacityUnitDistance(0), this->CroppingRegionFlags, error))
  {
    vtkErrorMacro(<< error);
    return;
  }
  parts.Target.Composite(
    renderer, 1.0f / this->FinalColorWindow, 0.5f - this->FinalColorLevel / this->FinalColorWindow);
}

void vtkOpenGLTextureSliceVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Parts->Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkOpenGLTextureSliceVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSlices: " << this->NumberOfSlices << "\n";
  os << indent << "NumberOfDrawnSlices: " << this->GetNumberOfDrawnSlices() << "\n";
}
