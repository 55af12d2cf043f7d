// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <string>

/// What a decoder says of a volume, as texts for the tests.
namespace nexrad::testing
{

/// All damage, a line each.
inline std::string DamageOf(const RadarVolume& volume)
{
  std::string text;
  for (const Damage& damage : volume.damage)
  {
    text += damage.what + '\n';
  }
  return text;
}

/// All notes, a line each.
inline std::string NotesOf(const RadarVolume& volume)
{
  std::string text;
  for (const std::string& note : volume.notes)
  {
    text += note + '\n';
  }
  return text;
}

inline bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

inline bool HasDamage(const RadarVolume& volume, const std::string& part)
{
  return Has(DamageOf(volume), part);
}

inline bool HasNote(const RadarVolume& volume, const std::string& part)
{
  return Has(NotesOf(volume), part);
}

} // namespace nexrad::testing
