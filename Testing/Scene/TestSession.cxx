// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradSession.h"

#include "StormVolume.h"
#include "TestData.h"
#include "vtkNexradMessages.h"
#include "vtkNexradVolumeScene.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

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
