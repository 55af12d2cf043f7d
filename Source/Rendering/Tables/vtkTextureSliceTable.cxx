// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTable.h"

#include "vtkColorTransferFunction.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>

namespace
{

// Enough for a smooth ramp over 16-bit scalars; more where a function has steps closer together.
constexpr int MinimumWidth = 1024;
constexpr int MaximumWidth = 16384;

/// The scalars that the entries stand for, for a range that may be a single value.
std::array<double, 2> EntryRange(const vtkTextureSliceDomain& domain)
{
  const auto [low, high] = domain.Range;
  return {low, low < high ? high : low + 1.0};
}

int CountSamples(const vtkTextureSliceRow& row)
{
  int samples = 0;
  if (row.Opacity != nullptr)
  {
    const auto range = EntryRange(row.OpacityDomain);
    samples = row.Opacity->EstimateMinNumberOfSamples(range[0], range[1]);
  }
  if (row.Color != nullptr)
  {
    const auto range = EntryRange(row.ColorDomain);
    samples = std::max(samples, row.Color->EstimateMinNumberOfSamples(range[0], range[1]));
  }
  return samples;
}

int ChooseWidth(vtkOpenGLRenderWindow* window, const std::vector<vtkTextureSliceRow>& rows)
{
  int samples = 0;
  for (const vtkTextureSliceRow& row : rows)
  {
    samples = std::max(samples, CountSamples(row));
  }
  int width = MinimumWidth;
  const int limit = std::min(MaximumWidth, vtkTextureObject::GetMaximumTextureSize(window));
  while (width < samples && 2 * width <= limit)
  {
    width *= 2;
  }
  return width;
}

/// Calls put(i, scalar) for each of the entries, with the scalar that the function is asked for.
template <typename Function, typename Put>
void Sample(Function* function, const vtkTextureSliceDomain& domain, int width, Put put)
{
  const auto range = EntryRange(domain);
  const double step = (range[1] - range[0]) / (width - 1);
  double own[2];
  function->GetRange(own);
  for (int i = 0; i < width; ++i)
  {
    const double scalar = range[0] + i * step;
    put(i, domain.Native ? std::clamp(scalar, own[0], own[1]) : scalar);
  }
}

/// How far entry i of a row is on its way from 0 to 1.
float Ramp(int i, int width)
{
  return static_cast<float>(i) / static_cast<float>(width - 1);
}

void FillColor(
  vtkColorTransferFunction* color, const vtkTextureSliceDomain& domain, int width, float* entries)
{
  Sample(color, domain, width,
    [&](int i, double scalar)
    {
      double rgb[3];
      color->GetColor(scalar, rgb);
      std::copy(rgb, rgb + 3, entries + 4 * i);
    });
}

void FillOpacity(
  vtkPiecewiseFunction* opacity, const vtkTextureSliceDomain& domain, int width, float* entries)
{
  Sample(opacity, domain, width,
    [&](int i, double scalar)
    {
      const double value = std::clamp(opacity->GetValue(scalar), 0.0, 1.0);
      entries[4 * i + 3] = static_cast<float>(value);
    });
}

/// As in VTK's ray caster, functions without points are ramps: black to white, clear to half
/// opaque.
void FillRamps(const vtkTextureSliceRow& row, int width, float* entries)
{
  constexpr float mostOpaque = 0.5f;
  for (int i = 0; i < width; ++i)
  {
    if (row.Color != nullptr && row.Color->GetSize() == 0)
    {
      std::fill_n(entries + 4 * i, 3, Ramp(i, width));
    }
    if (row.Opacity != nullptr && row.Opacity->GetSize() == 0)
    {
      entries[4 * i + 3] = mostOpaque * Ramp(i, width);
    }
  }
}

void FillRow(const vtkTextureSliceRow& row, int width, float* entries)
{
  std::fill(entries, entries + 4 * width, 1.0f);
  if (row.Gray != nullptr)
  {
    Sample(row.Gray, row.ColorDomain, width,
      [&](int i, double scalar)
      { std::fill_n(entries + 4 * i, 3, static_cast<float>(row.Gray->GetValue(scalar))); });
  }
  else if (row.Color != nullptr)
  {
    FillColor(row.Color, row.ColorDomain, width, entries);
  }
  if (row.Opacity != nullptr)
  {
    FillOpacity(row.Opacity, row.OpacityDomain, width, entries);
  }
  FillRamps(row, width, entries);
}

/// The optical depth t of an opacity a: a ray keeps 2^-t = 1 - a of its light (Formulas R1), so
/// that n such distances have n times the depth. An opacity of 1 stays opaque over any step.
double ToOpticalDepth(double opacity)
{
  constexpr double most = 1048576.0;
  return std::clamp(-std::log2(1.0 - opacity), 0.0, most);
}

} // namespace

vtkMTimeType vtkTextureSliceRow::GetTime() const
{
  vtkMTimeType time = 0;
  for (vtkObject* function : {static_cast<vtkObject*>(this->Color),
         static_cast<vtkObject*>(this->Gray), static_cast<vtkObject*>(this->Opacity)})
  {
    time = std::max(time, function != nullptr ? function->GetMTime() : 0);
  }
  return time;
}

bool vtkTextureSliceRow::IsLike(const vtkTextureSliceRow& other) const
{
  const auto same = [](const vtkTextureSliceDomain& a, const vtkTextureSliceDomain& b)
  { return a.Range == b.Range && a.Native == b.Native; };
  return this->Color == other.Color && this->Gray == other.Gray && this->Opacity == other.Opacity &&
         this->OpticalDepth == other.OpticalDepth && same(this->ColorDomain, other.ColorDomain) &&
         same(this->OpacityDomain, other.OpacityDomain);
}

void vtkTextureSliceTable::Update(
  vtkOpenGLRenderWindow* window, const std::vector<vtkTextureSliceRow>& rows, bool nearest)
{
  this->Texture->SetContext(window);
  if (this->NeedsUpdate(window, rows))
  {
    this->Rows = rows;
    const int width = ChooseWidth(window, rows);
    this->Fill(width);
    this->Upload(static_cast<std::size_t>(width));
  }
  const int filter = nearest ? vtkTextureObject::Nearest : vtkTextureObject::Linear;
  this->Texture->SetMagnificationFilter(filter);
  this->Texture->SetMinificationFilter(filter);
}

bool vtkTextureSliceTable::NeedsUpdate(
  vtkOpenGLRenderWindow* window, const std::vector<vtkTextureSliceRow>& rows) const
{
  vtkMTimeType time = 0;
  for (const vtkTextureSliceRow& row : rows)
  {
    time = std::max(time, row.GetTime());
  }
  const auto like = [](const vtkTextureSliceRow& a, const vtkTextureSliceRow& b)
  { return a.IsLike(b); };
  return this->Texture->GetHandle() == 0 || this->Texture->GetContext() != window ||
         time > this->RowsTime ||
         !std::equal(rows.begin(), rows.end(), this->Rows.begin(), this->Rows.end(), like);
}

void vtkTextureSliceTable::Fill(int width)
{
  // The first and the last scalar lie at the centres of the outermost texels.
  this->Scale = (width - 1.0) / width;
  this->Bias = 0.5 / width;
  this->RowsTime = 0;
  this->Entries.resize(this->Rows.size() * static_cast<std::size_t>(width) * 4);
  float* entries = this->Entries.data();
  for (const vtkTextureSliceRow& row : this->Rows)
  {
    this->RowsTime = std::max(this->RowsTime, row.GetTime());
    FillRow(row, width, entries);
    entries += static_cast<std::size_t>(width) * 4;
  }
  this->IndexOpacities(static_cast<std::size_t>(width));
  this->FillTime.Modified();
}

void vtkTextureSliceTable::IndexOpacities(std::size_t width)
{
  this->Visibilities.resize(this->Rows.size());
  for (std::size_t row = 0; row < this->Rows.size(); ++row)
  {
    const float* opacities = this->Entries.data() + row * width * 4 + 3;
    this->Visibilities[row].Build(
      opacities, width, 4, [](float opacity) { return opacity > 0.0f; });
  }
}

std::vector<float> vtkTextureSliceTable::GetOpticalDepths(std::size_t row) const
{
  const std::size_t width = this->Entries.size() / (4 * this->Rows.size());
  std::vector<float> depths(width);
  for (std::size_t i = 0; i < width; ++i)
  {
    depths[i] = this->Entries[4 * (row * width + i) + 3];
  }
  return depths;
}

void vtkTextureSliceTable::Upload(std::size_t width)
{
  for (std::size_t row = 0; row < this->Rows.size(); ++row)
  {
    for (std::size_t i = row * width; this->Rows[row].OpticalDepth && i < (row + 1) * width; ++i)
    {
      float& alpha = this->Entries[4 * i + 3];
      alpha = static_cast<float>(ToOpticalDepth(static_cast<double>(alpha)));
    }
  }
  const int dimensions = this->Rows.size() == 1 ? 1 : 2;
  if (this->Texture->GetNumberOfDimensions() != dimensions)
  {
    this->Texture->ReleaseGraphicsResources(this->Texture->GetContext());
  }
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  const auto columns = static_cast<unsigned int>(width);
  if (dimensions == 1)
  {
    this->Texture->Create1DFromRaw(columns, 4, VTK_FLOAT, this->Entries.data());
  }
  else
  {
    this->Texture->Create2DFromRaw(
      columns, static_cast<unsigned int>(this->Rows.size()), 4, VTK_FLOAT, this->Entries.data());
  }
}

void vtkTextureSliceTable::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}
