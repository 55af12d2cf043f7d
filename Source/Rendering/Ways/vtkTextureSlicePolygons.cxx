// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSlicePolygons.h"

#include "vtkMath.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceShader.h"
#include "vtkTextureSliceUniforms.h"
#include "vtkVolumeMapper.h"

#include "TextureSlicePolygonFS.h"
#include "TextureSlicePolygonVS.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace
{

using Vector = std::array<double, 3>;
/// a, b, c, d: a*x + b*y + c*z + d is not negative on the side that is kept.
using Plane = std::array<double, 4>;
using Polygon = std::vector<Vector>;

double Evaluate(const Plane& plane, const Vector& p)
{
  return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3];
}

/// The part of a convex polygon on the positive side of a plane (Sutherland and Hodgman 1974).
Polygon Clip(const Polygon& polygon, const Plane& plane)
{
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector& a = polygon[i];
    const Vector& b = polygon[(i + 1) % polygon.size()];
    const double valueA = Evaluate(plane, a);
    const double valueB = Evaluate(plane, b);
    if (valueA >= 0.0)
    {
      kept.push_back(a);
    }
    if ((valueA >= 0.0) != (valueB >= 0.0))
    {
      const double t = valueA / (valueA - valueB);
      kept.push_back(
        {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
    }
  }
  return kept;
}

/// Half-spaces whose intersection is what is seen of the volume and a little more: whether the
/// place on a pixel's ray is drawn is decided by the ray.
std::vector<Plane> MakeLimits(const vtkTextureSliceView& view, const std::array<double, 6>& seen)
{
  std::vector<Plane> limits{{1, 0, 0, -seen[0]}, {-1, 0, 0, seen[1]}, {0, 1, 0, -seen[2]},
    {0, -1, 0, seen[3]}, {0, 0, 1, -seen[4]}, {0, 0, -1, seen[5]}};
  limits.insert(limits.end(), view.ClippingPlanes.begin(), view.ClippingPlanes.end());
  constexpr double margin = 1e-3; // of the box; OpenGL rounds corners to a part of a pixel
  for (Plane& limit : limits)
  {
    limit[3] += margin * std::hypot(limit[0], limit[1], limit[2]);
  }
  return limits;
}

/// A square of equal depth about the middle of the box, larger than the box.
Polygon MakeSquare(const Plane& depth, double atDepth)
{
  Vector normal{depth[0], depth[1], depth[2]};
  const double length = vtkMath::Normalize(normal.data());
  Vector right{};
  Vector up{};
  vtkMath::Perpendiculars(normal.data(), right.data(), up.data(), 0.0);
  const Vector middle{0.5, 0.5, 0.5};
  const double offset = (atDepth - Evaluate(depth, middle)) / length;
  Polygon square;
  for (const auto& [r, u] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
  {
    Vector corner{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      corner[i] = middle[i] + offset * normal[i] + r * right[i] + u * up[i];
    }
    square.push_back(corner);
  }
  return square;
}

/// Appends a polygon of that plane as triangles, four numbers a corner.
void Append(const Polygon& polygon, int plane, std::vector<float>& corners)
{
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    for (const Vector& corner : {polygon[0], polygon[i - 1], polygon[i]})
    {
      std::transform(corner.begin(), corner.end(), std::back_inserter(corners),
        [](double coordinate) { return static_cast<float>(coordinate); });
      corners.push_back(static_cast<float>(plane));
    }
  }
}

/// The corners of all triangles, those of the nearest plane first.
std::vector<float> MakeCorners(const vtkTextureSliceUniforms& uniforms)
{
  const vtkTextureSliceView& view = uniforms.Frame->GetView();
  const vtkTextureSlicePlanes& planes = *uniforms.Planes;
  const std::vector<Plane> limits = MakeLimits(view, uniforms.Seen);
  const auto& m = view.BoxToCamera;
  const Plane depth{-m[8], -m[9], -m[10], -m[11]};
  std::vector<float> corners;
  for (int plane = 0; plane < planes.GetNumberOfSlices(); ++plane)
  {
    Polygon polygon = MakeSquare(depth, planes.GetNearestDepth() + plane * planes.GetDepthStep());
    for (const Plane& limit : limits)
    {
      polygon = Clip(polygon, limit);
    }
    Append(polygon, plane, corners);
  }
  return corners;
}

} // namespace

vtkTextureSlicePolygons::vtkTextureSlicePolygons() = default;
vtkTextureSlicePolygons::~vtkTextureSlicePolygons() = default;

bool vtkTextureSlicePolygons::CanDraw(const vtkTextureSliceFeatures& features)
{
  return features.BlendMode == vtkVolumeMapper::COMPOSITE_BLEND && !features.Slabs;
}

bool vtkTextureSlicePolygons::Ready(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  vtkTextureSliceFeatures features = uniforms.Features;
  features.Skipping = false;
  const std::string defines = features.GetDefines();
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (this->Program == nullptr || defines != this->Key)
  {
    this->Key = defines;
    this->Program = cache->ReadyShaderProgram(TextureSlicePolygonVS,
      vtkTextureSliceShader::Make(TextureSlicePolygonFS, defines).c_str(), "");
    return this->Program != nullptr;
  }
  return cache->ReadyShaderProgram(this->Program) != nullptr;
}

void vtkTextureSlicePolygons::Draw(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  vtkTextureSliceUniforms withoutSkipping = uniforms;
  withoutSkipping.Features.Skipping = false;
  withoutSkipping.Use(this->Program, [&] { this->DrawTriangles(window, uniforms); });
}

void vtkTextureSlicePolygons::DrawTriangles(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms)
{
  constexpr int perCorner = 4;
  const std::vector<float> corners = MakeCorners(uniforms);
  if (corners.empty())
  {
    return;
  }
  this->Program->SetUniformMatrix("boxToClip", uniforms.Frame->GetBoxToClip());
  this->VertexArray->ShaderProgramChanged();
  this->VertexArray->Bind();
  this->Corners->Upload(corners, vtkOpenGLBufferObject::ArrayBuffer);
  this->VertexArray->AddAttributeArray(this->Program, this->Corners, "corner", 0,
    perCorner * sizeof(float), VTK_FLOAT, perCorner, false);
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_DEPTH_TEST);
  // Behind what is there already: Formulas R3.
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  // Polygons beyond the far plane count as well.
  glEnable(GL_DEPTH_CLAMP);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size() / perCorner));
  glDisable(GL_DEPTH_CLAMP);
  this->VertexArray->Release();
}

void vtkTextureSlicePolygons::ReleaseGraphicsResources()
{
  this->VertexArray->ReleaseGraphicsResources();
  this->Corners->ReleaseGraphicsResources();
  this->Program = nullptr;
}
