// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorMessage.h"
#include "Options/SessionFile.h"

#include "Options/DrawingOptions.h"
#include "TestData.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

using namespace nexrad;
using namespace nexrad::application;
using namespace nexrad::testing;

namespace
{

// What a session of this text is refused for; "" when it is read.
std::string Refusal(const std::string& text)
{
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.Path() / "day.nxsession";
  std::ofstream(path) << text;
  return MessageOf([&] { ReadSession(path); });
}

std::string SessionWith(const std::string& keys)
{
  return R"({"format": "nexrad3d session", "version": 1, )" + keys + "}";
}

} // namespace

TEST(SessionFile, IsReadAsItWasWritten)
{
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.Path() / "day.nxsession";
  Session session;
  session.drawing.input.inputs = {"/data/one.nxv", "/data/two.nxv"};
  session.drawing.camera.azimuth = 123.25;
  session.drawing.scene.preset = "storm cores";
  session.drawing.scene.heightWalls = false;
  session.drawing.size = {900, 600};
  session.drawing.input.grid.grid.dimensions = {64, 64, 32};
  session.shown = ParseIso8601("2006-03-12T18:35:00.250");
  session.interval = std::chrono::milliseconds(40);
  session.colours = R"([{"Name":"mine"}])";
  WriteSession(path, session);
  const Session read = ReadSession(path);
  EXPECT_EQ(read.drawing.input.inputs, session.drawing.input.inputs);
  EXPECT_EQ(read.drawing.camera.azimuth, 123.25);
  EXPECT_EQ(read.drawing.scene.preset, "storm cores");
  EXPECT_FALSE(read.drawing.scene.heightWalls);
  EXPECT_EQ(read.drawing.size, session.drawing.size);
  EXPECT_EQ(read.drawing.input.grid.grid.dimensions, (std::array<int, 3>{64, 64, 32}));
  EXPECT_EQ(read.shown, session.shown);
  EXPECT_EQ(read.interval, session.interval);
  EXPECT_EQ(read.colours, session.colours);
  EXPECT_FALSE(read.synthetic);
}

TEST(SessionFile, PathsStartAtTheFolderOfTheFile)
{
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.Path() / "day.nxsession";
  std::ofstream(path) << SessionWith(R"("inputs": ["day/x.nxv"], "options": {"slices": 512})");
  const Session session = ReadSession(path);
  EXPECT_EQ(session.drawing.input.inputs.front(), folder.Path() / "day" / "x.nxv");
  EXPECT_EQ(session.drawing.scene.slices, 512);
}

TEST(SessionFile, WhatIsWrongIsOneLineWithFileAndKey)
{
  const std::vector<std::pair<std::string, std::string>> cases = {{"", "format"},
    {"no JSON", "format"}, {"[1]", "format"}, {R"({"format": "other"})", "format"},
    {R"({"format": "nexrad3d session"})", "version: is null"},
    {R"({"format": "nexrad3d session", "version": 2})", "version: is 2"},
    {SessionWith(R"("inputs": [])"), "inputs: there is none"},
    {SessionWith(R"("inputs": "x")"), "inputs: write a list"},
    {SessionWith(R"("inputs": [1])"), "inputs: 1 is no text"},
    {SessionWith(R"("inputs": ["x"], "camera": 1)"), "camera: there is no such key"},
    {SessionWith(R"("inputs": ["x"], "time": "noon")"), "time: 'noon'"},
    {SessionWith(R"("inputs": ["x"], "interval": "1h")"), "interval: '1h'"},
    {SessionWith(R"("inputs": ["x"], "options": [])"), "options: write"},
    {SessionWith(R"("inputs": ["x"], "options": {"tilt": "200"})"), "options: --tilt"},
    {SessionWith(R"("inputs": ["x"], "options": {"names": false})"), "options: --names"},
    {SessionWith(R"("inputs": ["x"], "options": {"help": true})"), "options: --help"},
    {SessionWith(R"("inputs": ["x"], "options": {"hue": "1"})"), "options: --hue"},
    {SessionWith(R"("inputs": ["x"], "options": {"h\nue": "1"})"), "options: --h\\x0aue"},
    {SessionWith(R"("inputs": ["x"], "options": {"size": "a\r\nb"})"), "options: --size"},
    {SessionWith(R"("inputs": ["x"], "c\nd": 1)"), "c\\x0ad: there is no such key"},
    {SessionWith(R"("inputs": ["x"], ")" + std::string(10'000, 'k') + R"(": 1)"), "kkkk"}};
  for (const auto& [text, words] : cases)
  {
    const std::string refusal = Refusal(text);
    EXPECT_NE(refusal.find("day.nxsession: " + words), std::string::npos)
      << words << " in: " << refusal;
    EXPECT_EQ(refusal.find_first_of("\r\n"), std::string::npos) << refusal;
    EXPECT_LE(refusal.size(), 2'000u) << words;
  }
  EXPECT_EQ(Refusal(SessionWith(R"("inputs": ["x"])")), "");
}

TEST(SessionFile, AFileThatCannotBeReadIsNamed)
{
  EXPECT_THROW(ReadSession("/nonexistent/day.nxsession"), Error);
  EXPECT_THROW(ReadSession("/"), Error);
}
