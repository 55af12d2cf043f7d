// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceIntegralTable.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureSliceTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

void vtkTextureSliceIntegralTable::Integrate(
  const float* entries, std::size_t width, double mostDepth, float* integrals)
{
  const double step = 1.0 / static_cast<double>(width);
  std::array<double, 4> sum{};
  std::array<double, 4> last{};
  for (std::size_t i = 0; i < width; ++i)
  {
    const float* entry = entries + 4 * i;
    const double depth = std::min(static_cast<double>(entry[3]), mostDepth);
    const std::array<double, 4> current{depth * static_cast<double>(entry[0]),
      depth * static_cast<double>(entry[1]), depth * static_cast<double>(entry[2]), depth};
    for (std::size_t c = 0; c < 4; ++c)
    {
      sum[c] += i > 0 ? 0.5 * (last[c] + current[c]) * step : 0.0;
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
  if (this->Texture->GetHandle() != 0 && this->Texture->GetContext() == window &&
      this->FillTime == table.GetFillTime() && this->Rows == rows &&
      this->Dimensions == dimensions && this->MostDepth == mostDepth)
  {
    return;
  }
  this->Texture->SetContext(window);
  if (this->Dimensions != dimensions)
  {
    this->Texture->ReleaseGraphicsResources(window);
  }
  this->FillTime = table.GetFillTime();
  this->Rows = rows;
  this->Dimensions = dimensions;
  this->MostDepth = mostDepth;
  const std::size_t width = table.GetWidth();
  std::vector<float> integrals(static_cast<std::size_t>(rows) * width * 4);
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row)
  {
    Integrate(table.GetEntries(row), width, mostDepth, &integrals[row * width * 4]);
  }
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
  const auto columns = static_cast<unsigned int>(width);
  if (dimensions == 1)
  {
    this->Texture->Create1DFromRaw(columns, 4, VTK_FLOAT, integrals.data());
  }
  else
  {
    this->Texture->Create2DFromRaw(
      columns, static_cast<unsigned int>(rows), 4, VTK_FLOAT, integrals.data());
  }
}

void vtkTextureSliceIntegralTable::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}
