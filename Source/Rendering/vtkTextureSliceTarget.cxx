// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTarget.h"

#include "vtkAbstractMapper.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceParts.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"

#include "TextureSliceCompositeFS.h"

#include <algorithm>
#include <cmath>

namespace
{

/// See vtkTextureSliceTarget::DepthFormat; of the framebuffer that is drawn into.
std::array<int, 3> QueryDepthFormat()
{
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  const GLenum depth = bound == 0 ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
  const GLenum stencil = bound == 0 ? GL_STENCIL : GL_STENCIL_ATTACHMENT;
  const auto query = [](GLenum attachment, GLenum what)
  {
    GLint value = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, what, &value);
    return value;
  };
  const auto exists = [&](GLenum attachment)
  { return query(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE; };
  if (!exists(depth))
  {
    return {};
  }
  // The type of a combined depth and stencil attachment is asked for at the depth attachment.
  return {query(depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE),
    query(depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT,
    exists(stencil) && query(stencil, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) > 0};
}

std::array<int, 4> GetViewport(vtkOpenGLRenderWindow* window)
{
  std::array<int, 4> viewport{};
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport.data());
  return viewport;
}

bool HasSize(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, int width, int height)
{
  return texture->GetHandle() != 0 && texture->GetContext() == window &&
         texture->GetWidth() == static_cast<unsigned int>(width) &&
         texture->GetHeight() == static_cast<unsigned int>(height);
}

void Prepare(vtkTextureObject* texture, vtkOpenGLRenderWindow* window)
{
  texture->SetContext(window);
  texture->ResetFormatAndType();
  vtkTextureSliceSetSampling(texture, true);
}

vtkDataArray* Allocate(vtkImageData* image, const std::array<int, 2>& size, int type, int count)
{
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(type, count);
  return image->GetPointData()->GetScalars();
}

/// The depth in the window, 0 to 1, of a place as texture coordinates.
double FindDepth(const vtkTextureSliceFrame& frame, const float* place)
{
  const std::array<double, 16>& toClip = frame.View.BoxToClip;
  double z = toClip[11];
  double w = toClip[15];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto box =
      static_cast<double>((place[axis] - frame.TextureBias[axis]) / frame.TextureScale[axis]);
    z += toClip[8 + axis] * box;
    w += toClip[12 + axis] * box;
  }
  return std::clamp(0.5 * z / w + 0.5, 0.0, 1.0);
}

/// The stage is known to the pass alone, but each one declares other textures.
vtkTextureSlicePeeling::Stage FindStage(const std::string& declared)
{
  const auto declares = [&declared](const char* name)
  { return declared.find(name) != std::string::npos; };
  return declares("depthRangeTex")       ? vtkTextureSlicePeeling::Rest
         : !declares("innerDepthTex")    ? vtkTextureSlicePeeling::None
         : declares("lastFrontColorTex") ? vtkTextureSlicePeeling::Between
                                         : vtkTextureSlicePeeling::Outside;
}

} // namespace

double vtkTextureSliceResolution::Choose(double allowedTime, double minimum, double maximum)
{
  constexpr double distances[] = {1.0, 2.0, 5.0, 10.0};
  double chosen = distances[0];
  for (const double distance : distances)
  {
    chosen = distance;
    if (!IsInteractive(allowedTime) || this->FullTime <= allowedTime * distance * distance)
    {
      break;
    }
  }
  this->LastDistance = std::max(minimum, std::min(chosen, maximum));
  return this->LastDistance;
}

void vtkTextureSliceResolution::Report(double seconds)
{
  const double full = seconds * this->LastDistance * this->LastDistance;
  // Averaged, so that one slow frame does not make the picture flicker.
  this->FullTime = this->FullTime > 0.0 ? 0.5 * (this->FullTime + full) : full;
}

const char* vtkTextureSlicePeeling::Update(
  vtkRenderer* renderer, vtkAbstractMapper* mapper, vtkVolume* volume)
{
  this->Asked = None;
  this->Picture = 0;
  this->Mapper = mapper;
  this->Volume = volume;
  vtkInformation* keys = volume->GetPropertyKeys();
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  const int count = keys != nullptr && keys->Has(passes) ? passes->Length(keys) : 0;
  for (int i = 0; i < count; ++i)
  {
    auto* pass = vtkOpenGLRenderPass::SafeDownCast(passes->Get(keys, i));
    // Where a pass that peels volumes declares its textures in the shader of VTK's ray caster.
    const std::string mark = "//VTK::DepthPeeling::Dec";
    std::string declared = mark;
    if (pass != nullptr)
    {
      std::string vertexShader;
      std::string geometryShader;
      pass->PreReplaceShaderValues(vertexShader, geometryShader, declared, mapper, volume);
    }
    if (declared != mark)
    {
      this->Pass = pass;
      this->Asked = FindStage(declared);
      if (this->Asked == None)
      {
        return "a render pass peels the volume in a way that is not known: call "
               "SetUseDepthPeelingForVolumes(false) on the renderer";
      }
      // VTK's pass takes all that is translucent for hidden where a pixel has several samples.
      // Passes of the renderer's own draw into pictures without them.
      return renderer->GetPass() == nullptr && renderer->GetRenderWindow()->GetMultiSamples() > 0
               ? "VTK's depth peeling draws nothing in a window with multisamples: call "
                 "SetMultiSamples(0) on the window"
               : nullptr;
    }
  }
  return nullptr;
}

void vtkTextureSlicePeeling::SetUniforms(vtkShaderProgram* program) const
{
  this->Pass->SetShaderParameters(program, this->Mapper, this->Volume);
  program->SetUniformi("peelInFront", this->CountPictures() == 2 && this->Picture == 0 ? 1 : 0);
}

std::array<int, 2> vtkTextureSliceTarget::GetSize(vtkOpenGLRenderWindow* window, double pixelSize)
{
  const std::array<int, 4> viewport = GetViewport(window);
  const auto count = [pixelSize](int pixels)
  { return static_cast<int>(std::max(1.0, std::ceil(pixels / pixelSize))); };
  return {count(viewport[2]), count(viewport[3])};
}

bool vtkTextureSliceTarget::CopyDepth()
{
  const std::array<int, 3> format = QueryDepthFormat();
  const auto [bits, isFloat, hasStencil] = format;
  const auto [left, bottom, width, height] = this->Viewport;
  if (!HasSize(this->Depth, this->Window, width, height) || this->DepthFormat != format)
  {
    // A framebuffer keeps textures of the old size, even where new ones have their names.
    this->DepthFramebuffer->ReleaseGraphicsResources(this->Window);
    Prepare(this->Depth, this->Window);
    const auto columns = static_cast<unsigned int>(width);
    const auto rows = static_cast<unsigned int>(height);
    const int ofVTK = isFloat      ? vtkTextureObject::Float32
                      : bits == 16 ? vtkTextureObject::Fixed16
                      : bits == 32 ? vtkTextureObject::Fixed32
                                   : vtkTextureObject::Fixed24;
    if (!(hasStencil ? this->Depth->AllocateDepthStencil(columns, rows)
                     : this->Depth->AllocateDepth(columns, rows, ofVTK)))
    {
      return false;
    }
    this->DepthFormat = format;
  }
  GLint source = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &source);
  vtkOpenGLState* state = this->Window->GetState();
  this->DepthFramebuffer->SetContext(this->Window);
  this->DepthFramebuffer->Bind();
  this->DepthFramebuffer->AddDepthAttachment(this->Depth);
  this->DepthFramebuffer->DeactivateDrawBuffers();
  state->vtkglDisable(GL_SCISSOR_TEST);
  if (bits == 0)
  {
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglClear(GL_DEPTH_BUFFER_BIT);
    return true;
  }
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned int>(source));
  state->vtkglBlitFramebuffer(left, bottom, left + width, bottom + height, 0, 0, width, height,
    GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  return true;
}

bool vtkTextureSliceTarget::MakePicture(int width, int height, bool fullPrecision)
{
  if (HasSize(this->Color, this->Window, width, height) && this->FullPrecision == fullPrecision)
  {
    return true;
  }
  this->Framebuffer->ReleaseGraphicsResources(this->Window);
  Prepare(this->Color, this->Window);
  this->Color->SetInternalFormat(fullPrecision ? GL_RGBA32F : GL_RGBA16);
  this->FullPrecision = fullPrecision;
  return this->Color->Allocate2D(
    static_cast<unsigned int>(width), static_cast<unsigned int>(height), 4, VTK_FLOAT);
}

std::string vtkTextureSliceTarget::Begin(const vtkTextureSliceParts& parts)
{
  this->Window = parts.Window;
  this->Viewport = GetViewport(this->Window);
  const auto [width, height] = GetSize(this->Window, parts.PixelSize);
  // Polygons round hundreds of samples, one after the other.
  const bool fullPrecision =
    parts.Features.Places || parts.Ways.GetDrawn() == vtkOpenGLTextureSliceVolumeMapper::POLYGONS;
  if (!this->MakePicture(width, height, fullPrecision))
  {
    return "OpenGL could not make a floating-point picture of " + std::to_string(width) + " x " +
           std::to_string(height) + " pixels";
  }
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  if (parts.Features.NeedsDepth() && !this->CopyDepth())
  {
    state->PopFramebufferBindings();
    return "OpenGL could not make a copy of the window's depth";
  }
  this->Framebuffer->SetContext(this->Window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Color);
  this->Framebuffer->ActivateDrawBuffer(0);
  const char* reason = "";
  if (!vtkOpenGLFramebufferObject::GetFrameBufferStatus(
        vtkOpenGLFramebufferObject::GetDrawMode(), reason))
  {
    state->PopFramebufferBindings();
    return std::string("OpenGL cannot draw into a floating-point picture: ") + reason;
  }
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglViewport(0, 0, width, height);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  return "";
}

void vtkTextureSliceTarget::End()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->PopFramebufferBindings();
  state->vtkglViewport(this->Viewport[0], this->Viewport[1], this->Viewport[2], this->Viewport[3]);
}

void vtkTextureSliceTarget::Composite(vtkTextureSliceParts& parts)
{
  const vtkTextureSliceFeatures& features = parts.Features;
  vtkOpenGLState* state = this->Window->GetState();
  // Associated colour over the window; identifiers as they are.
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->SetEnumState(GL_BLEND, !features.Selection);
  const std::string defines = features.GetDefines();
  vtkShaderProgram* program = this->Box.Ready(this->Window, defines,
    [&defines]
    {
      std::string shader = TextureSliceCompositeFS;
      vtkShaderProgram::Substitute(shader, "//VTK::TextureSlice::Defines", defines);
      return shader;
    });
  if (features.Peel > 0)
  {
    if (features.Peel != vtkTextureSlicePeeling::Rest)
    {
      // As the pass itself: where a volume draws nothing, the largest of nothing and what is there
      // leaves it alone.
      state->vtkglBlendEquation(GL_MAX);
    }
    parts.Peeling.SetUniforms(program);
  }
  // Between an extreme and no sample at all there is nothing.
  const bool smooth = parts.PixelSize != 1.0 &&
                      features.BlendMode != vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND &&
                      features.BlendMode != vtkVolumeMapper::MINIMUM_INTENSITY_BLEND;
  vtkTextureSliceSetSampling(this->Color, !smooth);
  this->Color->Activate();
  program->SetUniformi("volumeImage", this->Color->GetTextureUnit());
  const std::array<float, 4> toPicture{1.0f / static_cast<float>(this->Viewport[2]),
    1.0f / static_cast<float>(this->Viewport[3]),
    -static_cast<float>(this->Viewport[0]) / static_cast<float>(this->Viewport[2]),
    -static_cast<float>(this->Viewport[1]) / static_cast<float>(this->Viewport[3])};
  program->SetUniform4f("toPicture", toPicture.data());
  const float finalWindow = parts.Request.Mapper->GetFinalColorWindow();
  program->SetUniformf("colorScale", 1.0f / finalWindow);
  program->SetUniformf(
    "colorBias", 0.5f - parts.Request.Mapper->GetFinalColorLevel() / finalWindow);
  program->SetUniform3f("selectionColor", parts.SelectionColor.data());
  this->Box.Draw(parts, program);
  this->Color->Deactivate();
}

void vtkTextureSliceTarget::ReleaseGraphicsResources(vtkOpenGLRenderWindow* window)
{
  this->Box.ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->DepthFramebuffer->ReleaseGraphicsResources(window);
  this->Color->ReleaseGraphicsResources(window);
  this->Depth->ReleaseGraphicsResources(window);
  this->Window = nullptr;
}

std::vector<float> vtkTextureSliceImages::Download(vtkTextureObject* picture)
{
  std::vector<float> pixels(std::size_t{4} * picture->GetWidth() * picture->GetHeight());
  picture->Activate();
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, pixels.data());
  picture->Deactivate();
  return pixels;
}

void vtkTextureSliceImages::Fill(const vtkTextureSliceParts& parts,
  const std::vector<float>& colors, const std::vector<float>& places)
{
  vtkOpenGLTextureSliceVolumeMapper* mapper = parts.Request.Mapper;
  const float window = mapper->GetFinalColorWindow();
  const float level = 0.5f * window - mapper->GetFinalColorLevel();
  const int depthType = mapper->GetDepthImageScalarType();
  const bool clamps = mapper->GetClampDepthToBackface() != 0;
  const auto size = vtkTextureSliceTarget::GetSize(parts.Window, parts.PixelSize);
  vtkDataArray* bytes = Allocate(this->Color, size, VTK_UNSIGNED_CHAR, 4);
  vtkDataArray* depths = Allocate(this->Depth, size, depthType, 1);
  const bool rounds = depthType != VTK_FLOAT;
  const double farthest = rounds ? depths->GetDataTypeMax() : 1.0;
  for (vtkIdType pixel = 0; pixel < bytes->GetNumberOfTuples(); ++pixel)
  {
    const float* color = colors.data() + 4 * pixel;
    const float* place = places.data() + 4 * pixel;
    const bool meetsVolume = place[3] > 0.0f;
    for (int i = 0; i < 4; ++i)
    {
      const float final = i < 3 ? (color[i] + level * color[3]) / window : color[3];
      const float value = meetsVolume ? std::clamp(final, 0.0f, 1.0f) : (i < 3 ? 1.0f : 0.0f);
      bytes->SetComponent(pixel, i, std::round(255.0f * value));
    }
    const bool hasDepth = place[3] == 1.0f || (clamps && meetsVolume);
    const double depth = farthest * (hasDepth ? FindDepth(parts.Frame, place) : 1.0);
    depths->SetComponent(pixel, 0, rounds ? std::round(depth) : depth);
  }
}
