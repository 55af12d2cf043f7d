// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTarget.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceUniforms.h"

#include "TextureSliceCompositeFS.h"

#include <algorithm>
#include <cmath>

namespace
{

/// OpenGL copies depth only between equal formats, so the target takes the window's.
struct DepthFormat
{
  int Bits = 0;
  bool Float = false;
  bool Stencil = false;

  int Key() const { return this->Bits * 4 + (this->Float ? 2 : 0) + (this->Stencil ? 1 : 0); }
  int VTKFormat() const
  {
    if (this->Float)
    {
      return vtkTextureObject::Float32;
    }
    return this->Bits == 16
             ? vtkTextureObject::Fixed16
             : (this->Bits == 32 ? vtkTextureObject::Fixed32 : vtkTextureObject::Fixed24);
  }
};

/// The depth format of the framebuffer that is drawn into.
DepthFormat QueryDepthFormat()
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

  DepthFormat format;
  if (exists(depth))
  {
    format.Bits = query(depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
    // The type of a combined depth and stencil attachment is asked for at the depth attachment.
    format.Float = query(depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
    format.Stencil = exists(stencil) && query(stencil, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) > 0;
  }
  return format;
}

/// Pixels of the picture for those of the window.
int CountPixels(int pixels, double pixelSize)
{
  return static_cast<int>(std::max(1.0, std::ceil(pixels / pixelSize)));
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

/// Makes a texture ready to be allocated anew.
void Prepare(vtkTextureObject* texture, vtkOpenGLRenderWindow* window)
{
  texture->SetContext(window);
  texture->ResetFormatAndType();
  vtkTextureSliceSetSampling(texture, true);
}

std::string MakeCompositeShader(const vtkTextureSliceFeatures& features)
{
  std::string shader = TextureSliceCompositeFS;
  vtkShaderProgram::Substitute(shader, "//VTK::TextureSlice::Defines", features.GetDefines());
  return shader;
}

} // namespace

vtkTextureSliceTarget::vtkTextureSliceTarget() = default;
vtkTextureSliceTarget::~vtkTextureSliceTarget() = default;

std::array<int, 2> vtkTextureSliceTarget::GetSize(vtkOpenGLRenderWindow* window, double pixelSize)
{
  const std::array<int, 4> viewport = GetViewport(window);
  return {CountPixels(viewport[2], pixelSize), CountPixels(viewport[3], pixelSize)};
}

bool vtkTextureSliceTarget::CopyDepth(std::string& error)
{
  const DepthFormat format = QueryDepthFormat();
  const auto [left, bottom, width, height] = this->Viewport;
  if (!HasSize(this->Depth, this->Window, width, height) || this->DepthKey != format.Key())
  {
    // A framebuffer keeps textures of the old size, even where new ones have their names.
    this->DepthFramebuffer->ReleaseGraphicsResources(this->Window);
    Prepare(this->Depth, this->Window);
    const auto columns = static_cast<unsigned int>(width);
    const auto rows = static_cast<unsigned int>(height);
    if (!(format.Stencil ? this->Depth->AllocateDepthStencil(columns, rows)
                         : this->Depth->AllocateDepth(columns, rows, format.VTKFormat())))
    {
      error = "OpenGL could not make a copy of the window's depth";
      return false;
    }
    this->DepthKey = format.Key();
  }
  GLint source = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &source);
  vtkOpenGLState* state = this->Window->GetState();
  this->DepthFramebuffer->SetContext(this->Window);
  this->DepthFramebuffer->Bind();
  this->DepthFramebuffer->AddDepthAttachment(this->Depth);
  this->DepthFramebuffer->DeactivateDrawBuffers();
  state->vtkglDisable(GL_SCISSOR_TEST);
  if (format.Bits == 0)
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

bool vtkTextureSliceTarget::MakePicture(
  int width, int height, bool fullPrecision, std::string& error)
{
  if (HasSize(this->Color, this->Window, width, height) && this->FullPrecision == fullPrecision)
  {
    return true;
  }
  this->Framebuffer->ReleaseGraphicsResources(this->Window);
  Prepare(this->Color, this->Window);
  this->Color->SetInternalFormat(fullPrecision ? GL_RGBA32F : GL_RGBA16);
  this->FullPrecision = fullPrecision;
  if (!this->Color->Allocate2D(
        static_cast<unsigned int>(width), static_cast<unsigned int>(height), 4, VTK_FLOAT))
  {
    error = "OpenGL could not make a floating-point picture of " + std::to_string(width) + " x " +
            std::to_string(height) + " pixels";
    return false;
  }
  return true;
}

bool vtkTextureSliceTarget::Begin(vtkOpenGLRenderWindow* window, double pixelSize, bool copiesDepth,
  bool fullPrecision, std::string& error)
{
  this->Window = window;
  this->Viewport = GetViewport(window);
  const auto [width, height] = GetSize(window, pixelSize);
  if (!this->MakePicture(width, height, fullPrecision, error))
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  if (copiesDepth && !this->CopyDepth(error))
  {
    state->PopFramebufferBindings();
    return false;
  }
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Color);
  this->Framebuffer->ActivateDrawBuffer(0);
  const char* reason = "";
  if (!vtkOpenGLFramebufferObject::GetFrameBufferStatus(
        vtkOpenGLFramebufferObject::GetDrawMode(), reason))
  {
    error = std::string("OpenGL cannot draw into a floating-point picture: ") + reason;
    state->PopFramebufferBindings();
    return false;
  }
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglViewport(0, 0, width, height);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  return true;
}

void vtkTextureSliceTarget::End()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->PopFramebufferBindings();
  state->vtkglViewport(this->Viewport[0], this->Viewport[1], this->Viewport[2], this->Viewport[3]);
}

void vtkTextureSliceTarget::Composite(bool smooth, const vtkTextureSliceUniforms& uniforms,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  const vtkTextureSliceFeatures& features = uniforms.Features;
  vtkShaderProgram* program = this->Box.Ready(
    this->Window, features.GetDefines(), [&features] { return MakeCompositeShader(features); });
  vtkTextureSliceSetSampling(this->Color, !smooth);
  this->Color->Activate();
  program->SetUniformi("volumeImage", this->Color->GetTextureUnit());
  const std::array<float, 4> toPicture{1.0f / static_cast<float>(this->Viewport[2]),
    1.0f / static_cast<float>(this->Viewport[3]),
    -static_cast<float>(this->Viewport[0]) / static_cast<float>(this->Viewport[2]),
    -static_cast<float>(this->Viewport[1]) / static_cast<float>(this->Viewport[3])};
  program->SetUniform4f("toPicture", toPicture.data());
  setUniforms(program);
  this->Box.Draw(uniforms.Frame, uniforms.Seen);
  this->Color->Deactivate();
}

void vtkTextureSliceTarget::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Box.ReleaseGraphicsResources();
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->DepthFramebuffer->ReleaseGraphicsResources(window);
  this->Color->ReleaseGraphicsResources(window);
  this->Depth->ReleaseGraphicsResources(window);
  this->Window = nullptr;
}
