// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/ChunkDecoder.h"

#include <utility>

namespace nexrad
{

ChunkDecoder::ChunkDecoder(const Level2Options& theOptions)
  : options(theOptions)
  , assembler(theOptions)
  , decoder(assembler, theOptions)
{
}

void ChunkDecoder::Begin(int number, const std::string& name)
{
  assembler.BeginPiece(name);
  if (number > expected)
  {
    const int missing = number - expected;
    assembler.AddDamage(0,
      std::to_string(missing) + (missing == 1 ? " chunk" : " chunks") + " missing before this one");
  }
  expected = number + 1;
}

void ChunkDecoder::AddOther(const std::string& name)
{
  assembler.BeginPiece(name);
  assembler.AddDamage(0, "a chunk of another volume, left out");
}

void ChunkDecoder::Decode(std::vector<std::uint8_t> stored)
{
  size = stored.size();
  if (stored.size() >= options.maximumFileBytes)
  {
    assembler.AddDamage(stored.size(), FileCapText(options));
  }
  decoder.Decode(std::move(stored));
}

RadarVolume ChunkDecoder::VolumeSoFar(const std::string& name) const
{
  VolumeAssembler copy = assembler;
  return copy.Finish(name, size);
}

} // namespace nexrad
