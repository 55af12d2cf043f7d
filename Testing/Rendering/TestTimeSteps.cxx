// SPDX-License-Identifier: BSD-3-Clause
// Of a volume that follows another one, the mapper uploads what differs: each picture beside that
// of a mapper that meets the volume first, to the last bit.
#include "RenderingTest.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace
{

using namespace nexrad::testing;

class TimeSteps : public RenderingTest
{
protected:
  void SetUp() override
  {
    RenderingTest::SetUp();
    if (!IsSkipped() && !HasFatalFailure())
    {
      this->Stage = this->MakeStage();
    }
  }
  void TearDown() override
  {
    this->Stage.reset();
    RenderingTest::TearDown();
  }

  static std::unique_ptr<Scene> MakeStage()
  {
    auto stage = std::make_unique<Scene>(120, 90);
    SetStormFunctions(stage->GetProperty(), VTK_FLOAT);
    vtkCamera* camera = stage->GetRenderer()->GetActiveCamera();
    camera->SetFocalPoint(0.0, 0.0, 12.0);
    camera->SetPosition(50.0, -90.0, 70.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    stage->GetRenderer()->ResetCameraClippingRange(-80, 80, -80, 80, -80, 80);
    return stage;
  }

  /// Shows the next step: its picture is that of the volume alone, and not the last one.
  void ExpectStep(vtkImageData* image, const char* what, bool changes = true)
  {
    SCOPED_TRACE(what);
    this->Mapper->SetInputData(image);
    const Picture shown = this->Stage->Draw(this->Mapper);
    vtkNew<vtkImageData> copy;
    copy->DeepCopy(image);
    vtkNew<vtkOpenGLTextureSliceVolumeMapper> other;
    other->SetScalarMode(this->Mapper->GetScalarMode());
    other->SelectScalarArray(this->Mapper->GetArrayName());
    other->SetInputData(copy);
    const Picture expected = this->Stage->Draw(other);
    const Picture background = this->Stage->Draw(nullptr);
    EXPECT_GT(Compare(expected, expected, background).Pixels, 100);
    EXPECT_EQ(Compare(shown, expected, background).Worst, 0.0);
    if (this->Last != nullptr && changes)
    {
      EXPECT_GT(Compare(shown, this->Last, background).Worst, 2.0) << "nothing to be seen changed";
    }
    this->Last = shown;
  }

  static vtkDataArray* ScalarsOf(vtkImageData* image)
  {
    return image->GetPointData()->GetScalars() != nullptr ? image->GetPointData()->GetScalars()
                                                          : image->GetCellData()->GetScalars();
  }

  /// A storm of which a box has another reflectivity.
  static vtkSmartPointer<vtkImageData> MakeStep(
    int place, double dBZ = 55.0, int scalarType = VTK_FLOAT)
  {
    auto image = MakeStorm(40, scalarType);
    const double scalar = scalarType == VTK_FLOAT || scalarType == VTK_DOUBLE ? dBZ : dBZ + 33.0;
    for (int z = 4; z < 15; ++z)
    {
      for (int y = place; y < place + 9; ++y)
      {
        for (int x = place; x < place + 7; ++x)
        {
          image->SetScalarComponentFromDouble(x, y, z, 0, scalar);
        }
      }
    }
    return image;
  }

  /// Hides every so many'th point.
  static vtkSmartPointer<vtkImageData> MakeHidden(int place, vtkIdType each)
  {
    auto image = MakeStep(place);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(image->GetNumberOfPoints());
    ghosts->FillValue(0);
    for (vtkIdType id = 0; id < image->GetNumberOfPoints(); id += each)
    {
      ghosts->SetValue(id, vtkDataSetAttributes::HIDDENPOINT);
    }
    image->GetPointData()->AddArray(ghosts);
    return image;
  }

  std::unique_ptr<Scene> Stage;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Mapper;
  Picture Last;
};

} // namespace

TEST_F(TimeSteps, APartChanges)
{
  for (const int type : {VTK_FLOAT, VTK_UNSIGNED_CHAR, VTK_SHORT})
  {
    SetStormFunctions(this->Stage->GetProperty(), type);
    for (const int place : {3, 10, 21, 30})
    {
      this->ExpectStep(MakeStep(place, 55.0, type), "another place");
    }
  }
}

TEST_F(TimeSteps, TheRangeChanges)
{
  // Doubles are spread over their range: another range changes all texels.
  for (const int type : {VTK_FLOAT, VTK_DOUBLE})
  {
    this->ExpectStep(MakeStep(15, 50.0, type), "a storm");
    this->ExpectStep(MakeStep(15, 75.0, type), "a higher maximum");
    this->ExpectStep(MakeStep(15, 20.0, type), "a lower one");
  }
}

TEST_F(TimeSteps, SizeAndTypeChange)
{
  this->ExpectStep(MakeStep(15), "float");
  this->ExpectStep(MakeStorm(25, VTK_FLOAT), "smaller");
  this->ExpectStep(MakeStep(15), "as before");
  this->ExpectStep(MakeStep(25, 55.0, VTK_DOUBLE), "the texels' type stays");
  this->ExpectStep(MakeStep(5), "and back");
  SetStormFunctions(this->Stage->GetProperty(), VTK_SHORT);
  this->ExpectStep(MakeStep(15, 55.0, VTK_SHORT), "short");
  // As many bytes, another distance from the least value of the type.
  this->ExpectStep(MakeStep(25, 55.0, VTK_UNSIGNED_SHORT), "unsigned short");
}

TEST_F(TimeSteps, PointsHideAndAppear)
{
  this->ExpectStep(MakeStep(15), "all visible");
  this->ExpectStep(MakeHidden(15, 3), "some hidden");
  this->ExpectStep(MakeHidden(15, 5), "others hidden");
  this->ExpectStep(MakeHidden(22, 5), "other scalars, the same hidden");
  this->ExpectStep(MakeStep(22), "all visible again");
}

TEST_F(TimeSteps, ScalarsThatAreNotFinite)
{
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  this->ExpectStep(MakeStep(12), "all finite");
  this->ExpectStep(MakeStep(12, nothing), "a hole");
  this->ExpectStep(MakeStep(17, nothing), "another place");
  this->ExpectStep(MakeStep(17, std::numeric_limits<double>::infinity()), "infinite", false);
  this->ExpectStep(MakeStep(12), "all finite");
}

TEST_F(TimeSteps, InPlaceAndBack)
{
  const auto image = MakeStep(10);
  this->ExpectStep(image, "at first");
  vtkNew<vtkImageData> first;
  first->DeepCopy(image);
  ScalarsOf(image)->DeepCopy(ScalarsOf(MakeStep(20)));
  ScalarsOf(image)->Modified();
  this->ExpectStep(image, "the same array, changed");
  this->ExpectStep(first, "the old values in another array");
  this->ExpectStep(first, "nothing", false);
}

TEST_F(TimeSteps, AnotherArrayAndCells)
{
  const auto image = MakeStep(10);
  vtkSmartPointer<vtkDataArray> second = ScalarsOf(MakeStep(20));
  ScalarsOf(image)->SetName("first");
  second->SetName("second");
  image->GetPointData()->AddArray(second);
  this->Mapper->SetScalarModeToUsePointFieldData();
  for (const char* name : {"first", "second", "first"})
  {
    this->Mapper->SelectScalarArray(name);
    this->ExpectStep(image, name);
  }
  this->Mapper->SetScalarModeToDefault();
  vtkNew<vtkImageData> cells;
  cells->SetOrigin(image->GetOrigin());
  cells->SetSpacing(image->GetSpacing());
  cells->SetDimensions(41, 41, 21);
  cells->GetCellData()->SetScalars(ScalarsOf(MakeStep(25)));
  this->ExpectStep(cells, "scalars of cells, as many");
}

TEST_F(TimeSteps, AnotherWindowKnowsNothing)
{
  this->ExpectStep(MakeStep(10), "first window");
  const auto first = std::exchange(this->Stage, this->MakeStage());
  this->ExpectStep(MakeStep(20), "second window");
  this->Mapper->ReleaseGraphicsResources(this->Stage->GetWindow());
  this->ExpectStep(MakeStep(30), "released");
}

TEST_F(TimeSteps, PreparedAhead)
{
  std::vector<vtkSmartPointer<vtkImageData>> steps;
  vtkSmartPointer<vtkObject> before;
  for (const int place : {4, 9, 14, 19, 24, 29})
  {
    steps.push_back(place == 14 ? MakeHidden(place, 4) : MakeStep(place));
    before = vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(steps.back(), before);
    ASSERT_NE(before, nullptr);
  }
  for (const auto& step : steps)
  {
    this->ExpectStep(step, "in order");
  }
  for (const std::size_t i : {0, 3, 1, 4})
  {
    this->ExpectStep(steps[i], "what was prepared is used up");
  }
}

TEST_F(TimeSteps, PreparedForAnotherOrder)
{
  const auto first = MakeStep(4);
  const auto second = MakeStep(14);
  const auto third = MakeStep(24);
  auto before = vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(first);
  before = vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(second, before);
  vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(third, before);
  this->ExpectStep(first, "as prepared");
  this->ExpectStep(third, "the second left out");
  this->ExpectStep(second, "back");
}

TEST_F(TimeSteps, ChangedAfterItWasPrepared)
{
  const auto first = MakeStep(4);
  const auto second = MakeStep(14);
  const auto before = vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(first);
  vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(second, before);
  this->ExpectStep(first, "as prepared");
  ScalarsOf(second)->DeepCopy(ScalarsOf(MakeStep(28)));
  ScalarsOf(second)->Modified();
  this->ExpectStep(second, "changed meanwhile");
}

TEST_F(TimeSteps, PreparingNothingIsNoError)
{
  vtkNew<vtkImageData> empty;
  EXPECT_EQ(vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(empty), nullptr);
  const auto image = MakeStep(10);
  vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(image, empty); // no answer of it
  this->ExpectStep(image, "prepared after nothing");
}

TEST_F(TimeSteps, UploadedBeforeTheFirstFrame)
{
  const auto image = MakeStep(10);
  this->Mapper->SetInputData(image);
  this->Stage->GetVolume()->SetMapper(this->Mapper);
  EXPECT_TRUE(this->Mapper->PreLoadData(this->Stage->GetRenderer(), this->Stage->GetVolume()));
  this->ExpectStep(image, "uploaded");

  this->Mapper->SetInputData(MakeRod(40000, 8.0));
  EXPECT_FALSE(this->Mapper->PreLoadData(this->Stage->GetRenderer(), this->Stage->GetVolume()));
  EXPECT_NE(this->TakeMessages().find("at most"), std::string::npos);
  this->ExpectStep(MakeStep(20), "after a volume that did not fit");
}
