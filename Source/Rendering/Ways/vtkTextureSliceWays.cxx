// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceWays.h"

#include "vtkTextureSliceTrial.h"
#include "vtkTextureSliceUniforms.h"

#include <array>
#include <cstdlib>
#include <optional>

namespace
{

const char* const Variable = "VTK_TEXTURE_SLICE_WAY";
const std::array<const char*, 4> Names{"automatic", "fragments", "compute", "polygons"};

} // namespace

vtkTextureSliceWays::Way vtkTextureSliceWays::FindAsked()
{
  const char* value = std::getenv(Variable);
  if (value == nullptr)
  {
    return this->Asked;
  }
  for (std::size_t way = 0; way < Names.size(); ++way)
  {
    if (std::string(value) == Names[way])
    {
      return static_cast<Way>(way);
    }
  }
  this->Fallback =
    std::string(Variable) + " is \"" + value + "\", not automatic, fragments, compute or polygons";
  return this->Asked;
}

vtkTextureSliceWays::Way vtkTextureSliceWays::ChooseByTrial(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  if (this->ComputeFails || !vtkTextureSliceCompute::IsSupported())
  {
    return Fragments;
  }
  const std::optional<bool> known = vtkTextureSliceTrial::Recall();
  if (!known && this->Drawn == Automatic)
  {
    return Fragments;
  }
  const bool isFaster = known ? *known : vtkTextureSliceTrial::Run(window, uniforms.Volume);
  return isFaster ? Compute : Fragments;
}

bool vtkTextureSliceWays::ReadyCompute(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  if (!vtkTextureSliceCompute::IsSupported())
  {
    this->Fallback = "the context has no compute shaders (OpenGL 4.3): fragments draw the volume";
    return false;
  }
  this->ComputeFails = this->ComputeFails || !this->March.ReadyCompute(window, uniforms);
  if (this->ComputeFails)
  {
    this->Fallback = "the compute shader does not compile: fragments draw the volume";
  }
  return !this->ComputeFails;
}

bool vtkTextureSliceWays::ReadyFragments(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  const bool canBePolygons = vtkTextureSlicePolygons::CanDraw(uniforms.Features);
  const bool tries = !this->FragmentsFail || !canBePolygons;
  this->FragmentsFail = !tries || !this->March.ReadyFragments(window, uniforms);
  if (this->FragmentsFail && canBePolygons)
  {
    this->Fallback = "the fragment shader does not compile: polygons draw the volume";
  }
  return !this->FragmentsFail;
}

bool vtkTextureSliceWays::Choose(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  this->Fallback.clear();
  const bool canBePolygons = vtkTextureSlicePolygons::CanDraw(uniforms.Features);
  Way way = this->FindAsked();
  if (way == Automatic || (way == Polygons && !canBePolygons))
  {
    way = this->ChooseByTrial(window, uniforms);
  }
  if (way == Compute && !this->ReadyCompute(window, uniforms))
  {
    way = Fragments;
  }
  if (way == Fragments && !this->ReadyFragments(window, uniforms))
  {
    way = Polygons;
  }
  this->Drawn = way;
  return way != Polygons || (canBePolygons && this->PolygonsOfPlanes.Ready(window, uniforms));
}

void vtkTextureSliceWays::Draw(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms, vtkTextureObject* picture)
{
  switch (this->Drawn)
  {
  case Compute:
    this->March.DrawCompute(uniforms, picture);
    break;
  case Polygons:
    this->PolygonsOfPlanes.Draw(window, uniforms);
    break;
  default:
    this->March.DrawFragments(window, uniforms);
  }
}

void vtkTextureSliceWays::ReleaseGraphicsResources(vtkOpenGLRenderWindow* window)
{
  this->March.ReleaseGraphicsResources(window);
  this->PolygonsOfPlanes.ReleaseGraphicsResources();
  this->ComputeFails = false;
  this->FragmentsFail = false;
}
