// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceRequest.h"

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceTarget.h"
#include "vtkVersionMacros.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <utility>

namespace
{

/// Highlights where the eye sees the light mirrored (Phong), as VTK draws them from 9.2 on, and not
/// where the surface faces half-way between light and eye (Blinn).
constexpr bool MirroredHighlights = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0);

/// What a table of so many rows is in the shader.
const char* SamplerOf(int rows)
{
  return rows == 1 ? "sampler1D" : "sampler2D";
}

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

/// @param contours nullptr: there are no values.
std::vector<double> GetValues(vtkContourValues* contours)
{
  return contours != nullptr ? std::vector<double>(contours->GetValues(),
                                 contours->GetValues() + contours->GetNumberOfContours())
                             : std::vector<double>();
}

/// The scalar that is full red, green or blue where scalars are colours: VTK takes only bytes.
constexpr double FullColor = 255.0;

/// Where scalars lie in the ranges of the components; 0 beyond the last one.
std::array<float, 4> NormalizeAll(
  double scalar, const std::vector<vtkTextureSliceComponent>& components)
{
  std::array<float, 4> values{};
  std::transform(components.begin(), components.end(), values.begin(),
    [scalar](const vtkTextureSliceComponent& component) { return Normalized(scalar, component); });
  return values;
}

/// The first of these texts whose condition holds; nullptr if none does.
const char* FindFirst(std::initializer_list<std::pair<bool, const char*>> texts)
{
  const auto* const first =
    std::find_if(texts.begin(), texts.end(), [](const auto& text) { return text.first; });
  return first != texts.end() ? first->second : nullptr;
}

} // namespace

std::string vtkTextureSliceFeatures::GetDefines() const
{
  std::string defines;
  const auto define = [&defines](const char* name, const std::string& text)
  { defines += std::string("#define TEXTURE_SLICE_") + name + ' ' + text + '\n'; };
  using Named = std::pair<const char*, int>;
  for (const auto& [name, number] :
    {Named("COMPOSITE", vtkVolumeMapper::COMPOSITE_BLEND),
      {"MAXIMUM", vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND},
      {"MINIMUM", vtkVolumeMapper::MINIMUM_INTENSITY_BLEND},
      {"AVERAGE", vtkVolumeMapper::AVERAGE_INTENSITY_BLEND},
      {"ADDITIVE", vtkVolumeMapper::ADDITIVE_BLEND},
      {"ISOSURFACE", vtkVolumeMapper::ISOSURFACE_BLEND}, {"PLANE", vtkVolumeMapper::SLICE_BLEND},
      {"BLEND", this->BlendMode}, {"COMPONENTS", this->Components}, {"FUNCTIONS", this->Functions},
      {"ROWS", this->CountRows()}, {"CLIPPING_PLANES", this->ClippingPlanes},
      {"PEEL_OUTSIDE", vtkTextureSlicePeeling::Outside},
      {"PEEL_BETWEEN", vtkTextureSlicePeeling::Between},
      {"PEEL_REST", vtkTextureSlicePeeling::Rest}})
  {
    define(name, std::to_string(number));
  }
  // Defined where they are above 0.
  for (const auto& [name, number] :
    {Named("MASKED", this->Masked), {"PAGED", this->Paged}, {"BLANKED", this->Blanked},
      {"RECTILINEAR", this->Rectilinear}, {"CROPPED", this->Cropped}, {"PARALLEL", this->Parallel},
      {"GRADIENT_OPACITY", this->GradientOpacity}, {"SMOOTH_GRADIENT", this->SmoothGradient},
      {"CLIPPED_SCALARS", this->ClippedScalars && this->ClippingPlanes > 0},
      {"TABLE_2D", this->Table2D}, {"EXTREME_SAMPLE", this->ExtremeSample},
      {"GRADIENT", this->NeedsGradient()}, {"SECOND_ARRAY", this->SecondArray},
      {"SECOND_MASKED", this->SecondMasked}, {"BINARY_MASK", this->BinaryMask},
      {"SELECTION", this->Selection}, {"SHADOWS", this->Shadows},
      {"LIT_TURNS", this->Shadows && this->HasJoinedLight()}, {"LABELS", this->Labels},
      {"MIRRORED_HIGHLIGHTS", MirroredHighlights}, {"SKIPPING", this->Skipping},
      {"SLABS", this->Slabs ? SlabsOfPiece : 0}, {"PEEL", this->Peel}, {"PLACES", this->Places},
      {"ISO_VALUES", this->IsoValues}, {"CONTOURS", this->Contours}})
  {
    if (number > 0)
    {
      define(name, std::to_string(number));
    }
  }
  if (this->Lights >= 0)
  {
    define("LIGHTS", std::to_string(this->Lights));
  }
  define("TABLE", SamplerOf(this->CountRows()));
  define("INTEGRAL_TABLE", SamplerOf(this->CountFunctions()));
  return defines;
}

const char* vtkTextureSliceRequest::FindUnsupported() const
{
  const char* refused = FindFirst({{this->Mapper->GetInputCount() > 1,
                                     "several volumes in one mapper are not supported: give each a "
                                     "mapper of its own"},
    {this->BlendMode < vtkVolumeMapper::COMPOSITE_BLEND ||
        this->BlendMode > vtkVolumeMapper::SLICE_BLEND,
      "the blend mode must be composite, maximum, minimum, average, "
      "additive, isosurface or slice"},
    {this->Components > 4, "the scalars must have 1 to 4 components"}});
  if (refused != nullptr || this->Property == nullptr)
  {
    return refused;
  }
  const bool has2D = this->Has2D();
  const bool dependent = this->Components > 0 && !this->IsIndependent();
  const bool namesSecond = has2D && this->Components > 0 && this->NamesSecondArray;
  const int second = this->ReadsSecondArray() ? this->SecondArray->GetNumberOfComponents() : 0;
  return FindFirst({{this->BlendMode == vtkVolumeMapper::SLICE_BLEND &&
                        this->GetSlicePlane() == nullptr,
                      "slice blending needs a vtkPlane with a normal: call SetSliceFunction on the "
                      "property"},
    {has2D && this->BlendMode != vtkVolumeMapper::COMPOSITE_BLEND,
      "two-dimensional transfer functions are supported in the composite blend mode alone: use it "
      "or TF_1D"},
    {namesSecond && this->SecondArray == nullptr,
      "the volume has no array of the name that SetTransfer2DYAxisArray was given, beside its "
      "scalars: name another one, or call SetTransfer2DYAxisArray with nullptr"},
    {namesSecond && (second > 4 || (!dependent && second < this->Components)),
      "the second array of two-dimensional transfer functions must have a component for each set "
      "of functions, and 4 at most: name another one, or call SetTransfer2DYAxisArray with "
      "nullptr"},
    {this->HasMask(vtkGPUVolumeRayCastMapper::LabelMapMaskType) && (this->Components > 1 || has2D),
      "a label map is supported for one component with one-dimensional transfer functions alone: "
      "call SetMaskInput with nullptr"},
    {dependent && this->Components != 2 && this->Components != 4,
      "one or three dependent components are not supported, only 2 (value, opacity) and 4 (RGBA): "
      "call IndependentComponentsOn"},
    {dependent && this->Components == 4 && this->ScalarType != VTK_UNSIGNED_CHAR,
      "four dependent components must be unsigned char: call IndependentComponentsOn"},
    {this->BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND &&
        (this->Components > 2 || (this->Components == 2 && !dependent)),
      "isosurfaces are supported for one component and for two dependent ones (colour, surface) "
      "alone: choose one component, or call IndependentComponentsOff"}});
}

std::size_t vtkTextureSliceRequest::CountMostBytes() const
{
  const vtkIdType most = this->Mapper->GetMaxMemoryInBytes();
  return most > 0 ? static_cast<std::size_t>(most) : vtkTextureSlicePages::UsualMemory;
}

std::vector<double> vtkTextureSliceRequest::GetIsoValues() const
{
  const bool has = this->BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND;
  std::vector<double> values = GetValues(has ? this->Property->GetIsoSurfaceValues() : nullptr);
  std::sort(values.begin(), values.end());
  return values;
}

std::vector<double> vtkTextureSliceRequest::GetContours() const
{
  const bool has =
    this->BlendMode == vtkVolumeMapper::COMPOSITE_BLEND && this->Mapper->GetUseDepthPass() != 0;
  return GetValues(has ? this->Mapper->GetDepthPassContourValues() : nullptr);
}

bool vtkTextureSliceRequest::HasMask(int type) const
{
  return this->Mapper->GetMaskInput() != nullptr && this->Mapper->GetMaskType() == type;
}

vtkPlane* vtkTextureSliceRequest::GetSlicePlane() const
{
  auto* plane = this->BlendMode == vtkVolumeMapper::SLICE_BLEND
                  ? vtkPlane::SafeDownCast(this->Property->GetSliceFunction())
                  : nullptr;
  return plane != nullptr && vtkMath::Norm(plane->GetNormal()) > 0.0 ? plane : nullptr;
}

int vtkTextureSliceRequest::CountLabels() const
{
  // Labels choose the colour of a sample; projections show none.
  const bool used = this->HasMask(vtkGPUVolumeRayCastMapper::LabelMapMaskType) &&
                    (this->BlendMode == vtkVolumeMapper::COMPOSITE_BLEND ||
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
  features.Functions = this->GetFunctions(this->Components - 1) + 1;
  const bool isExtreme = this->BlendMode == vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND ||
                         this->BlendMode == vtkVolumeMapper::MINIMUM_INTENSITY_BLEND;
  features.ExtremeSample = isExtreme && this->Components > 1 && !this->IsIndependent();
  features.GradientOpacity = this->ShowsPlaces() && this->HasGradientOpacity();
  features.SmoothGradient = this->Mapper->GetSmoothGradient();
  features.ClippedScalars = this->Property->GetUseClippedVoxelIntensity() != 0;
  features.Table2D = this->Has2D();
  features.SecondArray = this->ReadsSecondArray() ? this->SecondArray->GetNumberOfComponents() : 0;
  features.BinaryMask = this->HasMask(vtkGPUVolumeRayCastMapper::BinaryMaskType);
  features.Labels = this->CountLabels();
  features.IsoValues = static_cast<int>(this->GetIsoValues().size());
  features.Contours = static_cast<int>(this->GetContours().size());
  // One-dimensional functions of interpolated scalars.
  features.Slabs = this->Mapper->GetPreIntegration() && features.Contours == 0 &&
                   this->BlendMode == vtkVolumeMapper::COMPOSITE_BLEND && !this->Has2D() &&
                   !this->IsNearest();
  return features;
}

vtkTextureSliceRow vtkTextureSliceRequest::MakeRow(int functions, int label,
  const vtkTextureSliceComponent& color, const vtkTextureSliceComponent& opacity) const
{
  // What a label has no function for is as it is without a label.
  vtkTextureSliceRow row;
  vtkColorTransferFunction* colorOfLabel =
    label > 0 ? this->Property->GetLabelColor(label) : nullptr;
  vtkPiecewiseFunction* opacityOfLabel =
    label > 0 ? this->Property->GetLabelScalarOpacity(label) : nullptr;
  if (colorOfLabel != nullptr)
  {
    row.Color = colorOfLabel;
  }
  else if (this->Property->GetColorChannels(functions) == 1)
  {
    row.Gray = this->Property->GetGrayTransferFunction(functions);
  }
  else
  {
    row.Color = this->Property->GetRGBTransferFunction(functions);
  }
  const auto native = vtkGPUVolumeRayCastMapper::NATIVE;
  row.ColorDomain = {
    color.Range, colorOfLabel == nullptr && this->Mapper->GetColorRangeType() == native};
  row.Opacity =
    opacityOfLabel != nullptr ? opacityOfLabel : this->Property->GetScalarOpacity(functions);
  row.OpacityDomain = {opacity.Range,
    opacityOfLabel == nullptr && this->Mapper->GetScalarOpacityRangeType() == native};
  row.OpticalDepth = this->BlendMode == vtkVolumeMapper::COMPOSITE_BLEND;
  return row;
}

std::vector<vtkTextureSliceRow> vtkTextureSliceRequest::MakeRows(
  const std::vector<vtkTextureSliceComponent>& components) const
{
  const vtkTextureSliceFeatures features = this->GetFeatures();
  const bool native =
    this->Mapper->GetGradientOpacityRangeType() == vtkGPUVolumeRayCastMapper::NATIVE;
  std::vector<vtkTextureSliceRow> rows;
  for (int i = 0; i < features.CountRows(); ++i)
  {
    const int function = i % features.CountFunctions();
    const int label = std::max(0, function - features.Functions + 1);
    const int set = label > 0 ? 0 : function;
    const auto& color = components[static_cast<std::size_t>(set)];
    const auto& opacity = features.Functions > 1 ? color : components.back();
    if (i == function)
    {
      rows.push_back(this->MakeRow(set, label, color, opacity));
      continue;
    }
    vtkPiecewiseFunction* ofLabel =
      label > 0 ? this->Property->GetLabelGradientOpacity(label) : nullptr;
    vtkTextureSliceRow row;
    row.Opacity = ofLabel != nullptr ? ofLabel : this->Property->GetGradientOpacity(set);
    row.OpacityDomain = {{0.0, GradientRange * Width(opacity)}, label == 0 && native};
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

double vtkTextureSliceRequest::GetWeight(int component) const
{
  return this->IsIndependent() && this->Components > 1
           ? this->Property->GetComponentWeight(component)
           : 1.0;
}

void vtkTextureSliceRequest::SetMaterials(vtkShaderProgram* program) const
{
  std::vector<float> weights;
  std::vector<float> ratios;
  std::vector<float> materials;
  for (int i = 0; i < this->Components; ++i)
  {
    const int functions = this->GetFunctions(i);
    weights.push_back(static_cast<float>(this->GetWeight(i)));
    ratios.push_back(static_cast<float>(this->GetUnitDistance(0) / this->GetUnitDistance(i)));
    for (const double returned :
      {this->Property->GetAmbient(functions), this->Property->GetDiffuse(functions),
        this->Property->GetSpecular(functions), this->Property->GetSpecularPower(functions)})
    {
      materials.push_back(static_cast<float>(returned));
    }
  }
  SetValues(program, "componentWeight", weights);
  SetValues(program, "unitDistanceRatio", ratios);
  program->SetUniform4fv("material", this->Components, materials.data());
}

std::vector<float> vtkTextureSliceRequest::FindIsoValues(
  const std::vector<vtkTextureSliceComponent>& components) const
{
  return Normalize(this->GetIsoValues(), components.back());
}

void vtkTextureSliceRequest::SetUniforms(const std::vector<vtkTextureSliceComponent>& components,
  const std::vector<vtkTextureSliceComponent>& second, vtkShaderProgram* program) const
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
  SetScales(second, "secondScale", "secondBias", program);
  program->SetUniform4f(
    "clippedScalars", NormalizeAll(this->Property->GetClippedVoxelIntensity(), targets).data());
  SetValues(program, "isoValues", this->FindIsoValues(components));
  this->SetMaterials(program);
  SetValues(program, "contours", Normalize(this->GetContours(), components.front()));
  const double* range = this->Mapper->GetAverageIPScalarRange();
  program->SetUniform4f("averageFrom", NormalizeAll(range[0], components).data());
  program->SetUniform4f("averageTo", NormalizeAll(range[1], components).data());
}
