// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceParts.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkOpenGLTextureSliceVolumeMapper);

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

/// Points along each axis; empty for what is neither an image nor a rectilinear grid.
std::vector<int> FindDimensions(vtkDataSet* input)
{
  auto* image = vtkImageData::SafeDownCast(input);
  auto* grid = vtkRectilinearGrid::SafeDownCast(input);
  const int* points = image != nullptr ? image->GetDimensions() : nullptr;
  points = grid != nullptr ? grid->GetDimensions() : points;
  return points != nullptr ? std::vector<int>(points, points + 3) : std::vector<int>();
}

/// Whether a volume of these dimensions has a thickness along each axis and fits a texture. A
/// volume whose source has not run yet has no dimensions: then nothing speaks against it.
bool CanHold(vtkOpenGLRenderWindow* window, vtkDataSet* input, bool cellData)
{
  const std::vector<int> points = FindDimensions(input);
  if (points.empty() || input->GetNumberOfPoints() == 0)
  {
    return !points.empty();
  }
  auto* grid = vtkRectilinearGrid::SafeDownCast(input);
  if (grid != nullptr && vtkTextureSliceCoordinates::FindUnsupported(grid) != nullptr)
  {
    return false;
  }
  const int limit = vtkTextureObject::GetMaximumTextureSize3D(window); // -1: no context yet
  const auto [least, most] = std::minmax_element(points.begin(), points.end());
  return *least > 1 && (limit <= 0 || *most - (cellData ? 1 : 0) <= limit);
}

/// What VTK's ray caster would do and the slices leave out; empty: nothing.
std::string FindIgnored(vtkGPUVolumeRayCastMapper* mapper, vtkVolume* volume)
{
  std::string ignored;
  const auto add = [&ignored](bool asked, const char* name)
  { ignored += asked ? (ignored.empty() ? "" : ", ") + std::string(name) : ""; };
  vtkShaderProperty* shaders = volume->GetShaderProperty();
  add(mapper->GetUseDepthPass() != 0, "UseDepthPass");
  add(mapper->GetRenderToImage() != 0, "RenderToImage");
  add(shaders->GetNumberOfShaderReplacements() > 0 || shaders->HasFragmentShaderCode() ||
        shaders->HasVertexShaderCode(),
    "the shader property");
  return ignored;
}

/// The ranges of the scalars alone, as far as a request needs to know them.
std::vector<vtkTextureSliceComponent> FindRanges(vtkDataArray* scalars)
{
  std::vector<vtkTextureSliceComponent> components(
    static_cast<std::size_t>(scalars->GetNumberOfComponents()));
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    scalars->GetFiniteRange(components[i].Range.data(), static_cast<int>(i));
  }
  return components;
}

} // namespace

vtkOpenGLTextureSliceVolumeMapper::vtkOpenGLTextureSliceVolumeMapper()
  : Parts(std::make_unique<vtkTextureSliceParts>())
{
}

vtkOpenGLTextureSliceVolumeMapper::~vtkOpenGLTextureSliceVolumeMapper()
{
  this->Parts->Release(this->Parts->Window);
}

int vtkOpenGLTextureSliceVolumeMapper::GetNumberOfDrawnSlices() const
{
  return this->Parts->Planes.GetNumberOfSlices();
}

int vtkOpenGLTextureSliceVolumeMapper::GetDrawnWay() const
{
  return this->Parts->Ways.GetDrawn();
}

vtkTextureSliceRequest vtkOpenGLTextureSliceVolumeMapper::MakeRequest(
  vtkVolumeProperty* property, vtkDataSet* input, vtkDataArray* scalars, bool cellData)
{
  vtkTextureSliceRequest request;
  request.Property = property;
  request.BlendMode = this->BlendMode;
  if (scalars != nullptr)
  {
    request.Components = scalars->GetNumberOfComponents();
    request.ScalarType = scalars->GetDataType();
  }
  request.PreIntegration = this->PreIntegration;
  request.AverageRange = {this->AverageIPScalarRange[0], this->AverageIPScalarRange[1]};
  request.NativeColor = this->ColorRangeType == NATIVE;
  request.NativeOpacity = this->ScalarOpacityRangeType == NATIVE;
  request.NativeGradientOpacity = this->GradientOpacityRangeType == NATIVE;
  request.BinaryMask = this->MaskInput != nullptr && this->MaskType == BinaryMaskType;
  request.SmoothGradient = this->SmoothGradient;
  if (this->Transfer2DYAxisArray != nullptr && input != nullptr)
  {
    vtkDataArray* second = this->FindSecondArray(input, cellData);
    request.SecondArray = second != nullptr ? second->GetNumberOfComponents() : -1;
  }
  request.LabelMap = this->MaskInput != nullptr && this->MaskType == LabelMapMaskType;
  return request;
}

vtkDataArray* vtkOpenGLTextureSliceVolumeMapper::FindSecondArray(vtkDataSet* input, bool cellData)
{
  vtkDataSetAttributes* attributes =
    cellData ? static_cast<vtkDataSetAttributes*>(input->GetCellData()) : input->GetPointData();
  return attributes->GetArray(this->Transfer2DYAxisArray);
}

const char* vtkOpenGLTextureSliceVolumeMapper::FindUnsupported(
  const vtkTextureSliceRequest& request)
{
  if (this->GetInputCount() > 1)
  {
    return "several volumes in one mapper are not supported: give each a mapper of its own";
  }
  return request.FindUnsupported();
}

int vtkOpenGLTextureSliceVolumeMapper::IsRenderSupported(
  vtkRenderWindow* window, vtkVolumeProperty* property)
{
  auto* openGLWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  vtkDataSet* input = this->GetInput(0);
  if (openGLWindow == nullptr || input == nullptr)
  {
    // Without an input there is nothing to say about it.
    return openGLWindow != nullptr &&
           this->FindUnsupported(this->MakeRequest(property, nullptr, nullptr, false)) == nullptr;
  }
  int cellFlag = 0;
  vtkDataArray* scalars = this->GetScalars(
    input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  const vtkTextureSliceRequest request = this->MakeRequest(property, input, scalars, cellFlag == 1);
  return CanHold(openGLWindow, input, cellFlag == 1) && this->FindUnsupported(request) == nullptr &&
         (scalars == nullptr || property == nullptr ||
           request.FindUnsupportedRange(FindRanges(scalars)) == nullptr);
}

void vtkOpenGLTextureSliceVolumeMapper::GetReductionRatio(double ratio[3])
{
  ratio[0] = ratio[1] = ratio[2] = 1.0;
  std::vector<int> size = FindDimensions(this->GetTransformedInput(0));
  GLint limit = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limit);
  if (size.empty() || limit <= 0)
  {
    return;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    ratio[axis] = std::min(
      1.0, static_cast<double>(limit) / std::max(1, size[axis] - (this->CellFlag == 1 ? 1 : 0)));
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

vtkImageData* vtkOpenGLTextureSliceVolumeMapper::TakeInput(
  vtkDataArray*& scalars, std::string& error)
{
  // VTK 9.1 keeps the class of its copy when an image takes the place of a grid, or a grid that of
  // an image: such a copy has the arrays of the new input alone.
  vtkDataSet* input = this->GetTransformedInput(0);
  if (input != nullptr && input->GetDataObjectType() != this->GetInput(0)->GetDataObjectType())
  {
    input = this->GetInput(0);
  }
  auto* image = vtkImageData::SafeDownCast(input);
  auto* grid = vtkRectilinearGrid::SafeDownCast(input);
  if (grid != nullptr)
  {
    if (const char* unsupported = vtkTextureSliceCoordinates::FindUnsupported(grid))
    {
      error = unsupported;
      return nullptr;
    }
    this->Parts->GridAsImage = vtkTextureSliceCoordinates::MakeImage(grid);
    image = this->Parts->GridAsImage;
  }
  if (image == nullptr)
  {
    error = "the input must be a vtkImageData or a vtkRectilinearGrid";
    return nullptr;
  }
  this->Parts->Coordinates.Set(grid);
  scalars = this->GetScalars(
    image, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, this->CellFlag);
  return image;
}

std::string vtkOpenGLTextureSliceVolumeMapper::DrawVolume(vtkRenderer* renderer, vtkVolume* volume)
{
  std::string error;
  vtkDataArray* scalars = nullptr;
  vtkImageData* image = this->TakeInput(scalars, error);
  if (image == nullptr)
  {
    return error;
  }
  const vtkTextureSliceRequest request =
    this->MakeRequest(volume->GetProperty(), image, scalars, this->CellFlag == 1);
  if (const char* unsupported = this->FindUnsupported(request))
  {
    return unsupported;
  }
  if (const char* unsupported = this->Parts->Peeling.Update(renderer, this, volume))
  {
    return unsupported;
  }
  if (request.IsEmpty())
  {
    return "";
  }
  this->Parts->Frame.SetVolume(image, this->CellFlag == 1, volume);
  if (this->Parts->Frame.IsFlat())
  {
    return "the volume has no thickness: every axis needs at least two points and an invertible "
           "matrix";
  }
  const double allowedTime = volume->GetAllocatedRenderTime();
  this->Parts->PixelSize = this->ChooseImageSampleDistance(allowedTime);
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();
  error = this->DrawSlices(renderer, image, scalars, request);
  if (this->AutoAdjustSampleDistances && vtkTextureSliceResolution::IsInteractive(allowedTime))
  {
    glFinish();
    timer->StopTimer();
    this->Parts->Resolution.Report(timer->GetElapsedTime());
  }
  return error;
}

void vtkOpenGLTextureSliceVolumeMapper::RenderVolume(vtkRenderer* renderer, vtkVolume* volume)
{
  const std::string refused = this->DrawVolume(renderer, volume);
  if (vtkTextureSliceParts::IsNews(this->Parts->Refused, refused))
  {
    vtkErrorMacro(<< refused);
  }
  const std::string ignored = FindIgnored(this, volume);
  if (vtkTextureSliceParts::IsNews(this->Parts->Ignored, ignored))
  {
    vtkWarningMacro(
      "the slices are drawn without " << ignored << ", which only VTK's ray caster knows");
  }
  const std::string fallback = this->Parts->Ways.GetFallback();
  if (vtkTextureSliceParts::IsNews(this->Parts->Fallback, fallback))
  {
    vtkWarningMacro(<< fallback);
  }
}

void vtkOpenGLTextureSliceVolumeMapper::GPURender(vtkRenderer* renderer, vtkVolume* volume)
{
  // Of a selection's passes, only the one that asks for props: voxels have no identifiers here.
  vtkHardwareSelector* selector = renderer->GetSelector();
  if (selector == nullptr)
  {
    this->RenderVolume(renderer, volume);
  }
  else if (selector->GetCurrentPass() == vtkHardwareSelector::ACTOR_PASS)
  {
    selector->BeginRenderProp();
    this->RenderVolume(renderer, volume);
    selector->EndRenderProp();
  }
}

double vtkOpenGLTextureSliceVolumeMapper::ChooseImageSampleDistance(double allowedTime)
{
  const auto asked = static_cast<double>(this->ImageSampleDistance);
  if (!this->AutoAdjustSampleDistances || !vtkTextureSliceResolution::IsInteractive(allowedTime))
  {
    return asked;
  }
  return this->Parts->Resolution.Choose(allowedTime,
    std::max<double>(asked, this->MinimumImageSampleDistance),
    std::max<double>(asked, this->MaximumImageSampleDistance));
}

void vtkOpenGLTextureSliceVolumeMapper::SetUpFrame(vtkRenderer* renderer)
{
  this->Parts->Frame.SetCamera(renderer);
  this->SetUpCuts();
}

void vtkOpenGLTextureSliceVolumeMapper::SetUpCuts()
{
  vtkTextureSliceCropping cropping;
  cropping.On = this->Cropping != 0;
  cropping.RegionFlags = this->CroppingRegionFlags;
  std::copy(this->CroppingRegionPlanes, this->CroppingRegionPlanes + 6, cropping.Planes.begin());
  vtkTextureSliceFrame& frame = this->Parts->Frame;
  frame.SetCropping(cropping);
  frame.SetClippingPlanes(this->GetClippingPlanes());
}

bool vtkOpenGLTextureSliceVolumeMapper::PlaceSlices(
  vtkImageData* image, const vtkTextureSliceRequest& request)
{
  vtkTextureSliceParts& parts = *this->Parts;
  parts.EmptySpace.Update({&request, &parts.Texture, &parts.Table, &parts.LabelTable,
    &parts.Table2D, &parts.Frame, this->CroppingRegionFlags});
  parts.Frame.SetPlane(request.GetSlicePlane());
  vtkTextureSliceView view = parts.Frame.GetView();
  view.NumberOfSlices = this->NumberOfSlices;
  view.SampleDistance = this->ChooseSampleDistance(image, parts.Frame.GetShortestVoxelEdge());
  if (request.IsNearest())
  {
    view.Faces = parts.Frame.GetIntervals();
    view.FirstFace = parts.Frame.GetFirstFace();
  }
  view.Viewport = vtkTextureSliceTarget::GetSize(parts.Window, parts.PixelSize);
  parts.Planes.Place(view);
  // A sum is black where all that was sampled is clear.
  const bool isSeen =
    request.BlendMode == vtkVolumeMapper::ADDITIVE_BLEND || !parts.EmptySpace.IsNothingVisible();
  return parts.Planes.GetNumberOfSlices() > 0 && isSeen;
}

std::string vtkOpenGLTextureSliceVolumeMapper::DrawSlices(vtkRenderer* renderer,
  vtkImageData* image, vtkDataArray* scalars, const vtkTextureSliceRequest& request)
{
  vtkTextureSliceParts& parts = *this->Parts;
  std::string error = this->UpdateVolume(renderer, image, scalars, request);
  if (!error.empty())
  {
    return error;
  }
  this->SetUpFrame(renderer);
  if (!this->PlaceSlices(image, request))
  {
    return "";
  }
  parts.Lights.Update(renderer);
  this->UpdateShadows(image, scalars, request);

  const vtkTextureSliceUniforms uniforms = this->MakeUniforms(renderer, request);
  const StateKeeper keeper(parts.Window->GetState());
  parts.Ways.SetAsked(this->Way);
  for (int picture = 0; picture < parts.Peeling.CountPictures(); ++picture)
  {
    parts.Peeling.SetPicture(picture);
    if (!parts.Draw(uniforms, error))
    {
      return error;
    }
    parts.Composite(uniforms, 1.0f / this->FinalColorWindow,
      0.5f - this->FinalColorLevel / this->FinalColorWindow);
  }
  return "";
}

std::string vtkOpenGLTextureSliceVolumeMapper::UpdateVolume(vtkRenderer* renderer,
  vtkImageData* image, vtkDataArray* scalars, const vtkTextureSliceRequest& request)
{
  vtkTextureSliceParts& parts = *this->Parts;
  std::string error;
  // As in VTK's ray caster, "nearest" holds for the table as well as for the volume.
  const bool nearest = request.IsNearest();
  if (!this->Upload(renderer, image, scalars, error) ||
      !parts.UpdateTables(request, nearest, error))
  {
    return error;
  }
  if (const char* unsupported = request.FindUnsupportedRange(parts.Texture.GetComponents()))
  {
    return unsupported;
  }
  parts.Texture.SetNearest(nearest);
  if (parts.Coordinates.IsUsed())
  {
    parts.Coordinates.Update(parts.Window);
  }
  if (request.ReadsSecondArray())
  {
    const bool cellData = this->CellFlag == 1;
    parts.SecondArray.Update(parts.Window,
      vtkTextureSliceScalars::Find(image, this->FindSecondArray(image, cellData), cellData), error);
    parts.SecondArray.SetNearest(nearest);
  }
  return error;
}

void vtkOpenGLTextureSliceVolumeMapper::FollowScattering(
  vtkVolumeProperty* property, vtkTextureSliceShadowSettings& settings)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  if (property->GetShade(0) != 0 && this->VolumetricScatteringBlending > 0.0f)
  {
    settings.Scattering = static_cast<double>(this->VolumetricScatteringBlending);
    settings.Reach = static_cast<double>(this->GlobalIlluminationReach);
  }
#else
  static_cast<void>(property);
  static_cast<void>(settings);
#endif
}

void vtkOpenGLTextureSliceVolumeMapper::UpdateShadows(
  vtkImageData* image, vtkDataArray* scalars, const vtkTextureSliceRequest& request)
{
  vtkTextureSliceParts& parts = *this->Parts;
  vtkTextureSliceShadowSettings settings;
  // The light is computed in cells of one size.
  if (!parts.Coordinates.IsUsed())
  {
    settings.Shadow = this->ShadowStrength;
    settings.Occlusion = this->OcclusionStrength;
    this->FollowScattering(request.Property, settings);
  }
  settings.Density = this->ShadowDensity;
  settings.Exposure = this->Exposure;
  std::copy(this->LightDirection, this->LightDirection + 3, settings.ToLight.begin());
  std::copy(this->Zenith, this->Zenith + 3, settings.Zenith.begin());
  // The same border as for the image sample distance; the window's own rate, because the time of a
  // prop is shared out only while a frame is drawn.
  settings.Interactive =
    this->AutoAdjustSampleDistances != 0 &&
    vtkTextureSliceResolution::IsInteractive(1.0 / parts.Window->GetDesiredUpdateRate());
  vtkTextureSliceShadows::Source source{&request, image, scalars, &parts.Texture, &parts.Table,
    &parts.LabelTable, nullptr, &parts.Frame, this->CroppingRegionFlags,
    static_cast<double>(this->MaskBlendFactor)};
  if (this->MaskInput != nullptr)
  {
    source.MaskValues = this->FindMaskValues();
  }
  parts.Shadows.Update(parts.Window, source, settings);
}

bool vtkOpenGLTextureSliceVolumeMapper::UpdateLight(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (window == nullptr || !this->ValidateRender(renderer, volume))
  {
    return false;
  }
  window->Initialize(); // it may not have been drawn yet
  std::string error;
  vtkDataArray* scalars = nullptr;
  vtkImageData* image = this->TakeInput(scalars, error);
  if (image == nullptr)
  {
    return false;
  }
  const vtkTextureSliceRequest request =
    this->MakeRequest(volume->GetProperty(), image, scalars, this->CellFlag == 1);
  if (this->FindUnsupported(request) != nullptr)
  {
    return false; // drawing says why
  }
  this->Parts->Frame.SetVolume(image, this->CellFlag == 1, volume);
  if (this->Parts->Frame.IsFlat() || !this->UpdateVolume(renderer, image, scalars, request).empty())
  {
    return false;
  }
  this->SetUpCuts();
  this->UpdateShadows(image, scalars, request);
  return true;
}

vtkImageData* vtkOpenGLTextureSliceVolumeMapper::GetLightVolume()
{
  return this->Parts->Shadows.GetImage();
}

bool vtkOpenGLTextureSliceVolumeMapper::Upload(
  vtkRenderer* renderer, vtkImageData* image, vtkDataArray* scalars, std::string& error)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->Parts->Use(window);
  auto source = vtkTextureSliceScalars::Find(image, scalars, this->CellFlag == 1);
  source.Places = this->Parts->Coordinates.GetPlaces();
  return this->Parts->Texture.Update(window, source, error) &&
         this->Parts->Blanks.Update(window, image, this->CellFlag == 1, error) &&
         this->UpdateMask(image, error);
}

vtkSmartPointer<vtkObject> vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(
  vtkImageData* image, vtkObject* before)
{
  const bool cellData = image->GetPointData()->GetScalars() == nullptr;
  vtkDataArray* scalars =
    cellData ? image->GetCellData()->GetScalars() : image->GetPointData()->GetScalars();
  const vtkIdType texels = cellData ? image->GetNumberOfCells() : image->GetNumberOfPoints();
  if (scalars == nullptr || scalars->GetNumberOfTuples() != texels)
  {
    return nullptr;
  }
  return vtkTextureSliceChecksums::Prepare(vtkTextureSliceScalars::Find(image, scalars, cellData),
    vtkTextureSliceChecksums::SafeDownCast(before));
}

bool vtkOpenGLTextureSliceVolumeMapper::PreLoadData(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (window == nullptr || !this->ValidateRender(renderer, volume))
  {
    return false;
  }
  window->Initialize(); // it may not have been drawn yet
  std::string error;
  vtkDataArray* scalars = nullptr;
  vtkImageData* image = this->TakeInput(scalars, error);
  if (image == nullptr || !this->Upload(renderer, image, scalars, error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  return true;
}

vtkDataArray* vtkOpenGLTextureSliceVolumeMapper::FindMaskValues()
{
  vtkDataSetAttributes* attributes =
    this->CellFlag == 1 ? static_cast<vtkDataSetAttributes*>(this->MaskInput->GetCellData())
                        : this->MaskInput->GetPointData();
  return attributes->GetScalars();
}

bool vtkOpenGLTextureSliceVolumeMapper::UpdateMask(vtkImageData* image, std::string& error)
{
  if (this->MaskInput == nullptr)
  {
    return true;
  }
  const bool cellData = this->CellFlag == 1;
  vtkDataArray* values = this->FindMaskValues();
  if (values == nullptr || values->GetDataType() != VTK_UNSIGNED_CHAR ||
      values->GetNumberOfComponents() != 1 ||
      vtkTextureSliceScalars::GetSize(this->MaskInput, cellData) !=
        vtkTextureSliceScalars::GetSize(image, cellData))
  {
    error = std::string("the mask must have the dimensions of the volume and ") +
            (cellData ? "cell" : "point") + " scalars of one unsigned char";
    return false;
  }
  vtkTextureSliceTexture& mask = this->Parts->Mask;
  const auto source = vtkTextureSliceScalars::Find(this->MaskInput, values, cellData);
  if (!mask.Update(this->Parts->Window, source, error))
  {
    return false;
  }
  mask.SetNearest(true);
  return true;
}

std::array<double, 6> vtkOpenGLTextureSliceVolumeMapper::FindSeen() const
{
  std::array<double, 6> seen = this->Parts->Frame.GetView().Part;
  // A sum is black wherever there are samples.
  for (std::size_t axis = 0; axis < 3 && this->BlendMode != ADDITIVE_BLEND; ++axis)
  {
    const std::array<double, 6>& visible = this->Parts->EmptySpace.GetSeen();
    seen[2 * axis] = std::max(seen[2 * axis], visible[2 * axis]);
    seen[2 * axis + 1] = std::min(seen[2 * axis + 1], visible[2 * axis + 1]);
  }
  return seen;
}

vtkTextureSliceUniforms vtkOpenGLTextureSliceVolumeMapper::MakeUniforms(
  vtkRenderer* renderer, const vtkTextureSliceRequest& request)
{
  vtkTextureSliceParts& parts = *this->Parts;
  vtkTextureSliceUniforms uniforms;
  uniforms.Features = request.GetFeatures();
  uniforms.Features.Masked = parts.Texture.IsMasked();
  uniforms.Features.Cropped = parts.Frame.NeedsCropTest();
  uniforms.Features.Parallel = renderer->GetActiveCamera()->GetParallelProjection() != 0;
  uniforms.Features.Shadows = parts.Shadows.IsUsed();
  uniforms.Features.ScaledLight = parts.Shadows.IsScaled();
  uniforms.Features.Scattering = parts.Shadows.IsScattering();
  uniforms.Features.Peel = parts.Peeling.GetStage();
  uniforms.Features.ClippingPlanes =
    static_cast<int>(parts.Frame.GetClippingPlanesInTexture().size() / 4);
  uniforms.Features.Skipping = parts.EmptySpace.IsSkippingWorthwhile();
  uniforms.Features.Rectilinear = parts.Coordinates.IsUsed();
  uniforms.Features.Blanked = parts.Blanks.IsUsed();
  uniforms.Features.SecondMasked = request.ReadsSecondArray() && parts.SecondArray.IsMasked();
  if (request.IsShaded())
  {
    uniforms.Features.Lights = parts.Lights.CountForShader();
  }
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    uniforms.Features.Selection = true;
    selector->GetPropColorValue(uniforms.SelectionColor.data());
  }
  uniforms.Frame = &parts.Frame;
  uniforms.Planes = &parts.Planes;
  uniforms.Seen = this->FindSeen();
  uniforms.PixelSize = parts.PixelSize;
  uniforms.Surfaces = request.MakeSurfaces();
  uniforms.Volume = parts.Texture.GetTexture();
  parts.AddTextures(uniforms);
  uniforms.SetParts = [this, &request, features = uniforms.Features](vtkShaderProgram* program)
  {
    request.SetUniforms(this->Parts->Texture.GetComponents(), program);
    program->SetUniformi("cropFlags", this->CroppingRegionFlags);
    program->SetUniformf("labelWeight", this->MaskBlendFactor);
    this->Parts->SetUniforms(features, program);
  };
  return uniforms;
}

void vtkOpenGLTextureSliceVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  // A window that is about to end is not known as the owner any more.
  if (this->Parts->Window == nullptr || this->Parts->Window == window)
  {
    this->Parts->Release(vtkOpenGLRenderWindow::SafeDownCast(window));
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkOpenGLTextureSliceVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSlices: " << this->NumberOfSlices << "\n";
  os << indent << "SmoothGradient: " << (this->SmoothGradient ? "On" : "Off") << "\n";
  os << indent << "ShadowStrength: " << this->ShadowStrength << "\n";
  os << indent << "OcclusionStrength: " << this->OcclusionStrength << "\n";
  os << indent << "ShadowDensity: " << this->ShadowDensity << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "LightDirection: " << this->LightDirection[0] << " " << this->LightDirection[1]
     << " " << this->LightDirection[2] << "\n";
  os << indent << "Zenith: " << this->Zenith[0] << " " << this->Zenith[1] << " " << this->Zenith[2]
     << "\n";
  os << indent << "PreIntegration: " << (this->PreIntegration ? "On" : "Off") << "\n";
  os << indent << "Way: " << this->Way << "\n";
  os << indent << "NumberOfDrawnSlices: " << this->GetNumberOfDrawnSlices() << "\n";
}
