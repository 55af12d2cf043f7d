// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceShader.h"

#include "vtkShaderProgram.h"

#include "TextureSliceColoringFS.h"
#include "TextureSliceLightingFS.h"
#include "TextureSliceMarchFS.h"
#include "TextureSlicePeelFS.h"
#include "TextureSliceRayFS.h"
#include "TextureSliceSamplesFS.h"
#include "TextureSliceSamplingFS.h"
#include "TextureSliceShadowsFS.h"
#include "TextureSliceSkippingFS.h"
#include "TextureSliceSlabsFS.h"
#include "TextureSliceSurfacesFS.h"
#include "TextureSliceTableFS.h"
#include "TextureSliceTrialFS.h"

namespace
{

std::string PutIn(std::string main, const std::string& parts)
{
  vtkShaderProgram::Substitute(main, "//VTK::TextureSlice::Parts", parts);
  return main;
}

} // namespace

std::string vtkTextureSliceShader::Make(const char* main, const std::string& defines)
{
  std::string parts = defines;
  for (const char* part : {TextureSliceRayFS, TextureSliceSamplingFS, TextureSliceLightingFS,
         TextureSliceShadowsFS, TextureSliceTableFS, TextureSliceColoringFS, TextureSliceSamplesFS,
         TextureSliceSlabsFS, TextureSliceSurfacesFS, TextureSliceSkippingFS, TextureSliceMarchFS})
  {
    parts += part;
  }
  vtkShaderProgram::Substitute(parts, "//VTK::TextureSlice::Peel", TextureSlicePeelFS);
  return PutIn(main, parts);
}

std::string vtkTextureSliceShader::MakeTrial(const char* main)
{
  return PutIn(main, TextureSliceTrialFS);
}
