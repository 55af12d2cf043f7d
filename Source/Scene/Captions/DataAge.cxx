// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Captions/DataAge.h"

#include "nexrad/Grid/GriddedVolume.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
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

// The states of a volume of values or of codes.
class States
{
public:
  States(vtkImageData* volume, const std::string& array)
    : states(ValuesOf<vtkUnsignedCharArray>(volume, array + "_state"))
  {
    auto* table = vtkUnsignedCharArray::SafeDownCast(
      volume->GetFieldData()->GetArray((array + "_code_states").c_str()));
    if (states == nullptr && table != nullptr && table->GetNumberOfTuples() == 256)
    {
      states = ValuesOf<vtkUnsignedCharArray>(volume, array);
      ofCode = table->GetPointer(0);
    }
  }

  bool AreKnown() const { return states != nullptr; }
  bool IsKnown(vtkIdType voxel) const
  {
    return IsMeasured(ToVoxelState(ofCode != nullptr ? ofCode[states[voxel]] : states[voxel]));
  }

private:
  const unsigned char* states; // or codes
  const unsigned char* ofCode = nullptr;
};

} // namespace

std::vector<std::optional<double>> AgesOfData(
  vtkImageData* volume, const std::string& array, std::size_t sites)
{
  const float* age = ValuesOf<vtkFloatArray>(volume, array + "_age");
  const unsigned char* radars = ValuesOf<vtkUnsignedCharArray>(volume, array + "_radars");
  const unsigned char* site = ValuesOf<vtkUnsignedCharArray>(volume, array + "_site");
  const States states(volume, array);
  const bool one = sites == 1;
  if (age == nullptr || !states.AreKnown() || (!one && (radars == nullptr || site == nullptr)))
  {
    return {};
  }
  std::vector<Histogram> histograms(sites, Histogram{});
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    const std::size_t which = one ? 0 : site[i];
    if (states.IsKnown(i) && which < sites && (one || radars[i] == 1))
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
