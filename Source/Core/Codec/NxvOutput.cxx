// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvOutput.h"

#include "nexrad/Codec/LittleEndian.h"
#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"

#include <string>

namespace nexrad
{

void WriteNxvFile(
  const std::filesystem::path& path, const NxvHeader& header, const NxvPayload& payload)
{
  const std::string text = FormatNxvHeader(header);
  if (text.size() > NxvLargestHeader)
  {
    throw Error(path.string() + ": the header would be longer than " +
                std::to_string(NxvLargestHeader) + " bytes");
  }
  std::vector<std::uint8_t> start = {'N', 'X', 'V', '1'};
  AppendLittleEndian(static_cast<std::uint32_t>(text.size()), start);
  AtomicFile file(path);
  file.Write(start.data(), start.size());
  file.Write(text.data(), text.size());
  for (const std::vector<std::uint8_t>* part : payload)
  {
    file.Write(part->data(), part->size());
  }
  file.Commit();
}

} // namespace nexrad
