// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/InfoReport.h"

#include "Output/EchoReport.h"
#include "Output/MessageOutput.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/MomentLimits.h"
#include "nexrad/Model/MomentSummary.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Model/SweepWaveforms.h"
#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/Quality/EchoClassification.h"
#include "nexrad/System/RangeLoop.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace nexrad::application
{

namespace
{

using Json = nlohmann::ordered_json;

template <typename Value>
Json OrNull(const std::optional<Value>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

Json TimeOrNull(const std::optional<Time>& time)
{
  return time ? Json(FormatIso8601(*time)) : Json(nullptr);
}

Json MakeMoment(const MomentSummary& summary, MomentName name)
{
  Json moment = {{"gates", summary.gates}, {"first_gate_m", summary.firstGate},
    {"gate_spacing_m", summary.gateSpacing}, {"valid", summary.valid},
    {"below_threshold", summary.belowThreshold}, {"range_folded", summary.rangeFolded}};
  if (name == MomentName::CFP)
  {
    moment["status"] = summary.status;
  }
  const bool known = summary.valid > 0;
  moment["min"] = known ? Json(summary.minimum) : Json(nullptr);
  moment["max"] = known ? Json(summary.maximum) : Json(nullptr);
  moment["mean"] = known ? Json(summary.mean) : Json(nullptr);
  return moment;
}

// A file that does not tell holds 0, which no radar has.
Json KnownOrNull(float value)
{
  return value > 0.0F ? Json(value) : Json(nullptr);
}

std::string KnownText(float value, int decimals)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  return value > 0.0F ? text.str() : "-";
}

Json MakeSweep(const Sweep& sweep, std::size_t index, double beamWidth)
{
  const Ray& first = sweep.rays.front();
  const std::string waveform = ToString(sweep.waveform);
  Json result = {{"index", index}, {"elevation_number", sweep.elevationNumber},
    {"elevation_deg", sweep.MedianElevation()}, {"elevation_mean_deg", sweep.MeanElevation()},
    {"waveform", waveform.empty() ? Json(nullptr) : Json(waveform)}, {"rays", sweep.rays.size()},
    {"stray_rays", sweep.StrayRays(beamWidth).size()}, {"first_azimuth_deg", first.azimuth},
    {"start", FormatIso8601(first.time)}, {"nyquist_m_s", KnownOrNull(first.nyquist)},
    {"unambiguous_range_m", KnownOrNull(first.unambiguousRange)}, {"moments", Json::object()}};
  for (const MomentName name : AllMoments)
  {
    const MomentSummary summary = Summarize(sweep, name);
    if (summary.rays > 0)
    {
      result["moments"][ToString(name)] = MakeMoment(summary, name);
    }
  }
  return result;
}

Json MakeGate(const RadarVolume& volume, const GateRequest& request)
{
  Json gate = {{"sweep", request.sweep}, {"ray", request.ray}, {"gate", request.gate},
    {"moments", Json::object()}};
  const Ray* ray = FindRay(volume, request);
  for (const MomentName name : AllMoments)
  {
    if (ray != nullptr && request.gate < ray->Row(name).gates)
    {
      const MomentRow& row = ray->Row(name);
      const bool valid = row.State(request.gate) == GateState::Valid;
      const double value = (row.Raw(request.gate) - double(row.offset)) / double(row.scale);
      gate["moments"][ToString(name)] = {
        {"raw", row.Raw(request.gate)}, {"value", valid ? Json(value) : Json(nullptr)}};
    }
  }
  return gate;
}

Json MakeCuts(const RadarVolume& volume)
{
  Json volumes = Json::array();
  for (const VolumeCuts& cuts : volume.cuts)
  {
    volumes.push_back({{"vcp", OrNull(cuts.patternNumber)}, {"expected", OrNull(cuts.expected)},
      {"missing", cuts.missing}, {"excerpt", cuts.excerpt}, {"not_scanned", cuts.notScanned},
      {"repeated", cuts.repeated}, {"end", ToString(cuts.end)}});
  }
  return volumes;
}

std::string DescribePosition(const Site& site)
{
  if (!site.position)
  {
    return "position unknown";
  }
  std::ostringstream text;
  const Position& place = *site.position;
  text << std::fixed << std::setprecision(4) << std::abs(place.latitude)
       << (place.latitude < 0.0 ? " S " : " N ") << std::abs(place.longitude)
       << (place.longitude < 0.0 ? " W, " : " E, ") << std::setprecision(0) << place.altitude
       << " m above mean sea level";
  return text.str();
}

std::string NameOrUnnamed(const Site& site)
{
  return site.name.empty() ? "unnamed site" : site.name;
}

// The rest of a line: what was scanned, and how much of it is there.
void PrintContents(
  const RadarVolume& volume, const std::optional<int>& messageType, std::ostream& out)
{
  if (volume.coveragePatternNumber)
  {
    out << "VCP " << *volume.coveragePatternNumber << ", ";
  }
  if (messageType)
  {
    out << "message " << *messageType << ", ";
  }
  out << Counted(volume.sweeps.size(), "sweep") << ", " << Counted(volume.RayCount(), "ray") << ", "
      << (volume.complete ? "complete" : "not complete") << '\n';
}

void PrintHead(const RadarVolume& volume, std::ostream& out)
{
  out << volume.file << '\n'
      << "  " << NameOrUnnamed(volume.site) << ", " << DescribePosition(volume.site) << '\n'
      << "  ";
  PrintContents(volume, volume.messageType, out);
  if (const auto start = volume.Start())
  {
    out << "  " << FormatIso8601(*start) << " to " << FormatIso8601(*volume.End()) << '\n';
  }
}

// The ICD's letters; "-" when unknown.
const char* ShortNameOf(Waveform waveform)
{
  switch (waveform)
  {
  case Waveform::ContiguousSurveillance:
    return "CS";
  case Waveform::ContiguousDoppler:
    return "CD/W";
  case Waveform::ContiguousDopplerWithout:
    return "CD/WO";
  case Waveform::Batch:
    return "B";
  case Waveform::StaggeredPulsePair:
    return "SPP";
  case Waveform::Unknown:
    break;
  }
  return "-";
}

std::string DescribeSweep(const Sweep& sweep, std::size_t index)
{
  std::ostringstream out;
  const Ray& first = sweep.rays.front();
  out << std::fixed << std::setw(7) << index << std::setw(5) << sweep.elevationNumber
      << std::setw(8) << std::setprecision(2) << sweep.MedianElevation() << std::setw(6)
      << sweep.rays.size() << "  " << FormatIso8601(first.time).substr(11, 12) << std::setw(9)
      << KnownText(first.nyquist, 1) << std::setw(7) << ShortNameOf(sweep.waveform) << std::setw(6)
      << KnownText(first.unambiguousRange / 1000.0F, 0) << std::setprecision(1) << "  ";
  for (const MomentName name : AllMoments)
  {
    const MomentSummary summary = Summarize(sweep, name);
    if (summary.rays > 0)
    {
      out << ' ' << ToString(name) << ' ' << summary.gates << 'x' << summary.gateSpacing << 'm';
      if (summary.valid > 0)
      {
        out << " (" << summary.minimum << " to " << summary.maximum << ')';
      }
    }
  }
  out << '\n';
  return out.str();
}

// What `make` makes of the sweeps, in their order. It reads all of their gates, side by side.
template <class Made, class Make>
std::vector<Made> OfEachSweep(const RadarVolume& volume, const Make& make)
{
  std::vector<Made> made(volume.sweeps.size());
  RunEach(ThreadLoop(CoreCount()), made.size(),
    [&](std::size_t index) { made[index] = make(volume.sweeps[index], index); });
  return made;
}

void PrintGate(const Json& gate, std::ostream& out)
{
  out << "  gate " << gate["sweep"] << ',' << gate["ray"] << ',' << gate["gate"] << ':';
  for (const auto& [name, moment] : gate["moments"].items())
  {
    out << ' ' << name << ' ' << moment["value"] << " (raw " << moment["raw"] << ')';
  }
  out << (gate["moments"].empty() ? " not in this file\n" : "\n");
}

// What reading noted, and what is found in the values by looking at all of them.
std::vector<std::string> NotesOn(const RadarVolume& volume)
{
  std::vector<std::string> notes = volume.notes;
  const std::string impossible = DescribeImpossibleGates(volume.sweeps);
  if (!impossible.empty())
  {
    notes.push_back(impossible);
  }
  return notes;
}

// What quality control finds in the reflectivity; empty without any, or where nobody asked for it.
std::optional<ReasonCounts> CountEcho(const RadarVolume& volume, const InfoRequest& request)
{
  const bool any = std::any_of(volume.sweeps.begin(), volume.sweeps.end(),
    [](const Sweep& sweep) { return sweep.Has(MomentName::REF); });
  if (!any || !request.echo)
  {
    return std::nullopt;
  }
  return ClassifyEcho(volume).counts;
}

} // namespace

const Ray* FindRay(const RadarVolume& volume, const GateRequest& request)
{
  const bool found =
    request.sweep < volume.sweeps.size() && request.ray < volume.sweeps[request.sweep].rays.size();
  return found ? &volume.sweeps[request.sweep].rays[request.ray] : nullptr;
}

Json MakeInfoJson(const RadarVolume& volume, const InfoRequest& request)
{
  const auto& position = volume.site.position;
  Json info = {{"file", volume.file},
    {"site", volume.site.name.empty() ? Json(nullptr) : Json(volume.site.name)},
    {"latitude", position ? Json(position->latitude) : Json(nullptr)},
    {"longitude", position ? Json(position->longitude) : Json(nullptr)},
    {"altitude_m",
      position ? Json(volume.storedAltitude.value_or(position->altitude)) : Json(nullptr)},
    {"vcp", OrNull(volume.coveragePatternNumber)}, {"message_type", OrNull(volume.messageType)},
    {"start", TimeOrNull(volume.Start())}, {"end", TimeOrNull(volume.End())},
    {"complete", volume.complete}, {"cuts", MakeCuts(volume)}, {"damage", Json::array()},
    {"notes", NotesOn(volume)}, {"echo", nullptr}, {"sweeps", Json::array()}};
  if (const auto echo = CountEcho(volume, request))
  {
    info["echo"] = MakeEchoJson(*echo);
  }
  for (const Damage& damage : volume.damage)
  {
    info["damage"].push_back({{"offset", damage.offset}, {"what", damage.what}});
  }
  info["sweeps"] = OfEachSweep<Json>(volume,
    [beamWidth = BeamWidthOf(volume.site)](const Sweep& sweep, std::size_t index)
    { return MakeSweep(sweep, index, beamWidth); });
  for (const GateRequest& gate : request.gates)
  {
    info["gates"].push_back(MakeGate(volume, gate));
  }
  return info;
}

void PrintInfoLine(const RadarVolume& volume, std::ostream& out)
{
  out << volume.file << ": ";
  if (volume.sweeps.empty())
  {
    out << (HoldsMetadataAlone(volume) ? "metadata alone, no ray\n" : "no ray can be read\n");
    return;
  }
  out << NameOrUnnamed(volume.site) << ", " << FormatIso8601(*volume.Start()) << " to "
      << FormatIso8601(*volume.End()) << ", ";
  PrintContents(volume, std::nullopt, out);
}

void PrintInfoTable(const RadarVolume& volume, const InfoRequest& request, std::ostream& out)
{
  PrintHead(volume, out);
  if (!volume.sweeps.empty())
  {
    out << "  sweep  cut  elev.°  rays  start (UTC)   Nyq. m/s  wave    km  moments: gates (lowest "
           "to highest)\n";
  }
  for (const std::string& line : OfEachSweep<std::string>(volume, DescribeSweep))
  {
    out << line;
  }
  if (const auto echo = CountEcho(volume, request))
  {
    PrintEcho(*echo, out);
  }
  for (const GateRequest& gate : request.gates)
  {
    PrintGate(MakeGate(volume, gate), out);
  }
  for (const std::string& note : NotesOn(volume))
  {
    out << "  note: " << note << '\n';
  }
}

} // namespace nexrad::application
