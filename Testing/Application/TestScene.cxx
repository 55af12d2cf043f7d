// SPDX-License-Identifier: BSD-3-Clause
#include "PictureWindow.h"
#include "StormVolume.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>

#include <cstdlib>
#include <filesystem>
using namespace nexrad;
using namespace nexrad::scene;

TEST(Scene, Draft)
{
  SceneOptions o;
  if (getenv("EX"))
    o.exaggeration = atof(getenv("EX"));
  RadarScene s(o);
  CameraView v;
  if (getenv("AZ"))
    v.azimuth = atof(getenv("AZ"));
  if (getenv("TILT"))
    v.tilt = atof(getenv("TILT"));
  if (getenv("PAR"))
    v.parallel = true;
  s.SetCamera(v);
  s.SetVolume(nexrad::testing::MakeStormVolume(true));
  PictureWindow w(s, {1280, 720});
  WritePng(w.Draw(), "/tmp/app-draft.png");
}
