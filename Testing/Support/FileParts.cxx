// SPDX-License-Identifier: BSD-3-Clause
#include "FileParts.h"

#include "TestData.h"
#include "nexrad/Compression/Container.h"
#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Level2/Messages/MessageStream.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace nexrad::testing
{

namespace
{

constexpr std::size_t volumeHeaderBytes = 24;

Bytes Slice(const Bytes& bytes, std::size_t begin, std::size_t end)
{
  return {bytes.begin() + static_cast<std::ptrdiff_t>(begin),
    bytes.begin() + static_cast<std::ptrdiff_t>(end)};
}

// Where each group of messages begins, and the end.
std::vector<std::size_t> BoundsOfMessages(const Bytes& plain, std::size_t messages)
{
  std::vector<std::size_t> bounds;
  const ByteView view(plain.data(), plain.size());
  MessageStream stream(view.Sub(volumeHeaderBytes), [](std::size_t, const std::string&) {});
  std::size_t count = 0;
  while (const auto message = stream.Next())
  {
    if (count++ % messages == 0)
    {
      bounds.push_back(volumeHeaderBytes + message->offset);
    }
  }
  bounds.push_back(plain.size());
  return bounds;
}

std::vector<std::size_t> BoundsOfRecords(const Bytes& plain)
{
  std::vector<std::size_t> bounds;
  const ByteView view(plain.data(), plain.size());
  if (FindLdmRecord(view, volumeHeaderBytes) == volumeHeaderBytes)
  {
    for (const LdmRecord& record :
      FindLdmRecords(view, volumeHeaderBytes, [](std::size_t, const std::string&) {}))
    {
      bounds.push_back(record.offset);
    }
    bounds.push_back(plain.size());
  }
  return bounds;
}

std::string Difference(const Ray& a, const Ray& b)
{
  if (a.time != b.time || a.azimuth != b.azimuth || a.elevation != b.elevation ||
      a.nyquist != b.nyquist || a.unambiguousRange != b.unambiguousRange ||
      a.radialStatus != b.radialStatus || a.elevationNumber != b.elevationNumber)
  {
    return FormatIso8601(a.time) + " or " + FormatIso8601(b.time);
  }
  for (const MomentName name : AllMoments)
  {
    const MomentRow& one = a.Row(name);
    const MomentRow& other = b.Row(name);
    const bool same =
      one.gates == other.gates && one.wordBits == other.wordBits && one.scale == other.scale &&
      one.offset == other.offset && one.firstGate == other.firstGate &&
      one.gateSpacing == other.gateSpacing && one.firstValue == other.firstValue &&
      std::equal(one.words, one.words + std::size_t(one.gates) * one.wordBits / 8, other.words);
    if (!same)
    {
      return std::string(ToString(name)) + " at " + FormatIso8601(a.time);
    }
  }
  return {};
}

} // namespace

Bytes FileParts::Whole() const
{
  return nexrad::testing::Join({header, nexrad::testing::Join(parts)});
}

FileParts CutFile(const std::filesystem::path& path, std::size_t messages)
{
  const std::string content = FileContent(path);
  return CutFile(Bytes(content.begin(), content.end()), messages);
}

FileParts CutFile(Bytes stored, std::size_t messages)
{
  std::vector<Damage> ignored;
  DecodingBudget budget(std::size_t(1) << 30, std::size_t(1) << 30);
  const Bytes plain = OpenContainer(std::move(stored), budget, ignored).bytes;
  std::vector<std::size_t> bounds = BoundsOfRecords(plain);
  bounds = bounds.empty() ? BoundsOfMessages(plain, messages) : bounds;
  FileParts file;
  file.header = Slice(plain, 0, volumeHeaderBytes);
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i)
  {
    file.parts.push_back(Slice(plain, bounds[i], bounds[i + 1]));
  }
  return file;
}

FileParts Decompress(const FileParts& file)
{
  constexpr std::size_t lengthBytes = 4;
  FileParts plain;
  plain.header = file.header;
  for (const Bytes& part : file.parts)
  {
    const ByteView view(part.data(), part.size());
    const bool isRecord = IsLdmRecord(view, 0);
    plain.parts.push_back(
      isRecord ? Bzip2Reader().Run(view.Sub(lengthBytes), std::size_t(1) << 30).bytes : part);
  }
  return plain;
}

std::vector<ChangedFile> ChangeAt(
  const FileParts& file, std::size_t place, const Bytes& foreignPart)
{
  constexpr std::size_t late = 5;
  std::vector<ChangedFile> changed;
  const auto change = [&](const std::string& what, const auto& apply)
  {
    FileParts copy = file;
    apply(copy.parts, copy.parts.begin() + static_cast<std::ptrdiff_t>(place));
    changed.push_back({what + " at part " + std::to_string(place), copy.Whole()});
  };
  using Parts = std::vector<Bytes>;
  using Place = Parts::iterator;
  const Bytes part = file.parts[place];
  change("repeated at once", [&](Parts& parts, Place at) { parts.insert(at + 1, part); });
  change("repeated at the end", [&](Parts& parts, Place) { parts.push_back(part); });
  change("repeated in front", [&](Parts& parts, Place) { parts.insert(parts.begin(), part); });
  change("late by five", [&](Parts& parts, Place at)
    { std::rotate(at, at + 1, at + std::min<std::ptrdiff_t>(late + 1, parts.end() - at)); });
  change("late at the end", [&](Parts& parts, Place at) { std::rotate(at, at + 1, parts.end()); });
  if (place + 1 < file.parts.size())
  {
    change("swapped", [&](Parts&, Place at) { std::iter_swap(at, at + 1); });
  }
  change("foreign", [&](Parts& parts, Place at) { parts.insert(at, foreignPart); });
  return changed;
}

std::string DifferenceOf(const RadarVolume& a, const RadarVolume& b)
{
  if (a.site.name != b.site.name || !(a.site.position == b.site.position))
  {
    return "site " + a.site.name + " or " + b.site.name;
  }
  if (a.sweeps.size() != b.sweeps.size() || a.complete != b.complete ||
      a.coveragePatternNumber != b.coveragePatternNumber || a.messageType != b.messageType)
  {
    return std::to_string(a.sweeps.size()) + " or " + std::to_string(b.sweeps.size()) +
           " sweeps, complete or not, or another pattern";
  }
  for (std::size_t i = 0; i < a.sweeps.size(); ++i)
  {
    const Sweep& one = a.sweeps[i];
    const Sweep& other = b.sweeps[i];
    if (one.rays.size() != other.rays.size() || one.elevationNumber != other.elevationNumber ||
        one.waveform != other.waveform)
    {
      return "sweep " + std::to_string(i) + " of " + std::to_string(one.rays.size()) + " or " +
             std::to_string(other.rays.size()) + " rays";
    }
    for (std::size_t ray = 0; ray < one.rays.size(); ++ray)
    {
      if (const std::string what = Difference(one.rays[ray], other.rays[ray]); !what.empty())
      {
        return "sweep " + std::to_string(i) + ", ray " + std::to_string(ray) + ": " + what;
      }
    }
  }
  return {};
}

} // namespace nexrad::testing
