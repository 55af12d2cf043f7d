// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceCompute.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceOpenGL.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace
{

GLint GetInteger(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

/// Major version times ten and minor version.
int GetVersion()
{
  return 10 * GetInteger(GL_MAJOR_VERSION) + GetInteger(GL_MINOR_VERSION);
}

bool HasExtension(const char* name)
{
  const GLint count = GetInteger(GL_NUM_EXTENSIONS);
  for (GLint i = 0; i < count; ++i)
  {
    const GLubyte* extension = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (std::strcmp(reinterpret_cast<const char*>(extension), name) == 0)
    {
      return true;
    }
  }
  return false;
}

/// Columns and rows of a work group: 8, or less where the context allows less.
int FindGroupSize()
{
  int size = 8;
  for (const GLuint axis : {0u, 1u})
  {
    GLint most = 0;
    glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_SIZE, axis, &most);
    size = std::min(size, most);
  }
  while (size * size > GetInteger(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS))
  {
    size /= 2;
  }
  return size;
}

bool CanStore(GLenum format)
{
  GLint support = GL_NONE;
  glGetInternalformativ(GL_TEXTURE_2D, format, GL_SHADER_IMAGE_STORE, 1, &support);
  return support == GL_FULL_SUPPORT || support == GL_CAVEAT_SUPPORT;
}

/// The first lines of a shader.
std::string MakeVersion()
{
  const std::string version = GetVersion() >= 43
                                ? "#version 430\n"
                                : "#version 420\n#extension GL_ARB_compute_shader : require\n";
  return version + "#define TEXTURE_SLICE_GROUP " + std::to_string(FindGroupSize()) + "\n";
}

/// A program with one compute shader.
class ComputeProgram : public vtkShaderProgram
{
public:
  static ComputeProgram* New();
  vtkTypeMacro(ComputeProgram, vtkShaderProgram);

  void SetSource(std::string source) { this->Source = std::move(source); }

protected:
  /// VTK's shader cache asks for this before it uses a program.
  int CompileShader() override
  {
    const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
    const char* text = this->Source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    const GLuint program = glCreateProgram();
    glAttachShader(program, shader);
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    this->Handle = static_cast<int>(program);
    this->Compiled = linked == GL_TRUE;
    this->Linked = this->Compiled;
    if (!this->Compiled)
    {
      std::array<char, 1000> log{};
      glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
      vtkErrorMacro("a compute shader does not compile: " << log.data());
    }
    glDeleteShader(shader);
    return this->Compiled ? 1 : 0;
  }

private:
  std::string Source;
};

vtkStandardNewMacro(ComputeProgram);

} // namespace

bool vtkTextureSliceCompute::IsSupported()
{
  const bool hasShaders =
    GetVersion() >= 43 || (GetVersion() >= 42 && HasExtension("GL_ARB_compute_shader") &&
                            HasExtension("GL_ARB_internalformat_query2"));
  return hasShaders && FindGroupSize() > 0 && CanStore(GL_RGBA16);
}

vtkShaderProgram* vtkTextureSliceCompute::Ready(vtkOpenGLRenderWindow* window,
  const std::string& key, const std::function<std::string()>& makeShader)
{
  vtkSmartPointer<vtkShaderProgram>& program = this->Programs[key];
  if (program == nullptr)
  {
    std::string source = makeShader();
    vtkShaderProgram::Substitute(source, "//VTK::TextureSlice::Version", MakeVersion());
    auto made = vtkSmartPointer<ComputeProgram>::New();
    made->SetSource(source);
    program = made;
  }
  this->Program = window->GetShaderCache()->ReadyShaderProgram(program.Get());
  return this->Program;
}

void vtkTextureSliceCompute::Dispatch(
  vtkTextureObject* picture, const vtkTextureSlicePixels& pixels)
{
  const int size = FindGroupSize();
  const auto countGroups = [size](int from, int to)
  { return static_cast<GLuint>(std::max(0, (to - from + size - 1) / size)); };
  constexpr GLuint imageUnit = 0;
  this->Program->SetUniform2i("firstPixel", pixels.data());
  this->Program->SetUniform2i("endOfPixels", pixels.data() + 2);
  this->Program->SetUniformi("pictureImage", imageUnit);
  glBindImageTexture(imageUnit, picture->GetHandle(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16);
  glDispatchCompute(countGroups(pixels[0], pixels[2]), countGroups(pixels[1], pixels[3]), 1);
  // The picture is read as a texture, and cleared or stored into again for the next one.
  glMemoryBarrier(
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  glBindImageTexture(imageUnit, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16);
}

void vtkTextureSliceCompute::ReleaseGraphicsResources(vtkOpenGLRenderWindow* window)
{
  for (auto& [key, program] : this->Programs)
  {
    program->ReleaseGraphicsResources(window);
  }
  this->Programs.clear();
  this->Program = nullptr;
}

vtkTextureSlicePixels vtkTextureSliceCompute::FindPixels(const vtkTextureSliceFrame& frame,
  const std::array<double, 6>& part, const std::array<int, 2>& size)
{
  const auto& m = frame.GetView().BoxToClip;
  std::array<double, 4> limits{1.0, 1.0, -1.0, -1.0}; // of the window, -1 to 1
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const double x = part[corner & 1];
    const double y = part[2 + ((corner >> 1) & 1)];
    const double z = part[4 + ((corner >> 2) & 1)];
    const double w = m[12] * x + m[13] * y + m[14] * z + m[15];
    if (!(w > 0.0))
    {
      return {0, 0, size[0], size[1]};
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      const double* row = m.data() + 4 * axis;
      const double at = std::clamp((row[0] * x + row[1] * y + row[2] * z + row[3]) / w, -1.0, 1.0);
      limits[axis] = std::min(limits[axis], at);
      limits[2 + axis] = std::max(limits[2 + axis], at);
    }
  }
  vtkTextureSlicePixels pixels{};
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    pixels[axis] = static_cast<int>(std::floor(0.5 * (limits[axis] + 1.0) * size[axis]));
    pixels[2 + axis] = static_cast<int>(std::ceil(0.5 * (limits[2 + axis] + 1.0) * size[axis]));
  }
  return pixels;
}
