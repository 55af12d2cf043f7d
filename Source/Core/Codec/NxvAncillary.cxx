// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvAncillary.h"

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

template <class Value, class Test>
void CheckAll(const std::vector<Value>& values, const Test& isPossible, const std::string& right)
{
  const auto wrong = std::find_if_not(values.begin(), values.end(), isPossible);
  if (wrong != values.end())
  {
    throw Error("voxel " + std::to_string(wrong - values.begin()) + " has " +
                std::to_string(*wrong) + ": " + right);
  }
}

} // namespace

void CheckAncillaryArray(const std::string&, const std::vector<float>& values, std::size_t)
{
  CheckAll(
    values, [](float value) { return value >= 0.0F && std::isfinite(value); },
    "must be 0 or more, and finite");
}

void CheckAncillaryArray(
  const std::string& name, const std::vector<std::uint8_t>& values, std::size_t sites)
{
  if (name == "site")
  {
    CheckAll(
      values,
      [sites](std::uint8_t site) { return site < sites || site == AncillaryArrays::NoSite; },
      "must be one of " + std::to_string(sites) + " sites, counted from 0, or 255");
  }
}

} // namespace nexrad
