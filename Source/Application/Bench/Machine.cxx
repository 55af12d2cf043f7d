// SPDX-License-Identifier: BSD-3-Clause
#include "Bench/Machine.h"

#include "vtkNexradSmpLoop.h"

#include <vtkVersion.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
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

Machine ReadMachineJson(const nlohmann::ordered_json& json)
{
  Machine machine;
  machine.processor = json.at("processor");
  machine.cores = json.at("cores");
  machine.threads = json.at("threads");
  machine.build = json.at("build");
  machine.vtk = json.at("vtk");
  if (const auto& opengl = json.at("opengl"); !opengl.is_null())
  {
    machine.opengl = {opengl.at("vendor"), opengl.at("renderer"), opengl.at("version")};
  }
  return machine;
}

} // namespace nexrad::application
