// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLMessages.h"

#include "vtkOpenGLRenderWindow.h"

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include <sstream>

namespace nexrad::testing
{

namespace
{

/// What VTK causes itself: the shaders of VTK 9.1's ray caster read variables (g_eyePosObj,
/// clip_...) that some of their variants do not set. The slices' shaders have no such names.
bool IsOfVTKsRayCaster(const std::string& message)
{
  return message.find("used uninitialized") != std::string::npos &&
         (message.find("`g_") != std::string::npos || message.find("`clip_") != std::string::npos);
}

/// What NVIDIA's driver says with medium severity where it compiles a shader again for a new state.
bool IsOfRecompiling(GLenum type, const std::string& message)
{
  return type == GL_DEBUG_TYPE_PERFORMANCE &&
         message.find("recompiled based on GL state") != std::string::npos;
}

void GLAPIENTRY Receive(GLenum, GLenum type, GLuint id, GLenum severity, GLsizei,
  const GLchar* message, const void* collector)
{
  const bool grave = type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
                     severity == GL_DEBUG_SEVERITY_HIGH || severity == GL_DEBUG_SEVERITY_MEDIUM;
  if (grave && !IsOfVTKsRayCaster(message) && !IsOfRecompiling(type, message))
  {
    std::ostringstream line;
    line << "OpenGL message " << id << ", type 0x" << std::hex << type << ", severity 0x"
         << severity << ": " << message;
    static_cast<OpenGLMessages*>(const_cast<void*>(collector))->Add(line.str());
  }
}

} // namespace

bool OpenGLMessages::Watch(vtkRenderWindow* window)
{
  vtkOpenGLRenderWindow::SafeDownCast(window)->Initialize();
  window->MakeCurrent();
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  if (10 * major + minor < 43 || glDebugMessageCallback == nullptr)
  {
    return false;
  }
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(&Receive, this);
  glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  return true;
}

std::string OpenGLMessages::Take()
{
  std::string text;
  std::swap(text, this->Text);
  return text;
}

std::map<std::string, int> CountOpenGLObjects()
{
  std::map<std::string, int> counts;
  for (GLuint name = 1; name <= 20000; ++name)
  {
    counts["textures"] += glIsTexture(name) != GL_FALSE;
    counts["buffers"] += glIsBuffer(name) != GL_FALSE;
    counts["framebuffers"] += glIsFramebuffer(name) != GL_FALSE;
    counts["renderbuffers"] += glIsRenderbuffer(name) != GL_FALSE;
    counts["vertex arrays"] += glIsVertexArray(name) != GL_FALSE;
    counts["programs"] += glIsProgram(name) != GL_FALSE;
    counts["shaders"] += glIsShader(name) != GL_FALSE;
  }
  return counts;
}

} // namespace nexrad::testing
