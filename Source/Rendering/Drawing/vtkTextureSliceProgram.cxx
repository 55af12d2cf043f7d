// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceProgram.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceBlanks.h"
#include "vtkTextureSliceCoordinates.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceGeometry.h"
#include "vtkTextureSliceIntegralTable.h"
#include "vtkTextureSliceLights.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSlicePeeling.h"
#include "vtkTextureSliceShadows.h"
#include "vtkTextureSliceTable.h"
#include "vtkTextureSliceTable2D.h"

#include "TextureSliceColoringFS.h"
#include "TextureSliceFS.h"
#include "TextureSliceLightingFS.h"
#include "TextureSlicePeelFS.h"
#include "TextureSliceSamplingFS.h"
#include "TextureSliceShadowsFS.h"
#include "TextureSliceSlabsFS.h"
#include "TextureSliceTableFS.h"
#include "TextureSliceVS.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>

namespace
{

std::vector<float> Gather(const std::vector<vtkTextureSliceSurface>& surfaces,
  const std::function<float(const vtkTextureSliceSurface&)>& get)
{
  std::vector<float> values;
  std::transform(surfaces.begin(), surfaces.end(), std::back_inserter(values), get);
  return values;
}

void SetArray(vtkShaderProgram* program, const char* name, const std::vector<float>& values)
{
  program->SetUniform1fv(name, static_cast<int>(values.size()), values.data());
}

void SetUniforms(vtkShaderProgram* program, const vtkTextureSliceUniforms& uniforms)
{
  const vtkTextureSliceFrame& frame = *uniforms.Frame;
  program->SetUniformMatrix("boxToClip", frame.GetBoxToClip());
  program->SetUniform3f("textureScale", frame.GetTextureScale().data());
  program->SetUniform3f("textureBias", frame.GetTextureBias().data());
  program->SetUniformi("volumeTexture", uniforms.Volume->GetTextureUnit());
  program->SetUniform4f("scalarScale", uniforms.ScalarScale.data());
  program->SetUniform4f("scalarBias", uniforms.ScalarBias.data());
  uniforms.SetTable(program);
  const float inverseUnitDistance = uniforms.Surfaces.front().InverseUnitDistance;
  program->SetUniformf("inverseUnitDistance", inverseUnitDistance);
  SetArray(program, "unitDistanceRatio",
    Gather(uniforms.Surfaces, [inverseUnitDistance](const auto& surface)
      { return surface.InverseUnitDistance / inverseUnitDistance; }));
  program->SetUniform3f("cropLow", frame.GetCropLow().data());
  program->SetUniform3f("cropHigh", frame.GetCropHigh().data());
  program->SetUniformi("cropFlags", uniforms.CropFlags);
  program->SetUniform3f("voxelStep", frame.GetVoxelStep().data());
  program->SetUniform4f("stair", frame.GetStair().data());
  program->SetUniform3f("inverseAspect", frame.GetInverseAspect().data());
  program->SetUniform2f("averageRange", uniforms.AverageRange.data());
}

void SetMaskAndTables(vtkShaderProgram* program, const vtkTextureSliceUniforms& uniforms)
{
  const vtkTextureSliceFeatures& features = uniforms.Features;
  if (features.Table2D)
  {
    program->SetUniformi("transferTable2D", uniforms.Table2D->GetTexture()->GetTextureUnit());
    program->SetUniformf("table2DRows", static_cast<float>(uniforms.Table2D->GetNumberOfRows()));
  }
  if (features.Rectilinear)
  {
    program->SetUniformi("coordinateTable", uniforms.Coordinates->GetTexture()->GetTextureUnit());
    const auto entry = static_cast<float>(uniforms.Coordinates->GetMargin());
    const std::array<float, 2> scaleAndBias{1.0f - entry, 0.5f * entry};
    program->SetUniform2f("coordinateScaleAndBias", scaleAndBias.data());
    program->SetUniform3f("placeScale", uniforms.Frame->GetTextureScale().data());
    program->SetUniform3f("placeBias", uniforms.Frame->GetTextureBias().data());
  }
  if (features.SecondArray > 0)
  {
    program->SetUniformi("secondTexture", uniforms.SecondArray->GetTextureUnit());
    program->SetUniform4f("secondScale", uniforms.SecondScale.data());
    program->SetUniform4f("secondBias", uniforms.SecondBias.data());
  }
  if (features.Blanked)
  {
    uniforms.Blanks->SetUniforms(program);
  }
  if (features.HasMask())
  {
    program->SetUniformi("maskTexture", uniforms.Mask->GetTextureUnit());
  }
  if (features.Labels > 0)
  {
    vtkTextureSliceTable& table = *uniforms.LabelTable;
    program->SetUniformi("labelTable", table.GetTexture()->GetTextureUnit());
    program->SetUniformf("labelTableScale", static_cast<float>(table.GetScale()));
    program->SetUniformf("labelTableBias", static_cast<float>(table.GetBias()));
    program->SetUniformf("labelWeight", uniforms.LabelWeight);
  }
}

void SetLight(vtkShaderProgram* program, const vtkTextureSliceUniforms& uniforms)
{
  std::vector<float> material;
  for (const vtkTextureSliceSurface& surface : uniforms.Surfaces)
  {
    material.insert(material.end(), surface.Material.begin(), surface.Material.end());
  }
  program->SetUniform4fv("material", static_cast<int>(uniforms.Surfaces.size()), material.data());
  uniforms.Lights->SetUniforms(program, *uniforms.Frame);
}

/// The box as texture coordinates, and the part of it that is drawn.
void SetBox(vtkShaderProgram* program, const vtkTextureSliceUniforms& uniforms)
{
  // The outermost samples may lie a rounding error beyond the box.
  constexpr float margin = 1e-5f;
  const vtkTextureSliceFrame& frame = *uniforms.Frame;
  const auto& scale = frame.GetTextureScale();
  const auto& bias = frame.GetTextureBias();
  const auto& part = frame.GetView().Part;
  std::array<float, 3> low{};
  std::array<float, 3> high{};
  std::array<float, 3> partMiddle{};
  std::array<float, 3> partScale{};
  std::array<float, 3> stepToPart{};
  std::array<float, 3> stepToTexture{};
  const double inverseUnitDistance =
    static_cast<double>(uniforms.Surfaces.front().InverseUnitDistance);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double size = part[2 * axis + 1] - part[2 * axis];
    const double edge = std::abs(static_cast<double>(frame.GetEdges()[axis]));
    low[axis] = bias[axis] - margin;
    high[axis] = bias[axis] + scale[axis] + margin;
    partMiddle[axis] = static_cast<float>(part[2 * axis] + 0.5 * size);
    partScale[axis] = static_cast<float>(1.0 / size);
    stepToPart[axis] = static_cast<float>(1.0 / (size * edge));
    stepToTexture[axis] = scale[axis] / static_cast<float>(edge * inverseUnitDistance);
  }
  program->SetUniform3f("boxLow", low.data());
  program->SetUniform3f("boxHigh", high.data());
  program->SetUniform3f("partMiddle", partMiddle.data());
  program->SetUniform3f("partScale", partScale.data());
  program->SetUniform3f("stepToPart", stepToPart.data());
  program->SetUniform3f("stepToTexture", stepToTexture.data());
}

/// The number of the last entry of a row.
float GetLastEntry(const vtkTextureSliceIntegralTable& integrals)
{
  return static_cast<float>(integrals.GetWidth() - 1);
}

void SetSlabs(vtkShaderProgram* program, const vtkTextureSliceGeometry& geometry,
  const vtkTextureSliceUniforms& uniforms)
{
  program->SetUniformi("integralTable", uniforms.Integrals->GetTexture()->GetTextureUnit());
  program->SetUniformf("lastIntegral", GetLastEntry(*uniforms.Integrals));
  if (uniforms.Features.Labels > 0)
  {
    program->SetUniformi(
      "labelIntegralTable", uniforms.LabelIntegrals->GetTexture()->GetTextureUnit());
    program->SetUniformf("lastLabelIntegral", GetLastEntry(*uniforms.LabelIntegrals));
  }
  program->SetUniform2f("clipStep", geometry.GetClipStep().data());
  const std::vector<float> planes = uniforms.Frame->GetPlanesInPart();
  if (!planes.empty())
  {
    program->SetUniform4fv("clippingPlanes", static_cast<int>(planes.size() / 4), planes.data());
  }
}

} // namespace

std::vector<vtkTextureObject*> vtkTextureSliceUniforms::GetTextures() const
{
  std::vector<vtkTextureObject*> textures{this->Volume, this->Table->GetTexture()};
  if (this->Features.Table2D)
  {
    textures.push_back(this->Table2D->GetTexture());
  }
  if (this->Features.Rectilinear)
  {
    textures.push_back(this->Coordinates->GetTexture());
  }
  if (this->Features.SecondArray > 0)
  {
    textures.push_back(this->SecondArray);
  }
  if (this->Features.Blanked)
  {
    textures.push_back(this->Blanks->GetTexture());
  }
  if (this->Features.HasMask())
  {
    textures.push_back(this->Mask);
  }
  if (this->Features.Labels > 0)
  {
    textures.push_back(this->LabelTable->GetTexture());
  }
  if (this->Features.Shadows)
  {
    textures.push_back(this->Shadows->GetTexture());
  }
  if (this->Features.NeedsDepth())
  {
    textures.push_back(this->GeometryDepth);
  }
  if (this->Features.Slabs > 0)
  {
    textures.push_back(this->Integrals->GetTexture());
    if (this->Features.Labels > 0)
    {
      textures.push_back(this->LabelIntegrals->GetTexture());
    }
  }
  return textures;
}

void vtkTextureSliceUniforms::SetTable(vtkShaderProgram* program) const
{
  program->SetUniformi("transferTable", this->Table->GetTexture()->GetTextureUnit());
  program->SetUniformf("tableScale", static_cast<float>(this->Table->GetScale()));
  program->SetUniformf("tableBias", static_cast<float>(this->Table->GetBias()));
  SetArray(program, "componentWeight",
    Gather(this->Surfaces, [](const auto& surface) { return surface.Weight; }));
}

vtkTextureSliceProgram::vtkTextureSliceProgram()
{
  this->Vertices->SetType(vtkOpenGLBufferObject::ArrayBuffer);
}

vtkTextureSliceProgram::~vtkTextureSliceProgram() = default;

vtkShaderProgram* vtkTextureSliceProgram::Ready(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceFeatures& features) const
{
  std::string fragmentShader = TextureSliceFS;
  for (const auto& [place, text] :
    {std::pair("Defines", features.GetDefines()), {"Peel", TextureSlicePeelFS},
      {"Sampling", TextureSliceSamplingFS}, {"Lighting", TextureSliceLightingFS},
      {"Shadows", TextureSliceShadowsFS}, {"Table", TextureSliceTableFS},
      {"Coloring", TextureSliceColoringFS}, {"Slabs", TextureSliceSlabsFS}})
  {
    vtkShaderProgram::Substitute(
      fragmentShader, std::string("//VTK::TextureSlice::") + place, text);
  }
  std::string vertexShader = TextureSliceVS;
  vtkShaderProgram::Substitute(vertexShader, "//VTK::TextureSlice::Defines", features.GetDefines());
  return window->GetShaderCache()->ReadyShaderProgram(
    vertexShader.c_str(), fragmentShader.c_str(), "");
}

bool vtkTextureSliceProgram::Upload(
  vtkShaderProgram* program, const vtkTextureSliceGeometry& geometry)
{
  constexpr auto stride = sizeof(float) * vtkTextureSliceGeometry::FloatsPerVertex;
  this->VertexArray->Bind();
  if (!this->Vertices->Upload(geometry.GetVertices(), vtkOpenGLBufferObject::ArrayBuffer))
  {
    return false;
  }
  if (program == this->Program)
  {
    return true;
  }
  this->VertexArray->ShaderProgramChanged();
  this->VertexArray->Bind();
  // Blend modes that do not ask how far apart the slices are have no rayStep.
  const auto add = [&](const char* name, std::size_t offset)
  {
    return !program->IsAttributeUsed(name) ||
           this->VertexArray->AddAttributeArray(
             program, this->Vertices, name, static_cast<int>(offset), stride, VTK_FLOAT, 3, false);
  };
  const bool added = add("boxPosition", 0) && add("rayStep", 3 * sizeof(float));
  this->Program = added ? program : nullptr;
  return added;
}

void vtkTextureSliceProgram::DrawGroups(vtkOpenGLRenderWindow* window,
  const std::vector<int>& firstVertices, const Groups& groups, const AfterGroup& afterGroup)
{
  const std::size_t slices = firstVertices.size() - 1;
  std::size_t begin = 0;
  std::size_t size = groups.First > 0 ? static_cast<std::size_t>(groups.First) : slices;
  while (begin < slices)
  {
    const std::size_t end = std::min(begin + size, slices);
    glDrawArrays(GL_TRIANGLES, firstVertices[begin], firstVertices[end] - firstVertices[begin]);
    const int lastSlice = firstVertices[end] - firstVertices[end - 1];
    if (lastSlice > 0 && firstVertices[end] < firstVertices[slices])
    {
      afterGroup(this->Vertices, firstVertices[end - 1], lastSlice);
      window->GetShaderCache()->ReadyShaderProgram(this->Program);
      this->VertexArray->Bind();
    }
    begin = end;
    size *= static_cast<std::size_t>(groups.Growth);
  }
}

bool vtkTextureSliceProgram::Draw(vtkOpenGLRenderWindow* window,
  const vtkTextureSliceGeometry& geometry, const vtkTextureSliceUniforms& uniforms,
  const Groups& groups, const AfterGroup& afterGroup)
{
  vtkShaderProgram* program = this->Ready(window, uniforms.Features);
  if (program == nullptr || !this->Upload(program, geometry))
  {
    return false;
  }
  const std::vector<vtkTextureObject*> textures = uniforms.GetTextures();
  std::for_each(textures.begin(), textures.end(), [](vtkTextureObject* t) { t->Activate(); });
  SetUniforms(program, uniforms);
  SetMaskAndTables(program, uniforms);
  if (uniforms.Features.Lights >= 0)
  {
    SetLight(program, uniforms);
  }
  if (uniforms.Features.Shadows)
  {
    uniforms.Shadows->SetUniforms(program);
  }
  if (uniforms.Features.NeedsDepth())
  {
    program->SetUniformi("geometryDepth", uniforms.GeometryDepth->GetTextureUnit());
  }
  if (uniforms.Features.Peel > 0)
  {
    uniforms.Peeling->SetUniforms(program, uniforms.PixelSize);
  }
  if (uniforms.Features.IsoValues > 0)
  {
    SetArray(program, "isoValues", uniforms.IsoValues);
  }
  SetBox(program, uniforms);
  if (uniforms.Features.Slabs > 0)
  {
    SetSlabs(program, geometry, uniforms);
  }
  this->DrawGroups(window, geometry.GetFirstVertices(), groups, afterGroup);
  this->VertexArray->Release();
  this->Vertices->Release();
  std::for_each(textures.rbegin(), textures.rend(), [](vtkTextureObject* t) { t->Deactivate(); });
  return true;
}

void vtkTextureSliceProgram::ReleaseGraphicsResources()
{
  this->VertexArray->ReleaseGraphicsResources();
  this->Vertices->ReleaseGraphicsResources();
  this->Program = nullptr;
}
