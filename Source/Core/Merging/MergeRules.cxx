// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/MergeRules.h"

#include "nexrad/System/Error.h"

#include <string>

namespace nexrad
{

const char* ToString(MergeMethod method)
{
  switch (method)
  {
  case MergeMethod::Thesis:
    return "thesis";
  case MergeMethod::Beam:
    return "beam";
  }
  return "";
}

std::optional<MergeMethod> ParseMergeMethod(std::string_view text)
{
  for (const MergeMethod method : {MergeMethod::Thesis, MergeMethod::Beam})
  {
    if (text == ToString(method))
    {
      return method;
    }
  }
  return std::nullopt;
}

MomentOptions MomentOptionsOf(const MergeRules& rules)
{
  MomentOptions options = rules;
  if (rules.method == MergeMethod::Thesis)
  {
    options.quality.level = QualityLevel::Off;
  }
  return options;
}

VolumeRule VolumeRuleOf(const MergeRules& rules)
{
  return {rules.method == MergeMethod::Thesis, rules.maximumGap};
}

void RequireMoment(MergeMethod method, MomentName moment)
{
  if (method == MergeMethod::Thesis && moment != MomentName::REF)
  {
    throw Error(
      std::string("moment ") + ToString(moment) +
      " cannot be merged by the thesis's method, which knows reflectivity alone: set REF");
  }
}

} // namespace nexrad
