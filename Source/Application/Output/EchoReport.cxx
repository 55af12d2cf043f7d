// SPDX-License-Identifier: BSD-3-Clause
#include "Output/EchoReport.h"

#include "nexrad/Quality/EchoClassification.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <iomanip>
#include <numeric>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace nexrad::application
{

namespace
{

using Json = nlohmann::ordered_json;
using NamedCount = std::pair<std::string, std::size_t>;

constexpr std::array<QualityLevel, 2> levels = {QualityLevel::Standard, QualityLevel::Strict};

// Of each reason but None.
std::vector<NamedCount> ByReason(const ReasonCounts& counts)
{
  std::vector<NamedCount> named;
  for (std::size_t reason = 1; reason < EchoReasonCount; ++reason)
  {
    named.emplace_back(ToString(static_cast<EchoReason>(reason)), counts[reason]);
  }
  return named;
}

// Of each class but None.
std::vector<NamedCount> ByClass(const ReasonCounts& counts)
{
  std::vector<NamedCount> named;
  for (std::size_t each = 1; each < EchoClassCount; ++each)
  {
    named.emplace_back(ToString(static_cast<EchoClass>(each)), 0);
  }
  for (std::size_t reason = 1; reason < EchoReasonCount; ++reason)
  {
    const EchoClass of = ClassOf(static_cast<EchoReason>(reason));
    named.at(static_cast<std::size_t>(of) - 1).second += counts[reason];
  }
  return named;
}

// Of all reasons but None.
std::size_t Sum(const ReasonCounts& counts)
{
  return std::accumulate(counts.begin() + 1, counts.end(), std::size_t(0));
}

ReasonCounts TakenOut(const ReasonCounts& counts, QualityLevel level)
{
  ReasonCounts taken = counts;
  for (std::size_t reason = 0; reason < EchoReasonCount; ++reason)
  {
    const bool out = RemovesClass(level, ClassOf(static_cast<EchoReason>(reason)));
    taken[reason] = out ? taken[reason] : 0;
  }
  return taken;
}

// "ground texture 1200, few gates 30", the most first, without those that no gate has.
std::string ListOf(std::vector<NamedCount> counts)
{
  std::stable_sort(counts.begin(), counts.end(),
    [](const NamedCount& a, const NamedCount& b) { return a.second > b.second; });
  std::string list;
  for (const auto& [name, count] : counts)
  {
    if (count > 0)
    {
      list += (list.empty() ? "" : ", ") + name + " " + std::to_string(count);
    }
  }
  return list;
}

// "receiver_fault", as keys of JSON are.
Json ToJson(const std::vector<NamedCount>& counts)
{
  Json json = Json::object();
  for (const auto& [name, count] : counts)
  {
    std::string key = name;
    std::replace(key.begin(), key.end(), ' ', '_');
    json[key] = count;
  }
  return json;
}

} // namespace

Json MakeEchoJson(const ReasonCounts& counts)
{
  Json taken = Json::object();
  for (const QualityLevel level : levels)
  {
    taken[ToString(level)] = Sum(TakenOut(counts, level));
  }
  return {{"gates", Sum(counts)}, {"classes", ToJson(ByClass(counts))},
    {"reasons", ToJson(ByReason(counts))}, {"taken_out", taken}};
}

void PrintEcho(const ReasonCounts& counts, std::ostream& out)
{
  const std::size_t gates = Sum(counts);
  out << "  echo: " << gates << " gates of REF with a value";
  if (gates > 0)
  {
    out << ": " << ListOf(ByClass(counts)) << "\n  reasons: " << ListOf(ByReason(counts));
  }
  out << '\n';
}

std::string DescribeTakenOut(const ReasonCounts& counts, QualityLevel level)
{
  const ReasonCounts taken = TakenOut(counts, level);
  const std::size_t all = Sum(counts);
  std::ostringstream text;
  text << "quality control (" << ToString(level) << ") took out " << Sum(taken) << " of " << all
       << " gates of REF with a value";
  if (Sum(taken) > 0)
  {
    text << " (" << std::fixed << std::setprecision(1)
         << 100.0 * static_cast<double>(Sum(taken)) / static_cast<double>(all)
         << " %): " << ListOf(ByReason(taken));
  }
  return text.str();
}

} // namespace nexrad::application
