// SPDX-License-Identifier: BSD-3-Clause
// OpenGL's functions and constants, under whichever loader this VTK was built with.
#ifndef vtkTextureSliceOpenGL_h
#define vtkTextureSliceOpenGL_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h" // VTK 9.4 and later
#else
#include "vtk_glew.h"
#endif

#endif
