// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTable.h"

#include "vtkColorTransferFunction.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{

// Enough for a smooth ramp over 16-bit scalars; more where a function has steps closer together.
constexpr int MinimumWidth = 1024;
constexpr int MaximumWidth = 16384;

/// The scalars that the entries stand for, for a range that may be a single value.
std::array<double, 2> EntryRange(const std::array<double, 2>& scalarRange)
{
  return scalarRange[0] < scalarRange[1]
           ? scalarRange
           : std::array<double, 2>{scalarRange[0], scalarRange[0] + 1.0};
}

int ChooseWidth(
  vtkOpenGLRenderWindow* window, vtkVolumeProperty* property, const std::array<double, 2>& range)
{
  int samples = property->GetScalarOpacity(0)->EstimateMinNumberOfSamples(range[0], range[1]);
  if (property->GetColorChannels(0) == 3)
  {
    samples = std::max(
      samples, property->GetRGBTransferFunction(0)->EstimateMinNumberOfSamples(range[0], range[1]));
  }
  int width = MinimumWidth;
  const int limit = std::min(MaximumWidth, vtkTextureObject::GetMaximumTextureSize(window));
  while (width < samples && 2 * width <= limit)
  {
    width *= 2;
  }
  return width;
}

vtkMTimeType FunctionTime(vtkVolumeProperty* property)
{
  vtkObject* color = property->GetColorChannels(0) == 1
                       ? static_cast<vtkObject*>(property->GetGrayTransferFunction(0))
                       : property->GetRGBTransferFunction(0);
  return std::max(
    {property->GetMTime(), color->GetMTime(), property->GetScalarOpacity(0)->GetMTime()});
}

double Clamped(double scalar, bool native, const double range[2])
{
  return native ? std::clamp(scalar, range[0], range[1]) : scalar;
}

} // namespace

void vtkTextureSliceTable::Update(vtkOpenGLRenderWindow* window, const Request& request)
{
  this->Texture->SetContext(window);
  if (this->NeedsUpdate(window, request))
  {
    const auto range = EntryRange(request.ScalarRange);
    const int width = ChooseWidth(window, request.Property, range);
    this->Fill(request, width);
    this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
    this->Texture->Create2DFromRaw(
      static_cast<unsigned int>(width), 1, 4, VTK_FLOAT, this->Entries.data());
    this->Last = request;
    this->UpdateTime.Modified();
  }
  // As in VTK's ray caster, "nearest" holds for the table as well as for the volume.
  const int filter = request.Property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION
                       ? vtkTextureObject::Nearest
                       : vtkTextureObject::Linear;
  this->Texture->SetMagnificationFilter(filter);
  this->Texture->SetMinificationFilter(filter);
}

bool vtkTextureSliceTable::NeedsUpdate(vtkOpenGLRenderWindow* window, const Request& request) const
{
  return this->Texture->GetHandle() == 0 || this->Texture->GetContext() != window ||
         request.Property != this->Last.Property || request.ScalarRange != this->Last.ScalarRange ||
         request.NativeColorRange != this->Last.NativeColorRange ||
         request.NativeOpacityRange != this->Last.NativeOpacityRange ||
         FunctionTime(request.Property) > this->UpdateTime.GetMTime();
}

void vtkTextureSliceTable::Fill(const Request& request, int width)
{
  const auto range = EntryRange(request.ScalarRange);
  const double step = (range[1] - range[0]) / (width - 1);
  this->Scale = 1.0 / (step * width);
  this->Bias = 0.5 / width - range[0] * this->Scale;

  vtkVolumeProperty* property = request.Property;
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity(0);
  const bool gray = property->GetColorChannels(0) == 1;
  vtkPiecewiseFunction* grayColor = gray ? property->GetGrayTransferFunction(0) : nullptr;
  vtkColorTransferFunction* rgbColor = gray ? nullptr : property->GetRGBTransferFunction(0);
  double colorRange[2];
  double opacityRange[2];
  gray ? grayColor->GetRange(colorRange) : rgbColor->GetRange(colorRange);
  opacity->GetRange(opacityRange);

  this->Entries.resize(static_cast<std::size_t>(width) * 4);
  float* entry = this->Entries.data();
  for (int i = 0; i < width; ++i, entry += 4)
  {
    const double scalar = range[0] + i * step;
    const double colorScalar = Clamped(scalar, request.NativeColorRange, colorRange);
    double rgb[3];
    if (gray)
    {
      rgb[0] = rgb[1] = rgb[2] = grayColor->GetValue(colorScalar);
    }
    else
    {
      rgbColor->GetColor(colorScalar, rgb);
    }
    std::copy(rgb, rgb + 3, entry);
    const double alpha =
      opacity->GetValue(Clamped(scalar, request.NativeOpacityRange, opacityRange));
    entry[3] = static_cast<float>(std::clamp(alpha, 0.0, 1.0));
  }
}

void vtkTextureSliceTable::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}
