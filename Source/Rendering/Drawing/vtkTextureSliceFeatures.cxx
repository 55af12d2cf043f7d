// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceFeatures.h"

#include "vtkTextureSlicePeeling.h"

#include "vtkVersionMacros.h"
#include "vtkVolumeMapper.h"

namespace
{

void Define(std::string& defines, const char* name, int value)
{
  defines += std::string("#define TEXTURE_SLICE_") + name + ' ' + std::to_string(value) + '\n';
}

void DefineIf(bool condition, std::string& defines, const char* name)
{
  if (condition)
  {
    Define(defines, name, 1);
  }
}

/// Highlights where the eye sees the light mirrored (Phong), as VTK draws them from 9.2 on, and not
/// where the surface faces half-way between light and eye (Blinn).
constexpr bool MirroredHighlights = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0);

/// Where a ray ends, because what is behind adds less than a quarter of one of 255.
constexpr const char* Opaque = "(1023.0 / 1024.0)";
/// What each ray has, however short its way.
constexpr const char* LeastSamples = "2.0";
constexpr const char* LeastSlabs = "4.0";

/// What a vtkTextureSliceTable of so many rows is in the shader.
const char* SamplerOf(int rows)
{
  return rows == 1 ? "sampler1D" : "sampler2D";
}

} // namespace

std::string vtkTextureSliceFeatures::GetDefines() const
{
  std::string defines;
  Define(defines, "COMPOSITE", vtkVolumeMapper::COMPOSITE_BLEND);
  Define(defines, "MAXIMUM", vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
  Define(defines, "MINIMUM", vtkVolumeMapper::MINIMUM_INTENSITY_BLEND);
  Define(defines, "AVERAGE", vtkVolumeMapper::AVERAGE_INTENSITY_BLEND);
  Define(defines, "ADDITIVE", vtkVolumeMapper::ADDITIVE_BLEND);
  Define(defines, "ISOSURFACE", vtkVolumeMapper::ISOSURFACE_BLEND);
  Define(defines, "PLANE", vtkVolumeMapper::SLICE_BLEND);
  Define(defines, "BLEND", this->BlendMode);
  Define(defines, "COMPONENTS", this->Components);
  Define(defines, "FUNCTIONS", this->Functions);
  Define(defines, "ROWS", this->CountRows());
  DefineIf(this->Masked, defines, "MASKED");
  DefineIf(this->Blanked, defines, "BLANKED");
  DefineIf(this->Rectilinear, defines, "RECTILINEAR");
  DefineIf(this->Cropped, defines, "CROPPED");
  DefineIf(this->Parallel, defines, "PARALLEL");
  DefineIf(this->GradientOpacity, defines, "GRADIENT_OPACITY");
  DefineIf(this->SmoothGradient, defines, "SMOOTH_GRADIENT");
  DefineIf(this->ClippedScalars && this->ClippingPlanes > 0, defines, "CLIPPED_SCALARS");
  DefineIf(this->Table2D, defines, "TABLE_2D");
  DefineIf(this->ExtremeSample, defines, "EXTREME_SAMPLE");
  DefineIf(this->NeedsGradient(), defines, "GRADIENT");
  if (this->SecondArray > 0)
  {
    Define(defines, "SECOND_ARRAY", this->SecondArray);
    DefineIf(this->SecondMasked, defines, "SECOND_MASKED");
  }
  DefineIf(this->BinaryMask, defines, "BINARY_MASK");
  DefineIf(this->Selection, defines, "SELECTION");
  DefineIf(this->Shadows, defines, "SHADOWS");
  DefineIf(this->Scattering, defines, "SCATTERING");
  defines += std::string("#define TEXTURE_SLICE_TABLE ") + SamplerOf(this->CountRows()) + '\n';
  if (this->Labels > 0)
  {
    defines +=
      std::string("#define TEXTURE_SLICE_LABEL_TABLE ") + SamplerOf(this->CountLabelRows()) + '\n';
    Define(defines, "LABELS", this->Labels);
    Define(defines, "LABEL_ROWS", this->CountLabelRows());
  }
  if (this->Lights >= 0)
  {
    Define(defines, "LIGHTS", this->Lights);
    DefineIf(MirroredHighlights, defines, "MIRRORED_HIGHLIGHTS");
  }
  Define(defines, "CLIPPING_PLANES", this->ClippingPlanes);
  DefineIf(this->Skipping, defines, "SKIPPING");
  DefineIf(this->Places, defines, "PLACES");
  defines += "#define TEXTURE_SLICE_OPAQUE " + std::string(Opaque) + '\n';
  defines += "#define TEXTURE_SLICE_LEAST_SLICES " +
             std::string(this->Slabs ? LeastSlabs : LeastSamples) + '\n';
  if (this->Slabs)
  {
    Define(defines, "SLABS", SlabsOfPiece);
    defines += std::string("#define TEXTURE_SLICE_INTEGRAL_TABLE ") +
               (this->GetIntegralDimensions() == 1 ? "sampler1D" : "sampler2D") + '\n';
  }
  if (this->Peel > 0)
  {
    Define(defines, "PEEL", this->Peel);
    Define(defines, "PEEL_OUTSIDE", vtkTextureSlicePeeling::Outside);
    Define(defines, "PEEL_BETWEEN", vtkTextureSlicePeeling::Between);
    Define(defines, "PEEL_REST", vtkTextureSlicePeeling::Rest);
  }
  if (this->IsoValues > 0)
  {
    Define(defines, "ISO_VALUES", this->IsoValues);
  }
  if (this->Contours > 0)
  {
    Define(defines, "CONTOURS", this->Contours);
  }
  return defines;
}
