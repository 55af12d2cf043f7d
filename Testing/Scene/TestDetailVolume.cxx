// SPDX-License-Identifier: BSD-3-Clause
// A finer volume in place of a part of the volume.
#include "Scene/DetailVolume.h"
#include "vtkNexradVolumeScene.h"

#include "ScenePicture.h"
#include "StormVolume.h"
#include "Tolerance.h"
#include "VolumePart.h"
#include "vtkNexradImageConversion.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <bitset>

using namespace nexrad::scene;
using namespace nexrad::testing;

namespace
{

constexpr std::array<int, 2> detailSize = {400, 300};

// The voxels of the storm's tower, as they are in the storm.
vtkSmartPointer<vtkImageData> CutTower()
{
  auto tower = vtkSmartPointer<vtkImageData>::New();
  vtkNexradVolumeToImage(
    nexrad::testing::TakePart(MakeStorm(true), nexrad::VoxelBlock{{8, 8, 0}, {25, 25, 16}}), tower);
  return tower;
}

} // namespace

TEST(DetailVolume, DividesTheRegionsAboutItsBox)
{
  const std::array<double, 6> box = {-1.0, 1.0, -1.0, 1.0, 0.0, 2.0};
  vtkNew<vtkCamera> camera;
  camera->SetFocalPoint(0.0, 0.0, 1.0);
  camera->SetPosition(-10.0, -10.0, 10.0);
  for (const bool parallel : {false, true})
  {
    camera->SetParallelProjection(parallel);
    const RegionsAbout regions = DivideAbout(box, camera);
    EXPECT_EQ(regions.before & regions.behind, 0);
    EXPECT_EQ(regions.before | regions.behind, ((1 << 27) - 1) & ~(1 << 13));
    EXPECT_EQ(std::bitset<27>(static_cast<unsigned>(regions.before)).count(), 7U);
    EXPECT_NE(regions.before & (1 << 18), 0) << "west, south and above";
  }
  camera->SetParallelProjection(false);
  camera->SetPosition(0.0, 0.0, 10.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  EXPECT_EQ(DivideAbout(box, camera).before, 1 << 22) << "above alone";
}

// A part of the volume that stands in place of itself: what is before and behind it stays so from
// all sides.
TEST(DetailVolume, APartInPlaceOfItselfChangesLittle)
{
  const vtkSmartPointer<vtkImageData> storm = MakeStormVolume(true);
  const vtkSmartPointer<vtkImageData> tower = CutTower();
  vtkNew<vtkNexradVolumeScene> scene;
  UseClassicLook(scene);
  scene->SetVolume(storm);
  scene->SetOption("slices", "1024");
  OffScreenWindow window(scene->GetRenderer(), detailSize);
  for (const double azimuth : {20.0, 110.0, 200.0, 290.0})
  {
    for (const bool parallel : {false, true})
    {
      scene->SetAzimuth(azimuth);
      scene->SetParallelProjection(parallel);
      scene->SetDetail(nullptr);
      const Picture whole = window.Draw();
      scene->SetDetail(tower);
      EXPECT_AT_MOST(MeanDifference(window.Draw(), whole), 0.0235,
        "mean change of the picture by a part in place of itself, of 255")
        << azimuth;
    }
  }
}

TEST(DetailVolume, AFinerVolumeIsSeenAndTakenAway)
{
  const vtkSmartPointer<vtkImageData> storm = MakeStormVolume(true);
  const vtkSmartPointer<vtkImageData> tower = CutTower();
  tower->GetPointData()->GetScalars()->Fill(-33.0);
  vtkNew<vtkNexradVolumeScene> scene;
  scene->SetVolume(storm);
  OffScreenWindow window(scene->GetRenderer(), detailSize);
  const Picture whole = window.Draw();
  scene->SetDetail(tower);
  EXPECT_AT_LEAST(MeanDifference(window.Draw(), whole), 1.0,
    "mean change of the picture by an empty part, of 255");
  scene->SetDetail(nullptr);
  EXPECT_EQ(MeanDifference(window.Draw(), whole), 0.0);
}

// The ground is as dark as without the finer volume, which here holds nothing.
TEST(DetailVolume, TheGroundKeepsTheShadowOfTheVolume)
{
  const vtkSmartPointer<vtkImageData> tower = CutTower();
  tower->GetPointData()->GetScalars()->Fill(-33.0);
  vtkNew<vtkNexradVolumeScene> scene;
  scene->SetVolume(MakeStormVolume(true));
  scene->SetDetail(tower);
  OffScreenWindow window(scene->GetRenderer(), detailSize);
  const Picture shaded = window.Draw();
  EXPECT_EQ(MeanDifference(window.Draw(), shaded), 0.0);
  scene->SetOption("shadow", "0");
  scene->SetOption("occlusion", "0");
  const Picture plain = window.Draw();
  EXPECT_AT_LEAST(MeanDifference(shaded, plain), 12.0, "mean darkness of the shadow, of 255")
    << KeepPicture(shaded, "shaded-ground");
}
