// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradMoments.h"

#include "nexrad/Model/Moment.h"

#include "vtkObjectFactory.h"

#include <optional>

namespace
{

std::optional<nexrad::MomentName> Parse(const char* moment)
{
  return nexrad::ParseMomentName(moment ? moment : "");
}

} // namespace

vtkStandardNewMacro(vtkNexradMoments);

int vtkNexradMoments::GetNumberOfMoments()
{
  return static_cast<int>(nexrad::KnownMomentCount);
}

const char* vtkNexradMoments::GetMomentName(int index)
{
  return index >= 0 && index < GetNumberOfMoments()
           ? nexrad::ToString(nexrad::KnownMoments[static_cast<std::size_t>(index)])
           : nullptr;
}

const char* vtkNexradMoments::GetUnit(const char* moment)
{
  const std::optional<nexrad::MomentName> name = Parse(moment);
  return name ? nexrad::UnitOf(*name) : nullptr;
}

const char* vtkNexradMoments::GetTitle(const char* moment)
{
  const std::optional<nexrad::MomentName> name = Parse(moment);
  return name ? nexrad::TitleOf(*name) : nullptr;
}

bool vtkNexradMoments::HasTwoSigns(const char* moment)
{
  const std::optional<nexrad::MomentName> name = Parse(moment);
  return name && nexrad::HasTwoSigns(*name);
}

void vtkNexradMoments::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
