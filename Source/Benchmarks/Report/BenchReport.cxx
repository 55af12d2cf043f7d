// SPDX-License-Identifier: BSD-3-Clause
#include "Report/BenchReport.h"

#include "nexrad/System/Error.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <ostream>

namespace nexrad::application
{
namespace
{

using Json = nlohmann::ordered_json;

BenchReport ReadReportJson(const Json& json)
{
  BenchReport report;
  report.machine = ReadMachineJson(json);
  report.runs = json.at("runs");
  report.synthetic = json.at("synthetic");
  report.files = json.at("files");
  for (const auto& [key, table] : json.at("tables").items())
  {
    report.tables.push_back(ReadTableJson(key, table));
  }
  return report;
}

} // namespace

void PrintReport(const BenchReport& report, std::ostream& out)
{
  out << FormatMachine(report.machine) << '\n'
      << report.files << (report.files == 1 ? " file" : " files")
      << (report.synthetic ? ", SYNTHETIC" : "") << "; times are medians (least..most) of "
      << report.runs << (report.runs == 1 ? " run" : " runs") << "\n\n";
  for (const BenchTable& table : report.tables)
  {
    PrintTable(table, out);
  }
}

Json MakeReportJson(const BenchReport& report)
{
  Json json = Json::object();
  AddMachineJson(report.machine, json);
  json["runs"] = report.runs;
  json["synthetic"] = report.synthetic;
  json["files"] = report.files;
  json["tables"] = Json::object();
  for (const BenchTable& table : report.tables)
  {
    json["tables"][table.key] = MakeTableJson(table);
  }
  return json;
}

BenchReport ReadReport(const std::filesystem::path& path)
{
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path))
  {
    throw Error(path.string() + ": cannot be read");
  }
  try
  {
    return ReadReportJson(Json::parse(file));
  }
  catch (const std::exception& error)
  {
    throw Error(path.string() + ": is not what nexrad3d bench --json prints: " + error.what());
  }
}

} // namespace nexrad::application
