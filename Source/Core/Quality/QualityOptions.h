// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace nexrad
{

/// What quality control takes out of reflectivity.
enum class QualityLevel : std::uint8_t
{
  Off,      ///< nothing
  Standard, ///< ground echo, spikes, receiver faults and speckle
  Strict    ///< the same, and biological echo
};

/// "off", "standard", "strict".
const char* ToString(QualityLevel level);
/// Empty when the text is none of these names.
std::optional<QualityLevel> ParseQualityLevel(std::string_view text);

/// What is taken out of a volume before it is merged.
struct QualityOptions
{
  QualityLevel level = QualityLevel::Off; ///< see RemovesClass

  /// A gate with a value stays when as many of its 26 neighbours (ray, gate and tilt) have one;
  /// 0…26, 0 keeps all. See Despeckle.
  int neighbours = 0;

  bool operator==(const QualityOptions& other) const
  {
    return level == other.level && neighbours == other.neighbours;
  }
};

} // namespace nexrad
