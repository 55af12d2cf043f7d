// SPDX-License-Identifier: BSD-3-Clause
// A fragment shader that runs for each pixel of the volume's box.
#ifndef vtkTextureSliceBox_h
#define vtkTextureSliceBox_h

#include "vtkNew.h"

#include <array>
#include <functional>
#include <string>

class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureSliceFrame;

class vtkTextureSliceBox
{
public:
  vtkTextureSliceBox();
  ~vtkTextureSliceBox();

  /**
   * Makes the shader the current one.
   * @param key what the shader depends on: it is made anew when this changes.
   * @return nullptr if it does not compile
   */
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, const std::string& key,
    const std::function<std::string()>& makeShader);
  /**
   * After Ready.
   * @param seen the part of the box whose pixels are drawn: lower x, upper x, lower y and so on.
   * @param times how often, one after the other: the shader gets the number as "slice".
   */
  void Draw(const vtkTextureSliceFrame& frame, const std::array<double, 6>& seen, int times = 1);
  void ReleaseGraphicsResources();

private:
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray; ///< OpenGL draws with one, although it is empty
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkShaderProgram* Program = nullptr; ///< the shader cache owns it
  std::string Key;
};

#endif
