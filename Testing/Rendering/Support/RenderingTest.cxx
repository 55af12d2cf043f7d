// SPDX-License-Identifier: BSD-3-Clause
#include "RenderingTest.h"
#include "Tolerance.h"

#include "vtkImageData.h"
#include "vtkImageDifference.h"
#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>

namespace fs = std::filesystem;

namespace nexrad::testing
{

Scene::Scene(int width, int height, int multiSamples, bool debugOutput)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(multiSamples);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->AddVolume(this->Volume);
  this->Watched = debugOutput && this->Messages.Watch(this->Window);
}

Scene::~Scene()
{
  this->Window->Finalize(); // releases what the volume holds there
  EXPECT_EQ(this->Messages.Take(), "") << "while the window was closed";
}

vtkVolumeProperty* Scene::GetProperty()
{
  return this->Volume->GetProperty();
}

Picture Scene::Draw(vtkVolumeMapper* mapper)
{
  if (mapper != nullptr)
  {
    this->Volume->SetMapper(mapper);
  }
  this->Volume->SetVisibility(mapper != nullptr);
  this->Window->Render();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << "after drawing a frame";
  EXPECT_EQ(this->Messages.Take(), "") << "while a frame was drawn";

  const int* size = this->Window->GetSize();
  auto picture = Picture::New();
  picture->SetDimensions(size[0], size[1], 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  std::copy(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues(),
    static_cast<unsigned char*>(picture->GetScalarPointer()));
  return picture;
}

Color PixelAt(const Picture& picture, int x, int y)
{
  const auto* pixel = static_cast<const unsigned char*>(picture->GetScalarPointer(x, y, 0));
  return {double(pixel[0]), double(pixel[1]), double(pixel[2])};
}

double Difference::LargestMean() const
{
  return *std::max_element(this->Mean.begin(), this->Mean.end());
}

Difference Compare(const Picture& a, const Picture& b, const Picture& background)
{
  Difference difference;
  const auto* pa = static_cast<const unsigned char*>(a->GetScalarPointer());
  const auto* pb = static_cast<const unsigned char*>(b->GetScalarPointer());
  const auto* pg = static_cast<const unsigned char*>(background->GetScalarPointer());
  const vtkIdType count = background->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i, pa += 3, pb += 3, pg += 3)
  {
    if (std::equal(pa, pa + 3, pg) && std::equal(pb, pb + 3, pg))
    {
      continue;
    }
    ++difference.Pixels;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double d = std::abs(int(pa[c]) - int(pb[c]));
      difference.Mean[c] += d;
      difference.Worst = std::max(difference.Worst, d);
    }
  }
  for (double& mean : difference.Mean)
  {
    mean /= std::max(1, difference.Pixels);
  }
  return difference;
}

std::string WritePicture(const Picture& picture, const std::string& name)
{
  const fs::path folder = fs::path(NEXRAD_TEST_OUTPUT_DIR) / "Rendering";
  fs::create_directories(folder);
  const std::string path = (folder / (name + ".png")).string();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(picture);
  writer->Write();
  return path;
}

Picture DifferencePicture(const Picture& a, const Picture& b)
{
  auto result = Picture::New();
  result->DeepCopy(a);
  auto* out = static_cast<unsigned char*>(result->GetScalarPointer());
  const auto* other = static_cast<const unsigned char*>(b->GetScalarPointer());
  for (vtkIdType i = 0; i < 3 * a->GetNumberOfPoints(); ++i)
  {
    out[i] = static_cast<unsigned char>(std::min(255, 8 * std::abs(int(out[i]) - int(other[i]))));
  }
  return result;
}

Picture MovedPicture(const Picture& picture)
{
  auto moved = Picture::New();
  moved->DeepCopy(picture);
  auto* pixels = static_cast<unsigned char*>(moved->GetScalarPointer());
  std::rotate(pixels, pixels + 3, pixels + 3 * moved->GetNumberOfPoints());
  return moved;
}

namespace
{

/// The baseline of that name; where highlights differ, that of mirrored ones.
fs::path BaselinePath(const std::string& name)
{
  const fs::path folder = fs::path(NEXRAD_BASELINE_DIR) / "Rendering";
  const fs::path mirrored = folder / (name + "-mirrored.png");
  return HasMirroredHighlights() && fs::exists(mirrored) ? mirrored : folder / (name + ".png");
}

} // namespace

bool HasMirroredHighlights()
{
  return VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0);
}

double BaselineError(const Picture& picture, const std::string& name)
{
  const fs::path baseline = BaselinePath(name);
  if (!fs::exists(baseline))
  {
    std::cerr << "no baseline " << baseline << '\n';
    return std::numeric_limits<double>::infinity();
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(baseline.string().c_str());
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(picture);
  difference->SetImageConnection(reader->GetOutputPort());
  // VTK's defaults forgive a shift by a pixel and differences up to 16.
  difference->AllowShiftOff();
  difference->AveragingOff();
  difference->SetThreshold(2);
  difference->Update();
  return difference->GetThresholdedError();
}

void ExpectBaseline(const Picture& picture, const std::string& name)
{
  const std::string path = WritePicture(picture, name);
  const double error = BaselineError(picture, name);
  const double moved = BaselineError(MovedPicture(picture), name);
  std::cout << name << ": error " << error << ", moved by a pixel " << moved << '\n';
  EXPECT_AT_MOST(error, BaselineTolerance, name + ": error to the baseline",
    "other OpenGL drivers round differently; a picture moved by a pixel is further off")
    << "the picture is " << path;
  EXPECT_GT(moved, BaselineTolerance) << "a wrong picture passes";
}

/// Keeps VTK's messages in place of printing them.
class RenderingTest::Collector : public vtkOutputWindow
{
public:
  static Collector* New();
  vtkTypeMacro(Collector, vtkOutputWindow);
  void DisplayText(const char* text) override { this->Text += text; }

  std::string Text;

protected:
  Collector() = default;
};

vtkStandardNewMacro(RenderingTest::Collector);

RenderingTest::RenderingTest()
  : Messages(vtkSmartPointer<Collector>::New())
{
}

RenderingTest::~RenderingTest() = default;

void RenderingTest::SetUp()
{
  const char* display = std::getenv("DISPLAY");
  if (display == nullptr || *display == '\0')
  {
    const char* required = std::getenv("NEXRAD_REQUIRE_DISPLAY");
    if (required != nullptr && std::string(required) == "1")
    {
      FAIL() << "no display, but NEXRAD_REQUIRE_DISPLAY=1: run under xvfb-run";
    }
    GTEST_SKIP() << "no display: run under xvfb-run";
  }
  vtkOutputWindow::SetInstance(this->Messages);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // the collector has it all
}

void RenderingTest::TearDown()
{
  EXPECT_EQ(this->TakeMessages(), "") << "VTK reported this";
  vtkOutputWindow::SetInstance(nullptr);
}

std::string RenderingTest::TakeMessages()
{
  std::string text;
  std::swap(text, this->Messages->Text);
  return text;
}

} // namespace nexrad::testing
