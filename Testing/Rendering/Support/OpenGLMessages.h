// SPDX-License-Identifier: BSD-3-Clause
// What OpenGL itself says about the calls it is given, and how many objects it holds.
#pragma once

#include <map>
#include <string>

class vtkRenderWindow;

namespace nexrad::testing
{

/**
 * Collects the messages of OpenGL's debug output (GL_KHR_debug): errors, undefined behaviour, and
 * whatever has high or medium severity. Left out are notices of low severity, that a driver
 * compiles a shader again for a new state, and what compiling the shaders of VTK's own ray caster
 * causes. Must live as long as the windows that it watches draw.
 */
class OpenGLMessages
{
public:
  /// Opens that window's context, if it is not open yet, and listens to it from now on.
  /// @return whether the context has a debug output
  bool Watch(vtkRenderWindow* window);

  /// The messages since the last call, one a line.
  std::string Take();

  void Add(const std::string& message) { this->Text += message + '\n'; }

private:
  std::string Text;
};

/// How many objects the current context holds, by kind ("textures", "buffers", "framebuffers",
/// "renderbuffers", "vertex arrays", "programs", "shaders"), names up to 20,000 being asked.
std::map<std::string, int> CountOpenGLObjects();

} // namespace nexrad::testing
