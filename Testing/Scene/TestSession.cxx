// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradSession.h"

#include "StormVolume.h"
#include "TestData.h"
#include "vtkNexradDayReader.h"
#include "vtkNexradMessages.h"
#include "vtkNexradVolumeScene.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>

using namespace nexrad::testing;

TEST(Session, ShowsTheTimesOfASeries)
{
  const TemporaryFolder folder;
  const std::string index = WriteStormFiles(folder.Path(), 3);
  vtkNew<vtkNexradSession> session;
  session->AddFileName(index.c_str());
  vtkDoubleArray* times = session->GetTimeSteps();
  ASSERT_EQ(times->GetNumberOfValues(), 3);
  EXPECT_EQ(times->GetValue(1) - times->GetValue(0), 300.0);
  EXPECT_EQ(session->GetTimeStepIndex(), -1);
  EXPECT_EQ(session->GetScene()->GetVolume(), nullptr);

  ASSERT_TRUE(session->ShowTimeStep(2));
  EXPECT_EQ(session->GetTimeStepIndex(), 2);
  vtkImageData* last = session->GetScene()->GetVolume();
  ASSERT_NE(last, nullptr);
  EXPECT_TRUE(session->ShowTimeStep(2));
  EXPECT_EQ(session->GetScene()->GetVolume(), last) << "loaded again";

  const std::pair<double, int> nearest[] = {
    {-1e9, 0}, {149.0, 0}, {150.0, 0}, {151.0, 1}, {1e9, 2}};
  for (const auto& [seconds, step] : nearest)
  {
    EXPECT_TRUE(session->ShowTime(times->GetValue(0) + seconds));
    EXPECT_EQ(session->GetTimeStepIndex(), step) << seconds;
  }
  EXPECT_EQ(session->GetDamage()->GetNumberOfValues(), 0);
}

namespace
{

std::array<double, 6> FrameOf(vtkNexradSession* session, int step)
{
  std::array<double, 6> frame{};
  EXPECT_TRUE(session->ShowTimeStep(step));
  EXPECT_TRUE(session->GetScene()->GetFrameBounds(frame.data()));
  return frame;
}

} // namespace

// The storm moves 60 km to the east.
TEST(Session, TheFrameHoldsAllTimesOfEachPreset)
{
  const TemporaryFolder folder;
  vtkNew<vtkNexradSession> session;
  session->AddFileName(WriteStormFiles(folder.Path(), 4).c_str());
  const std::array<double, 6> all = FrameOf(session, 0);
  EXPECT_EQ(FrameOf(session, 3), all);
  vtkNew<vtkNexradSession> last;
  last->AddFileName((folder.Path() / "20060312T184500Z.nxv").c_str());
  EXPECT_LE(FrameOf(last, 0)[1], all[1]);
  EXPECT_GE(FrameOf(last, 0)[0], all[0] + 40e3);
  session->GetScene()->SetPreset("hail");
  const std::array<double, 6> hail = FrameOf(session, 3);
  EXPECT_LT(hail[1] - hail[0], 0.8 * (all[1] - all[0]));
  EXPECT_EQ(FrameOf(session, 0), hail);
}

TEST(Session, TheFrameHoldsAllTimesOfRadarFiles)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  vtkNew<vtkNexradSession> session;
  session->AddFileName((data / "level2" / "run-kbgm-20050821").c_str());
  session->GetDayReader()->SetDimensions(64, 64, 32);
  session->GetDayReader()->SetTimeStep(600.0);
  const std::array<double, 6> all = FrameOf(session, 0);
  EXPECT_EQ(FrameOf(session, 2), all);
  vtkNexradVolumeScene* scene = session->GetScene();
  scene->ClearFrame();
  scene->AddToFrame(scene->GetVolume()); // of the usual voxels, at the last time
  const std::array<double, 6> last = FrameOf(session, 2);
  for (std::size_t i = 0; i < last.size(); ++i)
  {
    EXPECT_LE((i % 2 == 0 ? 1.0 : -1.0) * (all[i] - last[i]), i < 4 ? 15e3 : 1e3) << i;
  }
}

TEST(Session, AnErrorLeavesWhatIsShown)
{
  const TemporaryFolder folder;
  const std::string index = WriteStormFiles(folder.Path(), 2);
  vtkNew<vtkNexradSession> session;
  vtkNexradMessages messages;
  messages.Watch(session);
  messages.Watch(session->GetScene());
  const auto expectError = [&messages](bool done, const std::string& words)
  {
    EXPECT_FALSE(done) << words;
    ASSERT_EQ(messages.Errors().size(), 1u) << words;
    EXPECT_NE(messages.Errors().front().find(words), std::string::npos)
      << messages.Errors().front();
    messages.Clear();
  };
  expectError(session->UpdateInformation(), "no file name");
  session->AddFileName(index.c_str());
  ASSERT_TRUE(session->ShowTimeStep(0));
  vtkImageData* first = session->GetScene()->GetVolume();
  expectError(session->ShowTimeStep(2), "no time step 2; there are 2");
  expectError(session->ShowTimeStep(-1), "no time step -1");
  session->GetScene()->SetPreset("velocity");
  expectError(session->ShowTimeStep(1), "is of VEL");
  EXPECT_EQ(session->GetTimeStepIndex(), 0);
  EXPECT_EQ(session->GetScene()->GetVolume(), first);
  session->GetScene()->SetPreset("");
  EXPECT_TRUE(session->ShowTimeStep(1));

  session->AddFileName("/dev/null");
  expectError(session->ShowTimeStep(0), "volumes and radar files");
  session->ClearFileNames();
  session->AddFileName("/nonexistent.nxv");
  expectError(session->UpdateInformation(), "/nonexistent.nxv");
  EXPECT_EQ(session->GetTimeSteps()->GetNumberOfValues(), 0);
}
