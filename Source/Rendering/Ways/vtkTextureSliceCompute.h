// SPDX-License-Identifier: BSD-3-Clause
// Compute shaders that store into a picture, one invocation a pixel.
#ifndef vtkTextureSliceCompute_h
#define vtkTextureSliceCompute_h

#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <map>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkTextureSliceFrame;

/// Pixels of a picture: lower left column and row, then the column and the row where they end.
using vtkTextureSlicePixels = std::array<int, 4>;

/**
 * VTK 9.1 has no class for compute shaders. The program here is a vtkShaderProgram, so that VTK's
 * record of the current program and its functions for uniforms hold for it too.
 */
class vtkTextureSliceCompute
{
public:
  /// Whether the context that is current has compute shaders (OpenGL 4.3, or 4.2 with
  /// ARB_compute_shader), large enough groups, and can store into a picture of 16-bit floats.
  static bool IsSupported();

  /**
   * Makes the shader the current one.
   * @param key what the shader depends on: each key has a program, until the release.
   * @param makeShader returns a shader like TextureSliceCS, whose version is put in here.
   * @return nullptr if it does not compile
   */
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, const std::string& key,
    const std::function<std::string()>& makeShader);
  /// After Ready: stores into those pixels of a picture of 16-bit floats, which may be read
  /// afterwards.
  void Dispatch(vtkTextureObject* picture, const vtkTextureSlicePixels& pixels);
  void ReleaseGraphicsResources(vtkOpenGLRenderWindow* window);

  /// The smallest rectangle with all pixels of a part of the box (lower x, upper x, lower y and so
  /// on) in a picture of that size; the whole picture where a corner is not in front of the eye.
  static vtkTextureSlicePixels FindPixels(const vtkTextureSliceFrame& frame,
    const std::array<double, 6>& part, const std::array<int, 2>& size);

private:
  std::map<std::string, vtkSmartPointer<vtkShaderProgram>> Programs;
  vtkShaderProgram* Program = nullptr; ///< that is ready
};

#endif
