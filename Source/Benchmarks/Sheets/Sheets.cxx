// SPDX-License-Identifier: BSD-3-Clause
#include "Sheets/Sheets.h"

#include "Drawing/PictureWindow.h"
#include "Output/OutputFile.h"
#include "Sheets/ResolutionSheet.h"
#include "Sheets/SlicesSheet.h"
#include "Sheets/SweepsSheet.h"
#include "Sheets/TimesSheet.h"
#include "nexrad/System/Error.h"

#include <vtkImageData.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace fs = std::filesystem;

namespace nexrad::scene
{
namespace
{

// In the order of sheetNames.
constexpr Sheet (*drawers[])(const SheetSource&) = {
  DrawResolutionSheet, DrawSlicesSheet, DrawTimesSheet, DrawSweepsSheet};

void WriteSheet(const Sheet& sheet, const SheetSource& source, SheetReport& report)
{
  const fs::path picture = source.request.folder / (sheet.table.key + ".png");
  const fs::path numbers = source.request.folder / (sheet.table.key + ".json");
  WritePng(sheet.picture, picture);
  nlohmann::ordered_json json = application::MakeTableJson(sheet.table);
  json["synthetic"] = source.synthetic;
  const std::string text =
    json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
  application::WriteFile(numbers, reinterpret_cast<const unsigned char*>(text.data()), text.size());
  report.outputs.insert(report.outputs.end(), {picture, numbers});
  report.tables.push_back(sheet.table);
}

bool IsWanted(const SheetRequest& request, const std::string& name)
{
  return request.only.empty() ||
         std::find(request.only.begin(), request.only.end(), name) != request.only.end();
}

} // namespace

SheetReport DrawSheets(const SheetRequest& request)
{
  RequireDisplay();
  application::MakeFolder(request.folder);
  const SheetSource source = MakeSheetSource(request);
  SheetReport report;
  for (const InputProblem& problem : source.scan.problems)
  {
    report.problems.push_back(problem.Line());
  }
  for (std::size_t i = 0; i < std::size(drawers); ++i)
  {
    if (IsWanted(request, sheetNames[i]))
    {
      try
      {
        WriteSheet(drawers[i](source), source, report);
      }
      catch (const Error& error)
      {
        report.problems.push_back(
          "the sheet " + std::string(sheetNames[i]) + " is not drawn: " + error.what());
      }
    }
    if (request.progress)
    {
      request.progress(static_cast<double>(i + 1) / std::size(drawers));
    }
  }
  return report;
}

} // namespace nexrad::scene
