// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Captions/DataAge.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace nexrad::scene
{
namespace
{

constexpr double binSeconds = 10.0;
constexpr std::size_t bins = 1080; // 3 h; older data count as that old

// How many voxels have which age.
using Histogram = std::array<vtkIdType, bins>;

std::optional<double> MedianMinutes(const Histogram& histogram)
{
  vtkIdType count = 0;
  for (const vtkIdType voxels : histogram)
  {
    count += voxels;
  }
  vtkIdType below = 0;
  for (std::size_t bin = 0; bin < bins; ++bin)
  {
    below += histogram[bin];
    if (count > 0 && 2 * below >= count)
    {
      return (static_cast<double>(bin) + 0.5) * binSeconds / 60.0;
    }
  }
  return std::nullopt;
}

template <class Array>
const auto* ValuesOf(vtkImageData* volume, const std::string& name)
{
  auto* array = Array::SafeDownCast(volume->GetPointData()->GetArray(name.c_str()));
  return array != nullptr && array->GetNumberOfTuples() == volume->GetNumberOfPoints()
           ? array->GetPointer(0)
           : nullptr;
}

} // namespace

std::vector<std::optional<double>> AgesOfData(
  vtkImageData* volume, const std::string& array, std::size_t sites)
{
  constexpr unsigned char notScanned = 3; // of the array of states
  const float* age = ValuesOf<vtkFloatArray>(volume, array + "_age");
  const unsigned char* radars = ValuesOf<vtkUnsignedCharArray>(volume, array + "_radars");
  const unsigned char* site = ValuesOf<vtkUnsignedCharArray>(volume, array + "_site");
  const unsigned char* state = ValuesOf<vtkUnsignedCharArray>(volume, array + "_state");
  const bool one = sites == 1;
  if (age == nullptr || state == nullptr || (!one && (radars == nullptr || site == nullptr)))
  {
    return {};
  }
  std::vector<Histogram> histograms(sites, Histogram{});
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    const std::size_t which = one ? 0 : site[i];
    if (state[i] != notScanned && which < sites && (one || radars[i] == 1))
    {
      const auto bin = static_cast<std::size_t>(std::max(0.0F, age[i]) / binSeconds);
      ++histograms[which][std::min(bin, bins - 1)];
    }
  }
  std::vector<std::optional<double>> ages;
  std::transform(histograms.begin(), histograms.end(), std::back_inserter(ages), MedianMinutes);
  return ages;
}

} // namespace nexrad::scene
