// SPDX-License-Identifier: BSD-3-Clause
// Windows come and go, inputs and functions change, requests are refused.
#include "RenderingTest.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

namespace
{

using namespace nexrad::testing;

constexpr double CubeSide = 8.0;

class MapperLife : public RenderingTest
{
protected:
  std::unique_ptr<Scene> MakeScene(double opacity = 0.12)
  {
    auto scene = std::make_unique<Scene>(64, 64);
    SetUniformFunctions(scene->GetProperty(), opacity);
    vtkCamera* camera = scene->GetRenderer()->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(CubeSide / 2, CubeSide / 2, CubeSide / 2);
    camera->SetPosition(CubeSide / 2, CubeSide / 2, 30.0);
    camera->SetParallelScale(5.0);
    camera->SetClippingRange(1.0, 60.0);
    return scene;
  }

  double Middle(Scene& scene, vtkVolumeMapper* mapper)
  {
    return PixelAt(scene.Draw(mapper), 32, 32)[0];
  }
};

constexpr double Expected = 255.0 * (1.0 - 0.3596345); // 0.88 to the power of 8

} // namespace

// The detector itself: an error that is made on purpose must be reported, or its silence elsewhere
// says nothing.
TEST_F(MapperLife, OpenGLReportsErrors)
{
  auto scene = this->MakeScene();
  ASSERT_TRUE(scene->HasDebugOutput()) << "OpenGL 4.3 is needed for the debug output";
  scene->GetWindow()->MakeCurrent();
  EXPECT_EQ(scene->GetMessages().Take(), "");
  glEnable(GL_TEXTURE_MAX_LEVEL); // no capability
  const std::string message = scene->GetMessages().Take();
  EXPECT_NE(message.find("GL_INVALID_ENUM"), std::string::npos) << message;
  // Mesa names the function, NVIDIA's driver the argument.
  const bool named = message.find("glEnable") != std::string::npos ||
                     message.find("<cap> enum is invalid") != std::string::npos;
  EXPECT_TRUE(named) << message;
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
}

TEST_F(MapperLife, OneMapperInTwoWindows)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputData(MakeUniformCube(9, 1.0f));
  auto first = this->MakeScene();
  auto second = this->MakeScene();
  EXPECT_WITHIN(
    this->Middle(*first, mapper), Expected, 1.0, "brightness in the first window, of 255", OneCode);
  EXPECT_WITHIN(this->Middle(*second, mapper), Expected, 1.0,
    "brightness in the second window, of 255", OneCode);
  EXPECT_WITHIN(this->Middle(*first, mapper), Expected, 1.0,
    "brightness in the first window again, of 255", OneCode);
  first.reset();
  EXPECT_WITHIN(this->Middle(*second, mapper), Expected, 1.0,
    "brightness in the second window alone, of 255", OneCode);
}

TEST_F(MapperLife, MapperOutlivesItsWindowAndTheOtherWayRound)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputData(MakeUniformCube(9, 1.0f));
  EXPECT_WITHIN(this->Middle(*this->MakeScene(), mapper), Expected, 1.0,
    "brightness in a window that goes, of 255", OneCode);
  auto scene = this->MakeScene();
  {
    vtkNew<vtkOpenGLTextureSliceVolumeMapper> shortLived;
    shortLived->SetInputData(MakeUniformCube(9, 1.0f));
    EXPECT_WITHIN(this->Middle(*scene, shortLived), Expected, 1.0,
      "brightness by a mapper that goes, of 255", OneCode);
  }
  EXPECT_WITHIN(this->Middle(*scene, mapper), Expected, 1.0,
    "brightness by a mapper that stays, of 255", OneCode);
}

TEST_F(MapperLife, ReleasedResourcesAreMadeAnew)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputData(MakeUniformCube(9, 1.0f));
  auto scene = this->MakeScene();
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_WITHIN(
      this->Middle(*scene, mapper), Expected, 1.0, "brightness after a release, of 255", OneCode);
    mapper->ReleaseGraphicsResources(scene->GetWindow());
  }
}

TEST_F(MapperLife, WindowSizeInputAndFunctionsMayChange)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  vtkSmartPointer<vtkImageData> cube = MakeUniformCube(9, 1.0f);
  mapper->SetInputData(cube);
  auto scene = this->MakeScene();
  EXPECT_WITHIN(
    this->Middle(*scene, mapper), Expected, 1.0, "brightness at first, of 255", OneCode);

  scene->GetWindow()->SetSize(96, 80);
  EXPECT_WITHIN(PixelAt(scene->Draw(mapper), 48, 40)[0], Expected, 1.0,
    "brightness in a resized window, of 255", OneCode);

  // The same function, changed in place.
  scene->GetProperty()->GetScalarOpacity()->RemoveAllPoints();
  scene->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 0.0);
  scene->GetProperty()->GetScalarOpacity()->AddPoint(1.0, 1.0);
  EXPECT_WITHIN(PixelAt(scene->Draw(mapper), 48, 40)[0], 255.0, 1.0,
    "brightness with other functions, of 255", OneCode);

  // The same array, changed in place.
  cube->GetPointData()->GetScalars()->Fill(0.0);
  cube->GetPointData()->GetScalars()->Modified();
  cube->Modified();
  EXPECT_EQ(PixelAt(scene->Draw(mapper), 48, 40)[0], 0.0);

  // Another array of another size.
  mapper->SetInputData(MakeUniformCube(5, 1.0f));
  EXPECT_WITHIN(PixelAt(scene->Draw(mapper), 40, 32)[0], 255.0, 1.0,
    "brightness of another input, of 255", OneCode);
}

TEST_F(MapperLife, NativeRangeClampsTheScalar)
{
  // Scalars outside of an opacity of 0.12 from 0 to 1, which does not hold beyond. At one of its
  // ends such a function is 0 already: at the first in VTK 9.1, at the last in 9.3.
  auto scene = this->MakeScene();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.12);
  opacity->AddPoint(1.0, 0.12);
  opacity->ClampingOff();
  scene->GetProperty()->SetScalarOpacity(opacity);
  double brightest = 0.0;
  for (const float scalar : {-5.0f, 5.0f})
  {
    vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
    mapper->SetInputData(MakeUniformCube(9, scalar));
    EXPECT_EQ(this->Middle(*scene, mapper), 0.0);
    mapper->SetScalarOpacityRangeType(vtkGPUVolumeRayCastMapper::NATIVE);
    brightest = std::max(brightest, this->Middle(*scene, mapper));
  }
  EXPECT_WITHIN(brightest, Expected, 1.0, "brightness of the strongest value, of 255", OneCode);
}

TEST_F(MapperLife, UnsupportedRequestsAreRefusedInOneLine)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputData(MakeUniformCube(9, 1.0f));
  auto scene = this->MakeScene();
  EXPECT_TRUE(mapper->IsRenderSupported(scene->GetWindow(), scene->GetProperty()));

  mapper->SetBlendModeToSlice();
  EXPECT_FALSE(mapper->IsRenderSupported(scene->GetWindow(), scene->GetProperty()));
  EXPECT_EQ(this->Middle(*scene, mapper), 0.0);
  EXPECT_NE(this->TakeMessages().find("slice blending needs a vtkPlane"), std::string::npos);

  // Three components without functions of their own mean nothing.
  mapper->SetBlendModeToComposite();
  vtkNew<vtkImageData> colors;
  colors->SetDimensions(3, 3, 3);
  colors->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  colors->GetPointData()->GetScalars()->Fill(1.0);
  mapper->SetInputData(colors);
  EXPECT_TRUE(mapper->IsRenderSupported(scene->GetWindow(), scene->GetProperty()));
  scene->GetProperty()->IndependentComponentsOff();
  EXPECT_FALSE(mapper->IsRenderSupported(scene->GetWindow(), scene->GetProperty()));
  EXPECT_EQ(this->Middle(*scene, mapper), 0.0);
  EXPECT_NE(this->TakeMessages().find("component"), std::string::npos); // VTK's own words
}

TEST_F(MapperLife, GridsThatDoNotAscendAreRefused)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(3, 3, 3);
  vtkNew<vtkFloatArray> coordinates;
  for (const float x : {0.0f, 4.0f, 1.0f})
  {
    coordinates->InsertNextValue(x);
  }
  grid->SetXCoordinates(coordinates);
  grid->SetYCoordinates(coordinates);
  grid->SetZCoordinates(coordinates);
  vtkNew<vtkFloatArray> scalars;
  scalars->SetNumberOfTuples(27);
  scalars->Fill(1.0);
  grid->GetPointData()->SetScalars(scalars);
  mapper->SetInputData(grid);
  auto scene = this->MakeScene();
  EXPECT_FALSE(mapper->IsRenderSupported(scene->GetWindow(), scene->GetProperty()));
  EXPECT_EQ(this->Middle(*scene, mapper), 0.0);
  EXPECT_NE(this->TakeMessages().find("they must ascend"), std::string::npos);
  this->Middle(*scene, mapper);
  EXPECT_EQ(this->TakeMessages(), "");
}

TEST_F(MapperLife, FourComponentsCannotHideTheirPoints)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  image->AllocateScalars(VTK_FLOAT, 4);
  image->GetPointData()->GetScalars()->Fill(std::nan(""));
  mapper->SetInputData(image);
  auto scene = this->MakeScene();
  this->Middle(*scene, mapper);
  EXPECT_NE(this->TakeMessages().find("four components with hidden points"), std::string::npos);
}

// The error names the size of a grid, the limit, and a size that fits; that size is drawn.
TEST_F(MapperLife, GridBeyondTheLargestTextureNamesBoth)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  auto scene = this->MakeScene();
  const auto draw = [&](int points)
  {
    mapper->SetInputData(MakeRod(points, CubeSide));
    return this->Middle(*scene, mapper);
  };
  EXPECT_EQ(draw(40000), 0.0);
  const std::string message = this->TakeMessages();
  EXPECT_NE(message.find("40000 x 2 x 2"), std::string::npos) << message;
  EXPECT_NE(message.find("at most"), std::string::npos) << message;
  EXPECT_NE(message.find(" x 2 x 2 or less"), std::string::npos) << message;
  double ratio[3];
  mapper->GetReductionRatio(ratio);
  EXPECT_LT(ratio[0], 1.0);
  EXPECT_EQ(ratio[1], 1.0);

  const std::string before = "resample it to ";
  const int fitting = std::atoi(message.c_str() + message.find(before) + before.size());
  EXPECT_EQ(fitting, int(std::lround(40000 * ratio[0])));
  EXPECT_WITHIN(
    draw(fitting), Expected, 1.0, "brightness at the largest texture that fits, of 255", OneCode);
}

TEST_F(MapperLife, ImageBeyondTheLargestTexture)
{
  vtkNew<vtkImageData> rod;
  rod->SetDimensions(40000, 2, 2);
  rod->SetSpacing(CubeSide / 39999, CubeSide, CubeSide);
  rod->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  rod->GetPointData()->GetScalars()->Fill(1.0);
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputData(rod);
  auto scene = this->MakeScene();
  EXPECT_NE(mapper->IsRenderSupported(scene->GetWindow(), scene->GetProperty()), 0);
  EXPECT_WITHIN(this->Middle(*scene, mapper), Expected, 1.0,
    "brightness of an image of 40000 voxels along an axis, of 255", OneCode);
  double ratio[3];
  mapper->GetReductionRatio(ratio);
  EXPECT_EQ(ratio[0], 1.0);
}

TEST_F(MapperLife, FlatImageIsAnError)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(9, 9, 1);
  flat->AllocateScalars(VTK_FLOAT, 1);
  flat->GetPointData()->GetScalars()->Fill(1.0);
  mapper->SetInputData(flat);
  auto scene = this->MakeScene();
  this->Middle(*scene, mapper);
  EXPECT_NE(this->TakeMessages().find("no thickness"), std::string::npos);
}
