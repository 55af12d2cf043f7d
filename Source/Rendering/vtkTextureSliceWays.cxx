// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceWays.h"

#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLBufferObject.h"
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
#include "TextureSliceLightCS.h"
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
#include <utility>
#include <vector>

namespace
{

/// Columns and rows of a work group of TextureSliceCS.
constexpr int GroupSize = 8;

GLint GetInteger(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

/// Whether VTK's loader found compute shaders, which OpenGL 4.3 has as well, and the context that
/// is current work groups that are large enough. OpenGL 4.2 stores into pictures of 16 bits.
bool HasCompute()
{
  return 10 * GetInteger(GL_MAJOR_VERSION) + GetInteger(GL_MINOR_VERSION) >= 42 &&
         VTK_TEXTURE_SLICE_HAS_COMPUTE &&
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

/// @param main has a place for the parts, before which the defines of the features come.
std::string MakeShader(std::string main, const std::string& defines)
{
  vtkShaderProgram::Substitute(main, "//VTK::TextureSlice::Parts",
    defines + TextureSliceRayFS + TextureSliceSamplingFS + TextureSliceLightingFS +
      TextureSliceColoringFS + TextureSliceSamplesFS + TextureSliceSlabsFS +
      TextureSliceSurfacesFS + TextureSliceMarchFS);
  return main;
}

/// Groups of a row, or of a column.
GLuint CountGroups(int from, int to)
{
  return static_cast<GLuint>((to - from + GroupSize - 1) / GroupSize);
}

/// What a compute shader knows by that number, for as long as this lives.
template <typename Values>
vtkSmartPointer<vtkOpenGLBufferObject> MakeBuffer(GLuint number, const Values& values)
{
  auto buffer = vtkSmartPointer<vtkOpenGLBufferObject>::New();
  buffer->Upload(values, vtkOpenGLBufferObject::ArrayBuffer);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, number, static_cast<GLuint>(buffer->GetHandle()));
  return buffer;
}

using Corners = std::vector<std::array<double, 2>>; ///< columns and rows in a picture

/// Those of the drawn part of the box, or of the picture where one is not in front of the eye.
Corners FindCorners(const vtkTextureSliceParts& parts)
{
  const double width = parts.Target.GetPicture()->GetWidth();
  const double height = parts.Target.GetPicture()->GetHeight();
  const std::array<double, 6>& seen = parts.Seen;
  Corners corners;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    double place[4] = {
      seen[corner & 1], seen[2 + ((corner >> 1) & 1)], seen[4 + ((corner >> 2) & 1)], 1.0};
    vtkMatrix4x4::MultiplyPoint(parts.Frame.View.BoxToClip.data(), place, place);
    if (!(place[3] > 0.0))
    {
      return {{0.0, 0.0}, {width, 0.0}, {0.0, height}, {width, height}};
    }
    corners.push_back(
      {0.5 * (place[0] / place[3] + 1.0) * width, 0.5 * (place[1] / place[3] + 1.0) * height});
  }
  return corners;
}

/// The smallest rectangle inside of another one with all its pixels between those corners, if any.
vtkTextureSlicePixels FindPixels(const Corners& corners, const vtkTextureSlicePixels& within)
{
  const auto [left, low, right, high] = within;
  vtkTextureSlicePixels pixels{right, high, left, low};
  for (const auto& from : corners)
  {
    for (const auto& to : corners)
    {
      // Of the way from one corner to another, what the rows of the rectangle see.
      for (const double row : {from[1], double(low), double(high)})
      {
        if ((row - from[1]) * (to[1] - row) >= 0.0 && row >= low && row <= high)
        {
          const double part = row == from[1] ? 0.0 : (row - from[1]) / (to[1] - from[1]);
          const double column =
            std::clamp(from[0] + part * (to[0] - from[0]), double(left), double(right));
          pixels = {std::min(pixels[0], static_cast<int>(std::floor(column))),
            std::min(pixels[1], static_cast<int>(std::floor(row))),
            std::max(pixels[2], static_cast<int>(std::ceil(column))),
            std::max(pixels[3], static_cast<int>(std::ceil(row)))};
        }
      }
    }
  }
  return {pixels[0], pixels[1], std::max(pixels[0], pixels[2]), std::max(pixels[1], pixels[3])};
}

/// Stores into those pixels of the picture of 16 bits, which may be read afterwards. Band by band,
/// what lies beside the box is left out.
void Dispatch(
  const vtkTextureSliceParts& parts, vtkShaderProgram* program, const vtkTextureSlicePixels& pixels)
{
  constexpr int rowsOfBand = 64;
  constexpr GLuint imageUnit = 0;
  const GLuint picture = parts.Target.GetPicture()->GetHandle();
  const Corners corners = FindCorners(parts);
  program->SetUniformi("pictureImage", imageUnit);
  glBindImageTexture(imageUnit, picture, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16);
  for (int row = pixels[1]; row < pixels[3]; row += rowsOfBand)
  {
    const auto band =
      FindPixels(corners, {pixels[0], row, pixels[2], std::min(row + rowsOfBand, pixels[3])});
    program->SetUniform2i("firstPixel", band.data());
    program->SetUniform2i("endOfPixels", band.data() + 2);
    glDispatchCompute(CountGroups(band[1], band[3]), CountGroups(band[0], band[2]), 1);
  }
  // The picture is read as a texture, and cleared or stored into again for the next one.
  glMemoryBarrier(
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  glBindImageTexture(imageUnit, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16);
}

} // namespace

vtkShaderProgram* vtkTextureSliceBox::Ready(vtkOpenGLRenderWindow* window, const std::string& key,
  const std::function<std::string()>& makeSource, bool isCompute)
{
  auto known = this->Programs.find(key);
  if (known == this->Programs.end() && isCompute)
  {
    auto made = vtkSmartPointer<ComputeProgram>::New();
    made->SetSource(makeSource());
    known = this->Programs.emplace(key, made).first;
  }
  else if (known == this->Programs.end())
  {
    vtkShaderProgram* made =
      window->GetShaderCache()->ReadyShaderProgram(TextureSliceBoxVS, makeSource().c_str(), "");
    known = this->Programs.emplace(key, made).first;
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
  const std::array<double, 6>& seen = parts.Seen;
  const double low[3] = {seen[0], seen[2], seen[4]};
  const double high[3] = {seen[1], seen[3], seen[5]};
  auto columns = vtkTextureSliceFrame::ToColumns(boxToClip);
  program->SetUniformMatrix4x4("boxToClip", columns.data());
  program->SetUniform3f("seenLow", low);
  program->SetUniform3f("seenHigh", high);
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

vtkTextureSliceWays::Way vtkTextureSliceWays::FindWay(
  const vtkTextureSliceParts& parts, bool canBePolygons)
{
  Way way = this->FindAsked(static_cast<Way>(parts.Request.Mapper->GetWay()));
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
  return way;
}

vtkTextureSliceWays::Way vtkTextureSliceWays::ChooseByTrial()
{
  // Polygons stand for a variable that is not set.
  const bool isTrialAsked = this->FindAsked(Mapper::POLYGONS) == Mapper::AUTOMATIC;
  if (!HasCompute() || (vtkTextureSliceIsLlvmpipe() && !isTrialAsked))
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
  const bool isCompute = way == Mapper::COMPUTE;
  this->Program = this->Box.Ready(
    parts.Window, Names[way] + defines,
    [&] { return MakeShader(isCompute ? TextureSliceCS : TextureSliceFS, defines); }, isCompute);
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
  const bool canBePolygons = parts.Features.BlendMode == Mapper::COMPOSITE_BLEND &&
                             !parts.Features.Slabs && parts.Features.Contours == 0;
  Way way = parts.Features.Places ? Mapper::FRAGMENTS : this->FindWay(parts, canBePolygons);
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
      way == Mapper::COMPUTE ? Dispatch(parts, this->Program, pixels)
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
  const vtkTextureSlicePixels all{
    0, 0, static_cast<int>(picture->GetWidth()), static_cast<int>(picture->GetHeight())};
  if (std::exchange(this->IsTrialDue, false))
  {
    this->RunTrial(parts, FindPixels(FindCorners(parts), all));
  }
  this->DrawPixels(this->Drawn, parts, all);
}

bool vtkTextureSliceWays::SweepLight(const vtkTextureSliceParts& parts,
  const vtkTextureSliceLightCells& cells, const vtkTextureSliceLightVolume::Courses& courses,
  std::vector<float>& sums)
{
  vtkShaderProgram* program = this->FindWay(parts, true) == Mapper::COMPUTE
                                ? this->Box.Ready(
                                    parts.Window, "light", [] { return TextureSliceLightCS; }, true)
                                : nullptr;
  if (program == nullptr)
  {
    return false;
  }
  std::vector<vtkTextureSliceLightCells::Surface> surfaces = cells.Surfaces;
  program->SetUniformi("countOfSurfaces", static_cast<int>(surfaces.size()));
  surfaces.emplace_back(); // no buffer is empty
  const auto values = MakeBuffer(0, cells.Values);
  const auto rays = MakeBuffer(1, std::vector<float>(cells.Grid.CountCells(1)));
  const auto arriving = MakeBuffer(2, sums);
  const auto ways = MakeBuffer(3, courses);
  const auto crossed = MakeBuffer(4, surfaces);
  for (std::size_t i = 0; i < courses.size(); ++i)
  {
    program->SetUniformi("number", static_cast<int>(i));
    for (const bool gathering : {false, true})
    {
      const std::array<int, 2>& count = gathering ? courses[i].Cells : courses[i].Rays;
      program->SetUniformi("gathering", gathering);
      glDispatchCompute(CountGroups(0, count[0]), CountGroups(0, count[1]), 1);
      glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    }
  }
  arriving->Bind();
  glGetBufferSubData(
    GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(sums.size() * sizeof(float)), sums.data());
  arriving->Release();
  return true;
}

void vtkTextureSliceWays::ReleaseGraphicsResources(vtkOpenGLRenderWindow* window)
{
  this->Box.ReleaseGraphicsResources(window);
  this->Program = nullptr;
}
