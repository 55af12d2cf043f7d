// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradGridAlgorithm.h"

#include "nexrad/Merging/MergeSettings.h"
#include "nexrad/System/Error.h"
#include "vtkNexradPipeline.h"

namespace
{

using Setting = nexrad::Setting<nexrad::MergeOptions>;

} // namespace

vtkNexradGridAlgorithm::vtkNexradGridAlgorithm() = default;

vtkNexradGridAlgorithm::~vtkNexradGridAlgorithm() = default;

void vtkNexradGridAlgorithm::SetOption(const char* key, const char* text)
{
  if (nexrad::FindSetting(nexrad::MergeSettings(), key) == nullptr)
  {
    vtkErrorMacro("there is no option " << key << "; GetOptionTable lists them");
    return;
  }
  std::string& known = this->Texts[key];
  if (known != text)
  {
    known = text;
    this->Modified();
  }
}

void vtkNexradGridAlgorithm::SetOption(const char* key, double number)
{
  const Setting* setting = nexrad::FindSetting(nexrad::MergeSettings(), key);
  this->SetOption(key, setting ? setting->TextOf(number).c_str() : "");
}

std::string vtkNexradGridAlgorithm::GetOption(const char* key) const
{
  const Setting* setting = nexrad::FindSetting(nexrad::MergeSettings(), key);
  const auto text = this->Texts.find(key);
  const bool given = text != this->Texts.end() && !text->second.empty();
  return !setting ? "" : given ? nexrad::NormalText(*setting, text->second) : setting->Default();
}

std::string vtkNexradGridAlgorithm::GetOptionTable()
{
  return nexrad::SettingsJson({nexrad::MergeSettings().begin(), nexrad::MergeSettings().end()});
}

void vtkNexradGridAlgorithm::SetDimensions(int x, int y, int z)
{
  this->SetOption("dims", nexrad::DimensionsText({x, y, z}).c_str());
}

void vtkNexradGridAlgorithm::SetDimensions(const int dimensions[3])
{
  this->SetDimensions(dimensions[0], dimensions[1], dimensions[2]);
}

void vtkNexradGridAlgorithm::SetRange(double metres)
{
  this->SetOption("range", metres);
}

void vtkNexradGridAlgorithm::SetHeightRange(double lower, double upper)
{
  this->SetOption("height", nexrad::HeightRangeText(lower, upper).c_str());
}

void vtkNexradGridAlgorithm::SetMethod(int method)
{
  if (method != THESIS && method != BEAM)
  {
    vtkErrorMacro("method " << method << " is unknown: it can be THESIS (" << THESIS
                            << ") or BEAM (" << BEAM << ")");
    return;
  }
  this->SetOption("method", method == THESIS ? "thesis" : "beam");
}

nexrad::MergeOptions vtkNexradGridAlgorithm::MakeMergeOptions() const
{
  nexrad::MergeOptions options;
  options.grid.range = nexrad::DefaultRange; // of a terminal radar as well
  for (const Setting& setting : nexrad::MergeSettings())
  {
    const auto text = this->Texts.find(setting.key);
    if (text != this->Texts.end() && !text->second.empty())
    {
      nexrad::SetText(setting, text->second, options);
    }
  }
  if (this->UseGeographicBounds)
  {
    options.grid.bounds = nexrad::GeographicBounds{this->GeographicBounds[0],
      this->GeographicBounds[1], this->GeographicBounds[2], this->GeographicBounds[3]};
  }
  if (this->UseStormMotion)
  {
    options.stormMotion = nexrad::Wind{this->StormMotion[0], this->StormMotion[1]};
  }
  if (this->UseGivenMotion)
  {
    options.motion = nexrad::Velocity{this->GivenMotion[0], this->GivenMotion[1]};
  }
  if (this->TimeInterpolation == LINEAR)
  {
    options.interpolation = nexrad::TimeInterpolationMethod::Linear;
  }
  for (const nexrad::MomentName moment : options.Moments())
  {
    nexrad::RequireMoment(options.method, moment);
  }
  return options;
}

int vtkNexradGridAlgorithm::Fail(unsigned long code, const std::string& line)
{
  this->SetErrorCode(code);
  return vtkNexradFail(this, line);
}

void vtkNexradGridAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const Setting& setting : nexrad::MergeSettings())
  {
    os << indent << setting.key << ": " << this->GetOption(setting.key.c_str()) << "\n";
  }
  os << indent << "UseGeographicBounds: " << this->UseGeographicBounds << "\n";
  os << indent << "GeographicBounds: " << this->GeographicBounds[0] << ", "
     << this->GeographicBounds[1] << ", " << this->GeographicBounds[2] << ", "
     << this->GeographicBounds[3] << "\n";
  os << indent << "UseStormMotion: " << this->UseStormMotion << "\n";
  os << indent << "StormMotion: " << this->StormMotion[0] << ", " << this->StormMotion[1] << "\n";
  os << indent << "TimeInterpolation: " << this->TimeInterpolation << "\n";
  os << indent << "UseGivenMotion: " << this->UseGivenMotion << "\n";
  os << indent << "GivenMotion: " << this->GivenMotion[0] << ", " << this->GivenMotion[1] << "\n";
}
