// SPDX-License-Identifier: BSD-3-Clause
// Shadows and ambient occlusion on isosurfaces, beside what geometry says.
#include "RenderingTest.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkStaticCellLocator.h"
#include "vtkTriangle.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace
{

using namespace nexrad::testing;

using Vector = std::array<double, 3>;

constexpr int PictureEdge = 300; // pixels along each side

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector Along(const Vector& from, const Vector& direction, double length)
{
  return {from[0] + length * direction[0], from[1] + length * direction[1],
    from[2] + length * direction[2]};
}

/// A ball above a plane: the scalar is the distance into the nearer one.
struct Ball
{
  static constexpr double Half = 16.0; ///< of the cube that contains both
  static constexpr double Radius = 6.0;
  static constexpr double Ground = -8.0;
  static constexpr Vector Centre{0.0, 0.0, 4.0};

  static double Scalar(const Vector& at, bool hasGround)
  {
    const double away = std::hypot(at[0] - Centre[0], at[1] - Centre[1], at[2] - Centre[2]);
    return hasGround ? std::max(Radius - away, Ground - at[2]) : Radius - away;
  }

  /// Where a ray first meets the ball.
  static std::optional<double> Meet(
    const Vector& from, const Vector& direction, double radius = Radius)
  {
    const Vector apart{from[0] - Centre[0], from[1] - Centre[1], from[2] - Centre[2]};
    const double half = Dot(apart, direction);
    const double root = half * half - Dot(apart, apart) + radius * radius;
    return root > 0.0 ? std::optional<double>(-half - std::sqrt(root)) : std::nullopt;
  }

  /// Cosine of the angle between the ball's normal there and a direction.
  static double GetFacing(const Vector& at, const Vector& direction)
  {
    const Vector normal{at[0] - Centre[0], at[1] - Centre[1], at[2] - Centre[2]};
    return Dot(normal, direction) / std::sqrt(Dot(normal, normal));
  }
};

class SurfaceShadows : public RenderingTest
{
protected:
  void SetUp() override
  {
    RenderingTest::SetUp();
    if (IsSkipped() || HasFatalFailure())
    {
      return;
    }
    this->Stage = std::make_unique<Scene>(PictureEdge, PictureEdge);
    this->Mapper->SetBlendModeToIsoSurface();
    this->SetLight({0.5, -0.3, 1.0});
    vtkVolumeProperty* property = this->Stage->GetProperty();
    property->SetInterpolationTypeToLinear();
    vtkNew<vtkColorTransferFunction> white;
    white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    property->SetColor(white);
    this->SetOpacity(1.0);
    this->MakeBall(65);
    this->Aim({30.0, -60.0, 45.0}, {0.0, 0.0, -2.0}, 14.0);
  }
  void TearDown() override
  {
    this->Stage.reset();
    RenderingTest::TearDown();
  }

  void SetLight(const Vector& towards)
  {
    this->ToLight = towards;
    vtkMath::Normalize(this->ToLight.data());
    this->Mapper->SetLightDirection(this->ToLight.data());
  }

  void SetOpacity(double opacity)
  {
    vtkNew<vtkPiecewiseFunction> function;
    function->AddPoint(0.0, opacity);
    this->Stage->GetProperty()->SetScalarOpacity(function);
  }

  void MakeBall(int points, bool hasGround = true)
  {
    const double spacing = 2.0 * Ball::Half / (points - 1);
    this->Input = vtkSmartPointer<vtkImageData>::New();
    this->Input->SetDimensions(points, points, points);
    this->Input->SetSpacing(spacing, spacing, spacing);
    this->Input->SetOrigin(-Ball::Half, -Ball::Half, -Ball::Half);
    this->Input->AllocateScalars(VTK_FLOAT, 1);
    auto* scalars = static_cast<float*>(this->Input->GetScalarPointer());
    for (vtkIdType id = 0; id < this->Input->GetNumberOfPoints(); ++id)
    {
      Vector place{};
      this->Input->GetPoint(id, place.data());
      scalars[id] = static_cast<float>(Ball::Scalar(place, hasGround));
    }
    this->Mapper->SetInputData(this->Input);
    this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 0.0);
  }

  /// Two surfaces: the outer one red, the inner one green, so that green is the light of the inner
  /// one times what the outer one lets through.
  void UseTwoSurfaces(double outer, double inner, double outerOpacity)
  {
    vtkVolumeProperty* property = this->Stage->GetProperty();
    property->GetIsoSurfaceValues()->SetValue(0, outer);
    property->GetIsoSurfaceValues()->SetValue(1, inner);
    vtkNew<vtkColorTransferFunction> color;
    vtkNew<vtkPiecewiseFunction> opacity;
    const double low = outer + 0.5 * (inner - outer);
    const double high = outer + 0.7 * (inner - outer);
    color->AddRGBPoint(low, 1.0, 0.0, 0.0);
    color->AddRGBPoint(high, 0.0, 1.0, 0.0);
    opacity->AddPoint(low, outerOpacity);
    opacity->AddPoint(high, 1.0);
    property->SetColor(color);
    property->SetScalarOpacity(opacity);
  }

  /// A parallel view that is so many units high.
  void Aim(const Vector& from, const Vector& at, double halfHeight)
  {
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(at.data());
    camera->SetPosition(from.data());
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetParallelScale(halfHeight);
    camera->SetClippingRange(1.0, 300.0);
  }

  /// Where the ray of a pixel begins.
  Vector FindStart(int x, int y)
  {
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->OrthogonalizeViewUp();
    Vector away{};
    Vector up{};
    Vector right{};
    Vector start{};
    camera->GetDirectionOfProjection(away.data());
    camera->GetViewUp(up.data());
    vtkMath::Cross(away.data(), up.data(), right.data());
    camera->GetPosition(start.data());
    const double height = 2.0 * camera->GetParallelScale();
    start = Along(start, right, ((x + 0.5) / PictureEdge - 0.5) * height);
    return Along(start, up, ((y + 0.5) / PictureEdge - 0.5) * height);
  }

  Vector GetSight()
  {
    Vector away{};
    this->Stage->GetRenderer()->GetActiveCamera()->GetDirectionOfProjection(away.data());
    return away;
  }

  Picture Draw() { return this->Stage->Draw(this->Mapper); }
  Picture DrawWith(double shadow, double occlusion = 0.0)
  {
    this->Mapper->SetShadowStrength(shadow);
    this->Mapper->SetOcclusionStrength(occlusion);
    return this->Draw();
  }

  /// Light in the middle of the lowest layer, 0 to 1.
  double LightBelow()
  {
    vtkImageData* light = this->Mapper->GetLightVolume();
    const int* size = light->GetDimensions();
    return light->GetScalarComponentAsDouble(size[0] / 2, size[1] / 2, 0, 0);
  }

  std::unique_ptr<Scene> Stage;
  vtkSmartPointer<vtkImageData> Input;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Mapper;
  Vector ToLight{};
};

/// Where surface pixels are lit and where not, by geometry and in a picture.
struct Agreement
{
  int Lit = 0;      ///< by geometry
  int Dark = 0;     ///< by geometry
  int LitWrong = 0; ///< darker than one half in the picture
  int DarkWrong = 0;

  void Add(bool lit, double light)
  {
    (lit ? this->Lit : this->Dark) += 1;
    this->LitWrong += lit && light < 0.5 ? 1 : 0;
    this->DarkWrong += !lit && light >= 0.5 ? 1 : 0;
  }
  double WrongShare() const
  {
    return double(this->LitWrong + this->DarkWrong) / (this->Lit + this->Dark);
  }
};

std::ostream& operator<<(std::ostream& os, const Agreement& a)
{
  return os << 100.0 * a.WrongShare() << " % wrong: of " << a.Lit << " lit pixels " << a.LitWrong
            << ", of " << a.Dark << " dark ones " << a.DarkWrong;
}

/// The triangles of an isosurface, for rays to the eye and to the light.
class Triangles
{
public:
  Triangles(vtkImageData* volume, double value)
  {
    this->Edges->SetInputData(volume);
    this->Edges->SetValue(0, value);
    this->Edges->ComputeNormalsOff();
    this->Edges->Update();
    this->Locator->SetDataSet(this->Edges->GetOutput());
    this->Locator->BuildLocator();
  }

  /// Whether the light reaches what a ray of sight meets first; nothing: it meets nothing.
  std::optional<bool> IsLit(const Vector& eye, const Vector& sight, const Vector& toLight)
  {
    Vector place{};
    vtkIdType triangle = -1;
    if (!this->Meet(eye, sight, place, triangle))
    {
      return std::nullopt;
    }
    Vector normal = this->GetNormal(triangle);
    const double sign = Dot(normal, sight) > 0.0 ? -1.0 : 1.0; // towards the eye
    constexpr double clear = 1e-3;
    return sign * Dot(normal, toLight) > 0.0 &&
           !this->Meet(Along(place, normal, sign * clear), toLight, place, triangle);
  }

private:
  bool Meet(const Vector& from, const Vector& direction, Vector& place, vtkIdType& triangle)
  {
    constexpr double farAway = 300.0;
    const Vector to = Along(from, direction, farAway);
    double at = 0.0;
    Vector parametric{};
    int part = 0;
    return this->Locator->IntersectWithLine(from.data(), to.data(), 1e-6, at, place.data(),
             parametric.data(), part, triangle) != 0;
  }

  Vector GetNormal(vtkIdType triangle)
  {
    std::array<Vector, 3> corners{};
    for (vtkIdType i = 0; i < 3; ++i)
    {
      this->Edges->GetOutput()->GetCell(triangle)->GetPoints()->GetPoint(
        i, corners[static_cast<std::size_t>(i)].data());
    }
    Vector normal{};
    vtkTriangle::ComputeNormal(
      corners[0].data(), corners[1].data(), corners[2].data(), normal.data());
    return normal;
  }

  vtkNew<vtkFlyingEdges3D> Edges;
  vtkNew<vtkStaticCellLocator> Locator;
};

} // namespace

// White surfaces without shading have the brightness of the light that arrives.
TEST_F(SurfaceShadows, ABallCastsItsShadowWhereGeometrySays)
{
  for (const int points : {33, 65, 129})
  {
    this->MakeBall(points);
    const Picture picture = this->DrawWith(1.0);
    WritePicture(picture, "surface-shadows-ball-" + std::to_string(points));
    Agreement onBall;
    Agreement onGround;
    const Vector sight = this->GetSight();
    for (int y = 0; y < PictureEdge; ++y)
    {
      for (int x = 0; x < PictureEdge; ++x)
      {
        const Vector start = this->FindStart(x, y);
        const double light = PixelAt(picture, x, y)[0] / 255.0;
        if (const auto way = Ball::Meet(start, sight))
        {
          onBall.Add(Ball::GetFacing(Along(start, sight, *way), this->ToLight) > 0.0, light);
          continue;
        }
        const Vector at = Along(start, sight, (Ball::Ground - start[2]) / sight[2]);
        if (std::max(std::abs(at[0]), std::abs(at[1])) < Ball::Half - 0.5)
        {
          onGround.Add(!Ball::Meet(at, this->ToLight), light);
        }
      }
    }
    std::cout << points << " points: ball " << onBall << "; ground " << onGround << '\n';
    EXPECT_GT(onBall.Dark, 500);
    EXPECT_GT(onGround.Dark, 5000);
    const std::string voxels = " of " + std::to_string(points) + " points, share";
    EXPECT_AT_MOST(onBall.WrongShare(),
      points == 33   ? 0.017
      : points == 65 ? 0.0044
                     : 0.0015,
      "wrong pixels on the ball" + voxels);
    EXPECT_AT_MOST(onGround.WrongShare(),
      points == 33   ? 0.012
      : points == 65 ? 0.0056
                     : 0.006,
      "wrong pixels on the plane" + voxels);
  }
}

// Rays from the surfaces that vtkFlyingEdges3D makes towards the light say which pixels are lit.
TEST_F(SurfaceShadows, TheStormsShadowsAreThoseOfRays)
{
  this->Aim({50.0, -90.0, 80.0}, {0.0, 0.0, 10.0}, 30.0);
  this->SetLight({-0.8, -0.4, 1.0});
  const Vector sight = this->GetSight();
  for (const int points : {64, 128, 256})
  {
    this->Input = MakeStorm(points, VTK_FLOAT);
    this->Mapper->SetInputData(this->Input);
    Agreement all;
    for (const double value : {20.0, 35.0})
    {
      this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, value);
      const Picture picture = this->DrawWith(1.0);
      Triangles triangles(this->Input, value);
      for (int y = 0; y < PictureEdge; y += 2)
      {
        for (int x = 0; x < PictureEdge; x += 2)
        {
          const auto lit = triangles.IsLit(this->FindStart(x, y), sight, this->ToLight);
          if (lit)
          {
            all.Add(*lit, PixelAt(picture, x, y)[0] / 255.0);
          }
        }
      }
    }
    std::cout << points << " points: " << all << '\n';
    EXPECT_GT(all.Dark, 1000);
    EXPECT_AT_MOST(all.WrongShare(),
      points == 64    ? 0.06
      : points == 128 ? 0.03
                      : 0.02,
      "wrong pixels on the storm of " + std::to_string(points) + " points, share");
  }
}

TEST_F(SurfaceShadows, ASurfaceTakesItsOpacityOfTheLight)
{
  this->SetLight({0.0, 0.0, 1.0});
  this->MakeBall(65, false);
  const auto below = [&](double opacity)
  {
    this->SetOpacity(opacity);
    this->DrawWith(1.0);
    return this->LightBelow();
  };
  EXPECT_LT(below(1.0), 1e-6);
  EXPECT_EQ(below(0.0), 1.0);
  for (const double opacity : {0.2, 0.5, 0.9})
  {
    // Into the ball and out of it.
    EXPECT_WITHIN(below(opacity), std::pow(1.0 - opacity, 2), 1.5e-5, "light below the ball");
  }
  this->Mapper->SetShadowDensity(0.5);
  EXPECT_WITHIN(below(0.5), 0.5, 1.5e-5, "light below the ball");
  EXPECT_LT(below(1.0), 1e-6);
}

// An opaque ball keeps all light from what is below it, until it is cut or masked away.
TEST_F(SurfaceShadows, WhatIsNotDrawnCastsNoShadow)
{
  this->SetLight({0.0, 0.0, 1.0});
  this->MakeBall(65, false);
  this->Mapper->SetShadowStrength(1.0);
  const auto lightBelow = [&]
  {
    this->Draw();
    return this->LightBelow();
  };
  EXPECT_LT(lightBelow(), 1e-6);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(1.5, 0.0, 0.0);
  plane->SetNormal(1.0, 0.0, 0.0);
  this->Mapper->AddClippingPlane(plane);
  EXPECT_EQ(lightBelow(), 1.0);
  this->Mapper->RemoveAllClippingPlanes();
  this->Mapper->CroppingOn();
  this->Mapper->SetCroppingRegionPlanes(1.5, 16.0, -16.0, 16.0, -16.0, 16.0);
  EXPECT_EQ(lightBelow(), 1.0);
  this->Mapper->CroppingOff();
  EXPECT_LT(lightBelow(), 1e-6);
  vtkNew<vtkUnsignedCharArray> flags;
  flags->SetNumberOfTuples(this->Input->GetNumberOfPoints());
  flags->Fill(0.0);
  vtkNew<vtkImageData> mask;
  mask->CopyStructure(this->Input);
  mask->GetPointData()->SetScalars(flags);
  this->Mapper->SetMaskTypeToBinary();
  this->Mapper->SetMaskInput(mask);
  EXPECT_EQ(lightBelow(), 1.0);
}

// The upper half of the ball from above: the light that arrives at an inner surface.
TEST_F(SurfaceShadows, AnInnerSurfaceHasWhatTheOuterOneLeaves)
{
  const Vector sight = this->GetSight();
  constexpr double cell = 0.5;
  for (const double outerOpacity : {0.5, 0.2})
  {
    for (const double apart : {0.25, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0})
    {
      this->UseTwoSurfaces(0.0, apart * cell, outerOpacity);
      const Picture picture = this->DrawWith(1.0);
      double sum = 0.0;
      int pixels = 0;
      for (int y = 0; y < PictureEdge; ++y)
      {
        for (int x = 0; x < PictureEdge; ++x)
        {
          const Vector start = this->FindStart(x, y);
          const auto way = Ball::Meet(start, sight, Ball::Radius - apart * cell);
          if (way && Ball::GetFacing(Along(start, sight, *way), this->ToLight) > 0.3)
          {
            sum += PixelAt(picture, x, y)[1] / 255.0 / (1.0 - outerOpacity);
            ++pixels;
          }
        }
      }
      std::cout << "light " << apart << " cells below a surface of opacity " << outerOpacity << ": "
                << sum / pixels << '\n';
      EXPECT_WITHIN(sum / pixels, 1.0 - outerOpacity, 0.044, "light below an outer surface");
    }
  }
}

// Where the ball faces the light, the shadow must leave the picture as it is.
TEST_F(SurfaceShadows, AConvexSurfaceDoesNotShadowItsLitSide)
{
  for (const Vector& light : {Vector{0.5, -0.3, 1.0}, {1.0, -1.0, 0.1}, {0.1, -1.0, 0.3}})
  {
    this->SetLight(light);
    const Picture without = this->DrawWith(0.0);
    const Picture with = this->DrawWith(1.0);
    const Vector sight = this->GetSight();
    double worst = 0.0;
    double sum = 0.0;
    int pixels = 0;
    for (int y = 0; y < PictureEdge; ++y)
    {
      for (int x = 0; x < PictureEdge; ++x)
      {
        const Vector start = this->FindStart(x, y);
        const auto way = Ball::Meet(start, sight, 0.98 * Ball::Radius);
        if (way && Ball::GetFacing(Along(start, sight, *way), this->ToLight) > 0.2)
        {
          const double off = PixelAt(without, x, y)[0] - PixelAt(with, x, y)[0];
          worst = std::max(worst, off);
          sum += off;
          ++pixels;
        }
      }
    }
    std::cout << "self-shadow of 255: mean " << sum / pixels << ", most " << worst << ", over "
              << pixels << " pixels\n";
    EXPECT_GT(pixels, 3000);
    EXPECT_AT_MOST(sum / pixels, 0.014, "mean self-shadow of a ball, of 255");
    EXPECT_AT_MOST(worst, 8.0, "largest self-shadow of a ball, of 255");
  }
}

// The side of an opaque ball away from the light.
TEST_F(SurfaceShadows, NoLightLeaksThroughAnOpaqueSurface)
{
  this->SetLight({0.3, 0.2, 1.0});
  this->Aim({30.0, -60.0, -45.0}, {0.0, 0.0, 4.0}, 8.0);
  this->Stage->GetRenderer()->GetActiveCamera()->SetClippingRange(40.0, 300.0);
  this->MakeBall(65, false);
  const Picture picture = this->DrawWith(1.0);
  const Vector sight = this->GetSight();
  double worst = 0.0;
  int pixels = 0;
  for (int y = 0; y < PictureEdge; ++y)
  {
    for (int x = 0; x < PictureEdge; ++x)
    {
      const Vector start = this->FindStart(x, y);
      const auto way = Ball::Meet(start, sight);
      if (way && Ball::GetFacing(Along(start, sight, *way), this->ToLight) < -0.15)
      {
        worst = std::max(worst, PixelAt(picture, x, y)[0]);
        ++pixels;
      }
    }
  }
  EXPECT_GT(pixels, 10000);
  EXPECT_AT_MOST(worst, 1.0, "light on the dark side of an opaque ball, of 255", OneCode);
}

// The sky is seen whole from a plane, and not from below a ball.
TEST_F(SurfaceShadows, OcclusionIsTheSkyOnTheSideOfTheEye)
{
  this->Aim({0.0, -20.0, 60.0}, {0.0, 0.0, -8.0}, 15.0);
  const Picture without = this->DrawWith(0.0);
  const Picture with = this->DrawWith(0.0, 1.0);
  WritePicture(with, "surface-occlusion-ball");
  const Vector sight = this->GetSight();
  double top = 0.0;
  double beneath = 0.0;
  int pixels = 0;
  for (int y = 0; y < PictureEdge; ++y)
  {
    for (int x = 0; x < PictureEdge; ++x)
    {
      const Vector start = this->FindStart(x, y);
      const double off = PixelAt(without, x, y)[0] - PixelAt(with, x, y)[0];
      const auto way = Ball::Meet(start, sight);
      if (way && Along(start, sight, *way)[2] > Ball::Centre[2] + 0.99 * Ball::Radius)
      {
        top = std::max(top, off);
      }
      const Vector at = Along(start, sight, (Ball::Ground - start[2]) / sight[2]);
      if (!way && std::hypot(at[0], at[1]) < Ball::Radius)
      {
        beneath += off;
        ++pixels;
      }
    }
  }
  EXPECT_AT_MOST(top, 1.0, "occlusion on top of a ball, of 255", OneCode);
  beneath /= pixels;
  // The share of the sky that the ball covers as seen from below it, from the directions of L2.
  const double covered = 1.0 - std::sqrt(0.75);
  std::cout << "occlusion of 255: on top of the ball " << top << ", beneath " << beneath << '\n';
  EXPECT_WITHIN(beneath, 255.0 * covered, 6.0, "occlusion beneath a ball, of 255");
}

TEST_F(SurfaceShadows, SwitchedOffAgainThePictureIsTheSameToTheLastBit)
{
  for (const bool shade : {false, true})
  {
    this->Stage->GetProperty()->SetShade(shade);
    const Picture off = this->DrawWith(0.0);
    EXPECT_EQ(this->Mapper->GetLightVolume(), nullptr);
    EXPECT_GT(Compare(this->DrawWith(0.5), off, off).Worst, 50.0);
    this->Stage->GetProperty()->SetAmbient(0.5);
    const Picture brighter = this->DrawWith(0.0);
    EXPECT_GT(Compare(this->DrawWith(0.0, 0.5), brighter, brighter).Worst, 20.0);
    this->Stage->GetProperty()->SetAmbient(0.1);
    EXPECT_EQ(Compare(this->DrawWith(0.0), off, off).Worst, 0.0);
  }
}

TEST_F(SurfaceShadows, WithoutADirectionThereAreNone)
{
  const Picture off = this->DrawWith(0.0);
  this->Mapper->SetZenith(0.0, 0.0, 0.0);
  for (const double x : {0.0, std::numeric_limits<double>::quiet_NaN()})
  {
    this->Mapper->SetLightDirection(x, 0.0, 0.0);
    EXPECT_EQ(Compare(this->DrawWith(1.0, 1.0), off, off).Worst, 0.0);
  }
}

// A light volume that is made anew is a modified image.
TEST_F(SurfaceShadows, LightIsMadeAnewForTheSurfacesNotForTheCamera)
{
  this->DrawWith(0.5, 0.5);
  vtkMTimeType made = this->Mapper->GetLightVolume()->GetMTime();
  const auto isMadeAnew = [&](const std::function<void()>& change)
  {
    change();
    this->Draw();
    const vtkMTimeType before = made;
    made = this->Mapper->GetLightVolume()->GetMTime();
    return made != before;
  };
  vtkContourValues* values = this->Stage->GetProperty()->GetIsoSurfaceValues();
  vtkRenderer* renderer = this->Stage->GetRenderer();
  EXPECT_FALSE(isMadeAnew([&] { renderer->GetActiveCamera()->Azimuth(20.0); }));
  EXPECT_FALSE(isMadeAnew([&] { this->Mapper->SetShadowStrength(0.7); }));
  EXPECT_FALSE(isMadeAnew([&] { this->Stage->GetProperty()->SetAmbient(0.3); }));
  EXPECT_TRUE(isMadeAnew([&] { values->SetValue(0, 0.5); }));
  EXPECT_TRUE(isMadeAnew([&] { values->SetValue(1, 1.0); }));
  EXPECT_TRUE(isMadeAnew([&] { this->SetOpacity(0.4); }));
  EXPECT_TRUE(isMadeAnew([&] { this->SetLight({0.0, 0.0, 1.0}); }));
  EXPECT_TRUE(isMadeAnew([&] { this->Mapper->SetBlendModeToComposite(); }));
  EXPECT_TRUE(isMadeAnew([&] { this->Mapper->SetBlendModeToIsoSurface(); }));
  EXPECT_FALSE(isMadeAnew([] {}));
}

// The picture: surfaces of 20 and 40 dBZ of the storm, the outer one translucent; the anvils shade
// the towers.
TEST_F(SurfaceShadows, TheStormHasALitAndADarkSide)
{
  Scene small(128, 128);
  small.GetVolume()->SetProperty(this->Stage->GetProperty());
  this->Aim({50.0, -90.0, 70.0}, {0.0, 0.0, 12.0}, 28.0);
  small.GetRenderer()->SetActiveCamera(this->Stage->GetRenderer()->GetActiveCamera());
  this->Input = MakeStorm(48, VTK_FLOAT);
  this->Mapper->SetInputData(this->Input);
  this->SetLight({-1.0, -1.0, 1.0});
  this->UseTwoSurfaces(20.0, 40.0, 0.5);
  this->Stage->GetProperty()->ShadeOn();
  this->Stage->GetProperty()->SetAmbient(0.4);
  this->Stage->GetProperty()->SetDiffuse(0.6);
  this->Stage->GetProperty()->SetSpecular(0.0);
  this->Mapper->SetShadowStrength(0.8);
  this->Mapper->SetOcclusionStrength(0.6);
  ExpectBaseline(small.Draw(this->Mapper), "SurfaceShadows");
}
