// SPDX-License-Identifier: BSD-3-Clause
// Codes of one byte beside the values and ghost types that they stand for.
#include "RenderingTest.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkCamera.h"
#include "vtkContourValues.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

namespace
{

using namespace nexrad::testing;

constexpr unsigned char Hidden = vtkDataSetAttributes::HIDDENPOINT;
constexpr unsigned char HiddenCode = 1;
using ValueOfCode = std::function<double(int code)>;

/// Half dBZ from -33 on: code 0 is no echo.
double HalfDecibels(int code)
{
  return 0.5 * code - 33.0;
}

class Codes : public RenderingTest
{
protected:
  void SetUp() override
  {
    RenderingTest::SetUp();
    if (IsSkipped() || HasFatalFailure())
    {
      return;
    }
    this->Stage = std::make_unique<Scene>(240, 180);
    SetStormFunctions(this->Stage->GetProperty(), VTK_FLOAT);
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->SetFocalPoint(0.0, 0.0, 12.0);
    camera->SetPosition(50.0, -90.0, 70.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Stage->GetRenderer()->ResetCameraClippingRange(-80, 80, -80, 80, -80, 80);
  }
  void TearDown() override
  {
    this->Stage.reset();
    RenderingTest::TearDown();
  }

  /// A storm as codes of half dBZ; the quarter in front is hidden. The table gives each code its
  /// value, and flags to the hidden one.
  static vtkSmartPointer<vtkImageData> MakeCodes(const ValueOfCode& valueOf = HalfDecibels)
  {
    constexpr int size = 48;
    const auto storm = MakeStorm(size, VTK_FLOAT);
    const auto* dbz = static_cast<const float*>(storm->GetScalarPointer());
    vtkNew<vtkUnsignedCharArray> codes;
    codes->SetName("REF");
    codes->SetNumberOfTuples(storm->GetNumberOfPoints());
    for (vtkIdType id = 0; id < storm->GetNumberOfPoints(); ++id)
    {
      const bool hidden = id % size < 18 && (id / size) % size < 20;
      const auto code =
        static_cast<unsigned char>(std::lround((static_cast<double>(dbz[id]) + 33.0) / 0.5));
      codes->SetValue(id, hidden ? HiddenCode : code == HiddenCode ? 0 : code);
    }
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->CopyStructure(storm);
    image->GetPointData()->SetScalars(codes);
    SetTable(image, valueOf);
    return image;
  }

  static void SetTable(vtkImageData* image, const ValueOfCode& valueOf)
  {
    vtkNew<vtkFloatArray> values;
    values->SetName("REF_code_values");
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName("REF_code_ghosts");
    for (int code = 0; code < 256; ++code)
    {
      values->InsertNextValue(static_cast<float>(valueOf(code == HiddenCode ? 0 : code)));
      ghosts->InsertNextValue(code == HiddenCode ? Hidden : 0);
    }
    image->GetFieldData()->AddArray(values);
    image->GetFieldData()->AddArray(ghosts);
  }

  /// The values and ghost types that an image of codes stands for.
  static vtkSmartPointer<vtkImageData> MakeValues(vtkImageData* coded)
  {
    auto* codes = vtkUnsignedCharArray::SafeDownCast(coded->GetPointData()->GetScalars());
    vtkDataArray* values = coded->GetFieldData()->GetArray("REF_code_values");
    vtkDataArray* flags = coded->GetFieldData()->GetArray("REF_code_ghosts");
    vtkNew<vtkFloatArray> scalars;
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType id = 0; id < codes->GetNumberOfTuples(); ++id)
    {
      scalars->InsertNextValue(static_cast<float>(values->GetComponent(codes->GetValue(id), 0)));
      ghosts->InsertNextValue(
        static_cast<unsigned char>(flags->GetComponent(codes->GetValue(id), 0)));
    }
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->CopyStructure(coded);
    image->GetPointData()->SetScalars(scalars);
    image->GetPointData()->AddArray(ghosts);
    return image;
  }

  Picture Draw(vtkImageData* image)
  {
    vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
    this->Set(mapper);
    mapper->SetInputData(image);
    return this->Stage->Draw(mapper);
  }

  /// The largest difference of a channel between codes and values, of 255.
  double WorstDifference(vtkImageData* coded, const std::string& name)
  {
    const Picture expected = this->Draw(MakeValues(coded));
    const Picture drawn = this->Draw(coded);
    WritePicture(drawn, name);
    const Difference difference = Compare(drawn, expected, this->Stage->Draw(nullptr));
    EXPECT_GT(difference.Pixels, 3000) << name;
    return difference.Worst;
  }

  void ExpectLikeValues(vtkImageData* coded, const std::string& name)
  {
    EXPECT_AT_MOST(this->WorstDifference(coded, name), 1.0,
      name + ": largest difference to the values, of 255", OneCode);
  }

  std::unique_ptr<Scene> Stage;
  std::function<void(vtkOpenGLTextureSliceVolumeMapper*)> Set = [](auto*) {};
};

} // namespace

// Each way to draw: interpolated between the values that the codes stand for, never across the
// edge of what is hidden.
TEST_F(Codes, AreDrawnAsTheirValues)
{
  const auto coded = MakeCodes();
  vtkVolumeProperty* property = this->Stage->GetProperty();
  this->ExpectLikeValues(coded, "codes");
  property->ShadeOn();
  this->ExpectLikeValues(coded, "codes-shaded");
  property->SetInterpolationTypeToNearest();
  this->ExpectLikeValues(coded, "codes-nearest");
  property->ShadeOff();
  property->SetInterpolationTypeToLinear();
  for (const auto& [mode, name] :
    {std::pair(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, "codes-maximum"),
      {vtkVolumeMapper::ADDITIVE_BLEND, "codes-sum"},
      {vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, "codes-average"}})
  {
    this->Set = [mode = mode](vtkOpenGLTextureSliceVolumeMapper* mapper)
    {
      mapper->SetBlendMode(mode);
      mapper->SetAverageIPScalarRange(-10.0, 80.0);
    };
    this->ExpectLikeValues(coded, name);
  }
}

// The tables that are integrated, and the light that the volume lets through, are of values.
TEST_F(Codes, AreIntegratedAndLitAsTheirValues)
{
  const auto coded = MakeCodes();
  this->Set = [](vtkOpenGLTextureSliceVolumeMapper* mapper) { mapper->PreIntegrationOn(); };
  this->ExpectLikeValues(coded, "codes-integrated");
  const Picture unlit = this->Draw(coded);
  this->Set = [](vtkOpenGLTextureSliceVolumeMapper* mapper)
  {
    mapper->PreIntegrationOn();
    mapper->SetShadowStrength(1.0);
    mapper->SetOcclusionStrength(1.0);
  };
  this->ExpectLikeValues(coded, "codes-shadows");
  EXPECT_AT_LEAST(Compare(this->Draw(coded), unlit, this->Stage->Draw(nullptr)).LargestMean(), 10.0,
    "mean change by shadows, of 255");
}

// The iso-value lies half-way between two codes; a sample may fall on either side of it.
TEST_F(Codes, IsosurfacesAreThoseOfTheValues)
{
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 30.25);
  this->Set = [](vtkOpenGLTextureSliceVolumeMapper* mapper) { mapper->SetBlendModeToIsoSurface(); };
  const auto coded = MakeCodes();
  const Picture expected = this->Draw(MakeValues(coded));
  const Difference difference = Compare(this->Draw(coded), expected, this->Stage->Draw(nullptr));
  EXPECT_GT(difference.Pixels, 500);
  EXPECT_AT_MOST(difference.LargestMean(), 0.1,
    "mean difference of isosurfaces of codes and values, of 255",
    "rounding may put a sample on either side of the surface; 0.05 dBZ further it is 0.19");
}

// No echo is 33 dB below the first code, as with codes of whole dBZ: still bytes.
TEST_F(Codes, NoEchoMayLieAsideOfTheOtherCodes)
{
  const auto coded = MakeCodes([](int code) { return code == 0 ? -33.0 : 0.5 * code - 20.0; });
  this->ExpectLikeValues(coded, "codes-no-echo-aside");
}

// Values that lie on no even steps, and values that fall with the code, are drawn as floats.
TEST_F(Codes, AnyTableIsDrawn)
{
  const auto uneven = MakeCodes([](int code) { return 90.0 * std::pow(code / 200.0, 1.5) - 33.0; });
  EXPECT_EQ(this->WorstDifference(uneven, "codes-uneven"), 0.0);
  const auto falling = MakeCodes([](int code) { return 60.0 - 0.5 * code; });
  this->ExpectLikeValues(falling, "codes-falling");
}

// A code without a number is hidden, as a scalar without one is.
TEST_F(Codes, ACodeWithoutANumberIsHidden)
{
  const auto coded = MakeCodes([](int code)
    { return code == 0 ? std::numeric_limits<double>::quiet_NaN() : HalfDecibels(code); });
  this->ExpectLikeValues(coded, "codes-nan");
}

// The same codes stand for something else: a new table counts as a new volume.
TEST_F(Codes, AChangedTableChangesThePicture)
{
  const auto coded = MakeCodes();
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputData(coded);
  const Picture before = this->Stage->Draw(mapper);
  SetTable(coded, [](int code) { return 0.5 * code - 53.0; });
  coded->Modified();
  const Picture after = this->Stage->Draw(mapper);
  const Picture background = this->Stage->Draw(nullptr);
  EXPECT_AT_LEAST(
    Compare(after, before, background).LargestMean(), 20.0, "mean change by another table, of 255");
  EXPECT_EQ(Compare(after, this->Draw(coded), background).Worst, 0.0);
}

// A volume of codes that follows another one, as in a series: as if it were the first.
TEST_F(Codes, AVolumeThatFollowsIsUploadedWhereItDiffers)
{
  const auto first = MakeCodes();
  const auto second = MakeCodes();
  auto* codes = vtkUnsignedCharArray::SafeDownCast(second->GetPointData()->GetScalars());
  for (vtkIdType id = 0; id < codes->GetNumberOfTuples(); ++id)
  {
    codes->SetValue(id, id % 48 > 36 ? HiddenCode : codes->GetValue(id));
  }
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputData(first);
  const Picture before = this->Stage->Draw(mapper);
  mapper->SetInputData(second);
  const Picture after = this->Stage->Draw(mapper);
  const Picture background = this->Stage->Draw(nullptr);
  EXPECT_EQ(Compare(after, this->Draw(second), background).Worst, 0.0);
  EXPECT_AT_LEAST(
    Compare(after, before, background).Worst, 20.0, "largest change by the next volume, of 255");
}
