// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Site.h"

#include <string>

namespace nexrad
{

/// Tells radars apart: by their names; those without a name by where they stand. A radar whose
/// stored position differs between two of its files is one radar all the same.
struct SiteKey
{
  std::string name;       ///< empty when the files give none
  double latitude = 0.0;  ///< degrees; 0 for a radar with a name, or without a position
  double longitude = 0.0; ///< degrees; likewise

  bool operator==(const SiteKey& other) const;
  bool operator<(const SiteKey& other) const;
};

/// The key of a radar.
SiteKey KeyOf(const Site& site);

} // namespace nexrad
