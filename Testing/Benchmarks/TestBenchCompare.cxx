// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramRun.h"
#include "Report/BenchReport.h"
#include "Report/CompareReports.h"
#include "TestData.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

using namespace nexrad;
using namespace nexrad::application;
using namespace nexrad::testing;
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace
{

// A report of two tables, whose times are all `factor` times those of the first machine.
BenchReport MakeReport(const std::string& processor, double factor)
{
  BenchReport report;
  report.machine.processor = processor;
  report.machine.cores = 8;
  report.machine.threads = 4;
  report.machine.build = "nexrad3d 0.1.0";
  report.machine.vtk = "9.1.0";
  report.machine.opengl = OpenGLNames{"Mesa", "llvmpipe", "4.5"};
  report.runs = 3;
  report.files = 5;
  BenchTable decode;
  decode.key = "decode";
  decode.title = "Decoding";
  decode.columns = {NameColumn("file", "file"), GivenColumn("mb", "MB", 1), {"s", "time, s", 2}};
  decode.rows = {{std::string("a"), 1.5, Measurement{2.0 * factor, 1.0 * factor, 3.0 * factor}},
    {std::string("b"), 2.5, std::monostate{}}};
  BenchTable rates;
  rates.key = "rates";
  rates.title = "Frames a second";
  rates.columns = {
    NameColumn("voxels", "voxels"), NameColumn("slices", "slices"), {"fps", "a second", 1}};
  rates.rows = {{std::string("8x8x8"), 64.0, 30.0 / factor}, {std::string("8x8x8"), 128.0, 0.0}};
  report.tables = {decode, rates};
  return report;
}

fs::path Write(const fs::path& folder, const std::string& name, const std::string& text)
{
  std::ofstream(folder / name) << text;
  return folder / name;
}

fs::path Write(const fs::path& folder, const std::string& name, const BenchReport& report)
{
  return Write(folder, name, MakeReportJson(report).dump());
}

std::string ErrorOf(const fs::path& path)
{
  try
  {
    ReadReport(path);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}

} // namespace

TEST(BenchReport, ComesBackFromJson)
{
  const TemporaryFolder folder;
  const BenchReport report = MakeReport("Pentium 4", 1.0);
  const BenchReport back = ReadReport(Write(folder.Path(), "a.json", report));
  EXPECT_EQ(MakeReportJson(back).dump(), MakeReportJson(report).dump());
  EXPECT_EQ(back.machine.opengl->renderer, "llvmpipe");
  std::ostringstream text;
  PrintReport(back, text);
  EXPECT_NE(text.str().find("Pentium 4, 8 cores (4 threads used); nexrad3d 0.1.0; VTK 9.1.0; "
                            "OpenGL 4.5, llvmpipe"),
    std::string::npos)
    << text.str();
}

TEST(BenchReport, SaysWhatIsWrongWithAFile)
{
  const TemporaryFolder folder;
  const auto wrong = [&](const std::string& text)
  { return ErrorOf(Write(folder.Path(), "wrong.json", text)); };
  EXPECT_NE(
    ErrorOf(folder.Path() / "none.json").find("none.json: cannot be read"), std::string::npos);
  EXPECT_NE(ErrorOf(folder.Path()).find("cannot be read"), std::string::npos);
  for (const std::string text : {"", "no JSON", "[]", "{}", "{\"processor\": 3}"})
  {
    EXPECT_NE(
      wrong(text).find("wrong.json: is not what nexrad3d bench --json prints"), std::string::npos)
      << text;
  }
  Json json = MakeReportJson(MakeReport("A", 1.0));
  json["tables"]["decode"]["rows"][0].erase("s");
  EXPECT_NE(wrong(json.dump()).find("table decode"), std::string::npos) << wrong(json.dump());
  json = MakeReportJson(MakeReport("A", 1.0));
  json["tables"]["rates"]["columns"][0]["kind"] = "guessed";
  EXPECT_NE(wrong(json.dump()).find("'guessed' is no kind of column"), std::string::npos);
}

TEST(CompareReports, SetsEachMeasuredColumnSideBySide)
{
  const Comparison comparison = CompareReports(MakeReport("A", 1.0), MakeReport("B", 4.0));
  EXPECT_TRUE(comparison.problems.empty());
  ASSERT_EQ(comparison.tables.size(), 2U);
  std::ostringstream text;
  PrintTable(comparison.tables[0], text);
  PrintTable(comparison.tables[1], text);
  // The row without a time has nothing to compare, and 0 no ratio.
  EXPECT_EQ(text.str(), "decode: time, s\n"
                        "  file                  A                   B  B / A\n"
                        "  a     2.00 (1.00..3.00)  8.00 (4.00..12.00)   4.00\n\n"
                        "rates: a second\n"
                        "  voxels  slices     A    B  B / A\n"
                        "  8x8x8       64  30.0  7.5   0.25\n"
                        "  8x8x8      128   0.0  0.0      -\n\n");
}

TEST(CompareReports, SaysWhatOneHasAlone)
{
  BenchReport a = MakeReport("A", 1.0);
  BenchReport b = MakeReport("B", 2.0);
  a.tables[0].rows[1][0] = std::string("c");
  b.tables.pop_back();
  b.files = 6;
  b.synthetic = true;
  const Comparison comparison = CompareReports(a, b);
  const std::vector<std::string> expected = {
    "A measured 5 real files, B 6 SYNTHETIC files: the ratios compare different work",
    "table decode: B has no row c", "B has no table rates", "table decode: A has no row b"};
  EXPECT_EQ(comparison.problems, expected);
  EXPECT_EQ(comparison.tables.size(), 1U);
}

TEST(CompareReports, NamesTheFirstOfManyMissingRows)
{
  const BenchReport a = MakeReport("A", 1.0);
  BenchReport b = MakeReport("B", 2.0);
  b.tables[0].rows.clear();
  const Comparison comparison = CompareReports(a, b);
  EXPECT_EQ(
    comparison.problems, std::vector<std::string>{"table decode: B has no row a and 1 more"});
}

TEST(CompareReports, TheCommandComparesTwoFiles)
{
  const TemporaryFolder folder;
  const fs::path a = Write(folder.Path(), "a.json", MakeReport("Pentium 4", 1.0));
  const fs::path b = Write(folder.Path(), "b.json", MakeReport("Opteron", 0.5));
  const ProgramRun text = RunNexrad3d({"bench", "--compare", a, b});
  EXPECT_EQ(text.status, 0) << text.errors;
  EXPECT_NE(text.output.find("A: " + a.string() + ": Pentium 4"), std::string::npos) << text.output;
  EXPECT_NE(text.output.find("B: " + b.string() + ": Opteron"), std::string::npos) << text.output;
  const ProgramRun json = RunNexrad3d({"bench", "--compare", a, b, "--json"});
  const Json report = Json::parse(json.output);
  EXPECT_EQ(report["b"]["processor"], "Opteron");
  EXPECT_EQ(report["a"]["opengl"]["renderer"], "llvmpipe");
  EXPECT_EQ(report["tables"]["decode.s"]["rows"][0]["ratio"], 0.5);
  EXPECT_EQ(report["tables"]["rates.fps"]["rows"][0]["ratio"], 2.0);
}

TEST(CompareReports, TheCommandSaysWhatItCannotCompare)
{
  const TemporaryFolder folder;
  const fs::path a = Write(folder.Path(), "a.json", MakeReport("A", 1.0));
  BenchReport half = MakeReport("B", 1.0);
  half.tables.erase(half.tables.begin());
  const fs::path b = Write(folder.Path(), "b.json", half);
  const ProgramRun partly = RunNexrad3d({"bench", "--compare", a, b});
  EXPECT_EQ(partly.status, 3);
  EXPECT_EQ(partly.errors, "B has no table decode\n");
  half.tables.clear();
  const fs::path empty = Write(folder.Path(), "empty.json", half);
  const ProgramRun nothing = RunNexrad3d({"bench", "--compare", a, empty});
  EXPECT_EQ(nothing.status, 1);
  EXPECT_NE(nothing.errors.find("nothing in common"), std::string::npos) << nothing.errors;
  const ProgramRun wrong = RunNexrad3d({"bench", "--compare", a, "/dev/null"});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.errors.find("/dev/null: is not what"), std::string::npos) << wrong.errors;
  EXPECT_EQ(RunNexrad3d({"bench", "--compare", a}).status, 2);
  EXPECT_EQ(RunNexrad3d({"bench", a, "--compare", a, b}).status, 2);
}
