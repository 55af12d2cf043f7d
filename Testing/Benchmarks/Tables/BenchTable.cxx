// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/BenchTable.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <ostream>

namespace nexrad::application
{
namespace
{

std::string Round(double number, int decimals)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, number);
  return text;
}

struct CellText
{
  int decimals;

  std::string operator()(std::monostate) const { return "-"; }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(double number) const { return Round(number, decimals); }
  std::string operator()(const Measurement& time) const
  {
    return Round(time.median, decimals) + " (" + Round(time.least, decimals) + ".." +
           Round(time.most, decimals) + ")";
  }
};

struct CellJson
{
  nlohmann::ordered_json operator()(std::monostate) const { return nullptr; }
  nlohmann::ordered_json operator()(const std::string& text) const { return text; }
  nlohmann::ordered_json operator()(double number) const { return number; }
  nlohmann::ordered_json operator()(const Measurement& time) const
  {
    return {{"median", time.median}, {"least", time.least}, {"most", time.most}};
  }
};

// In the order of BenchColumnKind.
constexpr const char* kindNames[] = {"name", "given", "measured"};

nlohmann::ordered_json MakeColumnsJson(const std::vector<BenchColumn>& columns)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const BenchColumn& column : columns)
  {
    list.push_back({{"key", column.key}, {"heading", column.heading},
      {"kind", kindNames[static_cast<int>(column.kind)]}, {"decimals", column.decimals}});
  }
  return list;
}

// The first column names the rows and stands to the left, the others hold numbers.
void PrintLine(
  const std::vector<std::string>& cells, const std::vector<std::size_t>& widths, std::ostream& out)
{
  for (std::size_t column = 0; column < cells.size(); ++column)
  {
    const std::string space(widths[column] - cells[column].size(), ' ');
    out << (column == 0 ? "  " + cells[column] + space : "  " + space + cells[column]);
  }
  out << '\n';
}

} // namespace

void PrintTable(const BenchTable& table, std::ostream& out)
{
  std::vector<std::vector<std::string>> lines(1 + table.rows.size());
  std::vector<std::size_t> widths(table.columns.size(), 0);
  for (std::size_t column = 0; column < table.columns.size(); ++column)
  {
    lines[0].push_back(table.columns[column].heading);
    for (std::size_t row = 0; row < table.rows.size(); ++row)
    {
      lines[row + 1].push_back(
        std::visit(CellText{table.columns[column].decimals}, table.rows[row][column]));
    }
    for (const std::vector<std::string>& line : lines)
    {
      widths[column] = std::max(widths[column], line.back().size());
    }
  }
  out << table.title << '\n';
  for (const std::vector<std::string>& line : lines)
  {
    PrintLine(line, widths, out);
  }
  out << '\n';
}

nlohmann::ordered_json MakeTableJson(const BenchTable& table)
{
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const std::vector<BenchCell>& cells : table.rows)
  {
    nlohmann::ordered_json row = nlohmann::ordered_json::object();
    for (std::size_t column = 0; column < table.columns.size(); ++column)
    {
      row[table.columns[column].key] = std::visit(CellJson{}, cells[column]);
    }
    rows.push_back(row);
  }
  return {{"title", table.title}, {"columns", MakeColumnsJson(table.columns)}, {"rows", rows}};
}

} // namespace nexrad::application
