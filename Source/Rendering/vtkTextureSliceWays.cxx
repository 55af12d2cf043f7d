// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceWays.h"

#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceParts.h"

#include "TextureSliceBoxVS.h"
#include "TextureSliceCS.h"
#include "TextureSliceColoringFS.h"
#include "TextureSliceFS.h"
#include "TextureSliceLightingFS.h"
#include "TextureSliceMarchFS.h"
#include "TextureSliceRayFS.h"
#include "TextureSliceSamplesFS.h"
#include "TextureSliceSamplingFS.h"
#include "TextureSliceSlabsFS.h"
#include "TextureSliceSurfacesFS.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <utility>

namespace
{

/// Columns and rows of a work group of TextureSliceCS.
constexpr int GroupSize = 8;

using Mapper = vtkOpenGLTextureSliceVolumeMapper;

GLint GetInteger(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

bool HasExtension(const char* name)
{
  const GLint count = GetInteger(GL_NUM_EXTENSIONS);
  for (GLint i = 0; i < count; ++i)
  {
    const GLubyte* extension = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (std::strcmp(reinterpret_cast<const char*>(extension), name) == 0)
    {
      return true;
    }
  }
  return false;
}

/// Whether the context that is current has compute shaders, which OpenGL 4.3 has as well, and work
/// groups that are large enough. OpenGL 4.2 stores into pictures of 16 bits.
bool HasCompute()
{
  return 10 * GetInteger(GL_MAJOR_VERSION) + GetInteger(GL_MINOR_VERSION) >= 42 &&
         HasExtension("GL_ARB_compute_shader") &&
         GetInteger(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS) >= GroupSize * GroupSize;
}

/// A program with one compute shader, for which VTK 9.1 has no class. It is a vtkShaderProgram, so
/// that VTK's record of the current program and its functions for uniforms hold for it too.
class ComputeProgram : public vtkShaderProgram
{
public:
  static ComputeProgram* New();
  vtkTypeMacro(ComputeProgram, vtkShaderProgram);

  void SetSource(std::string source) { this->Source = std::move(source); }

protected:
  /// VTK's shader cache asks for this before it uses a program.
  int CompileShader() override
  {
    const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
    const char* text = this->Source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    const GLuint program = glCreateProgram();
    glAttachShader(program, shader);
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    this->Handle = static_cast<int>(program);
    this->Compiled = linked == GL_TRUE;
    this->Linked = this->Compiled;
    if (!this->Compiled)
    {
      std::array<char, 1000> log{};
      glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
      vtkErrorMacro("a compute shader does not compile: " << log.data());
    }
    glDeleteShader(shader);
    return this->Compiled ? 1 : 0;
  }

private:
  std::string Source;
};

vtkStandardNewMacro(ComputeProgram);

const char* const Variable = "VTK_TEXTURE_SLICE_WAY";
const std::array<const char*, 4> Names{"automatic", "fragments", "compute", "polygons"};

/// Where fragments, or compute, spend their time: at most so many columns and rows of the picture.
constexpr int SizeOfTrial = 256;
constexpr int RoundsOfTrial = 4;
/// By less than a factor of 2, times differ where other programs take one of two processors.
constexpr double MostOfFragments = 0.5;

/// Whether compute is much faster, for each renderer that had a trial in this thread.
thread_local std::map<std::string, bool> IsComputeFaster;

std::string GetRendererName()
{
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

/// @param main the shader that has a place for the parts.
/// @param defines see vtkTextureSliceFeatures::GetDefines.
std::string MakeShader(std::string main, const std::string& defines)
{
  std::string parts = defines;
  for (const char* part :
    {TextureSliceRayFS, TextureSliceSamplingFS, TextureSliceLightingFS, TextureSliceColoringFS,
      TextureSliceSamplesFS, TextureSliceSlabsFS, TextureSliceSurfacesFS, TextureSliceMarchFS})
  {
    parts += part;
  }
  vtkShaderProgram::Substitute(main, "//VTK::TextureSlice::Parts", parts);
  return main;
}

/// The smallest rectangle of a picture of that size that the drawn part of the box is in; all of
/// the picture where a corner is not in front of the eye.
vtkTextureSlicePixels FindPixels(const vtkTextureSliceParts& parts, const std::array<int, 2>& size)
{
  const std::array<double, 6>& seen = parts.Seen;
  std::array<double, 4> reached{1e9, 1e9, -1e9, -1e9};
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const std::array<double, 4> place{
      seen[corner & 1], seen[2 + ((corner >> 1) & 1)], seen[4 + ((corner >> 2) & 1)], 1.0};
    const auto clip = [&](std::size_t row)
    {
      return std::inner_product(
        place.begin(), place.end(), parts.Frame.View.BoxToClip.begin() + 4 * row, 0.0);
    };
    if (!(clip(3) > 0.0))
    {
      return {0, 0, size[0], size[1]};
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      const double at = 0.5 * (clip(axis) / clip(3) + 1.0) * size[axis];
      reached[axis] = std::min(reached[axis], at);
      reached[axis + 2] = std::max(reached[axis + 2], at);
    }
  }
  vtkTextureSlicePixels pixels{};
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double most = size[axis];
    pixels[axis] = static_cast<int>(std::clamp(std::floor(reached[axis]), 0.0, most));
    pixels[axis + 2] = static_cast<int>(std::clamp(std::ceil(reached[axis + 2]), 0.0, most));
  }
  return pixels;
}

/// Stores into those pixels of a picture of 16 bits, which may be read afterwards.
void Dispatch(
  vtkShaderProgram* program, vtkTextureObject* picture, const vtkTextureSlicePixels& pixels)
{
  constexpr GLuint imageUnit = 0;
  const auto countGroups = [](int from, int to)
  { return static_cast<GLuint>((to - from + GroupSize - 1) / GroupSize); };
  program->SetUniformi("pictureImage", imageUnit);
  program->SetUniform2i("firstPixel", pixels.data());
  program->SetUniform2i("endOfPixels", pixels.data() + 2);
  glBindImageTexture(imageUnit, picture->GetHandle(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16);
  glDispatchCompute(countGroups(pixels[0], pixels[2]), countGroups(pixels[1], pixels[3]), 1);
  // The picture is read as a texture, and cleared or stored into again for the next one.
  glMemoryBarrier(
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  glBindImageTexture(imageUnit, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16);
}

vtkSmartPointer<vtkShaderProgram> MakeComputeProgram(const std::string& defines)
{
  auto program = vtkSmartPointer<ComputeProgram>::New();
  program->SetSource(MakeShader(TextureSliceCS, defines));
  return program;
}

} // namespace

vtkShaderProgram* vtkTextureSliceBox::Ready(vtkOpenGLRenderWindow* window, const std::string& key,
  const std::function<vtkSmartPointer<vtkShaderProgram>()>& make)
{
  auto known = this->Programs.find(key);
  if (known == this->Programs.end())
  {
    known = this->Programs.emplace(key, make()).first;
  }
  vtkSmartPointer<vtkShaderProgram>& program = known->second;
  if (program != nullptr)
  {
    program = window->GetShaderCache()->ReadyShaderProgram(program.Get());
  }
  return program;
}

void vtkTextureSliceBox::Draw(
  const vtkTextureSliceParts& parts, vtkShaderProgram* program, int times)
{
  const std::array<double, 16>& boxToClip = parts.Frame.View.BoxToClip;
  std::array<float, 3> low{};
  std::array<float, 3> high{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    low[axis] = static_cast<float>(parts.Seen[2 * axis]);
    high[axis] = static_cast<float>(parts.Seen[2 * axis + 1]);
  }
  auto columns = vtkTextureSliceFrame::ToColumns(boxToClip);
  program->SetUniformMatrix4x4("boxToClip", columns.data());
  program->SetUniform3f("seenLow", low.data());
  program->SetUniform3f("seenHigh", high.data());
  vtkOpenGLState* state = parts.Window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_CULL_FACE);
  // A matrix that mirrors turns the triangles round.
  state->vtkglCullFace(vtkMatrix4x4::Determinant(boxToClip.data()) < 0.0 ? GL_FRONT : GL_BACK);
  // Faces beyond the far plane count as well.
  glEnable(GL_DEPTH_CLAMP);
  this->VertexArray->Bind();
  glDrawArraysInstanced(GL_TRIANGLES, 0, 36, times);
  this->VertexArray->Release();
  glDisable(GL_DEPTH_CLAMP);
}

void vtkTextureSliceBox::ReleaseGraphicsResources(vtkOpenGLRenderWindow* window)
{
  this->VertexArray->ReleaseGraphicsResources();
  for (const auto& named : this->Programs)
  {
    // The others belong to VTK's shader cache.
    if (auto* program = ComputeProgram::SafeDownCast(named.second))
    {
      program->ReleaseGraphicsResources(window);
    }
  }
  this->Programs.clear();
}

vtkTextureSliceWays::Way vtkTextureSliceWays::FindAsked(Way asked)
{
  const char* value = std::getenv(Variable);
  if (value == nullptr)
  {
    return asked;
  }
  const auto* const name = std::find(Names.begin(), Names.end(), std::string(value));
  if (name == Names.end())
  {
    this->Fallback = std::string(Variable) + " is \"" + value +
                     "\", not automatic, fragments, compute or polygons";
    return asked;
  }
  return static_cast<Way>(name - Names.begin());
}

vtkTextureSliceWays::Way vtkTextureSliceWays::ChooseByTrial()
{
  if (!HasCompute())
  {
    return Mapper::FRAGMENTS;
  }
  const auto known = IsComputeFaster.find(GetRendererName());
  this->IsTrialDue = known == IsComputeFaster.end() && this->Drawn != Mapper::AUTOMATIC;
  return known != IsComputeFaster.end() && known->second ? Mapper::COMPUTE : Mapper::FRAGMENTS;
}

void vtkTextureSliceWays::RunTrial(vtkTextureSliceParts& parts, const vtkTextureSlicePixels& pixels)
{
  vtkTextureSlicePixels part = pixels;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const int middle = (pixels[axis] + pixels[axis + 2]) / 2;
    part[axis] = std::max(part[axis], middle - SizeOfTrial / 2);
    part[axis + 2] = std::min(part[axis + 2], middle + SizeOfTrial / 2);
  }
  // The shortest times: drivers finish shaders at their first use, and other programs run as well.
  const std::array<Way, 2> ways{Mapper::FRAGMENTS, Mapper::COMPUTE};
  std::array<double, 2> milliseconds{1e30, 1e30};
  vtkOpenGLState* state = parts.Window->GetState();
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(part[0], part[1], part[2] - part[0], part[3] - part[1]);
  for (std::size_t i = 0; i < 2 * RoundsOfTrial; ++i)
  {
    const Way way = ways[i % 2];
    if (!this->Ready(way, parts, "fragments draw the volume"))
    {
      milliseconds[1] = 1e30;
      break;
    }
    glFinish();
    const auto begin = std::chrono::steady_clock::now();
    this->DrawPixels(way, parts, part);
    glFinish();
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    milliseconds[i % 2] = std::min(milliseconds[i % 2], time.count());
  }
  state->vtkglDisable(GL_SCISSOR_TEST);
  IsComputeFaster[GetRendererName()] = milliseconds[1] < MostOfFragments * milliseconds[0];
  this->Ready(this->Drawn, parts, "");
}

bool vtkTextureSliceWays::Ready(Way way, const vtkTextureSliceParts& parts, const char* instead)
{
  const std::string defines = parts.Features.GetDefines() +
                              (way == Mapper::POLYGONS ? "#define TEXTURE_SLICE_POLYGONS 1\n" : "");
  this->Program = this->Box.Ready(parts.Window, Names[way] + defines,
    [&]() -> vtkSmartPointer<vtkShaderProgram>
    {
      if (way == Mapper::COMPUTE)
      {
        return MakeComputeProgram(defines);
      }
      return parts.Window->GetShaderCache()->ReadyShaderProgram(
        TextureSliceBoxVS, MakeShader(TextureSliceFS, defines).c_str(), "");
    });
  if (this->Program == nullptr)
  {
    this->Fallback = std::string("the shader of ") + Names[way] + " does not compile: " + instead;
  }
  return this->Program != nullptr;
}

bool vtkTextureSliceWays::Choose(const vtkTextureSliceParts& parts)
{
  this->Fallback.clear();
  this->IsTrialDue = false;
  const bool canBePolygons =
    parts.Features.BlendMode == Mapper::COMPOSITE_BLEND && !parts.Features.Slabs;
  Way way = parts.Features.Places
              ? Mapper::FRAGMENTS
              : this->FindAsked(static_cast<Way>(parts.Request.Mapper->GetWay()));
  if (way == Mapper::AUTOMATIC || (way == Mapper::POLYGONS && !canBePolygons))
  {
    way = this->ChooseByTrial();
  }
  if (way == Mapper::COMPUTE && !HasCompute())
  {
    this->Fallback =
      "the context has no compute shaders (GL_ARB_compute_shader): fragments draw the volume";
    way = Mapper::FRAGMENTS;
  }
  if (way == Mapper::COMPUTE && !this->Ready(Mapper::COMPUTE, parts, "fragments draw the volume"))
  {
    way = Mapper::FRAGMENTS;
  }
  if (way == Mapper::FRAGMENTS &&
      !this->Ready(Mapper::FRAGMENTS, parts, "polygons draw the volume"))
  {
    way = Mapper::POLYGONS;
  }
  this->Drawn = way;
  return way != Mapper::POLYGONS ||
         (canBePolygons && this->Ready(Mapper::POLYGONS, parts, "nothing is drawn"));
}

void vtkTextureSliceWays::DrawPixels(
  Way way, vtkTextureSliceParts& parts, const vtkTextureSlicePixels& pixels)
{
  parts.DrawWith(this->Program,
    [&]
    {
      way == Mapper::COMPUTE ? Dispatch(this->Program, parts.Target.GetPicture(), pixels)
                             : this->Box.Draw(parts, this->Program,
                                 way == Mapper::POLYGONS ? parts.Planes.NumberOfSlices : 1);
    });
}

void vtkTextureSliceWays::Draw(vtkTextureSliceParts& parts)
{
  vtkOpenGLState* state = parts.Window->GetState();
  state->SetEnumState(GL_BLEND, this->Drawn == Mapper::POLYGONS);
  if (this->Drawn == Mapper::POLYGONS)
  {
    // Behind what is there already: Formulas R3.
    state->vtkglBlendEquation(GL_FUNC_ADD);
    state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  }
  vtkTextureObject* picture = parts.Target.GetPicture();
  const auto pixels = FindPixels(
    parts, {static_cast<int>(picture->GetWidth()), static_cast<int>(picture->GetHeight())});
  if (std::exchange(this->IsTrialDue, false))
  {
    this->RunTrial(parts, pixels);
  }
  this->DrawPixels(this->Drawn, parts, pixels);
}

void vtkTextureSliceWays::ReleaseGraphicsResources(vtkOpenGLRenderWindow* window)
{
  this->Box.ReleaseGraphicsResources(window);
  this->Program = nullptr;
}
