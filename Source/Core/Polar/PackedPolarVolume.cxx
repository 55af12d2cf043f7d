// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/PackedPolarVolume.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <optional>

namespace nexrad
{

namespace
{

// Codes below are the states without a value, the others places in the table.
constexpr std::uint8_t firstValueCode = 4;
constexpr std::size_t mostValues = 256 - firstValueCode;

std::uint32_t BitsOf(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

// Gives each different value a code.
class ValueTable
{
public:
  // Empty when there are no codes left.
  std::optional<std::uint8_t> CodeOf(float value)
  {
    const std::uint32_t bits = BitsOf(value);
    std::size_t place = bits * 2654435761U >> (32 - slotBits);
    while (slots[place].code != 0)
    {
      if (slots[place].bits == bits)
      {
        return slots[place].code;
      }
      place = (place + 1) % slots.size();
    }
    if (values.size() == mostValues)
    {
      return std::nullopt;
    }
    slots[place] = {bits, static_cast<std::uint8_t>(firstValueCode + values.size())};
    values.push_back(value);
    return slots[place].code;
  }

  std::vector<float> values;

private:
  struct Slot
  {
    std::uint32_t bits = 0;
    std::uint8_t code = 0; // 0: free; it is the code of no value
  };
  static constexpr unsigned slotBits = 11; // eight times as many slots as values
  std::array<Slot, std::size_t(1) << slotBits> slots;
};

// One code a gate; empty when the sweep has too many values.
std::vector<std::uint8_t> MakeCodes(const PolarSweep& sweep, ValueTable& table)
{
  std::vector<std::uint8_t> codes(sweep.values.size());
  for (std::size_t gate = 0; gate < codes.size(); ++gate)
  {
    const GateState state = sweep.states[gate];
    const auto code = state == GateState::Valid ? table.CodeOf(sweep.values[gate])
                                                : static_cast<std::uint8_t>(state);
    if (!code)
    {
      return {};
    }
    codes[gate] = *code;
  }
  return codes;
}

// A control byte c below 128 stands before c + 1 literals; one of 128 or more before a code that is
// repeated c − 126 times.
constexpr std::size_t mostLiterals = 128;
constexpr std::size_t mostRepeats = 129;
constexpr std::uint8_t repeatControl = 126;

std::size_t RunAt(const std::vector<std::uint8_t>& codes, std::size_t place)
{
  const std::size_t end = std::min(codes.size(), place + mostRepeats);
  std::size_t next = place + 1;
  while (next < end && codes[next] == codes[place])
  {
    ++next;
  }
  return next - place;
}

std::vector<std::uint8_t> PackCodes(const std::vector<std::uint8_t>& codes)
{
  constexpr std::size_t shortestRun = 3; // a shorter one would not be smaller
  std::vector<std::uint8_t> bytes;
  std::size_t literals = 0; // that stand before `place`
  const auto putLiterals = [&](std::size_t place)
  {
    if (literals > 0)
    {
      bytes.push_back(static_cast<std::uint8_t>(literals - 1));
      bytes.insert(bytes.end(), codes.data() + place - literals, codes.data() + place);
      literals = 0;
    }
  };
  for (std::size_t place = 0; place < codes.size();)
  {
    const std::size_t run = RunAt(codes, place);
    if (run >= shortestRun)
    {
      putLiterals(place);
      bytes.push_back(static_cast<std::uint8_t>(repeatControl + run));
      bytes.push_back(codes[place]);
      place += run;
      continue;
    }
    ++place;
    if (++literals == mostLiterals)
    {
      putLiterals(place);
    }
  }
  putLiterals(codes.size());
  bytes.shrink_to_fit();
  return bytes;
}

// Writes one code to a sweep of NaN and Valid.
void PutCode(
  std::uint8_t code, const std::vector<float>& table, std::size_t gate, PolarSweep& sweep)
{
  if (code >= firstValueCode)
  {
    sweep.values[gate] = table[code - firstValueCode];
  }
  else
  {
    sweep.states[gate] = static_cast<GateState>(code);
  }
}

void UnpackCodes(
  const std::vector<std::uint8_t>& bytes, const std::vector<float>& table, PolarSweep& sweep)
{
  const std::size_t gates = sweep.rays.size() * sweep.gates;
  sweep.values.assign(gates, std::numeric_limits<float>::quiet_NaN());
  sweep.states.assign(gates, GateState::Valid);
  std::size_t gate = 0;
  for (std::size_t place = 0; place < bytes.size();)
  {
    const std::uint8_t control = bytes[place++];
    const bool repeats = control >= mostLiterals;
    const std::size_t count = repeats ? control - repeatControl : control + std::size_t(1);
    for (std::size_t index = 0; index < count; ++index)
    {
      PutCode(bytes[place + (repeats ? 0 : index)], table, gate++, sweep);
    }
    place += repeats ? 1 : count;
  }
}

} // namespace

PackedPolarVolume::PackedPolarVolume(const PolarVolume& volume)
{
  frame.site = volume.site;
  frame.moment = volume.moment;
  frame.start = volume.start;
  frame.end = volume.end;
  frame.synthetic = volume.synthetic;
  for (const PolarSweep& sweep : volume.sweeps)
  {
    ValueTable table;
    const std::vector<std::uint8_t> codes = MakeCodes(sweep, table);
    PackedSweep& packed = sweeps.emplace_back();
    packed.packed = codes.size() == sweep.values.size();
    if (!packed.packed)
    {
      frame.sweeps.push_back(sweep);
      continue;
    }
    packed.table = table.values;
    packed.bytes = PackCodes(codes);
    PolarSweep& empty = frame.sweeps.emplace_back();
    empty.elevationNumber = sweep.elevationNumber;
    empty.firstGate = sweep.firstGate;
    empty.gateSpacing = sweep.gateSpacing;
    empty.gates = sweep.gates;
    empty.rays = sweep.rays;
    empty.waveform = sweep.waveform;
  }
}

PolarVolume PackedPolarVolume::Unpack() const
{
  PolarVolume volume = frame;
  for (std::size_t index = 0; index < sweeps.size(); ++index)
  {
    if (sweeps[index].packed)
    {
      UnpackCodes(sweeps[index].bytes, sweeps[index].table, volume.sweeps[index]);
    }
  }
  return volume;
}

std::size_t PackedPolarVolume::Bytes() const
{
  std::size_t bytes = sizeof(PackedPolarVolume) + MemoryOf(frame);
  for (const PackedSweep& sweep : sweeps)
  {
    bytes += sizeof(PackedSweep) + sweep.table.capacity() * sizeof(float) + sweep.bytes.capacity();
  }
  return bytes;
}

std::size_t MemoryOf(const PolarVolume& volume)
{
  std::size_t bytes = sizeof(PolarVolume);
  for (const PolarSweep& sweep : volume.sweeps)
  {
    bytes += sizeof(PolarSweep) + sweep.rays.size() * sizeof(PolarRay) +
             sweep.values.size() * sizeof(float) + sweep.states.size() * sizeof(GateState);
  }
  return bytes;
}

} // namespace nexrad
