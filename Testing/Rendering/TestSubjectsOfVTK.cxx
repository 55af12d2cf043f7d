// SPDX-License-Identifier: BSD-3-Clause
// Subjects of VTK's own tests of its GPU ray caster that no other file here has, on synthetic
// volumes.
#include "RayCasterComparison.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkSphereSource.h"
#include "vtkTextureSliceObjectFactory.h"
#include "vtkTransform.h"
#include "vtkVersionMacros.h"
#include "vtkVolume.h"
#include "vtkVolumePicker.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <iostream>

namespace
{

using namespace nexrad::testing;

/// While it lives, VTK makes slices where a program asks for a vtkGPUVolumeRayCastMapper.
class SlicesFromFactory
{
public:
  SlicesFromFactory() { vtkTextureSliceObjectFactory::Activate(); }
  ~SlicesFromFactory() { vtkTextureSliceObjectFactory::Deactivate(); }
  SlicesFromFactory(const SlicesFromFactory&) = delete;
  SlicesFromFactory& operator=(const SlicesFromFactory&) = delete;
};

class SubjectsOfVTK : public StormAgainstRayCaster
{
protected:
  /// From within the storm, towards the tall tower, lengths being multiplied by that scale.
  void AimFromInside(double scale = 1.0)
  {
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->SetPosition(4.0 * scale, 2.0 * scale, 4.0 * scale);
    camera->SetFocalPoint(-10.0 * scale, -6.0 * scale, 8.0 * scale);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(60.0);
    camera->SetClippingRange(0.5 * scale, 200.0 * scale);
  }

  /// A storm as high in points as it is wide, where the ray caster's cuts can be corrected.
  void UseTallStorm()
  {
    this->Input = MakeStorm(48, VTK_FLOAT, 48);
    SetStormFunctions(this->Stage->GetProperty(), VTK_FLOAT);
  }

  /// A plane given in data coordinates, moved with the volume by that matrix.
  static vtkSmartPointer<vtkPlane> MakePlane(
    const std::array<double, 3>& origin, const std::array<double, 3>& normal, vtkTransform* move)
  {
    auto plane = vtkSmartPointer<vtkPlane>::New();
    std::array<double, 3> point{};
    move->TransformPoint(origin.data(), point.data());
    std::array<double, 3> direction{};
    move->TransformNormal(normal.data(), direction.data());
    plane->SetOrigin(point.data());
    plane->SetNormal(direction.data());
    return plane;
  }

  /// Cuts both pictures by that plane of data coordinates; the ray caster's is displaced.
  vtkSmartPointer<vtkPlane> Clip(
    const std::array<double, 3>& origin, const std::array<double, 3>& normal, vtkTransform* move)
  {
    const std::array<double, 3> displaced{this->RayCasterCut(origin[0], 0),
      this->RayCasterCut(origin[1], 1), this->RayCasterCut(origin[2], 2)};
    this->RayCaster->AddClippingPlane(MakePlane(displaced, normal, move));
    auto plane = MakePlane(origin, normal, move);
    this->Slices->AddClippingPlane(plane);
    return plane;
  }

  void AddActor(vtkAlgorithmOutput* source, vtkPlane* clip)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source);
    if (clip != nullptr)
    {
      mapper->AddClippingPlane(clip);
    }
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    this->Stage->GetRenderer()->AddActor(actor);
  }

  /// As many components, that many times the storm's scalar turned about the axis by quarters.
  void UseComponents(int count, int scalarType)
  {
    vtkSmartPointer<vtkImageData> storm = MakeStorm(48, VTK_UNSIGNED_CHAR);
    this->Input = vtkSmartPointer<vtkImageData>::New();
    this->Input->CopyStructure(storm);
    this->Input->AllocateScalars(scalarType, count);
    vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
    vtkDataArray* values = storm->GetPointData()->GetScalars();
    for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
    {
      const vtkIdType i = id % 48;
      const vtkIdType j = id / 48 % 48;
      const vtkIdType layer = id - id % (48 * 48);
      const std::array<vtkIdType, 4> from{
        i + 48 * j, (47 - j) + 48 * i, (47 - i) + 48 * (47 - j), j + 48 * (47 - i)};
      for (int c = 0; c < count; ++c)
      {
        scalars->SetComponent(
          id, c, values->GetComponent(layer + from[static_cast<std::size_t>(c)], 0));
      }
    }
  }

  /// One colour for each component, as opaque as the scalar is large.
  void UseComponentFunctions(int count, double most)
  {
    const std::array<Color, 4> colors{
      {{1.0, 0.2, 0.1}, {0.1, 1.0, 0.2}, {0.2, 0.3, 1.0}, {1.0, 0.9, 0.2}}};
    for (int c = 0; c < count; ++c)
    {
      const Color& own = colors[static_cast<std::size_t>(c)];
      vtkNew<vtkColorTransferFunction> color;
      color->AddRGBPoint(0.0, 0.2 * own[0], 0.2 * own[1], 0.2 * own[2]);
      color->AddRGBPoint(100.0, own[0], own[1], own[2]);
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.0, 0.0);
      opacity->AddPoint(100.0, most);
      this->Stage->GetProperty()->SetColor(c, color);
      this->Stage->GetProperty()->SetScalarOpacity(c, opacity);
    }
  }

  void Use(vtkVolumeMapper::BlendModes mode)
  {
    this->ForBoth([mode](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendMode(mode); });
  }

  /// A label map of four stripes from west to east.
  void UseLabelStripes(const std::array<unsigned char, 4>& labels)
  {
    auto mask = vtkSmartPointer<vtkImageData>::New();
    mask->CopyStructure(this->Input);
    mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    auto* label = static_cast<unsigned char*>(mask->GetScalarPointer());
    for (vtkIdType id = 0; id < mask->GetNumberOfPoints(); ++id)
    {
      label[id] = labels[static_cast<std::size_t>(id % 48 / 12)];
    }
    this->ForBoth(
      [&](vtkGPUVolumeRayCastMapper* mapper)
      {
        mapper->SetMaskInput(mask);
        mapper->SetMaskTypeToLabelMap();
      });
  }

  /// Draws what make() gives, once with VTK's factories as they are and once with slices.
  void ExpectSameFromFactory(const std::string& name,
    const std::function<vtkSmartPointer<vtkVolumeMapper>()>& make, double tolerance)
  {
    const Picture background = this->Stage->Draw(nullptr);
    const auto rays = make();
    const Picture expected = this->Stage->Draw(rays);
    Picture actual;
    {
      const SlicesFromFactory factory;
      const auto slices = make();
      actual = this->Stage->Draw(slices);
    }
    const Difference difference = Compare(actual, expected, background);
    WritePicture(expected, name + "-rays");
    WritePicture(actual, name + "-slices");
    std::cout << name << ": mean difference " << difference.Mean[0] << ' ' << difference.Mean[1]
              << ' ' << difference.Mean[2] << " of 255, worst " << difference.Worst << ", over "
              << difference.Pixels << " pixels\n";
    EXPECT_GT(difference.Pixels, 3000);
    EXPECT_GT(difference.Worst, 0.0) << "both were drawn by the same mapper";
    EXPECT_AT_MOST(difference.LargestMean(), Allowed(tolerance),
      name + ": mean difference to the ray caster, of 255");
  }

  vtkSmartPointer<vtkSmartVolumeMapper> MakeSmart()
  {
    auto smart = vtkSmartPointer<vtkSmartVolumeMapper>::New();
    smart->SetInputData(this->Input);
    smart->SetRequestedRenderModeToGPU();
    smart->SetAutoAdjustSampleDistances(0);
    smart->SetInteractiveAdjustSampleDistances(0);
    smart->SetSampleDistance(static_cast<float>(this->SampleDistance));
    return smart;
  }
};

} // namespace

// From within the storm, cut open before the viewer.
TEST_F(SubjectsOfVTK, CameraInsideClipping)
{
  this->UseTallStorm();
  this->AimFromInside();
  vtkNew<vtkTransform> nothing;
  this->Clip({-4.0, -2.0, 6.0}, {-0.8, -0.5, 0.2}, nothing);
  this->ExpectSamePicture("subject-inside-clipping", Bar);
}

// Spacings of a thousandth: nothing may depend on lengths as such.
TEST_F(SubjectsOfVTK, CameraInsideSmallSpacing)
{
  constexpr double scale = 1e-3;
  const double* spacing = this->Input->GetSpacing();
  const double* origin = this->Input->GetOrigin();
  this->Input->SetSpacing(scale * spacing[0], scale * spacing[1], scale * spacing[2]);
  this->Input->SetOrigin(scale * origin[0], scale * origin[1], scale * origin[2]);
  this->Stage->GetProperty()->SetScalarOpacityUnitDistance(scale);
  this->SampleDistance *= scale;
  this->AimFromInside(scale);
  this->ExpectSamePicture("subject-inside-small-spacing", Bar);
}

// The camera within a volume that is turned, stretched and moved.
TEST_F(SubjectsOfVTK, CameraInsideTransformation)
{
  vtkNew<vtkTransform> move;
  move->Translate(3.0, -2.0, 1.0);
  move->RotateZ(40.0);
  move->RotateX(15.0);
  move->Scale(1.4, 0.7, 1.1);
  this->Stage->GetVolume()->SetUserTransform(move);
  this->AimFromInside();
  this->ExpectSamePicture("subject-inside-transformation", Bar);
}

// One plane through the storm and through a white ball in it.
TEST_F(SubjectsOfVTK, ClippingPolyData)
{
  this->UseTallStorm();
  vtkNew<vtkTransform> nothing;
  const auto plane = this->Clip({-8.0, -6.0, 0.0}, {-0.6, 0.8, 0.0}, nothing);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(-8.0, -6.0, 10.0);
  sphere->SetRadius(6.0);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  this->AddActor(sphere->GetOutputPort(), plane);
  this->ExpectSamePicture("subject-clipping-polydata", Bar);
}

// The volume is moved by a user's transform; the planes are the world's.
TEST_F(SubjectsOfVTK, ClippingUserTransform)
{
  this->UseTallStorm();
  vtkNew<vtkTransform> move;
  move->Translate(-4.0, 6.0, 0.0);
  move->RotateZ(30.0);
  this->Stage->GetVolume()->SetUserTransform(move);
  this->Clip({-6.0, -6.0, 0.0}, {-0.6, 0.8, 0.0}, move);
  this->Clip({0.0, 0.0, 4.0}, {0.0, 0.0, 1.0}, move);
  this->ExpectSamePicture("subject-clipping-transform", 1.3);
}

// A lit volume, cut: the cut face is lit by the gradient too.
TEST_F(SubjectsOfVTK, ShadedClipping)
{
  this->UseTallStorm();
  this->Stage->GetProperty()->ShadeOn();
  vtkNew<vtkTransform> nothing;
  this->Clip({-6.0, -6.0, 0.0}, {-0.6, 0.8, 0.0}, nothing);
  this->ExpectSamePicture("subject-shaded-clipping", 0.65);
}

// Some programs make each clipped surface one of its own, for gradients that end there.
TEST_F(SubjectsOfVTK, ShadedClippingWithClippedVoxelIntensity)
{
  this->UseTallStorm();
  this->Stage->GetProperty()->ShadeOn();
  vtkNew<vtkTransform> nothing;
  this->Clip({-6.0, -6.0, 0.0}, {-0.6, 0.8, 0.0}, nothing);
  const Picture without = this->Stage->Draw(this->Configure(this->Slices));
  this->Stage->GetProperty()->UseClippedVoxelIntensityOn();
  this->Stage->GetProperty()->SetClippedVoxelIntensity(-30.0);
  const Picture with = this->ExpectSamePicture("subject-clipped-voxel-intensity", 0.9);
  EXPECT_AT_LEAST(Compare(without, with, this->Stage->Draw(nullptr)).LargestMean(), 0.5,
    "what the intensity changes, of 255");
}

// Each of the 27 regions alone, in a fog that shows all of the box.
TEST_F(SubjectsOfVTK, EveryCroppingRegion)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.03);
  opacity->AddPoint(60.0, 0.3);
  this->Stage->GetProperty()->SetScalarOpacity(opacity);
  this->SampleDistance = 0.2;
  const Picture background = this->Stage->Draw(nullptr);
  double worst = 0.0;
  for (int region = 0; region < 27; ++region)
  {
    this->Crop({-12.0, 8.0, -10.0, 10.0, 7.0, 15.0}, 1 << region);
    const Picture expected = this->Stage->Draw(this->Configure(this->RayCaster));
    const Picture actual = this->Stage->Draw(this->Configure(this->Slices));
    const Difference difference = Compare(actual, expected, background);
    EXPECT_GT(difference.Pixels, 200) << "region " << region;
    EXPECT_AT_MOST(difference.LargestMean(), Bar, "mean difference to the ray caster, of 255")
      << "region " << region;
    worst = std::max(worst, difference.LargestMean());
  }
  std::cout << "27 regions: largest mean difference " << worst << " of 255\n";
}

// One mapper that changes its mind between frames.
TEST_F(SubjectsOfVTK, CompositeToMaximumAndBack)
{
  const Picture first = this->ExpectSamePicture("subject-composite-before", 0.2);
  this->Use(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
  this->ExpectSamePicture("subject-maximum-after", 0.058);
  this->Use(vtkVolumeMapper::COMPOSITE_BLEND);
  const Picture again = this->ExpectSamePicture("subject-composite-again", 0.2);
  EXPECT_EQ(Compare(again, first, first).Pixels, 0);
}

// Each kind of texel, interpolated and not, its extremes projected. ScalarTypes has all types.
TEST_F(SubjectsOfVTK, DataTypes)
{
  for (const int type :
    {VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_FLOAT})
  {
    this->UseStorm(type, 24);
    const bool isBytes = type == VTK_SIGNED_CHAR || type == VTK_UNSIGNED_CHAR;
    const bool isSigned = type == VTK_SIGNED_CHAR;
    const std::string name = std::string("subject-") + vtkImageScalarTypeNameMacro(type);
    this->Use(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
    this->ExpectSamePicture(name + "-maximum", isBytes ? (isSigned ? 0.52 : 0.39) : 0.073);
    this->Stage->GetProperty()->SetInterpolationTypeToNearest();
    this->ExpectSamePicture(name + "-maximum-nearest", isBytes ? (isSigned ? 1.3 : 0.57) : 0.25);
    this->Stage->GetProperty()->SetInterpolationTypeToLinear();
    vtkNew<vtkPiecewiseFunction> opacity; // the least scalar is visible too
    opacity->AddPoint(-40.0, 0.3);
    opacity->AddPoint(100.0, 1.0);
    this->Stage->GetProperty()->SetScalarOpacity(opacity);
    this->Use(vtkVolumeMapper::MINIMUM_INTENSITY_BLEND);
    this->ExpectSamePicture(name + "-minimum", 0.62);
  }
}

// Sums and means of three and of four components.
TEST_F(SubjectsOfVTK, SumsAndMeansOfSeveralComponents)
{
  for (const int count : {3, 4})
  {
    const std::string name = "subject-" + std::to_string(count);
    this->UseComponents(count, VTK_UNSIGNED_CHAR);
    this->UseComponentFunctions(count, 0.02);
    this->Use(vtkVolumeMapper::ADDITIVE_BLEND);
    this->ExpectSamePicture(name + "-additive", 0.55);
    this->UseComponentFunctions(count, 1.0);
    this->Use(vtkVolumeMapper::AVERAGE_INTENSITY_BLEND);
    this->ExpectSamePicture(name + "-average", 1.3, 20.0);
  }
}

// Red, green, blue and opacity: sum and mean of the red by the opacity.
TEST_F(SubjectsOfVTK, SumsAndMeansOfColours)
{
  this->UseComponents(4, VTK_UNSIGNED_CHAR);
  // VTK 9.1 looks the opacity up as if the fourth component spanned all bytes.
  this->Input->GetPointData()->GetScalars()->SetComponent(0, 3, 0.0);
  this->Input->GetPointData()->GetScalars()->SetComponent(1, 3, 255.0);
  this->Stage->GetProperty()->IndependentComponentsOff();
  this->UseComponentFunctions(1, 0.3);
  this->Use(vtkVolumeMapper::ADDITIVE_BLEND);
  this->ExpectSamePicture("subject-rgba-additive", 0.42, 20.0);
  this->UseComponentFunctions(1, 1.0);
  this->Use(vtkVolumeMapper::AVERAGE_INTENSITY_BLEND);
  this->ExpectSamePicture("subject-rgba-average", 0.06, 5.0);
}

// The brightest of each of four components.
TEST_F(SubjectsOfVTK, MaximumOfFourComponents)
{
  this->UseComponents(4, VTK_UNSIGNED_CHAR);
  this->UseComponentFunctions(4, 1.0);
  for (int c = 0; c < 4; ++c)
  {
    this->Stage->GetProperty()->SetComponentWeight(c, 0.25);
  }
  this->Use(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
  this->ExpectSamePicture("subject-4-maximum", 0.57, 20.0);
}

// The least of each of four components is the largest of what is left to 100. (VTK 9.1's ray caster
// writes the opacity of the minimum of several components into the blue channel.)
TEST_F(SubjectsOfVTK, MinimumOfFourComponents)
{
  const Picture background = this->Stage->Draw(nullptr);
  const auto draw = [&](vtkVolumeMapper::BlendModes mode, bool inverted)
  {
    this->UseComponents(4, VTK_UNSIGNED_CHAR);
    this->UseComponentFunctions(4, 1.0);
    vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
    for (int c = 0; c < 4; ++c)
    {
      this->Stage->GetProperty()->SetComponentWeight(c, 0.25);
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(inverted ? 100.0 : 0.0, 1.0);
      opacity->AddPoint(inverted ? 60.0 : 40.0, 0.2);
      this->Stage->GetProperty()->SetScalarOpacity(c, opacity);
      vtkNew<vtkColorTransferFunction> color;
      color->AddRGBPoint(inverted ? 100.0 : 0.0, 0.1, 0.2 * c, 0.9);
      color->AddRGBPoint(inverted ? 0.0 : 100.0, 1.0, 0.2 * c, 0.1);
      this->Stage->GetProperty()->SetColor(c, color);
      for (vtkIdType id = 0; inverted && id < scalars->GetNumberOfTuples(); ++id)
      {
        scalars->SetComponent(id, c, 100.0 - scalars->GetComponent(id, c));
      }
    }
    this->Slices->SetBlendMode(mode);
    return this->Stage->Draw(this->Configure(this->Slices));
  };
  const Picture least = draw(vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, false);
  const Picture most = draw(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, true);
  const Difference difference = Compare(least, most, background);
  EXPECT_GT(difference.Pixels, 4000);
  EXPECT_AT_MOST(difference.LargestMean(), 0.1,
    "four components: mean difference of the minimum to the maximum of the inverse, of 255",
    OneCode);
}

// A colour function of 4000 points: saw-teeth of red over the storm's range.
TEST_F(SubjectsOfVTK, LargeColorTransferFunction)
{
  vtkNew<vtkColorTransferFunction> color;
  for (int i = 0; i <= 4000; ++i)
  {
    const double dBZ = -33.0 + 100.0 * i / 4000.0;
    color->AddRGBPoint(dBZ, (i % 400) / 400.0, 0.3, 1.0 - i / 4000.0);
  }
  this->Stage->GetProperty()->SetColor(color);
  this->ExpectSamePicture("subject-large-function", 1.3);
}

// Three layers, seen at a slant, with an opaque square through the middle one.
TEST_F(SubjectsOfVTK, SlabWithASquare)
{
  this->Input = MakeStorm(48, VTK_FLOAT, 3);
  vtkNew<vtkPlaneSource> square;
  square->SetOrigin(-40.0, -10.0, 12.0);
  square->SetPoint1(40.0, -10.0, 12.0);
  square->SetPoint2(-40.0, 40.0, 12.0);
  this->AddActor(square->GetOutputPort(), nullptr);
  this->ExpectSamePicture("subject-slab", Bar);
}

// Another array becomes the scalars, and another one is chosen by name.
TEST_F(SubjectsOfVTK, ChangedArray)
{
  const Picture storm = this->ExpectSamePicture("subject-array-first", 0.2);
  vtkSmartPointer<vtkImageData> other = MakeStorm(48, VTK_FLOAT);
  vtkDataArray* halved = other->GetPointData()->GetScalars();
  halved->SetName("halved");
  for (vtkIdType id = 0; id < halved->GetNumberOfTuples(); ++id)
  {
    halved->SetComponent(id, 0, 0.5 * halved->GetComponent(id, 0));
  }
  this->Input->GetPointData()->GetScalars()->SetName("storm");
  this->Input->GetPointData()->AddArray(halved);
  this->Input->GetPointData()->SetActiveScalars("halved");
  const Picture weak = this->ExpectSamePicture("subject-array-halved", 0.045);
  EXPECT_AT_LEAST(
    Compare(weak, storm, weak).LargestMean(), 15.0, "mean change by another array, of 255");
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper)
    {
      mapper->SetScalarModeToUsePointFieldData();
      mapper->SelectScalarArray("storm");
    });
  const Picture again = this->ExpectSamePicture("subject-array-chosen", 0.2);
  EXPECT_EQ(Compare(again, storm, storm).Pixels, 0);
}

// A label between those that have functions is as if there were none, as in VTK 9.1. (VTK 9.3 gives
// it the functions of the next label.)
TEST_F(SubjectsOfVTK, LabelsWithoutFunctions)
{
  this->Stage->GetProperty()->SetScalarOpacityUnitDistance(this->SampleDistance);
  for (const int known : {1, 3})
  {
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, known == 1 ? 1.0 : 0.1, 0.3, known == 1 ? 0.1 : 1.0);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(5.0, 0.0);
    opacity->AddPoint(60.0, 0.2);
    this->Stage->GetProperty()->SetLabelColor(known, color);
    this->Stage->GetProperty()->SetLabelScalarOpacity(known, opacity);
  }
  this->UseLabelStripes({0, 1, 0, 3});
  const Picture expected = this->Stage->Draw(this->Configure(this->Slices));
  this->UseLabelStripes({0, 1, 2, 3});
  const Picture actual = this->Stage->Draw(this->Slices);
  EXPECT_EQ(Compare(actual, expected, expected).Pixels, 0);
#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION == 1
  this->ExpectSamePicture("subject-labels-unknown", 0.71);
#endif
}

// What slices have no use for is accepted and changes nothing.
TEST_F(SubjectsOfVTK, JitteringChangesNothing)
{
  const Picture before = this->Stage->Draw(this->Configure(this->Slices));
  this->Slices->UseJitteringOn();
  const Picture after = this->Stage->Draw(this->Slices);
  EXPECT_EQ(Compare(after, before, before).Pixels, 0);
}

// The volume is taken out of one window while another one is current.
TEST_F(SubjectsOfVTK, RemoveVolumeWhileAnotherWindowIsCurrent)
{
  this->Stage->Draw(this->Configure(this->Slices));
  Scene other(PictureSize, PictureSize);
  SetStormFunctions(other.GetProperty(), VTK_FLOAT);
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> mapper;
  mapper->SetInputData(this->Input);
  other.GetRenderer()->ResetCamera(this->Input->GetBounds());
  const Picture before = other.Draw(mapper);
  const auto held = CountOpenGLObjects();
  this->Stage->GetRenderer()->RemoveVolume(this->Stage->GetVolume());
  other.GetWindow()->MakeCurrent();
  EXPECT_EQ(CountOpenGLObjects(), held) << "the other window's objects were deleted";
  const Picture after = other.Draw(mapper);
  EXPECT_EQ(Compare(after, before, before).Pixels, 0);
  EXPECT_AT_LEAST(Compare(after, other.Draw(nullptr), after).Worst, 110.0,
    "largest change without the volume, of 255");
}

// One volume in two windows is taken out of the one that drew it first: the other keeps all of it.
TEST_F(SubjectsOfVTK, RemoveVolumeThatAnotherWindowDrewLast)
{
  vtkVolume* volume = this->Stage->GetVolume();
  this->Stage->Draw(this->Configure(this->Slices));
  vtkNew<vtkRenderer> renderer;
  renderer->SetActiveCamera(this->Stage->GetRenderer()->GetActiveCamera());
  renderer->AddVolume(volume);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(PictureSize, PictureSize);
  window->SetMultiSamples(0);
  window->OffScreenRenderingOn();
  window->AddRenderer(renderer);
  window->Render();
  const auto held = CountOpenGLObjects();
  this->Stage->GetWindow()->MakeCurrent();
  this->Stage->GetRenderer()->RemoveVolume(volume);
  window->MakeCurrent();
  EXPECT_EQ(CountOpenGLObjects(), held);
}

// The volume in a layer of its own over a layer with a ball: no depth is shared, so the ball hides
// nothing.
TEST_F(SubjectsOfVTK, RenderersInLayers)
{
  vtkRenderer* front = this->Stage->GetRenderer();
  vtkNew<vtkRenderer> back;
  this->Stage->GetWindow()->SetNumberOfLayers(2);
  this->Stage->GetWindow()->AddRenderer(back);
  front->SetLayer(1);
  back->SetActiveCamera(front->GetActiveCamera());
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(10.0, -40.0, 16.0);
  sphere->SetRadius(9.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  back->AddActor(actor);
  this->ExpectSamePicture("subject-layers", 0.21);
}

// VTK's picker finds the same place on the tall tower whichever mapper draws it.
TEST_F(SubjectsOfVTK, VolumePicker)
{
  const auto pick = [&](vtkVolumeMapper* mapper)
  {
    this->Stage->Draw(mapper);
    vtkRenderer* renderer = this->Stage->GetRenderer();
    renderer->SetWorldPoint(-10.0, -6.0, 8.0, 1.0);
    renderer->WorldToDisplay();
    const double* display = renderer->GetDisplayPoint();
    vtkNew<vtkVolumePicker> picker;
    EXPECT_NE(picker->Pick(display[0], display[1], 0.0, renderer), 0);
    EXPECT_EQ(picker->GetVolume(), this->Stage->GetVolume());
    const double* position = picker->GetPickPosition();
    return std::array<double, 3>{position[0], position[1], position[2]};
  };
  EXPECT_EQ(pick(this->Configure(this->Slices)), pick(this->Configure(this->RayCaster)));
}

// The program that most users of VTK write.
TEST_F(SubjectsOfVTK, SmartVolumeMapper)
{
  this->ExpectSameFromFactory(
    "subject-smart", [&] { return this->MakeSmart(); }, 0.2);
  this->ExpectSameFromFactory(
    "subject-smart-window-level",
    [&]
    {
      auto smart = this->MakeSmart();
      smart->SetFinalColorWindow(0.7f);
      smart->SetFinalColorLevel(0.4f);
      return smart;
    },
    0.25);
}

// One component or the length of a vector of three.
TEST_F(SubjectsOfVTK, VectorModes)
{
  this->UseComponents(3, VTK_FLOAT);
  this->UseComponentFunctions(3, 0.3);
  for (const int mode : {vtkSmartVolumeMapper::COMPONENT, vtkSmartVolumeMapper::MAGNITUDE})
  {
    this->ExpectSameFromFactory(
      "subject-vector-" + std::to_string(mode),
      [&]
      {
        auto smart = this->MakeSmart();
        smart->SetVectorMode(mode);
        smart->SetVectorComponent(1);
        return smart;
      },
      mode == vtkSmartVolumeMapper::COMPONENT ? 0.26 : 0.56);
  }
}

// Two blocks of one storm, each with a mapper that VTK makes for it.
TEST_F(SubjectsOfVTK, MultiBlockMapper)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (const int west : {0, 1})
  {
    vtkNew<vtkImageData> half;
    half->ShallowCopy(this->Input);
    vtkNew<vtkImageData> part;
    part->SetOrigin(this->Input->GetOrigin());
    part->SetSpacing(this->Input->GetSpacing());
    part->SetExtent(west * 24, west * 24 + 23 + (1 - west), 0, 47, 0, 23);
    part->AllocateScalars(VTK_FLOAT, 1);
    part->CopyAndCastFrom(half, part->GetExtent());
    blocks->SetBlock(static_cast<unsigned int>(west), part);
  }
  this->ExpectSameFromFactory(
    "subject-blocks",
    [&]
    {
      auto mapper = vtkSmartPointer<vtkMultiBlockVolumeMapper>::New();
      mapper->SetInputDataObject(blocks);
      mapper->SetRequestedRenderMode(vtkSmartVolumeMapper::GPURenderMode);
      return mapper;
    },
    0.19);
}
