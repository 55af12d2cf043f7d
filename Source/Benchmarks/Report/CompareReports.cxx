// SPDX-License-Identifier: BSD-3-Clause
#include "Report/CompareReports.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace nexrad::application
{
namespace
{

using Cells = std::vector<BenchCell>;

// The names of a row as one text, by which rows are found again.
std::string NameOf(const BenchTable& table, const Cells& row)
{
  std::string name;
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    if (table.columns[i].kind == BenchColumnKind::Name)
    {
      name += (name.empty() ? "" : ", ") + FormatCell(table.columns[i], row[i]);
    }
  }
  return name;
}

const BenchTable* FindTable(const BenchReport& report, const std::string& key)
{
  const auto found = std::find_if(report.tables.begin(), report.tables.end(),
    [&key](const BenchTable& table) { return table.key == key; });
  return found == report.tables.end() ? nullptr : &*found;
}

const Cells* FindRow(const BenchTable& table, const std::string& name)
{
  const auto found = std::find_if(table.rows.begin(), table.rows.end(),
    [&](const Cells& row) { return NameOf(table, row) == name; });
  return found == table.rows.end() ? nullptr : &*found;
}

BenchCell CellOf(const BenchTable& table, const Cells& row, const std::string& column)
{
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    if (table.columns[i].key == column)
    {
      return row[i];
    }
  }
  return {};
}

std::optional<double> NumberOf(const BenchCell& cell)
{
  if (const auto* time = std::get_if<Measurement>(&cell))
  {
    return time->median;
  }
  const auto* number = std::get_if<double>(&cell);
  return number == nullptr ? std::nullopt : std::optional<double>(*number);
}

// One measured column of both.
BenchTable CompareColumn(const BenchTable& a, const BenchTable& b, const BenchColumn& column)
{
  BenchTable table;
  table.key = a.key + '.' + column.key;
  table.title = a.key + ": " + column.heading;
  std::copy_if(a.columns.begin(), a.columns.end(), std::back_inserter(table.columns),
    [](const BenchColumn& other) { return other.kind == BenchColumnKind::Name; });
  const std::size_t names = table.columns.size();
  table.columns.push_back({"a", "A", column.decimals});
  table.columns.push_back({"b", "B", column.decimals});
  table.columns.push_back({"ratio", "B / A", 2});
  for (const Cells& row : a.rows)
  {
    const Cells* other = FindRow(b, NameOf(a, row));
    const BenchCell ofA = CellOf(a, row, column.key);
    const BenchCell ofB = other == nullptr ? BenchCell() : CellOf(b, *other, column.key);
    const auto numberA = NumberOf(ofA);
    const auto numberB = NumberOf(ofB);
    if (numberA && numberB)
    {
      Cells& cells = table.rows.emplace_back();
      for (std::size_t name = 0; name < names; ++name)
      {
        cells.push_back(CellOf(a, row, table.columns[name].key));
      }
      cells.insert(
        cells.end(), {ofA, ofB, *numberA == 0.0 ? BenchCell() : BenchCell(*numberB / *numberA)});
    }
  }
  return table;
}

void CompareTable(const BenchTable& a, const BenchTable& b, Comparison& comparison)
{
  for (const BenchColumn& column : a.columns)
  {
    if (column.kind == BenchColumnKind::Measured)
    {
      BenchTable table = CompareColumn(a, b, column);
      if (!table.rows.empty())
      {
        comparison.tables.push_back(std::move(table));
      }
    }
  }
}

// What one of them has alone.
void NameMissing(const BenchReport& has, const BenchReport& lacks, const std::string& nameOfLacking,
  std::vector<std::string>& problems)
{
  for (const BenchTable& table : has.tables)
  {
    const BenchTable* other = FindTable(lacks, table.key);
    if (other == nullptr)
    {
      problems.push_back(nameOfLacking + " has no table " + table.key);
      continue;
    }
    std::vector<std::string> rows;
    for (const Cells& row : table.rows)
    {
      if (FindRow(*other, NameOf(table, row)) == nullptr)
      {
        rows.push_back(NameOf(table, row));
      }
    }
    if (!rows.empty())
    {
      const std::string others =
        rows.size() > 1 ? " and " + std::to_string(rows.size() - 1) + " more" : "";
      problems.push_back(
        "table " + table.key + ": " + nameOfLacking + " has no row " + rows.front() + others);
    }
  }
}

} // namespace

Comparison CompareReports(const BenchReport& a, const BenchReport& b)
{
  Comparison comparison;
  if (a.files != b.files || a.synthetic != b.synthetic)
  {
    const auto describe = [](const BenchReport& report) {
      return std::to_string(report.files) + (report.synthetic ? " SYNTHETIC" : " real") + " files";
    };
    comparison.problems.push_back(
      "A measured " + describe(a) + ", B " + describe(b) + ": the ratios compare different work");
  }
  NameMissing(a, b, "B", comparison.problems);
  NameMissing(b, a, "A", comparison.problems);
  for (const BenchTable& table : a.tables)
  {
    if (const BenchTable* other = FindTable(b, table.key))
    {
      CompareTable(table, *other, comparison);
    }
  }
  return comparison;
}

} // namespace nexrad::application
