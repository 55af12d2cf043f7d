// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Calibration/RadarBiases.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <optional>

namespace nexrad
{

namespace
{

constexpr char separators[] = ":="; // between the name of a radar and its bias

using Matrix = std::vector<std::vector<double>>;

// "KLSX:2"; throws Error.
std::pair<std::string, double> ParseBias(const std::string& text)
{
  const std::size_t sign = text.find_first_of(separators);
  const std::string number = sign == std::string::npos ? "" : text.substr(sign + 1);
  char* end = nullptr;
  const double bias = std::strtod(number.c_str(), &end);
  if (sign == 0 || number.empty() || end != number.c_str() + number.size() ||
      !(std::abs(bias) <= LargestBias))
  {
    throw Error(
      "'" + text + "' is no bias of a radar; write its name and -20 to 20 dB, as in KLSX:2");
  }
  return {text.substr(0, sign), bias};
}

// Solves a system whose matrix is symmetric and positive definite, by elimination.
std::vector<double> Solve(Matrix matrix, std::vector<double> right)
{
  const std::size_t size = right.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    for (std::size_t row = i + 1; row < size; ++row)
    {
      const double factor = matrix[row][i] / matrix[i][i];
      for (std::size_t column = i; column < size; ++column)
      {
        matrix[row][column] -= factor * matrix[i][column];
      }
      right[row] -= factor * right[i];
    }
  }
  for (std::size_t i = size; i-- > 0;)
  {
    for (std::size_t column = i + 1; column < size; ++column)
    {
      right[i] -= matrix[i][column] * right[column];
    }
    right[i] /= matrix[i][i];
  }
  return right;
}

double MedianOfBiases(std::vector<double> biases)
{
  std::sort(biases.begin(), biases.end());
  const std::size_t half = biases.size() / 2;
  return biases.size() % 2 == 1 ? biases[half] : 0.5 * (biases[half - 1] + biases[half]);
}

// The radars that stated pairs connect, in groups, each in the order of the alphabet.
std::vector<std::vector<std::string>> FindGroups(const std::vector<BiasPair>& pairs)
{
  std::map<std::string, std::string> leaders; // a group is named by its first radar
  for (const BiasPair& pair : pairs)
  {
    leaders.emplace(pair.first, pair.first);
    leaders.emplace(pair.second, pair.second);
    const std::string first = leaders[pair.first];
    const std::string second = leaders[pair.second];
    for (auto& [site, leader] : leaders)
    {
      leader = leader == std::max(first, second) ? std::min(first, second) : leader;
    }
  }
  std::map<std::string, std::vector<std::string>> groups;
  for (const auto& [site, leader] : leaders)
  {
    groups[leader].push_back(site);
  }
  std::vector<std::vector<std::string>> list;
  for (auto& [leader, sites] : groups)
  {
    list.push_back(std::move(sites));
  }
  return list;
}

// The biases of one group, which the pairs connect.
std::vector<double> SolveGroup(
  const std::vector<std::string>& sites, const std::vector<BiasPair>& pairs)
{
  const auto indexOf = [&sites](const std::string& site) -> std::optional<std::size_t>
  {
    const auto found = std::lower_bound(sites.begin(), sites.end(), site);
    return found != sites.end() && *found == site
             ? std::optional<std::size_t>(static_cast<std::size_t>(found - sites.begin()))
             : std::nullopt;
  };
  // Normal equations. That the sum be 0 is one more equation, which makes the solution unique.
  Matrix matrix(sites.size(), std::vector<double>(sites.size(), 1.0));
  std::vector<double> right(sites.size(), 0.0);
  for (const BiasPair& pair : pairs)
  {
    const std::optional<std::size_t> first = indexOf(pair.first);
    const std::optional<std::size_t> second = indexOf(pair.second);
    if (first && second)
    {
      const auto weight = static_cast<double>(pair.cells);
      matrix[*first][*first] += weight;
      matrix[*second][*second] += weight;
      matrix[*first][*second] -= weight;
      matrix[*second][*first] -= weight;
      right[*first] += weight * pair.median;
      right[*second] -= weight * pair.median;
    }
  }
  std::vector<double> biases = Solve(matrix, right);
  const double middle = MedianOfBiases(biases);
  std::transform(
    biases.begin(), biases.end(), biases.begin(), [middle](double bias) { return bias - middle; });
  return biases;
}

template <typename... Values>
std::string Print(const char* format, Values... values)
{
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

// `part` of the whole text names one radar and its bias.
void AddBias(const std::string& part, const std::string& text, RadarBiases& biases)
{
  const auto [site, bias] = ParseBias(part);
  if (!biases.emplace(site, bias).second)
  {
    throw Error("radar " + site + " has two biases in '" + text + "'; give one");
  }
}

} // namespace

RadarBiases ParseBiases(const std::string& text)
{
  RadarBiases biases;
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    AddBias(text.substr(begin, comma - begin), text, biases);
    begin = comma + 1;
  }
  return biases;
}

BiasRequest ParseBiasRequest(const std::string& text)
{
  if (text == "auto" || text == "off")
  {
    return {text == "auto", {}};
  }
  if (text.find_first_of(separators) == std::string::npos)
  {
    throw Error("'" + text +
                "' is no bias; write auto, off, or radars and how many dB they measure too high, "
                "as in KLSX:2,KILX:-1.5");
  }
  return {false, ParseBiases(text)};
}

void RequireRadars(const RadarBiases& biases, const std::vector<std::string>& radars)
{
  const auto stray = std::find_if(biases.begin(), biases.end(),
    [&](const auto& each)
    { return std::find(radars.begin(), radars.end(), each.first) == radars.end(); });
  if (stray == biases.end())
  {
    return;
  }
  std::string names;
  for (const std::string& name : radars)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  throw Error("a bias is given for " + stray->first +
              ", which none of the inputs is of; they are of " + names);
}

RadarBiases ReconcileBiases(const std::vector<BiasPair>& pairs)
{
  std::vector<BiasPair> stated;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(stated),
    [](const BiasPair& pair) { return pair.IsStated(); });
  RadarBiases biases;
  for (const std::vector<std::string>& sites : FindGroups(stated))
  {
    const std::vector<double> solved = SolveGroup(sites, stated);
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      biases[sites[i]] = solved[i];
    }
  }
  return biases;
}

std::vector<std::string> BiasReport::Lines() const
{
  std::vector<std::string> lines;
  for (const BiasPair& pair : pairs)
  {
    const std::string names = pair.first + " - " + pair.second + ": ";
    lines.push_back(
      pair.IsStated()
        ? names +
            Print("median %+.2f dB, quartiles %+.2f and %+.2f dB, %zu places in %zu %s of volumes",
              pair.median, pair.lowerQuartile, pair.upperQuartile, pair.cells, pair.volumes,
              pair.volumes == 1 ? "pair" : "pairs")
        : names + Print("%zu places are too few to tell a difference", pair.cells));
  }
  for (const auto& [site, bias] : biases)
  {
    lines.push_back(site + Print(": bias %+.2f dB", bias));
  }
  for (const std::string& site : alone)
  {
    lines.push_back(site + ": no other radar tells its bias");
  }
  return lines;
}

} // namespace nexrad
