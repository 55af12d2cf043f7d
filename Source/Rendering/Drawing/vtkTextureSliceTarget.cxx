// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTarget.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceOpenGL.h"

#include "TextureSliceCompositeFS.h"
#include "TextureSlicePeelCompositeFS.h"
#include "TextureSlicePeelFS.h"
#include "TextureSliceTableFS.h"

#include <algorithm>
#include <cmath>

/// OpenGL copies depth only between equal formats, so the target takes the window's.
struct vtkTextureSliceTarget::DepthFormat
{
  int Bits;
  bool Float;
  bool Stencil;

  explicit DepthFormat(int key = 0)
    : Bits(key / 4)
    , Float((key & 2) != 0)
    , Stencil((key & 1) != 0)
  {
  }
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

namespace
{

/// Pixels of the picture for those of the window.
int CountPixels(int pixels, double pixelSize)
{
  return static_cast<int>(std::max(1.0, std::ceil(pixels / pixelSize)));
}

/// Makes a texture ready to be allocated anew.
void Prepare(vtkTextureObject* texture, vtkOpenGLRenderWindow* window)
{
  texture->SetContext(window);
  texture->ResetFormatAndType();
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
}

} // namespace

bool vtkTextureSliceTarget::HasSize(
  vtkTextureObject* texture, vtkOpenGLRenderWindow* window, const Size& size)
{
  return texture->GetHandle() != 0 && texture->GetContext() == window &&
         texture->GetWidth() == size.Width && texture->GetHeight() == size.Height;
}

vtkTextureSliceTarget::vtkTextureSliceTarget() = default;
vtkTextureSliceTarget::~vtkTextureSliceTarget() = default;

vtkTextureSliceTarget::DepthFormat vtkTextureSliceTarget::QueryDepthFormat()
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

bool vtkTextureSliceTarget::AllocateDepth(vtkTextureObject* texture, vtkOpenGLRenderWindow* window,
  const Size& size, const DepthFormat& format)
{
  Prepare(texture, window);
  return format.Stencil ? texture->AllocateDepthStencil(size.Width, size.Height)
                        : texture->AllocateDepth(size.Width, size.Height, format.VTKFormat());
}

bool vtkTextureSliceTarget::Resize(
  vtkOpenGLRenderWindow* window, const Size& size, const DepthFormat& format)
{
  if (HasSize(this->Color, window, size) && this->DepthKey == format.Key())
  {
    return true;
  }
  this->DepthKey = format.Key();
  // A framebuffer keeps textures of the old size, even where new ones have their names.
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->DepthFramebuffer->ReleaseGraphicsResources(window);
  this->ResolveFramebuffer->ReleaseGraphicsResources(window);
  this->ResolvedDepth->ReleaseGraphicsResources(window); // it has the old format
  this->GeometryDepth->ReleaseGraphicsResources(window);
  Prepare(this->Color, window);
  return this->Color->Allocate2D(size.Width, size.Height, 4, VTK_FLOAT) &&
         AllocateDepth(this->Depth, window, size, format);
}

bool vtkTextureSliceTarget::Attach(vtkOpenGLRenderWindow* window, std::string& error)
{
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Color);
  this->Framebuffer->AddDepthAttachment(this->Depth);
  this->Framebuffer->ActivateDrawBuffer(0);
  const char* reason = "";
  if (vtkOpenGLFramebufferObject::GetFrameBufferStatus(
        vtkOpenGLFramebufferObject::GetDrawMode(), reason))
  {
    return true;
  }
  error = std::string("OpenGL cannot draw into a floating-point picture: ") + reason;
  return false;
}

bool vtkTextureSliceTarget::CopyDepth(vtkOpenGLRenderWindow* window, unsigned int source,
  const std::array<int, 4>& viewport, const DepthFormat& format)
{
  const auto [left, bottom, width, height] = viewport;
  const Size full{static_cast<unsigned int>(width), static_cast<unsigned int>(height)};
  vtkOpenGLState* state = window->GetState();
  // C++17 has no lambda that takes one of the four.
  const auto copy = [&viewport, state](int x, int y, int toWidth, int toHeight)
  {
    state->vtkglBlitFramebuffer(x, y, x + viewport[2], y + viewport[3], 0, 0, toWidth, toHeight,
      GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  };
  if (HasSize(this->Color, window, full))
  {
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, source);
    copy(left, bottom, width, height);
    return true;
  }
  // OpenGL does not resolve samples and change the size in one step.
  if (!HasSize(this->ResolvedDepth, window, full) &&
      !AllocateDepth(this->ResolvedDepth, window, full, format))
  {
    return false;
  }
  this->ResolveFramebuffer->SetContext(window);
  this->ResolveFramebuffer->Bind();
  this->ResolveFramebuffer->AddDepthAttachment(this->ResolvedDepth);
  this->ResolveFramebuffer->DeactivateDrawBuffers();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, source);
  copy(left, bottom, width, height);
  this->Framebuffer->Bind();
  this->ResolveFramebuffer->Bind(GL_READ_FRAMEBUFFER);
  copy(0, 0, static_cast<int>(this->Color->GetWidth()), static_cast<int>(this->Color->GetHeight()));
  return true;
}

std::array<int, 2> vtkTextureSliceTarget::GetSize(vtkRenderer* renderer, double pixelSize)
{
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  return {CountPixels(width, pixelSize), CountPixels(height, pixelSize)};
}

bool vtkTextureSliceTarget::Begin(
  vtkRenderer* renderer, float clearValue, double pixelSize, std::string& error)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  std::array<int, 4> viewport{};
  auto& [left, bottom, width, height] = viewport;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  const auto [columns, rows] = GetSize(renderer, pixelSize);
  const Size size{static_cast<unsigned int>(columns), static_cast<unsigned int>(rows)};

  const DepthFormat format = QueryDepthFormat();
  if (!this->Resize(window, size, format))
  {
    error = "OpenGL could not make a floating-point picture of " + std::to_string(size.Width) +
            " x " + std::to_string(size.Height) + " pixels";
    return false;
  }
  GLint source = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &source);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  if (!this->Attach(window, error))
  {
    state->PopFramebufferBindings();
    return false;
  }

  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglViewport(0, 0, static_cast<int>(size.Width), static_cast<int>(size.Height));
  state->vtkglClearColor(clearValue, clearValue, clearValue, clearValue);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClear(GL_COLOR_BUFFER_BIT | (format.Bits > 0 ? 0 : GL_DEPTH_BUFFER_BIT));
  if (format.Bits > 0 &&
      !this->CopyDepth(window, static_cast<unsigned int>(source), viewport, format))
  {
    error = "OpenGL could not make a copy of the window's depth";
    state->PopFramebufferBindings();
    return false;
  }
  state->vtkglDepthMask(GL_FALSE);
  this->Window = window;
  return true;
}

bool vtkTextureSliceTarget::KeepDepth(std::string& error)
{
  const Size size{this->Color->GetWidth(), this->Color->GetHeight()};
  if (!HasSize(this->GeometryDepth, this->Window, size) &&
      !AllocateDepth(this->GeometryDepth, this->Window, size, DepthFormat(this->DepthKey)))
  {
    error = "OpenGL could not make a copy of the window's depth";
    return false;
  }
  const int width = static_cast<int>(size.Width);
  const int height = static_cast<int>(size.Height);
  this->DepthFramebuffer->SetContext(this->Window);
  this->DepthFramebuffer->Bind();
  this->DepthFramebuffer->AddDepthAttachment(this->GeometryDepth);
  this->DepthFramebuffer->DeactivateDrawBuffers();
  this->Framebuffer->Bind(GL_READ_FRAMEBUFFER);
  this->Window->GetState()->vtkglBlitFramebuffer(
    0, 0, width, height, 0, 0, width, height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  this->Framebuffer->Bind();
  return true;
}

void vtkTextureSliceTarget::BeginDepthOnly()
{
  this->DepthFramebuffer->SetContext(this->Window);
  this->DepthFramebuffer->Bind();
  this->DepthFramebuffer->AddDepthAttachment(this->Depth);
  this->DepthFramebuffer->DeactivateDrawBuffers();
}

void vtkTextureSliceTarget::EndDepthOnly()
{
  this->Framebuffer->Bind();
}

void vtkTextureSliceTarget::End()
{
  this->Window->GetState()->PopFramebufferBindings();
}

void vtkTextureSliceTarget::ReadyQuad(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceFeatures& features)
{
  const std::string defines = features.GetDefines();
  if (this->Quad && defines == this->QuadDefines)
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
    return;
  }
  std::string shader = TextureSliceCompositeFS;
  vtkShaderProgram::Substitute(shader, "//VTK::TextureSlice::Defines", defines);
  vtkShaderProgram::Substitute(shader, "//VTK::TextureSlice::Table", TextureSliceTableFS);
  const bool peeled = features.Peel > 0;
  vtkShaderProgram::Substitute(
    shader, "//VTK::TextureSlice::PeelComposite", peeled ? TextureSlicePeelCompositeFS : "");
  vtkShaderProgram::Substitute(
    shader, "//VTK::TextureSlice::Peel", peeled ? TextureSlicePeelFS : "");
  this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, shader.c_str(), "");
  this->QuadDefines = defines;
}

void vtkTextureSliceTarget::Composite(vtkRenderer* renderer, bool smooth,
  const vtkTextureSliceFeatures& features,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->ReadyQuad(window, features);
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  if (features.Peel > 0)
  {
    left = bottom = 0; // the pass has textures of the viewport's size
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglViewport(left, bottom, width, height);
  state->vtkglDisable(GL_DEPTH_TEST);

  const int filter = smooth ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  this->Color->SetMinificationFilter(filter);
  this->Color->SetMagnificationFilter(filter);
  this->Color->Activate();
  vtkShaderProgram* program = this->Quad->Program;
  program->SetUniformi("volumeImage", this->Color->GetTextureUnit());
  setUniforms(program);
  this->Quad->Render();
  this->Color->Deactivate();
}

void vtkTextureSliceTarget::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.reset();
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->DepthFramebuffer->ReleaseGraphicsResources(window);
  this->Color->ReleaseGraphicsResources(window);
  this->Depth->ReleaseGraphicsResources(window);
  this->ResolveFramebuffer->ReleaseGraphicsResources(window);
  this->ResolvedDepth->ReleaseGraphicsResources(window);
  this->GeometryDepth->ReleaseGraphicsResources(window);
  this->Window = nullptr;
}
