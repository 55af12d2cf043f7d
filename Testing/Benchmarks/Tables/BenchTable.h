// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Tables/Measurement.h"

#include <nlohmann/json_fwd.hpp>

#include <iosfwd>
#include <string>
#include <variant>
#include <vector>

namespace nexrad::application
{

/// What stands in one place of a table: nothing, a text, a number, or a time with its extremes.
using BenchCell = std::variant<std::monostate, std::string, double, Measurement>;

/// What the cells of a column are, for a comparison of two runs.
enum class BenchColumnKind
{
  Name,    ///< with the other names it tells the rows apart
  Given,   ///< the same on every machine: another's figures, what the files hold
  Measured ///< what this run found
};

struct BenchColumn
{
  std::string key;     ///< in JSON, with the unit: "bare_s"
  std::string heading; ///< in the printed table: "bare, s"
  int decimals = 0;    ///< of numbers and times, in the printed table
  BenchColumnKind kind = BenchColumnKind::Measured;
};

/// A column of names, and one of what is given.
inline BenchColumn NameColumn(const std::string& key, const std::string& heading)
{
  return {key, heading, 0, BenchColumnKind::Name};
}
inline BenchColumn GivenColumn(const std::string& key, const std::string& heading, int decimals = 0)
{
  return {key, heading, decimals, BenchColumnKind::Given};
}

/// One table of the benchmark.
struct BenchTable
{
  std::string key;   ///< in JSON
  std::string title; ///< one line: what was measured
  std::vector<BenchColumn> columns;
  std::vector<std::vector<BenchCell>> rows; ///< as many cells each as there are columns
};

/// Prints the table in columns as wide as their widest cell. A time shows its median, and its
/// extremes in brackets; nothing is a dash.
void PrintTable(const BenchTable& table, std::ostream& out);

/// Title and columns, and the rows as objects: numbers unrounded, a time as {"median", "least",
/// "most"}, nothing as null.
nlohmann::ordered_json MakeTableJson(const BenchTable& table);

} // namespace nexrad::application
