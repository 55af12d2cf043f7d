// SPDX-License-Identifier: BSD-3-Clause
#include "ScenePicture.h"
#include "RendererBound.h"
#include "Tolerance.h"
#include "vtkNexradVolumeScene.h"

#include <vtkImageData.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>

namespace fs = std::filesystem;

namespace nexrad::testing
{
namespace
{

// Of the mean difference. Measured: 0 between runs of Mesa's llvmpipe with vectors of 128 and 256
// bits, with and without threads. The bound leaves room for rounding at the edges of a few lines,
// and is half of what slices and VTK's ray caster differ by. An NVIDIA H100 differs by at most
// 0.46; a picture that is moved by a pixel differs by 5 or more.
double BaselineTolerance()
{
  return BoundOfRenderer(0.01, 0.9);
}

Picture ReadBaseline(const std::string& name)
{
  const fs::path path = fs::path(NEXRAD_BASELINE_DIR) / "Scene" / (name + ".png");
  EXPECT_TRUE(fs::exists(path)) << "no baseline " << path;
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

Picture Moved(const Picture& picture)
{
  const auto moved = Picture::New();
  moved->DeepCopy(picture);
  auto* bytes = static_cast<unsigned char*>(moved->GetScalarPointer());
  std::rotate(bytes, bytes + 3, bytes + 3 * moved->GetNumberOfPoints());
  return moved;
}

} // namespace

OffScreenWindow::OffScreenWindow(vtkRenderer* renderer, const std::array<int, 2>& size)
{
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(4);
  window->SetSize(size[0], size[1]);
  window->AddRenderer(renderer);
}

OffScreenWindow::~OffScreenWindow() = default;

Picture OffScreenWindow::Draw()
{
  window->Render();
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->ReadFrontBufferOff();
  grabber->Update();
  return grabber->GetOutput();
}

void UseClassicLook(vtkNexradVolumeScene* scene)
{
  scene->SetOption("look", "classic");
}

std::array<int, 3> PixelOf(const Picture& picture, int x, int y)
{
  const auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
  return {bytes[0], bytes[1], bytes[2]};
}

double MeanDifference(const Picture& a, const Picture& b)
{
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints() || a->GetNumberOfPoints() == 0)
  {
    return std::numeric_limits<double>::infinity();
  }
  const auto* left = static_cast<const unsigned char*>(a->GetScalarPointer());
  const auto* right = static_cast<const unsigned char*>(b->GetScalarPointer());
  const vtkIdType count = 3 * a->GetNumberOfPoints();
  double sum = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    sum += std::abs(int(left[i]) - int(right[i]));
  }
  return sum / static_cast<double>(count);
}

std::string KeepPicture(const Picture& picture, const std::string& name)
{
  const fs::path folder = fs::path(NEXRAD_TEST_OUTPUT_DIR) / "Scene";
  fs::create_directories(folder);
  const std::string path = (folder / (name + ".png")).string();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(picture);
  writer->Write();
  return path;
}

void ExpectSceneBaseline(const Picture& picture, const std::string& name)
{
  const std::string path = KeepPicture(picture, name);
  const Picture baseline = ReadBaseline(name);
  const double difference = MeanDifference(picture, baseline);
  const double moved = MeanDifference(Moved(picture), baseline);
  std::cout << name << ": difference " << difference << ", moved by a pixel " << moved << '\n';
  EXPECT_AT_MOST(difference, BaselineTolerance(), name + ": difference to the baseline, of 255",
    "other OpenGL drivers round differently; a picture moved by a pixel is further off")
    << "the picture is " << path;
  EXPECT_GT(moved, BaselineTolerance()) << "a wrong picture passes";
}

} // namespace nexrad::testing
