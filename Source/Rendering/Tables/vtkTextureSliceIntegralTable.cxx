// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceIntegralTable.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkTextureSliceTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{

using Entry = std::array<double, 4>;

/// Colour and depth, the depth limited.
Entry Limit(const float* entry, double mostDepth)
{
  return {static_cast<double>(entry[0]), static_cast<double>(entry[1]),
    static_cast<double>(entry[2]), std::min(static_cast<double>(entry[3]), mostDepth)};
}

/// What is integrated on the way from one entry to the next: colour times depth, and depth.
Entry Weigh(const Entry& from, const Entry& to, double way)
{
  Entry entry{};
  std::transform(from.begin(), from.end(), to.begin(), entry.begin(),
    [way](double a, double b) { return a + way * (b - a); });
  return {entry[0] * entry[3], entry[1] * entry[3], entry[2] * entry[3], entry[3]};
}

} // namespace

std::size_t vtkTextureSliceIntegralTable::ChooseWidth(std::size_t entries)
{
  constexpr std::size_t mostRefined = 2048; // OpenGL has textures of four times that
  return entries <= mostRefined ? 4 * entries - 3 : entries;
}

void vtkTextureSliceIntegralTable::Integrate(
  const float* entries, std::size_t width, double mostDepth, float* integrals)
{
  const std::size_t fine = ChooseWidth(width);
  const std::size_t parts = (fine - 1) / (width - 1);
  Entry sum{};
  Entry last{};
  for (std::size_t i = 0; i < fine; ++i)
  {
    const Entry from = Limit(entries + 4 * (i / parts), mostDepth);
    const Entry to = Limit(entries + 4 * std::min(i / parts + 1, width - 1), mostDepth);
    const Entry current =
      Weigh(from, to, static_cast<double>(i % parts) / static_cast<double>(parts));
    for (std::size_t c = 0; c < 4; ++c)
    {
      sum[c] += i > 0 ? 0.5 * (last[c] + current[c]) : 0.0;
      integrals[4 * i + c] = static_cast<float>(sum[c]);
    }
    last = current;
  }
}

double vtkTextureSliceIntegralTable::ChooseMostDepth(double unitsOfSlab)
{
  constexpr double opaque = 32.0; // 2^-32 of the light is left
  constexpr double least = 32.0;  // an opacity below 1 has a depth of 24 at most, in floats
  constexpr double most = 1048576.0;
  const double needed = std::clamp(opaque / std::max(unitsOfSlab, 1e-30), least, most);
  return std::exp2(std::ceil(std::log2(needed)));
}

void vtkTextureSliceIntegralTable::Update(vtkOpenGLRenderWindow* window,
  const vtkTextureSliceTable& table, int rows, int dimensions, double mostDepth)
{
  const Key key{table.GetFillTime(), rows, dimensions, mostDepth};
  if (this->Texture->GetHandle() != 0 && this->Texture->GetContext() == window && key == this->Last)
  {
    return;
  }
  this->Last = key;
  this->Texture->SetContext(window);
  const std::size_t width = table.GetWidth();
  this->Width = ChooseWidth(width);
  std::vector<float> integrals(static_cast<std::size_t>(rows) * this->Width * 4);
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row)
  {
    Integrate(table.GetEntries(row), width, mostDepth, &integrals[row * this->Width * 4]);
  }
  vtkTextureSliceSetSampling(this->Texture, true);
  vtkTextureSliceTable::Upload(
    this->Texture, dimensions, static_cast<std::size_t>(rows), integrals);
}

void vtkTextureSliceIntegralTable::SetUniforms(const char* name, vtkShaderProgram* program) const
{
  program->SetUniformf(name, static_cast<float>(this->Width) - 1.0f);
}
