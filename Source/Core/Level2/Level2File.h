// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Level2Options.h"
#include "nexrad/Level2/Messages/VolumeHeader.h"
#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// Reads a Level II file, or a folder of real-time chunks, in any container that the archive uses
/// (Documentation/Formats/level2.md lists them). Every ray that can be read is in the result; what
/// is wrong is in `damage`, and a file without a single ray is a volume without sweeps; when
/// nothing is wrong either, it holds metadata alone (HoldsMetadataAlone). A folder that holds a
/// single Level II file, whatever its name, is read as that file. A tar archive counts as a folder,
/// and its members are files ("day.tar/KTLX20130520_200356_V06.gz"). Throws Error when the path
/// cannot be opened, a folder holds neither, and for a file of another well-known format.
RadarVolume ReadLevel2(const std::filesystem::path& path, const Level2Options& options = {});

/// True for the volume of a file that holds metadata and no ray, as it should: the archive has such
/// files ("KTLX20130520_200356_V06_MDM") beside those of the volumes.
bool HoldsMetadataAlone(const RadarVolume& volume);

/// The bytes of a file as it is stored, at most `cap`, whatever it says of its size. Throws Error
/// when the file cannot be read, and for a pipe or a device.
std::vector<std::uint8_t> ReadStoredBytes(const std::filesystem::path& path, std::size_t cap);

/// The same as ReadLevel2 for bytes in memory; `name` stands for the path (the site's name may be
/// taken from it).
RadarVolume DecodeLevel2(
  std::vector<std::uint8_t> bytes, const std::string& name, const Level2Options& options = {});

/// True when the first bytes look like a Level II file or one of its containers: a volume header,
/// an LDM record, gzip, bzip2 or compress. Reads no more than a few dozen bytes; false when the
/// path cannot be read.
bool LooksLikeLevel2(const std::filesystem::path& path);

/// What a file is for which LooksLikeLevel2 is false: "a zip archive; unpack it first", or else
/// "not a Level II file".
std::string WhyNotLevel2(const std::filesystem::path& path);

/// The volume header, from the first bytes of a file or of a folder's first chunk. Its time may
/// differ from the rays' times. Empty when there is none, or it cannot be had without decompressing
/// much.
std::optional<VolumeHeader> PeekVolumeHeader(const std::filesystem::path& path);

/// Whether a file is a gzip stream of messages that are in no records of bzip2: then it is larger
/// than other files of the archive that hold as much.
bool IsGzipOfMessages(const std::filesystem::path& path);

/// One file of the real-time feed: "20210729-123848-001-S" starts the volume of that time, "-I"
/// goes on with it, "-E" ends it.
struct Chunk
{
  std::filesystem::path path;
  std::string volume; ///< "20210729-123848"
  int number = 0;     ///< from 1
  char kind = 'I';    ///< S, I or E
};

/// Empty when the file's name is not that of a chunk.
std::optional<Chunk> ParseChunkName(const std::filesystem::path& path);

/// The chunks of a folder, ordered by volume and number. Throws Error when it cannot be read.
std::vector<Chunk> ListChunks(const std::filesystem::path& folder);

} // namespace nexrad
