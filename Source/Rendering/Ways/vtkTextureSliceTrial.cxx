// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTrial.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceBox.h"
#include "vtkTextureSliceCompute.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceShader.h"
#include "vtkTextureSliceTarget.h"

#include "TextureSliceCS.h"
#include "TextureSliceFS.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <string>

namespace
{

constexpr int Size = 256;          ///< of the picture, along both axes
constexpr int FewestSamples = 4;   ///< on a ray
constexpr int MostSamples = 1024;  ///< on a ray
constexpr double LongEnough = 1.0; ///< milliseconds
constexpr int Rounds = 5;
/// Compute must win by more than the factor 2 by which times differ where other programs take one
/// of two processors from a software renderer.
constexpr double MostOfFragments = 0.5;

/// Whether compute is twice as fast, for each renderer that had a trial.
std::map<std::string, bool> Results;
std::mutex ResultsMutex;

/// Draws rays of that number of samples; false: the shader does not compile.
using Way = std::function<bool(int samples)>;

/// Milliseconds of one of the ways.
double Measure(const Way& draw, int samples)
{
  glFinish();
  const auto begin = std::chrono::steady_clock::now();
  draw(samples);
  glFinish();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
  return time.count();
}

bool IsComputeTwiceAsFast(const Way& fragments, const Way& compute)
{
  // Drivers finish shaders when they are used first.
  if (!fragments(FewestSamples) || !compute(FewestSamples))
  {
    return false;
  }
  int samples = FewestSamples;
  while (samples < MostSamples &&
         std::max(Measure(fragments, samples), Measure(compute, samples)) < LongEnough)
  {
    samples *= 2;
  }
  // The shortest times in turn, since other programs use the machine as well.
  double byFragments = std::numeric_limits<double>::max();
  double byCompute = byFragments;
  for (int round = 0; round < Rounds; ++round)
  {
    byFragments = std::min(byFragments, Measure(fragments, samples));
    byCompute = std::min(byCompute, Measure(compute, samples));
  }
  return byCompute < MostOfFragments * byFragments;
}

void SetUniforms(vtkShaderProgram* program, vtkTextureObject* volume, int samples)
{
  program->SetUniformi("volumeTexture", volume->GetTextureUnit());
  program->SetUniformi("samples", samples);
  program->SetUniformf("pixelToTexture", 1.0f / Size);
}

std::string GetRendererName()
{
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

} // namespace

std::optional<bool> vtkTextureSliceTrial::Recall()
{
  const std::lock_guard<std::mutex> lock(ResultsMutex);
  const auto found = Results.find(GetRendererName());
  return found != Results.end() ? std::optional<bool>(found->second) : std::nullopt;
}

bool vtkTextureSliceTrial::Run(vtkOpenGLRenderWindow* window, vtkTextureObject* volume)
{
  vtkTextureSliceTarget target;
  vtkTextureSliceBox box;
  vtkTextureSliceCompute computeShaders;
  const Way fragments = [&](int samples)
  {
    vtkShaderProgram* program =
      box.Ready(window, "", [] { return vtkTextureSliceShader::MakeTrial(TextureSliceFS); });
    if (program != nullptr)
    {
      SetUniforms(program, volume, samples);
      // Without a camera, the box from -1 to 1 is the whole picture.
      box.Draw(vtkTextureSliceFrame(), {-1, 1, -1, 1, -1, 1});
    }
    return program != nullptr;
  };
  const Way compute = [&](int samples)
  {
    vtkShaderProgram* program = computeShaders.Ready(
      window, "", [] { return vtkTextureSliceShader::MakeTrial(TextureSliceCS); });
    if (program != nullptr)
    {
      SetUniforms(program, volume, samples);
      computeShaders.Dispatch(target.GetPicture(), {0, 0, Size, Size});
    }
    return program != nullptr;
  };
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  state->vtkglViewport(0, 0, Size, Size);
  state->vtkglDisable(GL_BLEND);
  std::string error;
  bool isFaster = false;
  if (target.Begin(window, 1.0, false, false, error))
  {
    volume->Activate();
    isFaster = IsComputeTwiceAsFast(fragments, compute);
    volume->Deactivate();
    target.End();
  }
  box.ReleaseGraphicsResources();
  computeShaders.ReleaseGraphicsResources(window);
  target.ReleaseGraphicsResources(window);
  const std::lock_guard<std::mutex> lock(ResultsMutex);
  Results[GetRendererName()] = isFaster;
  return isFaster;
}
