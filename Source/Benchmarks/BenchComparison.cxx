// SPDX-License-Identifier: BSD-3-Clause
#include "BenchComparison.h"

#include "BenchOutput.h"
#include "Commands/Command.h"
#include "Report/CompareReports.h"
#include "nexrad/System/Error.h"

#include <nlohmann/json.hpp>

#include <iostream>

namespace nexrad::application
{
namespace
{

nlohmann::ordered_json DescribeReport(const std::filesystem::path& file, const BenchReport& report)
{
  nlohmann::ordered_json json = {{"file", file.string()}};
  AddMachineJson(report.machine, json);
  return json;
}

} // namespace

int RunBenchComparison(const BenchOptions& options)
{
  const BenchReport a = ReadReport(options.compare[0]);
  const BenchReport b = ReadReport(options.compare[1]);
  const Comparison comparison = CompareReports(a, b);
  if (comparison.tables.empty())
  {
    throw Error(options.compare[0].string() + " and " + options.compare[1].string() +
                " have measured nothing in common; give both the same files, --dims and --only");
  }
  if (options.json)
  {
    nlohmann::ordered_json json = {
      {"a", DescribeReport(options.compare[0], a)}, {"b", DescribeReport(options.compare[1], b)}};
    for (const BenchTable& table : comparison.tables)
    {
      json["tables"][table.key] = MakeTableJson(table);
    }
    PrintJson(json);
  }
  else
  {
    std::cout << "A: " << options.compare[0].string() << ": " << FormatMachine(a.machine)
              << "\nB: " << options.compare[1].string() << ": " << FormatMachine(b.machine)
              << "\n\n";
    for (const BenchTable& table : comparison.tables)
    {
      PrintTable(table, std::cout);
    }
  }
  return PrintProblems(comparison.problems);
}

} // namespace nexrad::application
