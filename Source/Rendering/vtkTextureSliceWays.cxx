// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceWays.h"

#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceParts.h"
#include "vtkVolumeMapper.h"

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
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

namespace
{

/// Columns and rows of a work group of the compute shader.
constexpr int GroupSize = 8;

GLint GetInteger(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

/// Major version times ten and minor version.
int GetVersion()
{
  return 10 * GetInteger(GL_MAJOR_VERSION) + GetInteger(GL_MINOR_VERSION);
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

/// Whether the context that is current has compute shaders (OpenGL 4.3, or 4.2 with
/// ARB_compute_shader), and can store into a picture of 16 bits.
bool HasCompute()
{
  if (GetVersion() < 43 && !(GetVersion() >= 42 && HasExtension("GL_ARB_compute_shader") &&
                             HasExtension("GL_ARB_internalformat_query2")))
  {
    return false;
  }
  GLint support = GL_NONE;
  glGetInternalformativ(GL_TEXTURE_2D, GL_RGBA16, GL_SHADER_IMAGE_STORE, 1, &support);
  return (support == GL_FULL_SUPPORT || support == GL_CAVEAT_SUPPORT) &&
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
/// Compute must win by more than the factor 2 by which times differ where other programs take one
/// of two processors from a software renderer.
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

/// Where the corners of a part of the box (lower x, upper x, lower y and so on) are in a picture of
/// that size, in pixels; none where a corner is not in front of the eye.
std::vector<std::array<double, 2>> FindCorners(const vtkTextureSliceFrame& frame,
  const std::array<double, 6>& part, const std::array<double, 2>& size)
{
  const auto& m = frame.View.BoxToClip;
  std::vector<std::array<double, 2>> corners;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const double x = part[corner & 1];
    const double y = part[2 + ((corner >> 1) & 1)];
    const double z = part[4 + ((corner >> 2) & 1)];
    const auto row = [&](std::size_t i)
    { return m[4 * i] * x + m[4 * i + 1] * y + m[4 * i + 2] * z + m[4 * i + 3]; };
    if (!(row(3) > 0.0))
    {
      return {};
    }
    corners.push_back(
      {0.5 * (row(0) / row(3) + 1.0) * size[0], 0.5 * (row(1) / row(3) + 1.0) * size[1]});
  }
  return corners;
}

/// The smallest rectangle, inside of another one, with all pixels between those corners; without
/// corners, all of the other one.
vtkTextureSlicePixels FindPixels(
  const std::vector<std::array<double, 2>>& corners, const vtkTextureSlicePixels& within)
{
  std::array<double, 4> reached{1e9, 1e9, -1e9, -1e9};
  for (const auto& from : corners)
  {
    for (const auto& to : corners)
    {
      // Of the way from one corner to another, what the rows of the rectangle see.
      for (const double at : {from[1], double(within[1]), double(within[3])})
      {
        if ((at - from[1]) * (to[1] - at) >= 0.0 && at >= within[1] && at <= within[3])
        {
          const double part = at == from[1] ? 0.0 : (at - from[1]) / (to[1] - from[1]);
          const double column = from[0] + part * (to[0] - from[0]);
          reached = {std::min(reached[0], column), std::min(reached[1], at),
            std::max(reached[2], column), std::max(reached[3], at)};
        }
      }
    }
  }
  vtkTextureSlicePixels pixels = within;
  for (std::size_t axis = 0; axis < 2 && !corners.empty(); ++axis)
  {
    const double most = within[axis + 2];
    pixels[axis] =
      static_cast<int>(std::clamp(std::floor(reached[axis]), 1.0 * within[axis], most));
    pixels[axis + 2] =
      static_cast<int>(std::clamp(std::ceil(reached[axis + 2]), 1.0 * within[axis], most));
  }
  return pixels;
}

/// Stores into those pixels of a picture of 16 bits, which may be read afterwards. What the corners
/// leave out is not drawn, band by band.
void Dispatch(vtkShaderProgram* program, vtkTextureObject* picture,
  const vtkTextureSlicePixels& pixels, const std::vector<std::array<double, 2>>& corners)
{
  constexpr int rowsOfBand = 64;
  constexpr GLuint imageUnit = 0;
  const auto countGroups = [](int from, int to)
  { return static_cast<GLuint>(std::max(0, (to - from + GroupSize - 1) / GroupSize)); };
  program->SetUniformi("pictureImage", imageUnit);
  glBindImageTexture(imageUnit, picture->GetHandle(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16);
  for (int row = pixels[1]; row < pixels[3]; row += rowsOfBand)
  {
    const auto band =
      FindPixels(corners, {pixels[0], row, pixels[2], std::min(row + rowsOfBand, pixels[3])});
    program->SetUniform2i("firstPixel", band.data());
    program->SetUniform2i("endOfPixels", band.data() + 2);
    glDispatchCompute(countGroups(band[0], band[2]), countGroups(band[1], band[3]), 1);
  }
  // The picture is read as a texture, and cleared or stored into again for the next one.
  glMemoryBarrier(
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  glBindImageTexture(imageUnit, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16);
}

vtkSmartPointer<vtkShaderProgram> MakeComputeProgram(const std::string& defines)
{
  std::string source = MakeShader(TextureSliceCS, defines);
  vtkShaderProgram::Substitute(source, "//VTK::TextureSlice::Version",
    std::string(GetVersion() >= 43 ? "#version 430\n"
                                   : "#version 420\n#extension GL_ARB_compute_shader : require\n") +
      "#define TEXTURE_SLICE_GROUP " + std::to_string(GroupSize) + "\n");
  auto program = vtkSmartPointer<ComputeProgram>::New();
  program->SetSource(source);
  return program;
}

bool CanBePolygons(const vtkTextureSliceFeatures& features)
{
  return features.BlendMode == vtkVolumeMapper::COMPOSITE_BLEND && !features.Slabs;
}

} // namespace

vtkTextureSliceBox::vtkTextureSliceBox() = default;
vtkTextureSliceBox::~vtkTextureSliceBox() = default;

vtkShaderProgram* vtkTextureSliceBox::Ready(vtkOpenGLRenderWindow* window, const std::string& key,
  const std::function<std::string()>& makeShader)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  this->Window = window;
  if (this->Program == nullptr || key != this->Key)
  {
    this->Program = cache->ReadyShaderProgram(TextureSliceBoxVS, makeShader().c_str(), "");
    this->Key = key;
    return this->Program;
  }
  return cache->ReadyShaderProgram(this->Program);
}

void vtkTextureSliceBox::Draw(
  const vtkTextureSliceFrame& frame, const std::array<double, 6>& seen, int times)
{
  vtkMatrix4x4* boxToClip = frame.BoxToClip;
  std::array<float, 3> low{};
  std::array<float, 3> high{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    low[axis] = static_cast<float>(seen[2 * axis]);
    high[axis] = static_cast<float>(seen[2 * axis + 1]);
  }
  this->Program->SetUniformMatrix("boxToClip", boxToClip);
  this->Program->SetUniform3f("seenLow", low.data());
  this->Program->SetUniform3f("seenHigh", high.data());
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_CULL_FACE);
  // A matrix that mirrors turns the triangles round.
  state->vtkglCullFace(boxToClip->Determinant() < 0.0 ? GL_FRONT : GL_BACK);
  // Faces beyond the far plane count as well.
  glEnable(GL_DEPTH_CLAMP);
  this->VertexArray->Bind();
  glDrawArraysInstanced(GL_TRIANGLES, 0, 36, times);
  this->VertexArray->Release();
  glDisable(GL_DEPTH_CLAMP);
}

void vtkTextureSliceBox::ReleaseGraphicsResources()
{
  this->VertexArray->ReleaseGraphicsResources();
  this->Program = nullptr;
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
    return Fragments;
  }
  const auto known = IsComputeFaster.find(GetRendererName());
  this->IsTrialDue = known == IsComputeFaster.end() && this->Drawn != Automatic;
  return known != IsComputeFaster.end() && known->second ? Compute : Fragments;
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
  // The shortest times in turn: drivers finish shaders when they are used first, and other programs
  // use the machine as well.
  const std::array<Way, 2> ways{Fragments, Compute};
  std::array<double, 2> milliseconds{1e30, 1e30};
  vtkOpenGLState* state = parts.Window->GetState();
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(part[0], part[1], part[2] - part[0], part[3] - part[1]);
  bool compiles = true;
  for (int i = 0; i < 2 * RoundsOfTrial && compiles; ++i)
  {
    const Way way = ways[i % 2];
    compiles = this->Ready(way, parts, "fragments draw the volume");
    if (compiles)
    {
      glFinish();
      const auto begin = std::chrono::steady_clock::now();
      this->DrawPixels(way, parts, part);
      glFinish();
      const std::chrono::duration<double, std::milli> time =
        std::chrono::steady_clock::now() - begin;
      milliseconds[i % 2] = std::min(milliseconds[i % 2], time.count());
    }
  }
  state->vtkglDisable(GL_SCISSOR_TEST);
  IsComputeFaster[GetRendererName()] =
    compiles && milliseconds[1] < MostOfFragments * milliseconds[0];
  this->Ready(this->Drawn, parts, "");
}

bool vtkTextureSliceWays::Ready(Way way, const vtkTextureSliceParts& parts, const char* instead)
{
  const std::string defines =
    parts.Features.GetDefines() + (way == Polygons ? "#define TEXTURE_SLICE_POLYGONS 1\n" : "");
  const std::string key = Names[way] + defines;
  this->Program = nullptr;
  if (this->Failed.count(key) == 0 && way == Compute)
  {
    vtkSmartPointer<vtkShaderProgram>& program = this->ComputePrograms[key];
    program = program != nullptr ? program : MakeComputeProgram(defines);
    this->Program = parts.Window->GetShaderCache()->ReadyShaderProgram(program.Get());
  }
  else if (this->Failed.count(key) == 0)
  {
    this->Program = this->Box.Ready(
      parts.Window, key, [&defines] { return MakeShader(TextureSliceFS, defines); });
  }
  if (this->Program == nullptr)
  {
    this->Failed.insert(key);
    this->Fallback = std::string("the shader of ") + Names[way] + " does not compile: " + instead;
  }
  return this->Program != nullptr;
}

bool vtkTextureSliceWays::Choose(const vtkTextureSliceParts& parts)
{
  this->Fallback.clear();
  this->IsTrialDue = false;
  const bool canBePolygons = CanBePolygons(parts.Features);
  Way way = parts.Features.Places
              ? Fragments
              : this->FindAsked(static_cast<Way>(parts.Request.Mapper->GetWay()));
  if (way == Automatic || (way == Polygons && !canBePolygons))
  {
    way = this->ChooseByTrial();
  }
  if (way == Compute && !HasCompute())
  {
    this->Fallback = "the context has no compute shaders (OpenGL 4.3): fragments draw the volume";
    way = Fragments;
  }
  if (way == Compute && !this->Ready(Compute, parts, "fragments draw the volume"))
  {
    way = Fragments;
  }
  if (way == Fragments && !this->Ready(Fragments, parts, "polygons draw the volume"))
  {
    way = Polygons;
  }
  this->Drawn = way;
  return way != Polygons || (canBePolygons && this->Ready(Polygons, parts, "nothing is drawn"));
}

void vtkTextureSliceWays::DrawPixels(
  Way way, vtkTextureSliceParts& parts, const vtkTextureSlicePixels& pixels)
{
  parts.DrawWith(this->Program,
    [&]
    {
      if (way == Compute)
      {
        Dispatch(this->Program, parts.Target.GetPicture(), pixels, this->Corners);
        return;
      }
      const int times = way == Polygons ? parts.Planes.GetNumberOfSlices() : 1;
      this->Box.Draw(parts.Frame, parts.Seen, times);
    });
}

void vtkTextureSliceWays::Draw(vtkTextureSliceParts& parts)
{
  vtkOpenGLState* state = parts.Window->GetState();
  state->SetEnumState(GL_BLEND, this->Drawn == Polygons);
  if (this->Drawn == Polygons)
  {
    // Behind what is there already: Formulas R3.
    state->vtkglBlendEquation(GL_FUNC_ADD);
    state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  }
  vtkTextureObject* picture = parts.Target.GetPicture();
  const int width = static_cast<int>(picture->GetWidth());
  const int height = static_cast<int>(picture->GetHeight());
  this->Corners = FindCorners(parts.Frame, parts.Seen, {1.0 * width, 1.0 * height});
  const auto pixels = FindPixels(this->Corners, {0, 0, width, height});
  if (std::exchange(this->IsTrialDue, false))
  {
    this->RunTrial(parts, pixels);
  }
  this->DrawPixels(this->Drawn, parts, pixels);
}

void vtkTextureSliceWays::ReleaseGraphicsResources(vtkOpenGLRenderWindow* window)
{
  this->Box.ReleaseGraphicsResources();
  for (auto& [key, program] : this->ComputePrograms)
  {
    program->ReleaseGraphicsResources(window);
  }
  this->ComputePrograms.clear();
  this->Program = nullptr;
  this->Failed.clear();
}
