// SPDX-License-Identifier: BSD-3-Clause
// The shaders that go along a pixel's ray, put together from their parts.
#ifndef vtkTextureSliceShader_h
#define vtkTextureSliceShader_h

#include <string>

namespace vtkTextureSliceShader
{

/**
 * @param main the shader that has a place for the parts: fragment, compute or polygon
 * @param defines see vtkTextureSliceFeatures::GetDefines
 */
std::string Make(const char* main, const std::string& defines);
/// The same with the rays of a trial in place of the parts.
std::string MakeTrial(const char* main);

} // namespace vtkTextureSliceShader

#endif
