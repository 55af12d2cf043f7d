// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradTwoFields.h"

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradVoxels.h"

#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkNexradTwoFields);

namespace
{

// Widths of the usual range from its lower end to the missing value.
constexpr double MissingWidths = 16.0;

using Range = std::array<double, 2>;

// In the units of the arrays: dBZ, m/s, m/s, dB, degrees, 1, dB; m/s, 1/s, 1/s, degrees/km.
constexpr std::array<Range, nexrad::KnownMomentCount> MomentRanges = {
  {{-32.0, 95.0}, {-64.0, 64.0}, {0.0, 32.0}, {-8.0, 12.0}, {0.0, 360.0}, {0.2, 1.06}, {0.0, 100.0},
    {-64.0, 64.0}, {-0.05, 0.05}, {-0.05, 0.05}, {-4.0, 12.0}}};

// Seconds, radars, weights and sites.
constexpr std::array<std::pair<const char*, Range>, 4> AncillaryRanges = {
  {{"age", {0.0, 900.0}}, {"radars", {0.0, 8.0}}, {"weight", {0.0, 8.0}}, {"site", {0.0, 32.0}}}};

// The moment of an ancillary array ("REF_age"), and what the array is ("age").
std::optional<std::pair<nexrad::MomentName, std::string>> SplitName(const std::string& name)
{
  const std::size_t end = name.find('_');
  const auto moment = nexrad::ParseMomentName(name.substr(0, end));
  return moment && end != std::string::npos
           ? std::optional(std::pair(*moment, name.substr(end + 1)))
           : std::nullopt;
}

vtkDataArray* FindFieldArray(vtkImageData* image, const std::string& name)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw nexrad::Error(array ? "the point array " + name + " has several components"
                        : name.empty()
                          ? "an array is not named: set ColorArrayName and OpacityArrayName"
                          : "the image has no point array " + name);
  }
  return array;
}

std::vector<float> ValuesOf(vtkDataArray* array)
{
  vtkNew<vtkFloatArray> floats;
  floats->DeepCopy(array); // which converts
  return {floats->GetPointer(0), floats->GetPointer(0) + array->GetNumberOfTuples()};
}

const unsigned char* FindBytes(vtkImageData* image, const std::string& name)
{
  return vtkNexradFindValues<vtkUnsignedCharArray>(
    image->GetPointData(), name, image->GetNumberOfPoints());
}

// Sets the values of points that have none to NaN.
void MarkMissing(vtkImageData* image, const std::string& name, std::vector<float>& values)
{
  const auto mark = [&values](const unsigned char* bytes, const auto& isMissing)
  {
    for (std::size_t i = 0; bytes != nullptr && i < values.size(); ++i)
    {
      values[i] = isMissing(bytes[i]) ? std::numeric_limits<float>::quiet_NaN() : values[i];
    }
  };
  const auto ancillary = SplitName(name);
  const std::string moment = ancillary ? nexrad::ToString(ancillary->first) : name;
  constexpr auto echo = static_cast<unsigned char>(nexrad::VoxelState::Echo);
  mark(FindBytes(image, moment + "_state"), [&](unsigned char state)
    { return ancillary ? !nexrad::IsMeasured(nexrad::ToVoxelState(state)) : state != echo; });
  if (ancillary)
  {
    mark(FindBytes(image, moment + "_radars"), [](unsigned char radars) { return radars == 0; });
    mark(FindBytes(image, moment + "_site"),
      [](unsigned char site) { return site == nexrad::AncillaryArrays::NoSite; });
  }
}

// 16 widths below the usual range, or that of the values.
double MissingValueOf(const std::string& name, const std::vector<float>& values)
{
  double range[2] = {0.0, 1.0};
  if (!vtkNexradTwoFields::GetUsualRange(name.c_str(), range))
  {
    const auto less = [](float a, float b) { return a < b || (std::isnan(b) && !std::isnan(a)); };
    const auto more = [](float a, float b) { return a < b || (std::isnan(a) && !std::isnan(b)); };
    range[0] = static_cast<double>(*std::min_element(values.begin(), values.end(), less));
    range[1] = static_cast<double>(*std::max_element(values.begin(), values.end(), more));
  }
  const double width = range[1] > range[0] ? range[1] - range[0] : 1.0;
  return std::isnan(range[0]) ? 0.0 : range[0] - MissingWidths * width;
}

// The ghost flags of an array that is not the active scalars.
void SetGhosts(vtkImageData* image, const std::string& name)
{
  const auto ancillary = SplitName(name);
  const auto moment = ancillary ? std::optional(ancillary->first) : nexrad::ParseMomentName(name);
  const unsigned char* states =
    moment ? FindBytes(image, std::string(nexrad::ToString(*moment)) + "_state") : nullptr;
  if (!states)
  {
    return;
  }
  constexpr auto hidden = static_cast<unsigned char>(vtkDataSetAttributes::HIDDENPOINT);
  const unsigned char* given = FindBytes(image, vtkDataSetAttributes::GhostArrayName());
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
  {
    const bool isHidden = vtkNexradIsHidden(*moment, static_cast<nexrad::VoxelState>(states[i]));
    const int others = given ? given[i] & ~hidden : 0;
    ghosts->SetValue(i, static_cast<unsigned char>(others | (isHidden ? hidden : 0)));
  }
  image->GetPointData()->AddArray(ghosts);
}

} // namespace

bool vtkNexradTwoFields::GetUsualRange(const char* array, double range[2])
{
  const std::string name = array ? array : "";
  if (const auto moment = nexrad::ParseMomentName(name))
  {
    std::copy_n(MomentRanges[static_cast<std::size_t>(*moment)].begin(), 2, range);
    return true;
  }
  const auto ancillary = SplitName(name);
  for (const auto& [of, usual] : AncillaryRanges)
  {
    if (ancillary && ancillary->second == of)
    {
      std::copy_n(usual.begin(), 2, range);
      return true;
    }
  }
  return false;
}

int vtkNexradTwoFields::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkDataObject::SetPointDataActiveScalarInfo(output->GetInformationObject(0), VTK_FLOAT, 2);
  return 1;
}

void vtkNexradTwoFields::Combine(vtkImageData* image)
{
  const std::string active = vtkNexradScalarsName(image);
  const std::string opacityName = this->OpacityArrayName.empty() ? active : this->OpacityArrayName;
  std::vector<float> colors = ValuesOf(FindFieldArray(image, this->ColorArrayName));
  MarkMissing(image, this->ColorArrayName, colors);
  const std::vector<float> opacities = ValuesOf(FindFieldArray(image, opacityName));
  if (opacityName != active)
  {
    SetGhosts(image, opacityName);
  }
  this->UsedMissingValue =
    this->UseMissingValue ? this->MissingValue : MissingValueOf(this->ColorArrayName, colors);
  const unsigned char* ghosts = FindBytes(image, vtkDataSetAttributes::GhostArrayName());
  vtkNew<vtkFloatArray> both;
  both->SetName("ColorAndOpacity");
  both->SetNumberOfComponents(2);
  both->SetComponentName(0, this->ColorArrayName.c_str());
  both->SetComponentName(1, opacityName.c_str());
  both->SetNumberOfTuples(image->GetNumberOfPoints());
  float* value = both->GetPointer(0);
  this->NumberOfMissingValues = 0;
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const bool missing = !std::isfinite(colors[i]);
    const bool hidden = ghosts && (ghosts[i] & vtkDataSetAttributes::HIDDENPOINT) != 0;
    this->NumberOfMissingValues += missing && !hidden ? 1 : 0;
    *value++ = missing ? static_cast<float>(this->UsedMissingValue) : colors[i];
    *value++ = opacities[i];
  }
  image->GetPointData()->SetScalars(both);
}

int vtkNexradTwoFields::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkImageData* image = vtkImageData::GetData(output);
  image->ShallowCopy(vtkImageData::GetData(input[0]));
  if (image->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  try
  {
    this->Combine(image);
  }
  catch (const nexrad::Error& error)
  {
    image->Initialize();
    this->SetErrorCode(vtkErrorCode::UserError);
    return vtkNexradFail(this, error.what());
  }
  return 1;
}

void vtkNexradTwoFields::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ColorArrayName: " << this->ColorArrayName << "\n";
  os << indent << "OpacityArrayName: " << this->OpacityArrayName << "\n";
  os << indent << "MissingValue: " << this->MissingValue << "\n";
  os << indent << "UseMissingValue: " << this->UseMissingValue << "\n";
  os << indent << "UsedMissingValue: " << this->UsedMissingValue << "\n";
  os << indent << "NumberOfMissingValues: " << this->NumberOfMissingValues << "\n";
}
