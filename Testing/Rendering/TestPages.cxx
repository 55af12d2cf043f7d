// SPDX-License-Identifier: BSD-3-Clause
// A volume that is stored in pages, beside the same one in a texture of its own.
#include "RendererBound.h"
#include "RenderingTest.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <memory>

namespace
{

using namespace nexrad::testing;

class Pages : public RenderingTest
{
protected:
  void SetUp() override
  {
    RenderingTest::SetUp();
    if (IsSkipped() || HasFatalFailure())
    {
      return;
    }
    this->Stage = std::make_unique<Scene>(300, 220);
    this->UseStorm(VTK_FLOAT);
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->SetFocalPoint(0.0, 0.0, 16.0);
    camera->SetPosition(80.0, -150.0, 110.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Stage->GetRenderer()->ResetCameraClippingRange(-160, 160, -160, 160, -160, 160);
  }
  void TearDown() override
  {
    this->Stage.reset();
    RenderingTest::TearDown();
  }

  /// A storm in a part of a volume whose sizes are no multiples of a page; all points without echo
  /// are hidden.
  void UseStorm(int scalarType)
  {
    const auto storm = MakeStorm(81, scalarType, 41);
    const double none = scalarType == VTK_FLOAT ? -33.0 : 0.0;
    this->Input = vtkSmartPointer<vtkImageData>::New();
    this->Input->SetDimensions(170, 150, 59);
    this->Input->SetOrigin(-85.0, -60.0, -4.0);
    this->Input->AllocateScalars(scalarType, 1);
    vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
    scalars->FillComponent(0, none);
    for (vtkIdType id = 0; id < storm->GetNumberOfPoints(); ++id)
    {
      const vtkIdType x = 44 + id % 81;
      const vtkIdType y = 19 + id / 81 % 81;
      const vtkIdType z = 3 + id / (81 * 81);
      scalars->SetTuple1(
        x + 170 * (y + 150 * z), storm->GetPointData()->GetScalars()->GetTuple1(id));
    }
    SetStormFunctions(this->Stage->GetProperty(), scalarType);
    this->Ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    this->Ghosts->SetNumberOfTuples(scalars->GetNumberOfTuples());
    for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
    {
      const bool hidden = scalars->GetTuple1(id) < none + 38.0; // 5 dBZ
      this->Ghosts->SetValue(id, hidden ? vtkDataSetAttributes::HIDDENPOINT : 0);
    }
    this->Ghosts->Modified();
    this->Input->GetPointData()->AddArray(this->Ghosts);
    this->Mapper->SetInputData(this->Input);
  }

  Picture DrawInPages()
  {
    this->Mapper->SetMaxMemoryInBytes(1);
    const Picture drawn = this->Stage->Draw(this->Mapper);
    this->Mapper->SetMaxMemoryInBytes(0);
    return drawn;
  }

  void ExpectSame(double worst = 1.0)
  {
    const Picture inPages = this->DrawInPages();
    const vtkIdType bytesOfPages = this->Mapper->GetTextureBytes();
    const Picture whole = this->Stage->Draw(this->Mapper);
    EXPECT_LT(bytesOfPages, 3 * this->Mapper->GetTextureBytes() / 4) << "there are no pages";
    const Difference difference = Compare(inPages, whole, this->Stage->Draw(nullptr));
    EXPECT_GT(difference.Pixels, 2000);
    EXPECT_AT_MOST(
      difference.Worst, worst, "largest difference of a volume in pages, of 255", OneCode);
  }

  std::unique_ptr<Scene> Stage;
  vtkSmartPointer<vtkImageData> Input;
  vtkNew<vtkUnsignedCharArray> Ghosts;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Mapper;
};

} // namespace

TEST_F(Pages, Floats)
{
  this->ExpectSame();
  this->Mapper->PreIntegrationOn();
  this->ExpectSame();
}

TEST_F(Pages, Bytes)
{
  this->UseStorm(VTK_UNSIGNED_CHAR);
  this->Stage->GetRenderer()->GetActiveCamera()->ParallelProjectionOn();
  this->Stage->GetRenderer()->GetActiveCamera()->SetParallelScale(60.0);
  this->ExpectSame();
}

TEST_F(Pages, CellScalars)
{
  vtkNew<vtkImageData> cells;
  cells->SetOrigin(this->Input->GetOrigin());
  cells->SetSpacing(this->Input->GetSpacing());
  cells->SetDimensions(171, 151, 60);
  cells->GetCellData()->SetScalars(this->Input->GetPointData()->GetScalars());
  cells->GetCellData()->AddArray(this->Ghosts);
  this->Mapper->SetInputData(cells);
  this->ExpectSame();
}

TEST_F(Pages, LitSurfaces)
{
  this->Mapper->SetBlendModeToIsoSurface();
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 25.0);
  this->Stage->GetProperty()->ShadeOn();
  this->Mapper->SmoothGradientOn();
  this->ExpectSame();
}

TEST_F(Pages, LightShadowsAndCuts)
{
  this->Stage->GetProperty()->ShadeOn();
  this->Mapper->SetShadowStrength(0.7);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(-6.0, -6.0, 0.0);
  plane->SetNormal(-0.6, 0.8, 0.1);
  this->Mapper->AddClippingPlane(plane);
  this->ExpectSame(BoundOfRenderer(1.0, 17.0)); // a sample at a cut may fall to either side
}

TEST_F(Pages, Projections)
{
  for (const int mode : {vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
         vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::ADDITIVE_BLEND})
  {
    SCOPED_TRACE(mode);
    this->Mapper->SetBlendMode(mode);
    this->ExpectSame();
  }
}

// Pages follow the scalars, and the same mapper goes from pages to a whole texture and back.
TEST_F(Pages, FollowTheScalars)
{
  const Picture before = this->DrawInPages();
  vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
  const vtkIdType half = scalars->GetNumberOfTuples() / 2;
  for (vtkIdType id = 0; id < half; ++id)
  {
    std::swap(*this->Ghosts->GetPointer(id), *this->Ghosts->GetPointer(id + half));
    const double value = scalars->GetTuple1(id);
    scalars->SetTuple1(id, scalars->GetTuple1(id + half));
    scalars->SetTuple1(id + half, value);
  }
  scalars->Modified();
  this->Ghosts->Modified();
  const Picture background = this->Stage->Draw(nullptr);
  EXPECT_GT(Compare(this->DrawInPages(), before, background).Worst, 50.0);
  this->ExpectSame();
  this->ExpectSame();
}

// Where nothing is hidden, but all points without echo have one scalar.
TEST_F(Pages, AreSharedWhereScalarsAreEqual)
{
  this->Input->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  this->ExpectSame();
}

TEST_F(Pages, AreNotSharedWhereSomePointsAreHidden)
{
  vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
  scalars->FillComponent(0, 40.0);
  scalars->Modified();
  this->ExpectSame();
}

TEST_F(Pages, AreNotUsedWhereAllScalarsDiffer)
{
  this->Input->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
  for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
  {
    scalars->SetTuple1(id, static_cast<double>(id % 61));
  }
  this->DrawInPages();
  EXPECT_EQ(this->Mapper->GetTextureBytes(),
    static_cast<vtkIdType>(sizeof(float)) * this->Input->GetNumberOfPoints());
}

// More pages than stand side by side in one row.
TEST_F(Pages, TakeHardlyMoreMemoryThanTheyHaveTexels)
{
  this->Input->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
  scalars->FillComponent(0, 40.0);
  for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
  {
    if (id / 170 % 150 < 96 && id / (170 * 150) < 32) // 11 × 6 × 2 pages; the others are alike
    {
      scalars->SetTuple1(id, static_cast<double>(id % 61));
    }
  }
  this->DrawInPages();
  constexpr vtkIdType bytesOfPages = 133 * 17 * 17 * 17 * sizeof(float);
  EXPECT_GE(this->Mapper->GetTextureBytes(), bytesOfPages);
  EXPECT_LT(this->Mapper->GetTextureBytes(), bytesOfPages + bytesOfPages / 20);
}
