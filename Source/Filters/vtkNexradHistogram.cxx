// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradHistogram.h"

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/Error.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradTwoFields.h"
#include "vtkNexradVoxels.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkNexradHistogram);

namespace
{

constexpr std::size_t codeCount = nexrad::VoxelCodes::Count;
constexpr double mostBins = 4096.0;
constexpr double binsOfUsualRange = 150.0;
constexpr auto echo = static_cast<unsigned char>(nexrad::VoxelState::Echo);

using Range = std::array<double, 2>;

// Voxels of one count, by the value, or by the code's value, of its bin.
struct Bins
{
  double width = 1.0;
  double first = 0.0; // number of the first bin: it begins at first * width
  std::vector<double> voxels;

  std::size_t Of(double value) const
  {
    const double bin = std::floor(value / this->width) - this->first;
    return static_cast<std::size_t>(
      std::clamp(bin, 0.0, static_cast<double>(this->voxels.size() - 1)));
  }
};

vtkDataArray* FindArray(vtkImageData* image, const std::string& name)
{
  vtkPointData* points = image->GetPointData();
  vtkDataArray* array = name.empty() ? points->GetScalars() : points->GetArray(name.c_str());
  if (!array)
  {
    throw nexrad::Error(name.empty() ? std::string("the image has no active scalars")
                                     : "the image has no point array " + name);
  }
  if (array->GetNumberOfComponents() != 1)
  {
    throw nexrad::Error("the point array " + name + " has several components");
  }
  return array;
}

// Which voxels are looked at, and which of these have a value.
struct Voxels
{
  vtkIdType stride = 1;
  vtkIdType count = 0; // of those that are looked at
  const unsigned char* states = nullptr;
  const unsigned char* ghosts = nullptr;

  bool Has(vtkIdType voxel) const
  {
    return this->states   ? this->states[voxel] == echo
           : this->ghosts ? (this->ghosts[voxel] & vtkDataSetAttributes::HIDDENPOINT) == 0
                          : true;
  }
};

Voxels VoxelsOf(vtkImageData* image, const std::string& name, vtkIdType most)
{
  const vtkIdType count = image->GetNumberOfPoints();
  Voxels voxels;
  voxels.stride = most > 0 ? (count + most - 1) / most : 1;
  voxels.count = (count + voxels.stride - 1) / voxels.stride;
  voxels.states =
    vtkNexradFindValues<vtkUnsignedCharArray>(image->GetPointData(), name + "_state", count);
  voxels.ghosts = vtkNexradFindValues<vtkUnsignedCharArray>(
    image->GetPointData(), vtkDataSetAttributes::GhostArrayName(), count);
  return voxels;
}

// How many of the voxels that are looked at are in each bin. `binOf` gives the bin of a voxel,
// `bins` for none.
template <class BinOf>
std::vector<double> CountBins(const Voxels& voxels, std::size_t bins, const BinOf& binOf)
{
  vtkSMPThreadLocal<std::vector<vtkIdType>> parts;
  vtkSMPTools::For(0, voxels.count,
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<vtkIdType>& part = parts.Local();
      part.resize(bins + 1);
      for (vtkIdType i = first; i < last; ++i)
      {
        ++part[binOf(i * voxels.stride)];
      }
    });
  std::vector<double> counts(bins);
  for (const std::vector<vtkIdType>& part : parts)
  {
    for (std::size_t bin = 0; bin < bins && bin < part.size(); ++bin)
    {
      counts[bin] += static_cast<double>(part[bin] * voxels.stride);
    }
  }
  return counts;
}

// Calls `use` with the values of an array, as values of its type.
template <class Use>
void WithValues(vtkDataArray* array, const Use& use)
{
  const auto useTyped = [&use](auto* typed) { use(vtk::DataArrayValueRange<1>(typed)); };
  if (!vtkArrayDispatch::Dispatch::Execute(array, useTyped))
  {
    useTyped(array);
  }
}

// Least and greatest value; the least above the greatest where there is none.
Range FindRange(vtkDataArray* array, const Voxels& voxels)
{
  Range range = {std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  vtkSMPThreadLocal<Range> parts(range);
  const auto find = [&](const auto& values)
  {
    vtkSMPTools::For(0, voxels.count,
      [&](vtkIdType first, vtkIdType last)
      {
        Range part = parts.Local();
        for (vtkIdType i = first; i < last; ++i)
        {
          const vtkIdType voxel = i * voxels.stride;
          const auto value = static_cast<double>(values[voxel]);
          if (voxels.Has(voxel) && std::isfinite(value))
          {
            part = {std::min(part[0], value), std::max(part[1], value)};
          }
        }
        parts.Local() = part;
      });
  };
  WithValues(array, find);
  for (const Range& part : parts)
  {
    range = {std::min(range[0], part[0]), std::max(range[1], part[1])};
  }
  return range;
}

// The least of 1, 2 and 5 times a power of ten that is not below a width.
double RoundUp(double width)
{
  const double decade = std::pow(10.0, std::floor(std::log10(width)));
  for (const double factor : {1.0, 2.0, 5.0})
  {
    if (width <= factor * decade * 1.000001)
    {
      return factor * decade;
    }
  }
  return 10.0 * decade;
}

// Empty bins from the least to the greatest value.
Bins MakeBins(const std::string& name, double width, const Range& range)
{
  double usual[2] = {range[0], range[1]};
  vtkNexradTwoFields::GetUsualRange(name.c_str(), usual);
  Bins bins;
  bins.width = width >= 1e-12        ? width
               : usual[1] > usual[0] ? RoundUp((usual[1] - usual[0]) / binsOfUsualRange)
                                     : 1.0;
  bins.first = std::floor(range[0] / bins.width);
  const double count = std::floor(range[1] / bins.width) - bins.first + 1.0;
  if (!(count <= mostBins))
  {
    throw nexrad::Error("the values of " + name + " lie in more than 4096 bins");
  }
  bins.voxels.resize(static_cast<std::size_t>(count));
  return bins;
}

// A code that stands for a value, the interval that was rounded to it, and its voxels.
struct Code
{
  double value;
  double from, to;
  double voxels;
};

// Those that stand for values, in the order of these.
std::vector<Code> CodesOf(
  vtkDataArray* values, const unsigned char* states, const std::vector<double>& counts)
{
  std::vector<Code> codes;
  for (std::size_t code = 0; code < codeCount; ++code)
  {
    const double value = values->GetComponent(static_cast<vtkIdType>(code), 0);
    if ((!states || states[code] == echo) && std::isfinite(value))
    {
      codes.push_back({value, value, value, counts[code]});
    }
  }
  std::sort(
    codes.begin(), codes.end(), [](const Code& a, const Code& b) { return a.value < b.value; });
  for (std::size_t i = 0; codes.size() > 1 && i < codes.size(); ++i)
  {
    const double before = i > 0 ? codes[i].value - codes[i - 1].value : 0.0;
    const double after = i + 1 < codes.size() ? codes[i + 1].value - codes[i].value : before;
    codes[i].from -= 0.5 * (i > 0 ? before : after);
    codes[i].to += 0.5 * after;
  }
  return codes;
}

void Spread(const Code& code, Bins& bins)
{
  if (!(code.from < code.to))
  {
    bins.voxels[bins.Of(code.value)] += code.voxels;
    return;
  }
  const double perUnit = code.voxels / (code.to - code.from);
  for (std::size_t bin = bins.Of(code.from); bin <= bins.Of(code.to); ++bin)
  {
    const double begin = (bins.first + static_cast<double>(bin)) * bins.width;
    const double shared = std::min(code.to, begin + bins.width) - std::max(code.from, begin);
    bins.voxels[bin] += perUnit * std::max(shared, 0.0);
  }
}

// `values`: of the codes.
Bins CountCodes(vtkImageData* image, vtkUnsignedCharArray* array, const std::string& name,
  vtkDataArray* values, vtkIdType most, double width)
{
  const unsigned char* of = array->GetPointer(0);
  const std::vector<double> counts = CountBins(VoxelsOf(image, "", most), codeCount,
    [of](vtkIdType voxel) { return static_cast<std::size_t>(of[voxel]); });
  const unsigned char* states = vtkNexradFindValues<vtkUnsignedCharArray>(
    image->GetFieldData(), name + "_code_states", codeCount);
  std::vector<Code> codes = CodesOf(values, states, counts);
  codes.erase(
    std::remove_if(codes.begin(), codes.end(), [](const Code& code) { return code.voxels == 0.0; }),
    codes.end());
  if (codes.empty())
  {
    return {};
  }
  Bins bins = MakeBins(name, width, {codes.front().from, codes.back().to});
  for (const Code& code : codes)
  {
    Spread(code, bins);
  }
  return bins;
}

Bins CountValues(
  vtkImageData* image, vtkDataArray* array, const std::string& name, vtkIdType most, double width)
{
  const Voxels voxels = VoxelsOf(image, name, most);
  const Range range = FindRange(array, voxels);
  if (range[0] > range[1])
  {
    return {};
  }
  Bins bins = MakeBins(name, width, range);
  const std::size_t none = bins.voxels.size();
  const auto count = [&](const auto& values)
  {
    bins.voxels = CountBins(voxels, none,
      [&](vtkIdType voxel)
      {
        const auto value = static_cast<double>(values[voxel]);
        return voxels.Has(voxel) && std::isfinite(value) ? bins.Of(value) : none;
      });
  };
  WithValues(array, count);
  return bins;
}

void ToTable(const Bins& bins, vtkTable* table)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("value");
  vtkNew<vtkDoubleArray> voxels;
  voxels->SetName("voxels");
  for (std::size_t bin = 0; bin < bins.voxels.size(); ++bin)
  {
    values->InsertNextValue((bins.first + static_cast<double>(bin) + 0.5) * bins.width);
    voxels->InsertNextValue(bins.voxels[bin]);
  }
  table->AddColumn(values);
  table->AddColumn(voxels);
}

} // namespace

int vtkNexradHistogram::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkNexradHistogram::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkImageData* image = vtkImageData::GetData(input[0]);
  vtkTable* table = vtkTable::GetData(output);
  if (image->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  try
  {
    vtkDataArray* array = FindArray(image, this->ArrayName);
    const std::string name = array->GetName() ? array->GetName() : "";
    vtkDataArray* values = vtkNexradFindCodeValues(image, name);
    ToTable(values ? CountCodes(image, vtkUnsignedCharArray::SafeDownCast(array), name, values,
                       this->MaximumNumberOfVoxels, this->BinWidth)
                   : CountValues(image, array, name, this->MaximumNumberOfVoxels, this->BinWidth),
      table);
  }
  catch (const nexrad::Error& error)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    return vtkNexradFail(this, error.what());
  }
  return 1;
}

void vtkNexradHistogram::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "BinWidth: " << this->BinWidth << "\n";
  os << indent << "MaximumNumberOfVoxels: " << this->MaximumNumberOfVoxels << "\n";
}
