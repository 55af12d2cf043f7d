// SPDX-License-Identifier: BSD-3-Clause
#include "GlbParts.h"
#include "NoDisplay.h"
#include "ProgramRun.h"
#include "StormVolume.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Codec/NxvFile.h"

#include <vtkBoundingBox.h>
#include <vtkCompositeDataIterator.h>
#include <vtkGLTFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

constexpr double heightScale = 3.0;

// Writes the surfaces of volumes, without a display.
ProgramRun WriteSurfaces(
  const fs::path& input, const fs::path& output, std::vector<std::string> options = {})
{
  const NoDisplay none;
  options.insert(options.begin(), {"render", input.string(), "-o", output.string()});
  return RunNexrad3d(options);
}

// The storm of StormVolume.h.
class SurfaceFiles : public ::testing::Test
{
protected:
  fs::path Input() const { return WriteStormFiles(folder.Path(), 1); }

  GlbParts Write(std::vector<std::string> options)
  {
    options.emplace_back("--quiet");
    const ProgramRun run = WriteSurfaces(this->Input(), output, std::move(options));
    EXPECT_EQ(run.status, 0) << run.errors;
    return ReadGlb(output);
  }

  const TemporaryFolder folder;
  const fs::path output = folder.Path() / "storm.glb";
};

// The places of a node's points.
std::vector<std::array<float, 3>> PointsOf(const GlbParts& parts, const std::string& name)
{
  return parts.Vectors(parts.Primitive(name).at("attributes").at("POSITION"));
}

} // namespace

// Each corner of the surface, put back to its place, has the value; between voxels of 10 km the
// field is not linear.
TEST_F(SurfaceFiles, SurfacesAreWhereTheStormHasTheirValue)
{
  const GlbParts parts = this->Write({"--iso-values", "20:0.3,40:0.6"});
  for (const auto& [name, value] : {std::pair("REF 20 dBZ", 20.0), std::pair("REF 40 dBZ", 40.0)})
  {
    double sum = 0.0;
    const auto points = PointsOf(parts, name);
    ASSERT_GT(points.size(), 100);
    for (const auto& [x, y, z] : points)
    {
      const double dBZ = Storm(static_cast<double>(x) / 1000.0, static_cast<double>(-z) / 1000.0,
        static_cast<double>(y) / 1000.0 / heightScale);
      sum += std::abs(dBZ - value);
    }
    EXPECT_AT_MOST(sum / static_cast<double>(points.size()), 1.2,
      "mean difference from a surface's value, in voxels of 10 km, dBZ");
  }
}

TEST_F(SurfaceFiles, NodesSayWhatTheyAre)
{
  const GlbParts parts = this->Write({"--iso-values", "20:0.3,40:0.6,50", "--rings", "50km"});
  std::vector<std::string> names;
  for (const nlohmann::json& node : parts.json.at("nodes"))
  {
    names.push_back(node.at("name"));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"ground", "coasts and borders of countries",
                     "borders of states and provinces", "borders of counties", "radar KLSX",
                     "radar KILX", "rings of range", "Reflectivity, 2006-03-12 18:30:00 UTC",
                     "SYNTHETIC", "REF 50 dBZ", "REF 40 dBZ", "REF 20 dBZ"}));
  const nlohmann::json surface = parts.Node("REF 40 dBZ").at("extras");
  EXPECT_EQ(surface.at("value"), 40.0);
  EXPECT_EQ(surface.at("unit"), "dBZ");
  EXPECT_EQ(surface.at("opacity"), 0.6);
  EXPECT_EQ(
    surface.at("triangles"), parts.Indices(parts.Primitive("REF 40 dBZ").at("indices")).size() / 3);
  EXPECT_EQ(parts.MaterialOf("REF 40 dBZ").at("alphaMode"), "BLEND");
  EXPECT_TRUE(parts.Primitive("REF 40 dBZ").at("attributes").contains("NORMAL"));
  EXPECT_EQ(parts.Primitive("borders of counties").at("mode"), 1);
  const nlohmann::json scene = parts.json.at("scenes").at(0);
  EXPECT_EQ(scene.at("name"), "SYNTHETIC: Reflectivity, 2006-03-12 18:30:00 UTC");
  const nlohmann::json extras = scene.at("extras");
  EXPECT_EQ(extras.at("synthetic"), true);
  EXPECT_EQ(extras.at("time_utc"), "2006-03-12T18:30:00.000Z");
  EXPECT_EQ(extras.at("radars"), (std::vector<std::string>{"KLSX", "KILX"}));
  EXPECT_EQ(extras.at("vertical_exaggeration"), heightScale);
  EXPECT_NE(
    extras.at("projection").get<std::string>().find("+proj=aeqd +lat_0=39"), std::string::npos);
  EXPECT_NEAR(extras.at("origin").at("latitude"), 39.0, 1e-9);
  EXPECT_NEAR(extras.at("origin").at("longitude"), -90.0, 1e-9);
  EXPECT_EQ(extras.at("surfaces").size(), 3);
}

// KLSX at 38.699 N, 90.683 W: 33 km south and 59 km west of the centre at 39 N, 90 W.
TEST_F(SurfaceFiles, RadarsStandAtTheirPlaces)
{
  const GlbParts parts = this->Write({});
  const auto [x, y, z] = PointsOf(parts, "radar KLSX").front(); // the tip
  EXPECT_NEAR(x, -59'400.0, 200.0);
  EXPECT_NEAR(z, 33'200.0, 200.0);
  EXPECT_NEAR(parts.Node("radar KLSX").at("extras").at("latitude"), 38.699, 1e-3);
  const auto ground = PointsOf(parts, "ground");
  for (const auto& corner : ground)
  {
    EXPECT_EQ(std::abs(corner[0]), 240'000.0F);
    EXPECT_EQ(std::abs(corner[2]), 240'000.0F);
    EXPECT_LT(corner[1], y);
  }
}

// As VTK reads it: the triangles, and the bounds of surfaces, ground and caption.
TEST_F(SurfaceFiles, VtkReadsAllOfIt)
{
  const GlbParts parts = this->Write({"--iso-values", "20:0.3,40:0.6"});
  std::size_t triangles = 0;
  std::size_t lines = 0;
  vtkBoundingBox wanted;
  for (const nlohmann::json& node : parts.json.at("nodes"))
  {
    const nlohmann::json primitive = parts.Primitive(node.at("name"));
    const std::size_t indices = parts.Indices(primitive.at("indices")).size();
    (primitive.at("mode") == 4 ? triangles : lines) +=
      indices / (primitive.at("mode") == 4 ? 3 : 2);
    for (const auto& point : PointsOf(parts, node.at("name")))
    {
      wanted.AddPoint(point[0], point[1], point[2]);
    }
  }
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(output.c_str());
  reader->Update();
  vtkBoundingBox bounds;
  std::size_t readTriangles = 0;
  std::size_t readLines = 0;
  const vtkSmartPointer<vtkCompositeDataIterator> blocks =
    vtk::TakeSmartPointer(reader->GetOutput()->NewIterator());
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    auto* mesh = vtkPolyData::SafeDownCast(blocks->GetCurrentDataObject());
    ASSERT_NE(mesh, nullptr);
    readTriangles += static_cast<std::size_t>(mesh->GetNumberOfPolys());
    readLines += static_cast<std::size_t>(mesh->GetNumberOfLines());
    bounds.AddBounds(mesh->GetBounds());
  }
  EXPECT_EQ(readTriangles, triangles);
  EXPECT_EQ(readLines, lines);
  EXPECT_GT(lines, 1000);
  EXPECT_EQ(bounds, wanted);
  // The anvil of 20 dBZ is 15 km high at most.
  EXPECT_NEAR(bounds.GetMaxPoint()[1], 15'000.0 * heightScale, 1'000.0 * heightScale);
}

TEST_F(SurfaceFiles, OptionsOfPicturesCount)
{
  std::set<std::string> contents;
  const std::vector<std::vector<std::string>> options = {{}, {"--iso-values", "30"},
    {"--exaggeration", "2"}, {"--theme", "dark"}, {"--crop", "-200km,-70km,-200km,200km,0,20km"},
    {"--clip", "-70km,-70km,90"}, {"--section", "-100km,-100km,0km,0km"}, {"--rings", "100km"}};
  for (const auto& some : options)
  {
    this->Write(some);
    contents.insert(FileContent(output));
  }
  EXPECT_EQ(contents.size(), options.size());
  // Without any, the surfaces are those of the preset.
  this->Write({"--preset", "iso-values"});
  EXPECT_EQ(contents.count(FileContent(output)), 1);
  const GlbParts cropped = this->Write({"--crop", "-200km,-70km,-200km,200km,0,20km"});
  for (const auto& point : PointsOf(cropped, "REF 35 dBZ"))
  {
    EXPECT_LE(point[0], -69'999.0F);
  }
}

TEST(SurfaceFilesOfSeveralTimes, HaveTheirTimeInTheName)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 2);
  const ProgramRun run = WriteSurfaces(series, folder.Path() / "storm.glb");
  ASSERT_EQ(run.status, 0) << run.errors;
  const fs::path first = folder.Path() / "storm-20060312T183000Z.glb";
  const fs::path second = folder.Path() / "storm-20060312T183500Z.glb";
  EXPECT_EQ(run.output, first.string() + "\n" + second.string() + "\n");
  EXPECT_EQ(ReadGlb(second).json.at("scenes").at(0).at("extras").at("time_utc"),
    "2006-03-12T18:35:00.000Z");
  EXPECT_NE(FileContent(first), FileContent(second));
}

// Velocities have no usual surfaces; those of a value that nothing reaches are left out.
TEST(SurfaceFilesOfVelocity, NameTheirUnit)
{
  const TemporaryFolder folder;
  const fs::path volume = WriteTwoMoments(folder.Path());
  const fs::path output = folder.Path() / "velocity.glb";
  const ProgramRun run =
    WriteSurfaces(volume, output, {"--moment", "VEL", "--iso-values", "-10,10,90"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const GlbParts parts = ReadGlb(output);
  EXPECT_TRUE(parts.Node("VEL -10 m/s").is_object());
  EXPECT_TRUE(parts.Node("VEL 90 m/s").is_null());
  const ProgramRun none = WriteSurfaces(volume, output, {"--moment", "VEL"});
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.errors.find("--iso-values"), std::string::npos) << none.errors;
}

TEST(SurfaceFilesFail, InOneLine)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 1);
  const ProgramRun nowhere = WriteSurfaces(series, folder.Path() / "no" / "storm.glb");
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_EQ(std::count(nowhere.errors.begin(), nowhere.errors.end(), '\n'), 1) << nowhere.errors;
  const std::vector<std::vector<std::string>> wrong = {
    {"--map", "composite"}, {"--colour-by", "REF_age"}, {"--preset", "velocity"}};
  for (const auto& options : wrong)
  {
    const ProgramRun run = WriteSurfaces(series, folder.Path() / "storm.glb", options);
    EXPECT_NE(run.status, 0) << options.front();
    EXPECT_FALSE(fs::exists(folder.Path() / "storm.glb"));
  }
}
