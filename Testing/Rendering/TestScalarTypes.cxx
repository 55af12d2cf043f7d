// SPDX-License-Identifier: BSD-3-Clause
// One volume in every scalar type gives one picture.
#include "RendererBound.h"
#include "RenderingTest.h"
#include "Tolerance.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace
{

using namespace nexrad::testing;

// Odd sizes: rows of bytes that are not multiples of four.
constexpr int Nx = 19;
constexpr int Ny = 13;
constexpr int Nz = 7;

/// A wavy ramp from offset to offset + 100.
vtkSmartPointer<vtkImageData> MakeRamp(int scalarType, double offset)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Nx, Ny, Nz);
  image->AllocateScalars(scalarType, 1);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtkIdType id = 0;
  for (int k = 0; k < Nz; ++k)
  {
    for (int j = 0; j < Ny; ++j)
    {
      for (int i = 0; i < Nx; ++i, ++id)
      {
        const double wave = std::sin(0.7 * i) * std::cos(0.5 * j + k);
        scalars->SetComponent(id, 0, offset + std::round(50.0 + 50.0 * wave));
      }
    }
  }
  return image;
}

class ScalarTypes : public RenderingTest
{
protected:
  Picture Draw(int scalarType, double offset)
  {
    Scene scene(128, 128);
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(offset, 0.0, 0.0, 1.0);
    color->AddRGBPoint(offset + 50.0, 0.0, 1.0, 0.0);
    color->AddRGBPoint(offset + 100.0, 1.0, 0.0, 0.0);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(offset + 10.0, 0.0);
    opacity->AddPoint(offset + 90.0, 0.5);
    scene.GetProperty()->SetColor(color);
    scene.GetProperty()->SetScalarOpacity(opacity);
    scene.GetProperty()->SetInterpolationTypeToLinear();
    vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
    mapper->SetInputData(MakeRamp(scalarType, offset));
    mapper->SetNumberOfSlices(100);
    vtkCamera* camera = scene.GetRenderer()->GetActiveCamera();
    camera->SetFocalPoint(9.0, 6.0, 3.0);
    camera->SetPosition(25.0, 30.0, 35.0);
    camera->SetClippingRange(10.0, 90.0);
    this->Background = scene.Draw(nullptr);
    return scene.Draw(mapper);
  }

  void ExpectLike(const Picture& reference, int scalarType, double offset, double bound)
  {
    const Difference difference =
      Compare(this->Draw(scalarType, offset), reference, this->Background);
    EXPECT_GT(difference.Pixels, 1000) << vtkImageScalarTypeNameMacro(scalarType);
    EXPECT_AT_MOST(difference.LargestMean(), bound, "mean difference to floats, of 255")
      << vtkImageScalarTypeNameMacro(scalarType) << " from " << offset;
  }

  Picture Background;
};

} // namespace

TEST_F(ScalarTypes, UnsignedTypes)
{
  const Picture reference = this->Draw(VTK_FLOAT, 0.0);
  for (const int type : {VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_UNSIGNED_INT, VTK_UNSIGNED_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_DOUBLE})
  {
    this->ExpectLike(reference, type, 0.0, 0.5);
  }
}

TEST_F(ScalarTypes, SignedTypesBelowZero)
{
  const Picture reference = this->Draw(VTK_FLOAT, 0.0);
  for (const int type :
    {VTK_SIGNED_CHAR, VTK_SHORT, VTK_INT, VTK_LONG, VTK_LONG_LONG, VTK_FLOAT, VTK_DOUBLE})
  {
    this->ExpectLike(reference, type, -50.0, 0.5);
  }
}

TEST_F(ScalarTypes, LargeOffsetsKeepTheirDifferences)
{
  const Picture reference = this->Draw(VTK_FLOAT, 0.0);
  // An NVIDIA H100 differs as much where the values begin at 0.
  const double shorts = BoundOfRenderer(0.0058, 0.41);
  this->ExpectLike(reference, VTK_SHORT, -32000.0, shorts);
  this->ExpectLike(reference, VTK_UNSIGNED_SHORT, 65000.0, shorts);
  this->ExpectLike(reference, VTK_INT, 2.0e9, 0.0058); // a float has steps of 128 there
  this->ExpectLike(reference, VTK_DOUBLE, 1.0e12, 0.0058);
}
