// SPDX-License-Identifier: BSD-3-Clause
// IsRenderSupported tells the truth: what it promises is drawn without a message, what it denies is
// refused with one error and leaves the picture alone.
#include "RenderingTest.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkImageCast.h"
#include "vtkImageData.h"
#include "vtkMultiVolume.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <iostream>
#include <memory>
#include <string>

namespace
{

using namespace nexrad::testing;

/// What is asked for beside the blend mode and the components.
enum Feature
{
  Nothing,
  Light,
  GradientOpacity,
  Functions2D,
  BinaryMask,
  Labels,
  SecondArray,
  PartOfTheRange, ///< for an average
  FeatureCount
};

struct Combination
{
  int BlendMode = 0;
  int ScalarType = VTK_UNSIGNED_CHAR;
  int Components = 1;
  bool Independent = true;
  Feature Asked = Nothing;

  std::string Name() const
  {
    return "blend mode " + std::to_string(this->BlendMode) + ", " +
           std::to_string(this->Components) +
           (this->Independent ? " independent " : " dependent ") +
           vtkImageScalarTypeNameMacro(this->ScalarType) + ", feature " +
           std::to_string(this->Asked);
  }
};

class RenderSupport : public RenderingTest
{
protected:
  void SetUp() override
  {
    RenderingTest::SetUp();
    if (!IsSkipped() && !HasFatalFailure())
    {
      this->Stage = std::make_unique<Scene>(16, 16);
      vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
      camera->ParallelProjectionOn();
      camera->SetFocalPoint(1.5, 1.5, 1.5);
      camera->SetPosition(1.5, 1.5, 9.0);
      camera->SetParallelScale(2.0);
      camera->SetClippingRange(1.0, 20.0);
      this->Background = this->Stage->Draw(nullptr);
    }
  }
  void TearDown() override
  {
    this->Stage.reset();
    RenderingTest::TearDown();
  }

  /// 4 x 4 x 4 points, scalars from 10 to 200 in every component.
  static vtkSmartPointer<vtkImageData> MakeImage(int scalarType, int components)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(4, 4, 4);
    image->AllocateScalars(scalarType, components);
    vtkDataArray* scalars = image->GetPointData()->GetScalars();
    for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
    {
      for (int c = 0; c < components; ++c)
      {
        scalars->SetComponent(id, c, 10.0 + 190.0 * double(id) / 63.0);
      }
    }
    auto another = vtkSmartPointer<vtkDataArray>::Take(scalars->NewInstance());
    another->DeepCopy(scalars);
    another->SetName("another");
    image->GetPointData()->AddArray(another);
    return image;
  }

  /// White and half opaque, whatever the scalar.
  static vtkSmartPointer<vtkVolumeProperty> MakeProperty(const Combination& combination)
  {
    auto property = vtkSmartPointer<vtkVolumeProperty>::New();
    property->SetIndependentComponents(combination.Independent);
    property->SetInterpolationTypeToLinear();
    for (int c = 0; c < 4; ++c)
    {
      vtkNew<vtkColorTransferFunction> color;
      color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.0, 0.5);
      property->SetColor(c, color);
      property->SetScalarOpacity(c, opacity);
      property->SetShade(c, combination.Asked == Light);
      if (combination.Asked == GradientOpacity)
      {
        property->SetGradientOpacity(c, opacity);
      }
    }
    property->GetIsoSurfaceValues()->SetValue(0, 100.0);
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(1.5, 1.5, 1.5);
    property->SetSliceFunction(plane);
    return property;
  }

  static void Add2D(vtkVolumeProperty* property)
  {
    vtkNew<vtkImageData> table;
    table->SetDimensions(8, 8, 1);
    table->AllocateScalars(VTK_FLOAT, 4);
    table->GetPointData()->GetScalars()->Fill(0.5);
    for (int c = 0; c < 4; ++c)
    {
      property->SetTransferFunction2D(c, table);
    }
    property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  }

  static void AddMask(vtkGPUVolumeRayCastMapper* mapper, vtkVolumeProperty* property, bool labels)
  {
    vtkSmartPointer<vtkImageData> mask = MakeImage(VTK_UNSIGNED_CHAR, 1);
    mask->GetPointData()->GetScalars()->Fill(labels ? 1.0 : 255.0);
    mapper->SetMaskInput(mask);
    labels ? mapper->SetMaskTypeToLabelMap() : mapper->SetMaskTypeToBinary();
    property->SetLabelColor(1, property->GetRGBTransferFunction());
    property->SetLabelScalarOpacity(1, property->GetScalarOpacity());
  }

  static void Ask(
    Feature feature, vtkOpenGLTextureSliceVolumeMapper* mapper, vtkVolumeProperty* property)
  {
    switch (feature)
    {
    case Functions2D:
      Add2D(property);
      break;
    case BinaryMask:
    case Labels:
      AddMask(mapper, property, feature == Labels);
      break;
    case SecondArray:
      Add2D(property);
      mapper->SetTransfer2DYAxisArray("another");
      break;
    case PartOfTheRange:
      mapper->SetAverageIPScalarRange(50.0, 150.0);
      break;
    default:
      break;
    }
  }

  /// @return whether it is supported
  bool ExpectTruth(const Combination& combination)
  {
    vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
    mapper->SetNumberOfSlices(8);
    mapper->SetInputData(MakeImage(combination.ScalarType, combination.Components));
    mapper->SetBlendMode(combination.BlendMode);
    const auto property = MakeProperty(combination);
    Ask(combination.Asked, mapper, property);
    this->Stage->GetVolume()->SetProperty(property);
    const bool promised = mapper->IsRenderSupported(this->Stage->GetWindow(), property) != 0;
    this->ExpectPicture(promised, mapper, combination.Name());
    return promised;
  }

  void ExpectPicture(bool promised, vtkVolumeMapper* mapper, const std::string& name)
  {
    const Picture picture = this->Stage->Draw(mapper);
    const std::string messages = this->TakeMessages();
    const int changed = Compare(picture, this->Background, this->Background).Pixels;
    if (promised)
    {
      EXPECT_EQ(messages, "") << name << " is promised";
      EXPECT_AT_LEAST(changed, 80, "pixels drawn") << name << " is promised";
    }
    else
    {
      const std::size_t first = messages.find("ERROR:");
      EXPECT_NE(first, std::string::npos) << name << " is denied";
      EXPECT_EQ(messages.find("ERROR:", first + 1), std::string::npos) << name << messages;
      EXPECT_EQ(changed, 0) << name << " is denied";
    }
  }

  std::unique_ptr<Scene> Stage;
  Picture Background;
};

} // namespace

TEST_F(RenderSupport, IsWhatDrawingDoes)
{
  int promised = 0;
  int denied = 0;
  for (int mode = vtkVolumeMapper::COMPOSITE_BLEND; mode <= vtkVolumeMapper::SLICE_BLEND; ++mode)
  {
    for (int components = 1; components <= 5; ++components)
    {
      for (const bool independent : {true, false})
      {
        for (int feature = Nothing; feature < FeatureCount; ++feature)
        {
          const bool yes = this->ExpectTruth(
            {mode, VTK_UNSIGNED_CHAR, components, independent, static_cast<Feature>(feature)});
          yes ? ++promised : ++denied;
        }
        const bool yes = this->ExpectTruth({mode, VTK_FLOAT, components, independent, Nothing});
        yes ? ++promised : ++denied;
      }
    }
  }
  std::cout << promised << " combinations promised and drawn, " << denied
            << " denied and refused\n";
  EXPECT_AT_LEAST(promised, 150, "combinations promised");
  EXPECT_AT_LEAST(denied, 250, "combinations denied");
}

// Two volumes in one mapper.
TEST_F(RenderSupport, KnowsTheInputs)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputDataObject(0, MakeImage(VTK_FLOAT, 1));
  mapper->SetInputDataObject(1, MakeImage(VTK_FLOAT, 1));
  const auto property = MakeProperty({});
  this->Stage->GetVolume()->SetProperty(property);
  EXPECT_FALSE(mapper->IsRenderSupported(this->Stage->GetWindow(), property));
  this->ExpectPicture(false, mapper, "two inputs");
  this->Stage->Draw(mapper);
  EXPECT_EQ(this->TakeMessages(), "") << "a refusal is said once";
}

// A prop of several volumes, which VTK hands to one mapper.
TEST_F(RenderSupport, RefusesAVolumeOfVolumesOnce)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  vtkNew<vtkMultiVolume> both;
  both->SetMapper(mapper);
  std::array<vtkNew<vtkVolume>, 2> volumes;
  for (int port = 0; port < 2; ++port)
  {
    mapper->SetInputDataObject(port, MakeImage(VTK_FLOAT, 1));
    volumes[static_cast<std::size_t>(port)]->SetProperty(MakeProperty({}));
    both->SetVolume(volumes[static_cast<std::size_t>(port)], port);
  }
  this->Stage->GetRenderer()->AddVolume(both);
  this->Stage->Draw(nullptr);
  EXPECT_NE(this->TakeMessages().find("give each a mapper of its own"), std::string::npos);
  this->Stage->Draw(nullptr);
  EXPECT_EQ(this->TakeMessages(), "");
  this->Stage->GetRenderer()->RemoveVolume(both);
}

// An image of one layer; an image and a grid larger than any texture.
TEST_F(RenderSupport, KnowsTheDimensions)
{
  for (const auto& [x, z] : {std::pair(9, 1), std::pair(40000, 2)})
  {
    const bool promised = z > 1;
    vtkNew<vtkImageData> image;
    image->SetDimensions(x, 2, z);
    image->SetSpacing(1.0, 3.0, 1.0);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    image->GetPointData()->GetScalars()->Fill(1.0);
    vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
    mapper->SetInputData(image);
    const auto property = MakeProperty({});
    this->Stage->GetVolume()->SetProperty(property);
    EXPECT_EQ(mapper->IsRenderSupported(this->Stage->GetWindow(), property) != 0, promised);
    this->ExpectPicture(promised, mapper, std::to_string(x) + " x 2 x " + std::to_string(z));
  }
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputData(MakeRod(40000, 3.0));
  const auto property = MakeProperty({});
  this->Stage->GetVolume()->SetProperty(property);
  EXPECT_FALSE(mapper->IsRenderSupported(this->Stage->GetWindow(), property));
  this->ExpectPicture(false, mapper, "a grid of 40000 x 2 x 2");
}

// A program may ask before the pipeline has run; dimensions and components are not known yet.
TEST_F(RenderSupport, SaysYesBeforeTheSourceHasRun)
{
  vtkNew<vtkImageCast> source;
  source->SetInputData(MakeImage(VTK_FLOAT, 4));
  source->SetOutputScalarTypeToUnsignedChar();
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  Combination colours;
  colours.Independent = false;
  const auto property = MakeProperty(colours);
  this->Stage->GetVolume()->SetProperty(property);
  EXPECT_TRUE(mapper->IsRenderSupported(this->Stage->GetWindow(), property));
  this->ExpectPicture(true, mapper, "a source that had not run");
}

// What is refused or ignored is said once, and again when it comes back.
TEST_F(RenderSupport, SaysOnceWhatIsLeftOut)
{
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputData(MakeImage(VTK_FLOAT, 1));
  const auto property = MakeProperty({});
  this->Stage->GetVolume()->SetProperty(property);
  const auto count = [&](const char* word)
  {
    for (int frame = 0; frame < 3; ++frame)
    {
      this->Stage->Draw(mapper);
    }
    const std::string messages = this->TakeMessages();
    int found = 0;
    for (std::size_t at = messages.find(word); at != std::string::npos;
         at = messages.find(word, at + 1))
    {
      ++found;
    }
    return found;
  };
  EXPECT_EQ(count("only VTK's ray caster knows"), 0);
  auto* shaders = this->Stage->GetVolume()->GetShaderProperty();
  shaders->AddFragmentShaderReplacement("//VTK::Base::Init", true, "", false);
  EXPECT_EQ(count("without the code of its shader property"), 1);
  shaders->ClearAllFragmentShaderReplacements();
  property->SetSliceFunction(nullptr);
  for (int round = 0; round < 2; ++round)
  {
    mapper->SetBlendMode(vtkVolumeMapper::SLICE_BLEND);
    EXPECT_EQ(count("slice blending needs a vtkPlane"), 1);
    mapper->SetBlendModeToComposite();
    EXPECT_EQ(count("ERROR"), 0);
  }
}
