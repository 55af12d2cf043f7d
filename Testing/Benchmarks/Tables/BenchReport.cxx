// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/BenchReport.h"

#include "vtkNexradThreads.h"

#include <vtkVersion.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <ostream>
#include <thread>

namespace nexrad::application
{
namespace
{

// Linux tells it in a list of "key : value", once a core.
std::string FindProcessorName()
{
  std::ifstream list("/proc/cpuinfo");
  for (std::string line; std::getline(list, line);)
  {
    const std::size_t colon = line.find(": ");
    if (line.compare(0, 10, "model name") == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

} // namespace

Machine DescribeMachine()
{
  Machine machine;
  machine.processor = FindProcessorName();
  machine.cores = std::max(1U, std::thread::hardware_concurrency());
  machine.threads = vtkNexradThreadCount();
  machine.build = "nexrad3d " NEXRAD_VERSION ", " NEXRAD_BUILD_TYPE ", " NEXRAD_COMPILER;
  machine.vtk = vtkVersion::GetVTKVersion();
  return machine;
}

std::string FormatMachine(const Machine& machine)
{
  std::string text = machine.processor + ", " + std::to_string(machine.cores) + " cores";
  if (machine.threads != machine.cores)
  {
    text += " (" + std::to_string(machine.threads) + " threads used)";
  }
  text += "; " + machine.build + "; VTK " + machine.vtk;
  if (machine.opengl)
  {
    text += "; OpenGL " + machine.opengl->version + ", " + machine.opengl->renderer;
  }
  return text;
}

void AddMachineJson(const Machine& machine, nlohmann::ordered_json& json)
{
  json["processor"] = machine.processor;
  json["cores"] = machine.cores;
  json["threads"] = machine.threads;
  json["build"] = machine.build;
  json["vtk"] = machine.vtk;
  json["opengl"] = nullptr;
  if (const auto& opengl = machine.opengl)
  {
    json["opengl"] = {
      {"vendor", opengl->vendor}, {"renderer", opengl->renderer}, {"version", opengl->version}};
  }
}

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

nlohmann::ordered_json MakeReportJson(const BenchReport& report)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  AddMachineJson(report.machine, json);
  json["runs"] = report.runs;
  json["synthetic"] = report.synthetic;
  json["files"] = report.files;
  json["tables"] = nlohmann::ordered_json::object();
  for (const BenchTable& table : report.tables)
  {
    json["tables"][table.key] = MakeTableJson(table);
  }
  return json;
}

} // namespace nexrad::application
