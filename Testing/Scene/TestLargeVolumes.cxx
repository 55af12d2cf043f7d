// SPDX-License-Identifier: BSD-3-Clause
// Volumes that are in their files in voxels of several sizes: which of them are read.
#include "Filters/Series/VolumeFiles.h"
#include "vtkNexradSession.h"

#include "ErrorMessage.h"
#include "StormVolume.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Codec/NxvFile.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradVolumeScene.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkXMLImageDataWriter.h>

#include <gtest/gtest.h>

#include <array>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

std::array<int, 3> SizeOf(vtkImageData* image)
{
  std::array<int, 3> size{};
  image->GetDimensions(size.data());
  return size;
}

class LargeVolumes : public ::testing::Test
{
protected:
  vtkSmartPointer<vtkImageData> LoadBox(const BoxRequest& box)
  {
    return series->LoadBox(0, box, {});
  }

  const TemporaryFolder folder;
  const std::filesystem::path path = WriteLargeStorm(folder.Path());
  const std::unique_ptr<VolumeSeries> series = OpenVolumeFiles({path});
};

} // namespace

// 2100 voxels along x are more than a texture is trusted to take.
TEST_F(LargeVolumes, TheFinestThatFitInATextureAreRead)
{
  EXPECT_TRUE(series->LeavesOutFiner(0));
  for (const bool codes : {false, true})
  {
    series->AllowCodes(codes);
    EXPECT_EQ(SizeOf(series->Load(0, {})), (std::array<int, 3>{1050, 32, 16}));
  }
  const auto all = OpenVolumeFiles({path}, {{}, {}, true, PlaceUnit::OfVolume, true});
  EXPECT_EQ(SizeOf(all->Load(0, {})), (std::array<int, 3>{2100, 64, 16}));
  EXPECT_FALSE(all->LeavesOutFiner(0));
  const TemporaryFolder small;
  EXPECT_FALSE(OpenVolumeFiles({WriteStormFiles(small.Path(), 1)})->LeavesOutFiner(0));
}

TEST_F(LargeVolumes, ABoxHasTheFinestVoxelsThatAreAskedFor)
{
  BoxRequest box;
  box.faces = {-100'000.0, -20'000.0, -97'500.0, 0.0};
  const auto fine = this->LoadBox(box);
  EXPECT_EQ(SizeOf(fine), (std::array<int, 3>{350, 13, 16})) << "mostVoxels is for merging";
  EXPECT_NEAR(fine->GetBounds()[0], -100'000.0, 229.0);
  EXPECT_NEAR(fine->GetBounds()[3], -3'750.0, 1.0) << "the last row's middle";
  ASSERT_EQ(fine->GetNumberOfPoints(), 350 * 13 * 16);
  const GriddedVolume whole = MakeLargeStorm();
  const GriddedVolume part = vtkNexradImageToVolume(fine);
  for (std::size_t i = 0; i < part.values.size(); ++i)
  {
    const auto at = [&](int axis, std::size_t index)
    {
      return std::lround((part.grid.Coordinate(axis, static_cast<int>(index)) -
                           whole.grid.origin[static_cast<std::size_t>(axis)]) /
                         whole.grid.spacing[static_cast<std::size_t>(axis)]);
    };
    const auto same = static_cast<std::size_t>(
      at(0, i % 350) + 2100 * (at(1, i / 350 % 13) + 64 * at(2, i / (350 * 13))));
    ASSERT_EQ(part.states[i], whole.states[same]) << i;
    ASSERT_NEAR(part.values[i], whole.values[same], 0.2501) << i;
  }
  box.spacing = 457.0; // less than twice the voxels
  EXPECT_EQ(SizeOf(this->LoadBox(box))[0], 350);
  box.spacing = 458.0;
  EXPECT_EQ(SizeOf(this->LoadBox(box))[0], 175);
  box.spacing = 1e6;
  EXPECT_EQ(SizeOf(this->LoadBox(box))[0], 43) << "the coarsest";
  box.spacing = 1.0;
  box.faces = {-300'000.0, 300'000.0, 0.0, 300'000.0};
  EXPECT_EQ(SizeOf(this->LoadBox(box)), (std::array<int, 3>{1050, 16, 16})) << "fits no finer";
  series->AllowCodes(true);
  EXPECT_EQ(SizeOf(this->LoadBox(box)), (std::array<int, 3>{2100, 32, 16})) << "in pages";
}

// A code takes two bytes of a texture, in pages 2.3. The whole may take a quarter, a box the rest.
TEST_F(LargeVolumes, TheyFitInTheTextureMemory)
{
  constexpr double wholeBytes = 4.0 * 2.0 * 1050 * 32 * 16;
  NxvReadOptions finest;
  finest.block = VoxelBlock::Of(MakeLargeStorm().grid);
  const double boxBytes =
    4.0 / 3.0 * 2.3 * static_cast<double>(CountVoxelsThatDiffer(path, finest));
  BoxRequest all;
  all.faces = {-300'000.0, 300'000.0, -100'000.0, 300'000.0};
  all.spacing = 1.0;
  for (const bool fits : {true, false})
  {
    const auto open = [&](double bytes)
    {
      VolumeFileRequest request;
      request.textureMemory = static_cast<std::size_t>(bytes) + (fits ? 1 : -4);
      auto limited = OpenVolumeFiles({path}, request);
      limited->AllowCodes(true);
      return limited;
    };
    EXPECT_EQ(SizeOf(open(wholeBytes)->Load(0, {}))[0], fits ? 1050 : 525);
    EXPECT_EQ(SizeOf(open(boxBytes)->LoadBox(0, all, {}))[0], fits ? 2100 : 1050);
  }
}

TEST_F(LargeVolumes, BoxesThatCannotBeReadAreErrors)
{
  BoxRequest box;
  box.faces = {400'000.0, 500'000.0, 0.0, 1000.0};
  const auto errorOf = [&] { return MessageOf([&] { this->LoadBox(box); }); };
  EXPECT_NE(errorOf().find("large.nxv: the box does not lie over the domain"), std::string::npos);
  box.faces = {0.0, 10'000.0, 0.0, 10'000.0};
  EXPECT_EQ(errorOf(), "");
  box.followedFrom = Time{};
  EXPECT_NE(errorOf().find("leave out --follow-from"), std::string::npos);
  box.followedFrom.reset();
  const auto inDegrees = OpenVolumeFiles({path}, {{}, {}, true, PlaceUnit::Degrees});
  EXPECT_NE(
    MessageOf([&] { inDegrees->LoadBox(0, box, {}); }).find("the box is"), std::string::npos);
  const std::string image = (folder.Path() / "storm.vti").string();
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(image.c_str());
  writer->SetInputData(MakeStormVolume(true));
  writer->Write();
  EXPECT_NE(MessageOf([&] { OpenVolumeFiles({image})->LoadBox(0, box, {}); })
              .find("from radar files alone"),
    std::string::npos);
}

// From far away, the voxels that fit; near, those as fine as the pixels of what is seen alone.
TEST_F(LargeVolumes, ASessionShowsVoxelsAsFineAsThePixels)
{
  vtkNew<vtkNexradSession> session;
  vtkNexradVolumeScene* scene = session->GetScene();
  scene->SetOption("frame", "domain");
  session->AddFileName(path.c_str());
  scene->SetZoom(0.3);
  ASSERT_TRUE(session->ShowTimeStep(0));
  EXPECT_EQ(SizeOf(scene->GetVolume())[0], 1050);
  EXPECT_EQ(scene->GetDetail(), nullptr) << "a pixel shows several voxels";
  scene->SetZoom(8.0);
  ASSERT_TRUE(session->ShowTimeStep(0));
  ASSERT_NE(scene->GetDetail(), nullptr);
  EXPECT_NEAR(scene->GetDetail()->GetSpacing()[0], 480'000.0 / 2100.0, 1e-6);
  const int seen = SizeOf(scene->GetDetail())[0];
  EXPECT_LT(seen, 1050) << "an eighth of the domain is seen, and what is behind it";
  EXPECT_GT(seen, 2100 / 8);
  EXPECT_EQ(SizeOf(scene->GetVolume())[0], 1050);
  scene->SetZoom(0.3);
  ASSERT_TRUE(session->ShowTimeStep(0));
  EXPECT_EQ(scene->GetDetail(), nullptr);
}
