// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a volume that is drawn in voxels as fine as the pixels.
#include "vtkNexradSession.h"
#include "vtkNexradVolumeScene.h"

#include "ScenePicture.h"
#include "StormVolume.h"
#include "TestData.h"
#include "Tolerance.h"
#include "VolumePart.h"
#include "vtkNexradImageConversion.h"

#include <vtkImageData.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

using namespace nexrad::testing;

namespace
{

constexpr std::array<int, 2> largeSize = {400, 300};

// Near the storm.
void LookAtStorm(vtkNexradVolumeScene* scene, double zoom)
{
  UseClassicLook(scene);
  scene->SetLookAt(-70'000.0, -70'000.0, 5'000.0);
  scene->SetZoom(zoom);
}

} // namespace

// As far as the picture shows it, or farther: the same picture.
TEST(LargePictures, ShowNoSeamWhereTheFineVoxelsEnd)
{
  const TemporaryFolder folder;
  const std::string path = WriteLargeStorm(folder.Path());
  vtkNew<vtkImageData> wide;
  vtkNexradVolumeToImage(
    TakePart(MakeLargeStorm(), nexrad::VoxelBlock{{0, 0, 0}, {2000, 64, 16}}), wide);
  vtkNew<vtkNexradSession> session;
  session->SetScalarsAsCodes(false);
  session->AddFileName(path.c_str());
  vtkNexradVolumeScene* scene = session->GetScene();
  OffScreenWindow window(scene->GetRenderer(), largeSize);
  for (const double zoom : {5.0, 10.0})
  {
    LookAtStorm(scene, zoom);
    ASSERT_TRUE(session->ShowTimeStep(0));
    vtkImageData* seen = scene->GetDetail();
    ASSERT_NE(seen, nullptr);
    ASSERT_LT(seen->GetDimensions()[0], 2000);
    const Picture picture = window.Draw();
    scene->SetDetail(wide);
    const Picture expected = window.Draw();
    EXPECT_AT_MOST(MeanDifference(picture, expected), 0.35,
      "mean difference of the picture from that of more fine voxels, of 255")
      << zoom << ' ' << KeepPicture(picture, "large-seen") << ' '
      << KeepPicture(expected, "large-wide");
    scene->SetDetail(nullptr);
    EXPECT_AT_LEAST(MeanDifference(window.Draw(), expected), 1.2,
      "mean difference of the picture in coarse voxels, of 255")
      << zoom;
  }
}
