// SPDX-License-Identifier: BSD-3-Clause
// A fragment shader that runs for each pixel of the viewport.
#ifndef vtkTextureSliceScreen_h
#define vtkTextureSliceScreen_h

#include "vtkNew.h"

#include <functional>
#include <string>

class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;

class vtkTextureSliceScreen
{
public:
  vtkTextureSliceScreen();
  ~vtkTextureSliceScreen();

  /**
   * Makes the shader the current one.
   * @param key what the shader depends on: it is made anew when this changes.
   * @return nullptr if it does not compile
   */
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, const std::string& key,
    const std::function<std::string()>& makeShader);
  /// After Ready.
  void Draw();
  void ReleaseGraphicsResources();

private:
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray; ///< OpenGL draws with one, although it is empty
  vtkShaderProgram* Program = nullptr;            ///< the shader cache owns it
  std::string Key;
};

#endif
