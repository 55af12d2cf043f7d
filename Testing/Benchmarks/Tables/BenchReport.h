// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Tables/BenchTable.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace nexrad::application
{

/// What OpenGL calls itself.
struct OpenGLNames
{
  std::string vendor;
  std::string renderer;
  std::string version;
};

/// What the figures of a benchmark belong to.
struct Machine
{
  std::string processor;             ///< as the system names it; "unknown" where it does not
  unsigned cores = 1;                ///< threads that the machine runs at a time
  unsigned threads = 1;              ///< that the work was divided among
  std::string build;                 ///< version, build type, compiler
  std::string vtk;                   ///< version of VTK
  std::optional<OpenGLNames> opengl; ///< where something was drawn
};

/// All but OpenGL, which only who draws learns.
Machine DescribeMachine();

/// "AMD EPYC, 2 cores; nexrad3d 0.1.0, Release, GNU 12.2.0; VTK 9.1.0; OpenGL llvmpipe".
std::string FormatMachine(const Machine& machine);

/// Adds the fields to a JSON object.
void AddMachineJson(const Machine& machine, nlohmann::ordered_json& json);

/// What one run of the benchmark found.
struct BenchReport
{
  Machine machine;
  int runs = 1;           ///< of each measurement
  bool synthetic = false; ///< some of the files are simulated
  std::size_t files = 0;  ///< that were measured
  std::vector<BenchTable> tables;
  std::vector<std::string> problems; ///< files and tables that were left out, a line each
};

/// Prints machine, files and tables for a person.
void PrintReport(const BenchReport& report, std::ostream& out);

/// The same as JSON.
nlohmann::ordered_json MakeReportJson(const BenchReport& report);

} // namespace nexrad::application
