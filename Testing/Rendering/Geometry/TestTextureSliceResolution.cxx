// SPDX-License-Identifier: BSD-3-Clause
// How the image sample distance follows the time that frames take.
#include "vtkTextureSliceTarget.h"

#include <gtest/gtest.h>

TEST(TextureSliceResolution, StillPicturesAreFine)
{
  vtkTextureSliceResolution resolution;
  EXPECT_EQ(resolution.Choose(1000.0, 1.0, 10.0), 1.0);
  resolution.Report(30.0);
  EXPECT_EQ(resolution.Choose(1000.0, 1.0, 10.0), 1.0);
}

TEST(TextureSliceResolution, SlowFramesMakeItCoarse)
{
  // 0.9 s at 1; 0.1 s are allowed: 2 would take 0.225 s, 5 takes 0.036 s.
  vtkTextureSliceResolution resolution;
  EXPECT_EQ(resolution.Choose(0.1, 1.0, 10.0), 1.0);
  resolution.Report(0.9);
  EXPECT_EQ(resolution.Choose(0.1, 1.0, 10.0), 5.0);
  // It stays there while frames take what was expected, and the still picture is fine again.
  resolution.Report(0.036);
  EXPECT_EQ(resolution.Choose(0.1, 1.0, 10.0), 5.0);
  EXPECT_EQ(resolution.Choose(1000.0, 1.0, 10.0), 1.0);
}

TEST(TextureSliceResolution, FastFramesMakeItFineAgain)
{
  vtkTextureSliceResolution resolution;
  resolution.Choose(0.1, 1.0, 10.0);
  resolution.Report(100.0);
  EXPECT_EQ(resolution.Choose(0.1, 1.0, 10.0), 10.0);
  for (int frame = 0; frame < 20; ++frame)
  {
    resolution.Report(0.0001);
    resolution.Choose(0.1, 1.0, 10.0);
  }
  EXPECT_EQ(resolution.Choose(0.1, 1.0, 10.0), 1.0);
}

TEST(TextureSliceResolution, StaysWithinItsLimits)
{
  vtkTextureSliceResolution resolution;
  EXPECT_EQ(resolution.Choose(1000.0, 1.5, 3.0), 1.5);
  resolution.Report(100.0);
  EXPECT_EQ(resolution.Choose(0.01, 1.5, 3.0), 3.0);
}
