// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvPayload.h"

#include "nexrad/Codec/MomentCode.h"
#include "nexrad/Codec/Quantizer.h"
#include "nexrad/Codec/RunLength.h"
#include "nexrad/Compression/Deflate.h"

namespace nexrad
{

void ReadDeflated(NxvInput& file, std::uint64_t offset, const NxvArray& array, std::uint8_t* target,
  std::size_t size, const RangeLoop& loop)
{
  const auto stream = file.ReadAll(offset, array.length);
  if (array.pieces.empty())
  {
    InflateBytes(stream.data(), stream.size(), target, size);
  }
  else
  {
    InflatePieces(stream.data(), array.pieces, array.pieceBytes, target, size, loop);
  }
}

bool HasByteCodes(const NxvArray& array)
{
  return array.type == NxvType::UInt7 || array.type == NxvType::UInt8;
}

void ReadByteCodes(NxvInput& file, std::uint64_t offset, const NxvArray& array, std::uint8_t* codes,
  std::size_t voxels, const RangeLoop& loop)
{
  if (array.storage == NxvStorage::Deflated)
  {
    ReadDeflated(file, offset, array, codes, voxels, loop);
  }
  else if (array.storage == NxvStorage::RunLength)
  {
    const auto stream = file.ReadAll(offset, array.length);
    DecodeRunLength(stream.data(), stream.size(), codes, voxels, loop);
  }
  else
  {
    // How long the run-length stream will be is not known: it is decoded as it comes.
    RunLengthDecoder decoder(codes, voxels);
    Inflater inflater(
      [&decoder](const std::uint8_t* data, std::size_t size) { decoder.Feed(data, size); });
    file.Read(offset, array.length,
      [&inflater](const std::uint8_t* data, std::size_t size) { inflater.Feed(data, size); });
    inflater.Finish();
    decoder.Finish();
  }
}

VoxelCodes ByteCodesOf(const NxvArray& array, float fill)
{
  const bool sevenBits = array.type == NxvType::UInt7;
  const Quantizer quantizer{array.offset, array.scale};
  const MomentCode momentCode{1, array.offset, array.scale};
  VoxelCodes meaning;
  for (unsigned code = 0; code < VoxelCodes::Count; ++code)
  {
    const auto byte = static_cast<std::uint8_t>(code);
    VoxelState& state = meaning.states[code];
    state = sevenBits ? Quantizer::StateOf(byte) : MomentCode::StateOf(code);
    if (sevenBits && code > Quantizer::NotScannedCode)
    {
      state = VoxelState::NotScanned; // no voxel has such a code
    }
    const float value = sevenBits ? quantizer.ValueOf(byte) : momentCode.ValueOf(code);
    meaning.values[code] = state == VoxelState::Echo ? value : fill;
  }
  return meaning;
}

} // namespace nexrad
