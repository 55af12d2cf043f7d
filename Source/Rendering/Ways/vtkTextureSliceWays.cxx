// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceWays.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceShader.h"
#include "vtkTextureSliceTrial.h"
#include "vtkTextureSliceUniforms.h"
#include "vtkVolumeMapper.h"

#include "TextureSliceCS.h"
#include "TextureSliceFS.h"
#include "TextureSlicePolygonFS.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>

namespace
{

const char* const Variable = "VTK_TEXTURE_SLICE_WAY";
const std::array<const char*, 4> Names{"automatic", "fragments", "compute", "polygons"};

bool CanBePolygons(const vtkTextureSliceFeatures& features)
{
  return features.BlendMode == vtkVolumeMapper::COMPOSITE_BLEND && !features.Slabs;
}

} // namespace

vtkTextureSliceWays::Way vtkTextureSliceWays::FindAsked()
{
  const char* value = std::getenv(Variable);
  if (value == nullptr)
  {
    return this->Asked;
  }
  const auto* const name = std::find(Names.begin(), Names.end(), std::string(value));
  if (name == Names.end())
  {
    this->Fallback = std::string(Variable) + " is \"" + value +
                     "\", not automatic, fragments, compute or polygons";
    return this->Asked;
  }
  return static_cast<Way>(name - Names.begin());
}

vtkTextureSliceWays::Way vtkTextureSliceWays::ChooseByTrial(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  if (!vtkTextureSliceCompute::IsSupported())
  {
    return Fragments;
  }
  const std::optional<bool> known = vtkTextureSliceTrial::Recall();
  if (!known && this->Drawn == Automatic)
  {
    return Fragments;
  }
  const bool isFaster =
    known ? *known : vtkTextureSliceTrial::Run(window, uniforms.Texture.GetTexture());
  return isFaster ? Compute : Fragments;
}

bool vtkTextureSliceWays::Ready(Way way, vtkOpenGLRenderWindow* window,
  const vtkTextureSliceUniforms& uniforms, const char* instead)
{
  const char* main = way == Compute    ? TextureSliceCS
                     : way == Polygons ? TextureSlicePolygonFS
                                       : TextureSliceFS;
  const std::string defines = uniforms.Features.GetDefines();
  const std::string key = Names[way] + defines;
  const auto make = [main, &defines] { return vtkTextureSliceShader::Make(main, defines); };
  this->Program = nullptr;
  if (this->Failed.count(key) == 0)
  {
    this->Program = way == Compute ? this->ComputeShaders.Ready(window, key, make)
                                   : this->Box.Ready(window, key, make);
  }
  if (this->Program == nullptr)
  {
    this->Failed.insert(key);
    this->Fallback = std::string("the shader of ") + Names[way] + " does not compile: " + instead;
  }
  return this->Program != nullptr;
}

bool vtkTextureSliceWays::Choose(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  this->Fallback.clear();
  const bool canBePolygons = CanBePolygons(uniforms.Features);
  Way way = uniforms.Features.Places ? Fragments : this->FindAsked();
  if (way == Automatic || (way == Polygons && !canBePolygons))
  {
    way = this->ChooseByTrial(window, uniforms);
  }
  if (way == Compute && !vtkTextureSliceCompute::IsSupported())
  {
    this->Fallback = "the context has no compute shaders (OpenGL 4.3): fragments draw the volume";
    way = Fragments;
  }
  if (way == Compute && !this->Ready(Compute, window, uniforms, "fragments draw the volume"))
  {
    way = Fragments;
  }
  if (way == Fragments && !this->Ready(Fragments, window, uniforms, "polygons draw the volume"))
  {
    way = Polygons;
  }
  this->Drawn = way;
  return way != Polygons ||
         (canBePolygons && this->Ready(Polygons, window, uniforms, "nothing is drawn"));
}

void vtkTextureSliceWays::Draw(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms, vtkTextureObject* picture)
{
  const vtkTextureSliceFrame& frame = uniforms.Frame;
  vtkOpenGLState* state = window->GetState();
  state->SetEnumState(GL_BLEND, this->Drawn == Polygons);
  if (this->Drawn == Polygons)
  {
    // Behind what is there already: Formulas R3.
    state->vtkglBlendEquation(GL_FUNC_ADD);
    state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  }
  uniforms.Use(this->Program,
    [&]
    {
      if (this->Drawn == Compute)
      {
        const auto pixels = vtkTextureSliceCompute::FindPixels(frame, uniforms.Seen,
          {static_cast<int>(picture->GetWidth()), static_cast<int>(picture->GetHeight())});
        this->ComputeShaders.Dispatch(picture, pixels);
        return;
      }
      this->Box.Draw(
        frame, uniforms.Seen, this->Drawn == Polygons ? uniforms.Planes.GetNumberOfSlices() : 1);
    });
}

void vtkTextureSliceWays::ReleaseGraphicsResources(vtkOpenGLRenderWindow* window)
{
  this->Box.ReleaseGraphicsResources();
  this->ComputeShaders.ReleaseGraphicsResources(window);
  this->Program = nullptr;
  this->Failed.clear();
}
