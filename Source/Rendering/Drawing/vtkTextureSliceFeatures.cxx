// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceFeatures.h"

#include "vtkTextureSlicePeeling.h"
#include "vtkVersionMacros.h"
#include "vtkVolumeMapper.h"

#include <utility>

namespace
{

/// Highlights where the eye sees the light mirrored (Phong), as VTK draws them from 9.2 on, and not
/// where the surface faces half-way between light and eye (Blinn).
constexpr bool MirroredHighlights = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0);

/// Where a ray ends, because what is behind adds less than a quarter of one of 255.
constexpr const char* Opaque = "(1023.0 / 1024.0)";
/// What each ray has, however short its way.
constexpr const char* LeastSamples = "2.0";
constexpr const char* LeastSlabs = "4.0";

/// What a table of so many rows is in the shader.
const char* SamplerOf(int rows)
{
  return rows == 1 ? "sampler1D" : "sampler2D";
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
      {"ROWS", this->CountRows()}, {"LABEL_ROWS", this->CountLabelRows()},
      {"CLIPPING_PLANES", this->ClippingPlanes}, {"PEEL_OUTSIDE", vtkTextureSlicePeeling::Outside},
      {"PEEL_BETWEEN", vtkTextureSlicePeeling::Between},
      {"PEEL_REST", vtkTextureSlicePeeling::Rest}})
  {
    define(name, std::to_string(number));
  }
  // Defined where they are above 0.
  for (const auto& [name, number] :
    {Named("MASKED", this->Masked), {"BLANKED", this->Blanked}, {"RECTILINEAR", this->Rectilinear},
      {"CROPPED", this->Cropped}, {"PARALLEL", this->Parallel},
      {"GRADIENT_OPACITY", this->GradientOpacity}, {"SMOOTH_GRADIENT", this->SmoothGradient},
      {"CLIPPED_SCALARS", this->ClippedScalars && this->ClippingPlanes > 0},
      {"TABLE_2D", this->Table2D}, {"EXTREME_SAMPLE", this->ExtremeSample},
      {"GRADIENT", this->NeedsGradient()}, {"SECOND_ARRAY", this->SecondArray},
      {"SECOND_MASKED", this->SecondMasked}, {"BINARY_MASK", this->BinaryMask},
      {"SELECTION", this->Selection}, {"SHADOWS", this->Shadows},
      {"LABELS", this->Labels}, {"MIRRORED_HIGHLIGHTS", MirroredHighlights},
      {"SKIPPING", this->Skipping}, {"SLABS", this->Slabs ? SlabsOfPiece : 0}, {"PEEL", this->Peel},
      {"PLACES", this->Places}, {"ISO_VALUES", this->IsoValues}, {"CONTOURS", this->Contours}})
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
  define("LABEL_TABLE", SamplerOf(this->CountLabelRows()));
  define("INTEGRAL_TABLE", this->GetIntegralDimensions() == 1 ? "sampler1D" : "sampler2D");
  define("OPAQUE", Opaque);
  define("LEAST_SLICES", this->Slabs ? LeastSlabs : LeastSamples);
  return defines;
}
