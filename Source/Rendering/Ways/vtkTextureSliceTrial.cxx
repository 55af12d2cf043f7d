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

class Trial
{
public:
  Trial(vtkOpenGLRenderWindow* window, vtkTextureObject* volume)
    : Window(window)
    , Volume(volume)
  {
  }
  ~Trial()
  {
    this->Box.ReleaseGraphicsResources();
    this->Compute.ReleaseGraphicsResources(this->Window);
    this->Target.ReleaseGraphicsResources(this->Window);
  }

  bool IsComputeTwiceAsFast()
  {
    vtkOpenGLState* state = this->Window->GetState();
    vtkOpenGLState::ScopedglViewport viewport(state);
    vtkOpenGLState::ScopedglScissor scissor(state);
    vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
    vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    vtkOpenGLState::ScopedglClearColor clearColor(state);
    vtkOpenGLState::ScopedglColorMask colorMask(state);
    state->vtkglViewport(0, 0, Size, Size);
    std::string error;
    if (!this->Target.Begin(this->Window, 1.0, false, false, error))
    {
      return false;
    }
    state->vtkglDisable(GL_BLEND);
    this->Volume->Activate();
    const bool faster = this->Compare();
    this->Volume->Deactivate();
    this->Target.End();
    return faster;
  }

private:
  bool Compare()
  {
    const auto fragments = [this](int samples) { return this->DrawFragments(samples); };
    const auto compute = [this](int samples) { return this->DrawCompute(samples); };
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

  /// Milliseconds of one of the ways.
  static double Measure(const std::function<bool(int)>& draw, int samples)
  {
    glFinish();
    const auto begin = std::chrono::steady_clock::now();
    draw(samples);
    glFinish();
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    return time.count();
  }

  bool DrawFragments(int samples)
  {
    vtkShaderProgram* program = this->Box.Ready(
      this->Window, "", [] { return vtkTextureSliceShader::MakeTrial(TextureSliceFS); });
    if (program != nullptr)
    {
      this->SetUniforms(program, samples);
      // Without a camera, the box from -1 to 1 is the whole picture.
      this->Box.Draw(vtkTextureSliceFrame(), {-1, 1, -1, 1, -1, 1});
    }
    return program != nullptr;
  }

  bool DrawCompute(int samples)
  {
    vtkShaderProgram* program = this->Compute.Ready(
      this->Window, "", [] { return vtkTextureSliceShader::MakeTrial(TextureSliceCS); });
    if (program != nullptr)
    {
      this->SetUniforms(program, samples);
      this->Compute.Dispatch(this->Target.GetPicture(), {0, 0, Size, Size});
    }
    return program != nullptr;
  }

  void SetUniforms(vtkShaderProgram* program, int samples)
  {
    program->SetUniformi("volumeTexture", this->Volume->GetTextureUnit());
    program->SetUniformi("samples", samples);
    program->SetUniformf("pixelToTexture", 1.0f / Size);
  }

  vtkOpenGLRenderWindow* Window;
  vtkTextureObject* Volume;
  vtkTextureSliceTarget Target;
  vtkTextureSliceBox Box;
  vtkTextureSliceCompute Compute;
};

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
  const bool isFaster = Trial(window, volume).IsComputeTwiceAsFast();
  const std::lock_guard<std::mutex> lock(ResultsMutex);
  Results[GetRendererName()] = isFaster;
  return isFaster;
}
