// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTables.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceOpenGL.h"

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

std::size_t ChooseWidth(vtkOpenGLRenderWindow* window, const std::vector<vtkTextureSliceRow>& rows)
{
  int samples = 0;
  for (const vtkTextureSliceRow& row : rows)
  {
    const auto [low, high] = EntryRange(row.OpacityDomain);
    samples = std::max(samples, row.Opacity->EstimateMinNumberOfSamples(low, high));
    if (row.Color != nullptr)
    {
      const auto [first, last] = EntryRange(row.ColorDomain);
      samples = std::max(samples, row.Color->EstimateMinNumberOfSamples(first, last));
    }
  }
  int width = MinimumWidth;
  const int limit = std::min(MaximumWidth, vtkTextureObject::GetMaximumTextureSize(window));
  while (width < samples && 2 * width <= limit)
  {
    width *= 2;
  }
  return static_cast<std::size_t>(width);
}

/// As in VTK's ray caster, functions without points are ramps: black to white, clear to half
/// opaque.
void AddRamp(vtkColorTransferFunction* function, const std::array<double, 2>& range)
{
  function->AddRGBPoint(range[0], 0.0, 0.0, 0.0);
  function->AddRGBPoint(range[1], 1.0, 1.0, 1.0);
}

void AddRamp(vtkPiecewiseFunction* function, const std::array<double, 2>& range)
{
  function->AddPoint(range[0], 0.0);
  function->AddPoint(range[1], 0.5);
}

/// The function, or where it has no points or its own range clamps the scalar, a copy that has
/// points and holds its last values.
template <typename Function>
vtkSmartPointer<Function> Complete(Function* function, const vtkTextureSliceDomain& domain)
{
  if (function->GetSize() > 0 && !domain.Native)
  {
    return function;
  }
  auto copy = vtkSmartPointer<Function>::New();
  copy->DeepCopy(function);
  copy->ClampingOn();
  if (function->GetSize() == 0)
  {
    AddRamp(copy, EntryRange(domain));
  }
  return copy;
}

void FillColor(const vtkTextureSliceRow& row, int width, float* entries)
{
  const auto [low, high] = EntryRange(row.ColorDomain);
  const std::size_t channels = row.Gray != nullptr ? 1 : 3;
  std::vector<float> colors(channels * static_cast<std::size_t>(width));
  if (row.Gray != nullptr)
  {
    Complete(row.Gray, row.ColorDomain)->GetTable(low, high, width, colors.data());
  }
  else
  {
    Complete(row.Color, row.ColorDomain)->GetTable(low, high, width, colors.data());
  }
  for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(width); ++i)
  {
    entries[4 * (i / 3) + i % 3] = colors[channels == 1 ? i / 3 : i];
  }
}

/// The optical depth t of an opacity a: a ray keeps 2^-t = 1 - a of its light (Formulas R1), so
/// that n such distances have n times the depth. An opacity of 1 stays opaque over any step.
float ToOpticalDepth(float opacity)
{
  constexpr double most = 1048576.0;
  return static_cast<float>(std::clamp(-std::log2(1.0 - static_cast<double>(opacity)), 0.0, most));
}

void FillOpacity(const vtkTextureSliceRow& row, int width, float* entries)
{
  const auto [low, high] = EntryRange(row.OpacityDomain);
  Complete(row.Opacity, row.OpacityDomain)->GetTable(low, high, width, entries + 3, 4);
  for (int i = 0; i < width; ++i)
  {
    const float opacity = std::clamp(entries[4 * i + 3], 0.0f, 1.0f);
    entries[4 * i + 3] = row.OpticalDepth ? ToOpticalDepth(opacity) : opacity;
  }
}

std::vector<float> MakeEntries(const vtkTextureSliceRow& row, std::size_t width)
{
  std::vector<float> entries(4 * width, 1.0f);
  if (row.Gray != nullptr || row.Color != nullptr)
  {
    FillColor(row, static_cast<int>(width), entries.data());
  }
  FillOpacity(row, static_cast<int>(width), entries.data());
  return entries;
}

std::vector<float> GetAlphas(const std::vector<float>& entries)
{
  std::vector<float> alphas(entries.size() / 4);
  for (std::size_t i = 0; i < alphas.size(); ++i)
  {
    alphas[i] = entries[4 * i + 3];
  }
  return alphas;
}

/// Four floats a point, in one plane.
bool IsTable(vtkImageData* image)
{
  vtkDataArray* scalars = image != nullptr ? image->GetPointData()->GetScalars() : nullptr;
  return scalars != nullptr && scalars->GetDataType() == VTK_FLOAT &&
         scalars->GetNumberOfComponents() == 4 && image->GetDimensions()[2] == 1;
}

bool HaveOneSize(const std::vector<vtkImageData*>& images, int limit)
{
  const int* size = images.front()->GetDimensions();
  const int height = size[1] * static_cast<int>(images.size());
  return size[0] <= limit && height <= limit &&
         std::all_of(images.begin(), images.end(),
           [size](vtkImageData* image) {
             return image->GetDimensions()[0] == size[0] && image->GetDimensions()[1] == size[1];
           });
}

using Entry = std::array<double, 4>;

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

void vtkTextureSliceTable::Update(
  vtkOpenGLRenderWindow* window, const std::vector<vtkTextureSliceRow>& rows, bool nearest)
{
  std::vector<Key> keys;
  const auto timeOf = [](vtkObject* function)
  { return function != nullptr ? function->GetMTime() : vtkMTimeType{0}; };
  for (const vtkTextureSliceRow& row : rows)
  {
    keys.emplace_back(row.Color, row.Gray, row.Opacity, timeOf(row.Color), timeOf(row.Gray),
      timeOf(row.Opacity), row.ColorDomain.Range, row.ColorDomain.Native, row.OpacityDomain.Range,
      row.OpacityDomain.Native, row.OpticalDepth);
  }
  if (this->Texture->GetHandle() == 0 || this->Texture->GetContext() != window ||
      keys != this->Last)
  {
    this->Texture->SetContext(window);
    this->Last = keys;
    this->Fill(window, rows);
    Upload(this->Texture, rows.size(), this->Entries);
  }
  vtkTextureSliceSetSampling(this->Texture, nearest);
}

void vtkTextureSliceTable::Fill(
  vtkOpenGLRenderWindow* window, const std::vector<vtkTextureSliceRow>& rows)
{
  this->Entries.clear();
  this->Visibilities.clear();
  this->Opacities.clear();
  const std::size_t width = ChooseWidth(window, rows);
  for (vtkTextureSliceRow row : rows)
  {
    const std::vector<float> entries = MakeEntries(row, width);
    this->Entries.insert(this->Entries.end(), entries.begin(), entries.end());
    this->Visibilities.emplace_back(GetAlphas(entries));
    row.Color = nullptr;
    row.Gray = nullptr;
    this->Opacities.push_back(GetAlphas(MakeEntries(row, ChooseWidth(window, {row}))));
  }
  this->FillTime.Modified();
}

void vtkTextureSliceTable::Upload(
  vtkTextureObject* texture, std::size_t rows, const std::vector<float>& texels)
{
  const int dimensions = rows == 1 ? 1 : 2;
  if (texture->GetNumberOfDimensions() != dimensions)
  {
    texture->ReleaseGraphicsResources(texture->GetContext());
  }
  const auto columns = static_cast<unsigned int>(texels.size() / (4 * rows));
  auto* first = const_cast<float*>(texels.data()); // which VTK only reads
  dimensions == 1
    ? texture->Create1DFromRaw(columns, 4, VTK_FLOAT, first)
    : texture->Create2DFromRaw(columns, static_cast<unsigned int>(rows), 4, VTK_FLOAT, first);
}

void vtkTextureSliceTable::SetUniforms(vtkShaderProgram* program) const
{
  // The first and the last scalar lie at the centres of the outermost texels.
  const auto texel = static_cast<float>(1.0 / static_cast<double>(this->GetWidth()));
  program->SetUniformf("tableScale", 1.0f - texel);
  program->SetUniformf("tableBias", 0.5f * texel);
}

std::string vtkTextureSliceTable2D::Update(
  vtkOpenGLRenderWindow* window, const std::vector<vtkImageData*>& images, bool nearest)
{
  if (!std::all_of(images.begin(), images.end(), IsTable))
  {
    return "a two-dimensional transfer function must be a 2-D image of four floats: see "
           "vtkVolumeProperty::SetTransferFunction2D";
  }
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  if (!HaveOneSize(images, limit))
  {
    return "the two-dimensional transfer functions of all components must have one size, at most " +
           std::to_string(limit) + " wide and together as high";
  }
  std::vector<std::pair<const void*, vtkMTimeType>> key;
  for (vtkImageData* image : images)
  {
    key.emplace_back(image, image->GetMTime());
  }
  const bool current = this->Texture->GetHandle() != 0 && this->Texture->GetContext() == window;
  this->Texture->SetContext(window);
  if ((!current || key != this->Last) && !this->Upload(images))
  {
    return "OpenGL could not make a texture of the two-dimensional transfer functions";
  }
  this->Last = key;
  vtkTextureSliceSetSampling(this->Texture, nearest);
  return "";
}

bool vtkTextureSliceTable2D::Upload(const std::vector<vtkImageData*>& images)
{
  const int* size = images.front()->GetDimensions();
  const auto width = static_cast<std::size_t>(size[0]);
  std::vector<float> entries;
  this->Visibilities.clear();
  for (vtkImageData* image : images)
  {
    const auto* first = static_cast<const float*>(image->GetScalarPointer());
    const auto points = static_cast<std::size_t>(image->GetNumberOfPoints());
    entries.insert(entries.end(), first, first + 4 * points);
    std::vector<float> most(width, 0.0f);
    for (std::size_t i = 0; i < points; ++i)
    {
      most[i % width] = std::max(most[i % width], first[4 * i + 3]);
    }
    this->Visibilities.emplace_back(most);
  }
  this->FillTime.Modified();
  return this->Texture->Create2DFromRaw(static_cast<unsigned int>(size[0]),
    static_cast<unsigned int>(size[1]) * static_cast<unsigned int>(images.size()), 4, VTK_FLOAT,
    entries.data());
}

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

void vtkTextureSliceIntegralTable::Update(
  vtkOpenGLRenderWindow* window, const vtkTextureSliceTable& table, int rows, double mostDepth)
{
  const Key key{table.GetFillTime(), rows, mostDepth};
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
  vtkTextureSliceTable::Upload(this->Texture, static_cast<std::size_t>(rows), integrals);
}

void vtkTextureSliceIntegralTable::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniformf("lastIntegral", static_cast<float>(this->Width) - 1.0f);
}
