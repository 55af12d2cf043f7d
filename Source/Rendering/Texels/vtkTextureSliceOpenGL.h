// SPDX-License-Identifier: BSD-3-Clause
// OpenGL's functions and constants, under whichever loader this VTK was built with, and how
// textures are read.
#ifndef vtkTextureSliceOpenGL_h
#define vtkTextureSliceOpenGL_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h" // VTK 9.4 and later
#define VTK_TEXTURE_SLICE_HAS_COMPUTE GLAD_GL_ARB_compute_shader
#else
#include "vtk_glew.h"
#define VTK_TEXTURE_SLICE_HAS_COMPUTE GLEW_ARB_compute_shader
#endif

#include "vtkTextureObject.h"

#include <cstring>

/// Mesa's software renderer draws.
inline bool vtkTextureSliceIsLlvmpipe()
{
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return renderer != nullptr && std::strstr(renderer, "llvmpipe") != nullptr;
}

/// Between texels there is the nearest one, or what is linear; beyond them there are the last ones.
inline void vtkTextureSliceSetSampling(vtkTextureObject* texture, bool nearest)
{
  const int filter = nearest ? vtkTextureObject::Nearest : vtkTextureObject::Linear;
  texture->SetMagnificationFilter(filter);
  texture->SetMinificationFilter(filter);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
}

#endif
