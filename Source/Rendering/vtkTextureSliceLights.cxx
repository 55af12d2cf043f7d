// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceLights.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
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

void SetArray(
  vtkShaderProgram* program, const char* name, const std::vector<std::array<float, 3>>& values)
{
  program->SetUniform3fv(
    name, static_cast<int>(values.size()), reinterpret_cast<const float(*)[3]>(values.data()));
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
        this->Cone.empty() && light->LightTypeIsHeadlight() != 0 && light->GetPositional() == 0;
      this->Append(renderer, light);
    }
  }
}

void vtkTextureSliceLights::Append(vtkRenderer* renderer, vtkLight* light)
{
  const double intensity = light->GetIntensity();
  const Vector ambient = ToFloat(light->GetAmbientColor(), intensity);
  for (std::size_t i = 0; i < 3; ++i)
  {
    this->Ambient[i] += ambient[i];
  }
  this->Diffuse.push_back(ToFloat(light->GetDiffuseColor(), intensity));
  this->Specular.push_back(ToFloat(light->GetSpecularColor(), intensity));

  double position[3];
  double direction[3];
  light->GetTransformedPosition(position);
  light->GetTransformedFocalPoint(direction);
  vtkMath::Subtract(direction, position, direction);
  vtkMath::Normalize(direction);
  vtkTransform* toCamera = renderer->GetActiveCamera()->GetModelViewTransformObject();
  this->Direction.push_back(ToFloat(toCamera->TransformNormal(direction)));
  this->Position.push_back(ToFloat(toCamera->TransformPoint(position)));

  this->Attenuation.push_back(ToFloat(light->GetAttenuationValues()));
  const double angle = light->GetConeAngle();
  const double cosine = angle <= WidestCone ? std::cos(vtkMath::RadiansFromDegrees(angle)) : -2.0;
  const double cone[3] = {light->GetPositional() != 0 ? 1.0 : 0.0, cosine, light->GetExponent()};
  this->Cone.push_back(ToFloat(cone));
}

int vtkTextureSliceLights::CountForShader() const
{
  if (this->Cone.empty())
  {
    return -1;
  }
  return this->OnlyHeadlight ? 0 : static_cast<int>(this->Cone.size());
}

void vtkTextureSliceLights::SetUniforms(
  vtkShaderProgram* program, const vtkTextureSliceFrame& frame) const
{
  program->SetUniformi("twoSided", this->TwoSided ? 1 : 0);
  SetArray(program, "lightDiffuse", this->Diffuse);
  SetArray(program, "lightSpecular", this->Specular);
  vtkNew<vtkMatrix4x4> cameraToBox;
  vtkMatrix4x4::Invert(frame.View.BoxToCamera.data(), cameraToBox->GetData());
  if (this->OnlyHeadlight)
  {
    const double eye[3] = {
      cameraToBox->GetElement(0, 3), cameraToBox->GetElement(1, 3), cameraToBox->GetElement(2, 3)};
    program->SetUniform3f("eyeInBox", ToFloat(eye).data());
    program->SetUniform3f("boxEdges", ToFloat(frame.View.EdgeLength.data()).data());
    return;
  }
  program->SetUniform3f("lightAmbient", this->Ambient.data());
  SetArray(program, "lightDirection", this->Direction);
  SetArray(program, "lightPosition", this->Position);
  SetArray(program, "lightAttenuation", this->Attenuation);
  SetArray(program, "lightCone", this->Cone);
  // Column by column, as OpenGL reads them. Normals go the other way about: by the transposed
  // matrix from camera to box coordinates, and from data to box lengths by the edges.
  std::array<float, 16> boxToCamera{};
  std::array<float, 9> gradientToCamera{};
  for (std::size_t i = 0; i < 16; ++i)
  {
    boxToCamera[i] = static_cast<float>(frame.View.BoxToCamera[4 * (i % 4) + i / 4]);
  }
  for (std::size_t i = 0; i < 9; ++i)
  {
    gradientToCamera[i] =
      static_cast<float>(cameraToBox->GetElement(static_cast<int>(i / 3), static_cast<int>(i % 3)) *
                         frame.View.EdgeLength[i / 3]);
  }
  program->SetUniformMatrix4x4("boxToCamera", boxToCamera.data());
  program->SetUniformMatrix3x3("gradientToCamera", gradientToCamera.data());
}
