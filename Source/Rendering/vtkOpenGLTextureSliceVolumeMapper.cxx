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
#include "vtkShaderProperty.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceParts.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkOpenGLTextureSliceVolumeMapper);

namespace
{

/// Points along each axis; empty for what is neither an image nor a rectilinear grid.
std::vector<int> FindDimensions(vtkDataSet* input)
{
  auto* image = vtkImageData::SafeDownCast(input);
  auto* grid = vtkRectilinearGrid::SafeDownCast(input);
  const int* points = image != nullptr ? image->GetDimensions() : nullptr;
  points = grid != nullptr ? grid->GetDimensions() : points;
  return points != nullptr ? std::vector<int>(points, points + 3) : std::vector<int>();
}

/// Whether a volume of these dimensions has a thickness along each axis, and one of a rectilinear
/// grid fits a texture. A volume whose source has not run yet has no dimensions: then nothing
/// speaks against it.
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
  return *least > 1 && (grid == nullptr || limit <= 0 || *most - (cellData ? 1 : 0) <= limit);
}

/// What VTK's ray caster would do and the slices leave out; empty: nothing.
std::string FindIgnored(vtkVolume* volume)
{
  vtkShaderProperty* shaders = volume->GetShaderProperty();
  const bool isAsked = shaders->GetNumberOfShaderReplacements() > 0 ||
                       shaders->HasFragmentShaderCode() || shaders->HasVertexShaderCode();
  return isAsked ? "the volume is drawn without the code of its shader property, which only VTK's "
                   "ray caster knows: make one by vtkOpenGLGPUVolumeRayCastMapper::New()"
                 : "";
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
  return this->Parts->Planes.NumberOfSlices;
}

vtkIdType vtkOpenGLTextureSliceVolumeMapper::GetTextureBytes() const
{
  return static_cast<vtkIdType>(this->Parts->Texture.CountBytes());
}

int vtkOpenGLTextureSliceVolumeMapper::GetDrawnWay() const
{
  return this->Parts->Ways.GetDrawn();
}

vtkTextureSliceRequest vtkOpenGLTextureSliceVolumeMapper::MakeRequest(
  vtkVolumeProperty* property, vtkDataSet* input, vtkDataArray* scalars, bool cellData)
{
  vtkTextureSliceRequest request;
  request.Mapper = this;
  request.Property = property;
  request.BlendMode = this->BlendMode;
  if (scalars != nullptr)
  {
    request.Components = scalars->GetNumberOfComponents();
    request.ScalarType = scalars->GetDataType();
  }
  if (this->Transfer2DYAxisArray != nullptr && input != nullptr)
  {
    request.NamesSecondArray = true;
    request.SecondArray =
      input->GetAttributes(cellData ? vtkDataObject::CELL : vtkDataObject::POINT)
        ->GetArray(this->Transfer2DYAxisArray);
  }
  return request;
}

int vtkOpenGLTextureSliceVolumeMapper::IsRenderSupported(
  vtkRenderWindow* window, vtkVolumeProperty* property)
{
  auto* openGLWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  vtkDataSet* input = this->GetInput(0);
  int cellFlag = 0;
  vtkDataArray* scalars = this->GetScalars(
    input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  const bool cellData = cellFlag == 1;
  // Without an input there is nothing to say about it.
  return openGLWindow != nullptr && (input == nullptr || CanHold(openGLWindow, input, cellData)) &&
         this->MakeRequest(property, input, scalars, cellData).FindUnsupported() == nullptr;
}

void vtkOpenGLTextureSliceVolumeMapper::GetReductionRatio(double ratio[3])
{
  // Images that are larger are stored in pages.
  auto* grid = vtkRectilinearGrid::SafeDownCast(this->GetTransformedInput(0));
  std::vector<int> size = FindDimensions(grid);
  size.resize(3, 1);
  GLint limit = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limit);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int voxels = std::max(1, size[axis] - (this->CellFlag == 1 ? 1 : 0));
    ratio[axis] = limit > 0 ? std::min(1.0, static_cast<double>(limit) / voxels) : 1.0;
  }
}

double vtkOpenGLTextureSliceVolumeMapper::ChooseSampleDistance()
{
  if (this->AutoAdjustSampleDistances)
  {
    return this->Parts->Frame.ShortestVoxelEdge;
  }
  vtkImageData* image = this->Parts->Image;
  return this->LockSampleDistanceToInputSpacing
           ? this->SpacingAdjustedSampleDistance(image->GetSpacing(), image->GetExtent())
           : static_cast<double>(this->SampleDistance);
}

std::string vtkOpenGLTextureSliceVolumeMapper::TakeInput()
{
  // VTK 9.1 keeps the class of its copy when an image takes the place of a grid, or a grid that of
  // an image: such a copy has the arrays of the new input alone.
  vtkDataSet* input = this->GetTransformedInput(0);
  if (input != nullptr && input->GetDataObjectType() != this->GetInput(0)->GetDataObjectType())
  {
    input = this->GetInput(0);
  }
  vtkTextureSliceParts& parts = *this->Parts;
  auto* grid = vtkRectilinearGrid::SafeDownCast(input);
  parts.Image = vtkImageData::SafeDownCast(input);
  if (grid != nullptr)
  {
    if (const char* unsupported = vtkTextureSliceCoordinates::FindUnsupported(grid))
    {
      return unsupported;
    }
    parts.Image = vtkTextureSliceCoordinates::MakeImage(grid);
  }
  if (parts.Image == nullptr)
  {
    return "the input must be a vtkImageData or a vtkRectilinearGrid";
  }
  parts.Coordinates.Set(grid);
  parts.Scalars = this->GetScalars(parts.Image, this->ScalarMode, this->ArrayAccessMode,
    this->ArrayId, this->ArrayName, this->CellFlag);
  return "";
}

std::string vtkOpenGLTextureSliceVolumeMapper::UpdateVolume(
  vtkRenderer* renderer, vtkVolume* volume)
{
  vtkTextureSliceParts& parts = *this->Parts;
  std::string error = this->TakeInput();
  if (!error.empty())
  {
    return error;
  }
  const bool cellData = this->CellFlag == 1;
  parts.Request = this->MakeRequest(volume->GetProperty(), parts.Image, parts.Scalars, cellData);
  if (const char* unsupported = parts.Request.FindUnsupported())
  {
    return unsupported;
  }
  parts.Frame.SetVolume(parts.Image, cellData, volume);
  if (parts.Frame.IsFlat())
  {
    return "the volume has no thickness: every axis needs at least two points and an invertible "
           "matrix";
  }
  parts.Use(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  error = this->UpdateMask();
  return error.empty() ? parts.UpdateVolume() : error;
}

bool vtkOpenGLTextureSliceVolumeMapper::PreLoadData(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (window == nullptr || !this->ValidateRender(renderer, volume))
  {
    return false;
  }
  window->Initialize(); // it may not have been drawn yet
  return this->Accept(this->UpdateVolume(renderer, volume));
}

bool vtkOpenGLTextureSliceVolumeMapper::Accept(const std::string& refused)
{
  if (std::exchange(this->Parts->Said[0], refused) != refused && !refused.empty())
  {
    vtkErrorMacro(<< refused);
  }
  return refused.empty();
}

std::string vtkOpenGLTextureSliceVolumeMapper::DrawVolume(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkTextureSliceParts& parts = *this->Parts;
  const std::string refused = this->UpdateVolume(renderer, volume);
  if (!refused.empty() ||
      (this->BlendMode == ISOSURFACE_BLEND && parts.Request.GetIsoValues().empty()))
  {
    return refused;
  }
  if (this->RenderToImage)
  {
    parts.Peeling = {}; // the images are of the volume alone
  }
  else if (const char* unsupported = parts.Peeling.Update(renderer, this, volume))
  {
    return unsupported;
  }
  const double allowedTime = volume->GetAllocatedRenderTime();
  const bool adapts =
    this->AutoAdjustSampleDistances && vtkTextureSliceResolution::IsInteractive(allowedTime);
  parts.PixelSize = static_cast<double>(this->ImageSampleDistance);
  if (adapts)
  {
    parts.PixelSize = parts.Resolution.Choose(allowedTime,
      std::max<double>(parts.PixelSize, this->MinimumImageSampleDistance),
      std::max<double>(parts.PixelSize, this->MaximumImageSampleDistance));
  }
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();
  const std::string error = this->DrawSlices(renderer);
  if (adapts)
  {
    glFinish();
    timer->StopTimer();
    parts.Resolution.Report(timer->GetElapsedTime());
  }
  return error;
}

void vtkOpenGLTextureSliceVolumeMapper::RenderVolume(vtkRenderer* renderer, vtkVolume* volume)
{
  this->Accept(this->DrawVolume(renderer, volume));
  const std::array<std::string, 2> warnings{FindIgnored(volume), this->Parts->Ways.GetFallback()};
  for (std::size_t i = 0; i < warnings.size(); ++i)
  {
    if (std::exchange(this->Parts->Said[i + 1], warnings[i]) != warnings[i] && !warnings[i].empty())
    {
      vtkWarningMacro(<< warnings[i]);
    }
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

bool vtkOpenGLTextureSliceVolumeMapper::PlaceSlices()
{
  vtkTextureSliceParts& parts = *this->Parts;
  parts.EmptySpace.Update(parts);
  vtkTextureSliceView& view = parts.Frame.View;
  vtkPlane* plane = parts.Request.GetSlicePlane();
  view.Plane.reset();
  if (plane != nullptr)
  {
    view.Plane = parts.Frame.ToBox(plane);
  }
  view.NumberOfSlices = this->NumberOfSlices;
  view.SampleDistance = this->ChooseSampleDistance();
  view.Viewport = vtkTextureSliceTarget::GetSize(parts.Window, parts.PixelSize);
  parts.Planes.Place(view);
  // A sum is black where all that was sampled is clear.
  return parts.Planes.NumberOfSlices > 0 &&
         (this->BlendMode == ADDITIVE_BLEND || !parts.EmptySpace.IsNothingVisible());
}

std::string vtkOpenGLTextureSliceVolumeMapper::DrawSlices(vtkRenderer* renderer)
{
  vtkTextureSliceParts& parts = *this->Parts;
  parts.Frame.SetCamera(renderer);
  parts.Frame.SetCuts(this);
  if (!this->PlaceSlices())
  {
    return this->RenderToImage ? this->TakeImages(false) : "";
  }
  parts.Lights.Update(renderer);
  this->UpdateShadows();
  this->SetFeatures(renderer);
  std::string error;
  parts.Window->GetState()->Push();
  for (int picture = 0; picture < parts.Peeling.CountPictures() && error.empty(); ++picture)
  {
    parts.Peeling.SetPicture(picture);
    error = parts.Draw();
    if (error.empty() && this->RenderToImage)
    {
      error = this->TakeImages(true);
    }
    else if (error.empty())
    {
      parts.Target.Composite(parts);
    }
  }
  parts.Window->GetState()->Pop();
  return error;
}

std::string vtkOpenGLTextureSliceVolumeMapper::TakeImages(bool isDrawn)
{
  vtkTextureSliceParts& parts = *this->Parts;
  const auto size = vtkTextureSliceTarget::GetSize(parts.Window, parts.PixelSize);
  std::vector<float> colors(4 * static_cast<std::size_t>(size[0]) * size[1]);
  std::vector<float> places = colors;
  if (isDrawn)
  {
    colors = vtkTextureSliceImages::Download(parts.Target.GetPicture());
    // Projections have the depths of what their functions would show of places.
    parts.Features.Places = true;
    parts.Features.Slabs = false;
    parts.Features.BlendMode =
      parts.Request.ShowsPlaces() ? this->BlendMode : static_cast<int>(COMPOSITE_BLEND);
    parts.Seen = parts.Frame.Cut.Part;
    const std::string error = parts.Draw();
    if (!error.empty())
    {
      return error;
    }
    places = vtkTextureSliceImages::Download(parts.Target.GetPicture());
  }
  parts.Images.Fill(parts, colors, places);
  return "";
}

void vtkOpenGLTextureSliceVolumeMapper::GetColorImage(vtkImageData* output)
{
  output->DeepCopy(this->Parts->Images.Color);
}

void vtkOpenGLTextureSliceVolumeMapper::GetDepthImage(vtkImageData* output)
{
  output->DeepCopy(this->Parts->Images.Depth);
}

void vtkOpenGLTextureSliceVolumeMapper::UpdateShadows()
{
  vtkTextureSliceParts& parts = *this->Parts;
  // The same border as for the image sample distance; the window's own rate, because the time of a
  // prop is shared out only while a frame is drawn.
  const bool interactive =
    this->AutoAdjustSampleDistances != 0 &&
    vtkTextureSliceResolution::IsInteractive(1.0 / parts.Window->GetDesiredUpdateRate());
  parts.Shadows.Update(parts, interactive);
}

bool vtkOpenGLTextureSliceVolumeMapper::UpdateLight(vtkRenderer* renderer, vtkVolume* volume)
{
  if (!this->PreLoadData(renderer, volume))
  {
    return false;
  }
  this->Parts->Frame.SetCuts(this);
  this->UpdateShadows();
  return true;
}

vtkImageData* vtkOpenGLTextureSliceVolumeMapper::GetLightVolume()
{
  return this->Parts->Shadows.GetImage();
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

std::string vtkOpenGLTextureSliceVolumeMapper::UpdateMask()
{
  vtkTextureSliceParts& parts = *this->Parts;
  parts.MaskValues = nullptr;
  if (this->MaskInput == nullptr)
  {
    return "";
  }
  const bool cellData = this->CellFlag == 1;
  vtkDataArray* values =
    this->MaskInput->GetAttributes(cellData ? vtkDataObject::CELL : vtkDataObject::POINT)
      ->GetScalars();
  parts.MaskValues = values;
  if (values == nullptr || values->GetDataType() != VTK_UNSIGNED_CHAR ||
      values->GetNumberOfComponents() != 1 ||
      vtkTextureSliceScalars::GetSize(this->MaskInput, cellData) !=
        vtkTextureSliceScalars::GetSize(parts.Image, cellData))
  {
    return std::string("the mask must have the dimensions of the volume and ") +
           (cellData ? "cell" : "point") + " scalars of one unsigned char";
  }
  return parts.Mask.Update(
    parts.Window, vtkTextureSliceScalars::Find(this->MaskInput, values, cellData), true);
}

void vtkOpenGLTextureSliceVolumeMapper::SetFeatures(vtkRenderer* renderer)
{
  vtkTextureSliceParts& parts = *this->Parts;
  vtkTextureSliceFeatures& features = parts.Features;
  features = parts.Request.GetFeatures();
  features.Masked = parts.Texture.IsMasked();
  features.Paged = parts.Texture.IsPaged();
  features.SecondMasked = features.SecondArray > 0 && parts.SecondArray.IsMasked();
  features.Rectilinear = parts.Coordinates.IsUsed();
  features.Blanked = parts.HasBlanks;
  features.Cropped = parts.Frame.Cut.CropFlags != -1;
  features.Parallel = renderer->GetActiveCamera()->GetParallelProjection() != 0;
  features.Shadows = parts.Shadows.IsUsed();
  features.Peel = parts.Peeling.GetStage();
  features.ClippingPlanes = static_cast<int>(parts.Frame.Cut.Planes.size());
  features.Skipping = parts.EmptySpace.IsSkippingWorthwhile() && features.Contours == 0;
  features.Lights = parts.Request.IsShaded() ? parts.Lights.CountForShader() : -1;
  vtkHardwareSelector* selector = renderer->GetSelector();
  features.Selection = selector != nullptr;
  if (selector != nullptr)
  {
    selector->GetPropColorValue(parts.SelectionColor.data());
  }
  parts.Seen = parts.Frame.Cut.Part;
  // A sum is black wherever there are samples.
  for (std::size_t axis = 0; axis < 3 && this->BlendMode != ADDITIVE_BLEND; ++axis)
  {
    const std::array<double, 6>& visible = parts.EmptySpace.Distances.Seen;
    parts.Seen[2 * axis] = std::max(parts.Seen[2 * axis], visible[2 * axis]);
    parts.Seen[2 * axis + 1] = std::min(parts.Seen[2 * axis + 1], visible[2 * axis + 1]);
  }
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
