// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTable.h"

#include "vtkColorTransferFunction.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"

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

/// The function, or where its own range clamps the scalar a copy that holds its last values.
template <typename Function>
vtkSmartPointer<Function> Clamp(Function* function, bool native)
{
  auto clamped = vtkSmartPointer<Function>::New();
  clamped->DeepCopy(function);
  clamped->ClampingOn();
  return native ? clamped : vtkSmartPointer<Function>(function);
}

void FillColor(const vtkTextureSliceRow& row, int width, float* entries)
{
  const auto [low, high] = EntryRange(row.ColorDomain);
  const std::size_t channels = row.Gray != nullptr ? 1 : 3;
  std::vector<float> colors(channels * static_cast<std::size_t>(width));
  if (row.Gray != nullptr)
  {
    Clamp(row.Gray, row.ColorDomain.Native)->GetTable(low, high, width, colors.data());
  }
  else
  {
    Clamp(row.Color, row.ColorDomain.Native)->GetTable(low, high, width, colors.data());
  }
  for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(width); ++i)
  {
    entries[4 * (i / 3) + i % 3] = colors[channels == 1 ? i / 3 : i];
  }
}

void FillOpacity(const vtkTextureSliceRow& row, int width, float* entries)
{
  const auto [low, high] = EntryRange(row.OpacityDomain);
  Clamp(row.Opacity, row.OpacityDomain.Native)->GetTable(low, high, width, entries + 3, 4);
  for (int i = 0; i < width; ++i)
  {
    entries[4 * i + 3] = std::clamp(entries[4 * i + 3], 0.0f, 1.0f);
  }
}

/// As in VTK's ray caster, functions without points are ramps: black to white, clear to half
/// opaque.
void FillRamps(const vtkTextureSliceRow& row, int width, float* entries)
{
  constexpr float mostOpaque = 0.5f;
  for (int i = 0; i < width; ++i)
  {
    const float ramp = static_cast<float>(i) / static_cast<float>(width - 1);
    if (row.Color != nullptr && row.Color->GetSize() == 0)
    {
      std::fill_n(entries + 4 * i, 3, ramp);
    }
    if (row.Opacity != nullptr && row.Opacity->GetSize() == 0)
    {
      entries[4 * i + 3] = mostOpaque * ramp;
    }
  }
}

void FillRow(const vtkTextureSliceRow& row, int width, float* entries)
{
  std::fill(entries, entries + 4 * width, 1.0f);
  if (row.Gray != nullptr || row.Color != nullptr)
  {
    FillColor(row, width, entries);
  }
  if (row.Opacity != nullptr)
  {
    FillOpacity(row, width, entries);
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
  this->RowsTime = 0;
  this->Entries.resize(this->Rows.size() * static_cast<std::size_t>(width) * 4);
  float* entries = this->Entries.data();
  for (const vtkTextureSliceRow& row : this->Rows)
  {
    this->RowsTime = std::max(this->RowsTime, row.GetTime());
    FillRow(row, width, entries);
    entries += static_cast<std::size_t>(width) * 4;
  }
  this->Visibilities.clear();
  for (std::size_t row = 0; row < this->Rows.size(); ++row)
  {
    this->Visibilities.emplace_back(this->GetAlphas(row));
  }
  this->FillTime.Modified();
}

std::vector<float> vtkTextureSliceTable::GetAlphas(std::size_t row) const
{
  const std::size_t width = this->GetWidth();
  std::vector<float> alphas(width);
  for (std::size_t i = 0; i < width; ++i)
  {
    alphas[i] = this->Entries[4 * (row * width + i) + 3];
  }
  return alphas;
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

void vtkTextureSliceTable::SetUniforms(const std::string& name, vtkShaderProgram* program) const
{
  // The first and the last scalar lie at the centres of the outermost texels.
  const auto texel = static_cast<float>(1.0 / static_cast<double>(this->GetWidth()));
  program->SetUniformf((name + "Scale").c_str(), 1.0f - texel);
  program->SetUniformf((name + "Bias").c_str(), 0.5f * texel);
}

void vtkTextureSliceTable::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}
