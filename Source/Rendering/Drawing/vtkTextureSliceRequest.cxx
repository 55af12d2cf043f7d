// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceRequest.h"

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <set>

namespace
{

/// VTK's ray caster spreads gradient opacity over a quarter of the scalars' range.
constexpr double GradientRange = 0.25;

double Width(const vtkTextureSliceComponent& component)
{
  return component.Range[1] > component.Range[0] ? component.Range[1] - component.Range[0] : 1.0;
}

/// Where a scalar lies in the component's range, 0 to 1 inside it.
float Normalized(double scalar, const vtkTextureSliceComponent& component)
{
  return static_cast<float>((scalar - component.Range[0]) / Width(component));
}

/// How texels become 0 to 1 over the range of each component.
void SetScales(const std::vector<vtkTextureSliceComponent>& components, const char* scaleName,
  const char* biasName, vtkShaderProgram* program)
{
  std::array<float, 4> scale{1.0f, 1.0f, 1.0f, 1.0f};
  std::array<float, 4> bias{};
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    scale[c] = static_cast<float>(components[c].Scale / Width(components[c]));
    bias[c] = Normalized(components[c].Bias, components[c]);
  }
  program->SetUniform4f(scaleName, scale.data());
  program->SetUniform4f(biasName, bias.data());
}

std::vector<float> Normalize(
  const std::vector<double>& scalars, const vtkTextureSliceComponent& component)
{
  std::vector<float> values;
  for (const double scalar : scalars)
  {
    values.push_back(Normalized(scalar, component));
  }
  return values;
}

void SetValues(vtkShaderProgram* program, const char* name, const std::vector<float>& values)
{
  program->SetUniform1fv(name, static_cast<int>(values.size()), values.data());
}

/// Whether a function is 1 whatever it is asked for.
bool IsOneEverywhere(vtkPiecewiseFunction* function)
{
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4]; // place, value, midpoint, sharpness
    function->GetNodeValue(i, node);
    if (node[1] != 1.0)
    {
      return false;
    }
  }
  return function->GetSize() > 0 && function->GetClamping() != 0;
}

/// The scalar that is full red, green or blue where scalars are colours: VTK takes only bytes.
constexpr double FullColor = 255.0;

bool IsExtreme(int blendMode)
{
  return blendMode == vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND ||
         blendMode == vtkVolumeMapper::MINIMUM_INTENSITY_BLEND;
}

} // namespace

const char* vtkTextureSliceRequest::FindUnsupported() const
{
  if (this->BlendMode < vtkVolumeMapper::COMPOSITE_BLEND ||
      this->BlendMode > vtkVolumeMapper::SLICE_BLEND)
  {
    return "the blend mode must be composite, maximum, minimum, average, additive, isosurface or "
           "slice";
  }
  if (this->Components > 4)
  {
    return "the scalars must have 1 to 4 components";
  }
  if (this->Property == nullptr)
  {
    return nullptr;
  }
  if (this->BlendMode == vtkVolumeMapper::SLICE_BLEND && this->GetSlicePlane() == nullptr)
  {
    return "slice blending needs a vtkPlane with a normal: call SetSliceFunction on the property";
  }
  const bool composite = this->BlendMode == vtkVolumeMapper::COMPOSITE_BLEND;
  if (this->Has2D() && !composite)
  {
    return "two-dimensional transfer functions are supported in the composite blend mode alone: "
           "use "
           "it or TF_1D";
  }
  if (const char* unsupported = this->FindUnsupportedSecondArray())
  {
    return unsupported;
  }
  if (this->LabelMap && (this->Components > 1 || this->Has2D()))
  {
    return "a label map is supported for one component with one-dimensional transfer functions "
           "alone: call SetMaskInput with nullptr";
  }
  const bool dependent = this->Components > 0 && !this->IsIndependent();
  if (dependent && this->Components != 2 && this->Components != 4)
  {
    return "one or three dependent components are not supported, only 2 (value, opacity) and 4 "
           "(RGBA): call IndependentComponentsOn";
  }
  if (dependent && this->Components == 4 && this->ScalarType != VTK_UNSIGNED_CHAR)
  {
    return "four dependent components must be unsigned char: call IndependentComponentsOn";
  }
  if (this->BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND &&
      (this->Components > 2 || (this->Components == 2 && !dependent)))
  {
    return "isosurfaces are supported for one component and for two dependent ones (colour, "
           "surface) "
           "alone: choose one component, or call IndependentComponentsOff";
  }
  return nullptr;
}

const char* vtkTextureSliceRequest::FindUnsupportedSecondArray() const
{
  if (!this->Has2D() || this->Components == 0)
  {
    return nullptr;
  }
  const int functions = this->IsIndependent() ? this->Components : 1;
  if (this->SecondArray < 0)
  {
    return "the volume has no array of the name that SetTransfer2DYAxisArray was given, beside its "
           "scalars: name another one, or call SetTransfer2DYAxisArray with nullptr";
  }
  if (this->SecondArray > 4 || (this->SecondArray > 0 && this->SecondArray < functions))
  {
    return "the second array of two-dimensional transfer functions must have a component for each "
           "set of functions, and 4 at most: name another one, or call SetTransfer2DYAxisArray "
           "with nullptr";
  }
  return nullptr;
}

const char* vtkTextureSliceRequest::FindUnsupportedRange(
  const std::vector<vtkTextureSliceComponent>& components) const
{
  // The picture holds one number of samples for all components.
  const bool counted = std::all_of(components.begin(), components.end(),
    [this](const vtkTextureSliceComponent& component)
    {
      return this->AverageRange[0] <= component.Range[0] &&
             component.Range[1] <= this->AverageRange[1];
    });
  if (this->BlendMode == vtkVolumeMapper::AVERAGE_INTENSITY_BLEND && components.size() > 1 &&
      this->IsIndependent() && !counted)
  {
    return "an average over part of the scalars' range is supported for one component alone: widen "
           "AverageIPScalarRange";
  }
  return nullptr;
}

std::vector<double> vtkTextureSliceRequest::GetIsoValues() const
{
  std::vector<double> values;
  if (this->BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND)
  {
    vtkContourValues* contours = this->Property->GetIsoSurfaceValues();
    values.assign(contours->GetValues(), contours->GetValues() + contours->GetNumberOfContours());
    std::sort(values.begin(), values.end());
  }
  return values;
}

vtkPlane* vtkTextureSliceRequest::GetSlicePlane() const
{
  auto* plane = this->BlendMode == vtkVolumeMapper::SLICE_BLEND
                  ? vtkPlane::SafeDownCast(this->Property->GetSliceFunction())
                  : nullptr;
  return plane != nullptr && vtkMath::Norm(plane->GetNormal()) > 0.0 ? plane : nullptr;
}

bool vtkTextureSliceRequest::IsEmpty() const
{
  return this->BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND && this->GetIsoValues().empty();
}

bool vtkTextureSliceRequest::IsNearest() const
{
  return this->Property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
}

bool vtkTextureSliceRequest::IsIndependent() const
{
  return this->Property->GetIndependentComponents() != 0;
}

bool vtkTextureSliceRequest::Has2D() const
{
  return this->Property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D;
}

int vtkTextureSliceRequest::CountLabels() const
{
  // Labels choose the colour of a sample; projections show none.
  const bool used = this->LabelMap && (this->BlendMode == vtkVolumeMapper::COMPOSITE_BLEND ||
                                        this->BlendMode == vtkVolumeMapper::SLICE_BLEND);
  const std::set<int> labels = used ? this->Property->GetLabelMapLabels() : std::set<int>();
  return labels.empty() ? 0 : *labels.rbegin();
}

bool vtkTextureSliceRequest::ShowsPlaces() const
{
  return this->BlendMode == vtkVolumeMapper::COMPOSITE_BLEND ||
         this->BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND ||
         this->BlendMode == vtkVolumeMapper::SLICE_BLEND;
}

bool vtkTextureSliceRequest::IntegratesSlabs() const
{
  return this->PreIntegration && this->Contours.empty() &&
         this->BlendMode == vtkVolumeMapper::COMPOSITE_BLEND && !this->Has2D() &&
         !this->IsNearest();
}

bool vtkTextureSliceRequest::IsShaded() const
{
  return this->ShowsPlaces() && this->Property->GetShade(0) != 0;
}

bool vtkTextureSliceRequest::HasGradientOpacity() const
{
  if (this->Has2D())
  {
    return false; // the functions know the gradient themselves
  }
  const int functions = this->IsIndependent() ? this->Components : 1;
  bool has = this->CountLabels() > 0 && this->Property->HasLabelGradientOpacity();
  for (int i = 0; i < functions; ++i)
  {
    has = has || (this->Property->HasGradientOpacity(i) &&
                   !IsOneEverywhere(this->Property->GetGradientOpacity(i)));
  }
  return has;
}

vtkTextureSliceFeatures vtkTextureSliceRequest::GetFeatures() const
{
  vtkTextureSliceFeatures features;
  features.BlendMode = this->BlendMode;
  features.Components = this->Components;
  features.Functions = this->IsIndependent() ? this->Components : 1;
  features.ExtremeSample =
    IsExtreme(this->BlendMode) && this->Components > 1 && !this->IsIndependent();
  features.GradientOpacity = this->ShowsPlaces() && this->HasGradientOpacity();
  features.SmoothGradient = this->SmoothGradient;
  features.ClippedScalars = this->Property->GetUseClippedVoxelIntensity() != 0;
  features.Table2D = this->Has2D();
  features.SecondArray = this->ReadsSecondArray() ? this->SecondArray : 0;
  features.BinaryMask = this->BinaryMask;
  features.Labels = this->CountLabels();
  features.Slabs = this->IntegratesSlabs();
  features.IsoValues = static_cast<int>(this->GetIsoValues().size());
  features.Contours = static_cast<int>(this->Contours.size());
  return features;
}

vtkTextureSliceRow vtkTextureSliceRequest::MakeRow(int functions,
  const vtkTextureSliceComponent& color, const vtkTextureSliceComponent& opacity) const
{
  vtkTextureSliceRow row;
  if (this->Property->GetColorChannels(functions) == 1)
  {
    row.Gray = this->Property->GetGrayTransferFunction(functions);
  }
  else
  {
    row.Color = this->Property->GetRGBTransferFunction(functions);
  }
  row.ColorDomain = {color.Range, this->NativeColor};
  row.Opacity = this->Property->GetScalarOpacity(functions);
  row.OpacityDomain = {opacity.Range, this->NativeOpacity};
  row.OpticalDepth = this->BlendMode == vtkVolumeMapper::COMPOSITE_BLEND;
  return row;
}

std::vector<vtkTextureSliceRow> vtkTextureSliceRequest::MakeRows(
  const std::vector<vtkTextureSliceComponent>& components) const
{
  const vtkTextureSliceFeatures features = this->GetFeatures();
  std::vector<vtkTextureSliceRow> rows;
  for (int i = 0; i < features.Functions; ++i)
  {
    const auto& own = components[static_cast<std::size_t>(i)];
    rows.push_back(this->MakeRow(i, own, features.Functions > 1 ? own : components.back()));
  }
  for (int i = 0; i < features.Functions && features.GradientOpacity; ++i)
  {
    vtkTextureSliceRow row;
    const auto& range =
      features.Functions > 1 ? components[static_cast<std::size_t>(i)] : components.back();
    row.Opacity = this->Property->GetGradientOpacity(i);
    row.OpacityDomain = {{0.0, GradientRange * Width(range)}, this->NativeGradientOpacity};
    rows.push_back(row);
  }
  return rows;
}

std::vector<vtkTextureSliceRow> vtkTextureSliceRequest::MakeLabelRows(
  const std::vector<vtkTextureSliceComponent>& components) const
{
  // What a label has no function for is as it is without a label.
  const vtkTextureSliceComponent& scalars = components.front();
  const int labels = this->CountLabels();
  std::vector<vtkTextureSliceRow> rows;
  for (int label = 1; label <= labels; ++label)
  {
    vtkTextureSliceRow row = this->MakeRow(0, scalars, scalars);
    if (vtkColorTransferFunction* color = this->Property->GetLabelColor(label))
    {
      row.Gray = nullptr;
      row.Color = color;
      row.ColorDomain = {scalars.Range, false};
    }
    if (vtkPiecewiseFunction* opacity = this->Property->GetLabelScalarOpacity(label))
    {
      row.Opacity = opacity;
      row.OpacityDomain = {scalars.Range, false};
    }
    rows.push_back(row);
  }
  for (int label = 1; label <= labels && this->HasGradientOpacity(); ++label)
  {
    vtkPiecewiseFunction* own = this->Property->GetLabelGradientOpacity(label);
    vtkTextureSliceRow row;
    row.Opacity = own != nullptr ? own : this->Property->GetGradientOpacity(0);
    row.OpacityDomain.Range = {0.0, GradientRange * Width(scalars)};
    rows.push_back(row);
  }
  return rows;
}

std::vector<vtkImageData*> vtkTextureSliceRequest::MakeTables2D() const
{
  const int functions = this->Has2D() ? this->GetFeatures().Functions : 0;
  std::vector<vtkImageData*> tables;
  for (int i = 0; i < functions; ++i)
  {
    tables.push_back(this->Property->GetTransferFunction2D(i));
  }
  return tables;
}

std::vector<vtkTextureSliceSurface> vtkTextureSliceRequest::MakeSurfaces() const
{
  const bool own = this->GetFeatures().Functions > 1;
  std::vector<vtkTextureSliceSurface> surfaces(static_cast<std::size_t>(this->Components));
  for (int i = 0; i < this->Components; ++i)
  {
    const int functions = own ? i : 0;
    vtkTextureSliceSurface& surface = surfaces[static_cast<std::size_t>(i)];
    surface.InverseUnitDistance =
      static_cast<float>(1.0 / this->Property->GetScalarOpacityUnitDistance(functions));
    surface.Weight = own ? static_cast<float>(this->Property->GetComponentWeight(i)) : 1.0f;
    surface.Material = {static_cast<float>(this->Property->GetAmbient(functions)),
      static_cast<float>(this->Property->GetDiffuse(functions)),
      static_cast<float>(this->Property->GetSpecular(functions)),
      static_cast<float>(this->Property->GetSpecularPower(functions))};
  }
  return surfaces;
}

std::vector<float> vtkTextureSliceRequest::FindIsoValues(
  const std::vector<vtkTextureSliceComponent>& components) const
{
  return Normalize(this->GetIsoValues(), components.back());
}

void vtkTextureSliceRequest::SetUniforms(
  const std::vector<vtkTextureSliceComponent>& components, vtkShaderProgram* program) const
{
  std::vector<vtkTextureSliceComponent> targets = components;
  if (this->Components == 4 && !this->IsIndependent())
  {
    std::for_each(targets.begin(), targets.begin() + 3,
      [](vtkTextureSliceComponent& color) {
        color.Range = {0.0, FullColor};
      });
  }
  SetScales(targets, "scalarScale", "scalarBias", program);
  std::array<float, 4> clipped{};
  std::transform(targets.begin(), targets.end(), clipped.begin(),
    [this](const vtkTextureSliceComponent& target)
    { return Normalized(this->Property->GetClippedVoxelIntensity(), target); });
  program->SetUniform4f("clippedScalars", clipped.data());
  SetValues(program, "isoValues", this->FindIsoValues(components));
  SetValues(program, "contours", Normalize(this->Contours, components.front()));
  const std::array<float, 2> averageRange{Normalized(this->AverageRange[0], components[0]),
    Normalized(this->AverageRange[1], components[0])};
  program->SetUniform2f("averageRange", averageRange.data());
}

void vtkTextureSliceRequest::SetSecondArray(
  const std::vector<vtkTextureSliceComponent>& components, vtkShaderProgram* program)
{
  SetScales(components, "secondScale", "secondBias", program);
}
