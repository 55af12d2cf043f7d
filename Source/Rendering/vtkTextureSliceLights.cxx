// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceLights.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTransform.h"

#include <cmath>

namespace
{

// OpenGL's: a spot light's cone is at most this wide, degrees from its axis.
constexpr double WidestCone = 90.0;

std::array<float, 3> ToFloat(const double v[3], double factor = 1.0)
{
  return {static_cast<float>(v[0] * factor), static_cast<float>(v[1] * factor),
    static_cast<float>(v[2] * factor)};
}

} // namespace

void vtkTextureSliceLights::Update(vtkRenderer* renderer)
{
  *this = vtkTextureSliceLights();
  this->TwoSided = renderer->GetTwoSidedLighting() != 0;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch() != 0)
    {
      this->OnlyHeadlight =
        this->Count == 0 && light->LightTypeIsHeadlight() != 0 && light->GetPositional() == 0;
      this->Append(renderer, light);
      ++this->Count;
    }
  }
}

void vtkTextureSliceLights::Append(vtkRenderer* renderer, vtkLight* light)
{
  const double intensity = light->GetIntensity();
  const auto ambient = ToFloat(light->GetAmbientColor(), intensity);
  for (std::size_t i = 0; i < 3; ++i)
  {
    this->Ambient[i] += ambient[i];
  }
  this->Vectors["lightDiffuse"].push_back(ToFloat(light->GetDiffuseColor(), intensity));
  this->Vectors["lightSpecular"].push_back(ToFloat(light->GetSpecularColor(), intensity));

  double position[3];
  double direction[3];
  light->GetTransformedPosition(position);
  light->GetTransformedFocalPoint(direction);
  vtkMath::Subtract(direction, position, direction);
  vtkMath::Normalize(direction);
  vtkTransform* toCamera = renderer->GetActiveCamera()->GetModelViewTransformObject();
  this->Vectors["lightDirection"].push_back(ToFloat(toCamera->TransformNormal(direction)));
  this->Vectors["lightPosition"].push_back(ToFloat(toCamera->TransformPoint(position)));

  this->Vectors["lightAttenuation"].push_back(ToFloat(light->GetAttenuationValues()));
  const double angle = light->GetConeAngle();
  const double cosine = angle <= WidestCone ? std::cos(vtkMath::RadiansFromDegrees(angle)) : -2.0;
  // Whether it has a position, cosine of the cone or -2, exponent.
  const double cone[3] = {light->GetPositional() != 0 ? 1.0 : 0.0, cosine, light->GetExponent()};
  this->Vectors["lightCone"].push_back(ToFloat(cone));
}

int vtkTextureSliceLights::CountForShader() const
{
  if (this->Count == 0)
  {
    return -1;
  }
  return this->OnlyHeadlight ? 0 : this->Count;
}

void vtkTextureSliceLights::SetUniforms(
  vtkShaderProgram* program, const vtkTextureSliceFrame& frame) const
{
  program->SetUniformi("twoSided", this->TwoSided ? 1 : 0);
  program->SetUniform3f("lightAmbient", this->Ambient.data());
  for (const auto& [name, values] : this->Vectors)
  {
    program->SetUniform3fv(name, this->Count, reinterpret_cast<const float(*)[3]>(values.data()));
  }
  std::array<double, 16> cameraToBox{};
  vtkMatrix4x4::Invert(frame.View.BoxToCamera.data(), cameraToBox.data());
  const double eye[3] = {cameraToBox[3], cameraToBox[7], cameraToBox[11]};
  program->SetUniform3f("eyeInBox", ToFloat(eye).data());
  program->SetUniform3f("boxEdges", ToFloat(frame.View.EdgeLength.data()).data());
  // Normals go the other way about: by the transposed matrix from camera to box coordinates, column
  // by column, and from data to box lengths by the edges.
  std::array<float, 9> gradientToCamera{};
  for (std::size_t i = 0; i < 9; ++i)
  {
    gradientToCamera[i] =
      static_cast<float>(cameraToBox[4 * (i / 3) + i % 3] * frame.View.EdgeLength[i / 3]);
  }
  auto boxToCamera = vtkTextureSliceFrame::ToColumns(frame.View.BoxToCamera);
  program->SetUniformMatrix4x4("boxToCamera", boxToCamera.data());
  program->SetUniformMatrix3x3("gradientToCamera", gradientToCamera.data());
}
