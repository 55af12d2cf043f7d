// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/RadarScene.h"

#include "Scene/Elements/SceneText.h"
#include "Scene/Map/MapLayer.h"
#include "Scene/Plan/PlanLayer.h"
#include "Scene/Plan/PlanScale.h"
#include "Scene/Scales/ColourBar.h"
#include "Scene/Scales/ScaleLayer.h"
#include "Scene/VolumeAppearance.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradTransferFunction.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

namespace nexrad::scene
{
namespace
{

constexpr Colour skyBottom = {0.030, 0.036, 0.046};
constexpr Colour skyTop = {0.055, 0.070, 0.095};
constexpr Colour titleColour = {0.95, 0.96, 0.98};
constexpr Colour noteColour = {0.70, 0.74, 0.79};
constexpr Colour warningColour = {1.0, 0.78, 0.10};

// The ground is drawn a little lower than mean sea level, in scene units.
constexpr double groundHeight = -0.0032;

// The captions, the N and the bar of length stand above and below this area, the colour bar to the
// right of it.
PictureArea SceneArea(const std::array<int, 2>& size, int textSize)
{
  return {-0.86, 2.0 * (LeftOfColourBar(size, textSize) - 0.025) - 1.0, -0.78, 0.77};
}

// "2010-09-11 01:20:00 UTC"
std::string TimeText(const VolumeInformation& information)
{
  if (!information.time)
  {
    return "time unknown";
  }
  std::string text = FormatIso8601(*information.time).substr(0, 19);
  text[10] = ' ';
  return text + " UTC";
}

// What was done with what, broken into lines of a dozen sites.
std::string SourceText(const std::string& title, const VolumeInformation& information)
{
  std::string text = title;
  if (!information.method.empty())
  {
    text += ", method " + information.method;
  }
  for (std::size_t i = 0; i < information.sites.size(); ++i)
  {
    text += (i % 12 == 0 ? "\n" : " ") + information.sites[i];
  }
  return text;
}

void RequireVoxels(vtkImageData* data)
{
  if (data == nullptr || data->GetNumberOfPoints() == 0 ||
      data->GetPointData()->GetScalars() == nullptr)
  {
    throw Error("the volume holds no voxels to draw");
  }
}

std::string ArrayOf(vtkImageData* data)
{
  const char* name = data->GetPointData()->GetScalars()->GetName();
  return name != nullptr ? name : "";
}

std::string ScaleText(double exaggeration)
{
  std::ostringstream stream;
  stream << "Height above mean sea level, stretched " << exaggeration << " times";
  return exaggeration == 1.0 ? "Height above mean sea level, to scale" : stream.str();
}

} // namespace

RadarScene::RadarScene(const SceneOptions& sceneOptions, vtkRenderer* filled)
  : options(sceneOptions)
  , renderer(filled)
  , transferFunction(MakeTransferFunction(sceneOptions, ""))
{
  if (filled == nullptr)
  {
    renderer = vtkSmartPointer<vtkRenderer>::New();
  }
  renderer->SetBackground(skyBottom[0], skyBottom[1], skyBottom[2]);
  renderer->SetBackground2(skyTop[0], skyTop[1], skyTop[2]);
  renderer->GradientBackgroundOn();
  volume->SetProperty(MakeVolumeProperty());
  this->TransferFunctionChanged();
}

RadarScene::~RadarScene()
{
  for (Props* group : {&plan, &ground, &scales, &captions})
  {
    this->Replace(*group, {});
  }
  renderer->RemoveVolume(volume);
}

vtkRenderer* RadarScene::GetRenderer()
{
  return renderer;
}

int RadarScene::TextSize() const
{
  return std::max(9, size[1] / 45);
}

vtkNexradTransferFunction* RadarScene::TransferFunction()
{
  return transferFunction;
}

void RadarScene::SetTransferFunction(
  vtkNexradTransferFunction* function, const std::string& ofArray)
{
  transferFunction = function;
  array = ofArray;
  this->TransferFunctionChanged();
}

void RadarScene::ShowVolume(bool shown)
{
  volume->SetVisibility(shown ? 1 : 0);
}

void RadarScene::TransferFunctionChanged()
{
  this->FillProperty();
  steps = ColourStepsOf(transferFunction);
  if (!options.plan)
  {
    scale = field ? field->scale : MomentScale(array, steps);
  }
  this->DrawCaptions();
}

void RadarScene::FillProperty()
{
  transferFunction->FillProperty(volume->GetProperty());
  if (field)
  {
    field->FillProperty(volume->GetProperty());
  }
}

void RadarScene::SetSlices(int slices)
{
  options.slices = slices;
  if (auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper()))
  {
    scene::SetSlices(mapper, slices, mapper->GetInput()->GetLength());
  }
}

void RadarScene::SetPictureSize(const std::array<int, 2>& pictureSize)
{
  size = pictureSize;
  this->DrawGround();
  this->DrawScales();
  this->DrawCaptions();
  this->Aim();
}

void RadarScene::SetCamera(const CameraView& cameraView)
{
  view = cameraView;
  this->DrawScales();
  this->Aim();
}

void RadarScene::Check(const SceneOptions& options, vtkImageData* data)
{
  RequireVoxels(data);
  MakeTransferFunction(options, ArrayOf(data));
  if (options.plan)
  {
    MakePlanView(vtkNexradImageToVolume(data), *options.plan);
  }
  else if (!options.colourBy.empty())
  {
    MakeColourField(options, data, ReadVolumeInformation(data));
  }
}

void RadarScene::SetVolume(vtkImageData* data)
{
  RequireVoxels(data);
  std::optional<PlanView> planView;
  if (options.plan)
  {
    planView = MakePlanView(vtkNexradImageToVolume(data), *options.plan);
  }
  std::optional<ColourField> newField;
  if (!options.plan && !options.colourBy.empty())
  {
    newField = MakeColourField(options, data, ReadVolumeInformation(data));
  }
  SceneFrame newFrame(
    data, options.exaggeration ? *options.exaggeration : DefaultExaggeration(data));
  note = ScaleText(newFrame.Exaggeration());
  note += newField && !newField->note.empty() ? "; " + newField->note : "";
  if (options.plan)
  {
    newFrame.Flatten();
  }
  const bool sameGround = newFrame.Bounds() == frame.Bounds() && !ground.empty();
  const std::vector<std::string> oldSites = information.sites;
  field = std::move(newField);
  this->FollowArray(data);
  if (field)
  {
    this->TransferFunctionChanged(); // the scale of the colours is this volume's
  }
  frame = newFrame;
  information = ReadVolumeInformation(data);

  vtkNew<vtkImageData> placed;
  placed->ShallowCopy(field ? field->volume.Get() : data);
  frame.MoveToScene(placed);
  if (planView)
  {
    this->DrawPlan(*planView, placed);
  }
  else
  {
    this->DrawVolume(placed, sameGround);
  }
  if (!sameGround)
  {
    this->DrawScales();
    this->Aim();
  }
  if (!sameGround || information.sites != oldSites)
  {
    this->DrawGround();
  }
  this->DrawCaptions();
}

// The colours and opacities of another moment, once its first volume comes. Those of the same
// moment stay as they were changed.
void RadarScene::FollowArray(vtkImageData* data)
{
  const std::string newArray = ArrayOf(data);
  if (newArray != array)
  {
    transferFunction = MakeTransferFunction(options, newArray);
    array = newArray;
    this->TransferFunctionChanged();
  }
}

bool RadarScene::Upload()
{
  auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  return mapper != nullptr && scene::Upload(mapper, renderer, volume);
}

void RadarScene::DrawVolume(vtkImageData* placed, bool sameMapper)
{
  if (!sameMapper)
  {
    volume->SetMapper(MakeVolumeMapper(options.mapper));
    renderer->AddVolume(volume);
  }
  volume->GetMapper()->SetInputDataObject(placed);
  this->SetSlices(options.slices);
}

void RadarScene::DrawPlan(const PlanView& shown, vtkImageData* placed)
{
  scale = ScaleFor(shown, options.plan->array, information.sites, MomentScale(array, steps));
  const std::string key = PlanKey(shown);
  note = shown.where + (key.empty() ? "" : "; " + key);
  this->Replace(plan, {MakePlanLayer(shown, scale, placed, PictureHeight(frame))});
}

void RadarScene::Replace(Props& group, Props replacement)
{
  for (const auto& prop : group)
  {
    renderer->RemoveViewProp(prop);
  }
  group = std::move(replacement);
  for (const auto& prop : group)
  {
    renderer->AddViewProp(prop);
  }
  this->OrderProps();
}

// Lines and letters that lie over each other are drawn in one order, whatever was replaced last.
void RadarScene::OrderProps()
{
  vtkPropCollection* props = renderer->GetViewProps();
  for (const Props* group : {&scales, &ground, &captions})
  {
    for (const auto& prop : *group)
    {
      props->RemoveItem(prop);
      props->AddItem(prop);
    }
  }
}

void RadarScene::DrawGround()
{
  this->Replace(
    ground, MakeMapLayer(frame, information.sites, options.ringSpacing, this->TextSize()));
}

void RadarScene::DrawScales()
{
  this->Replace(scales, MakeScaleLayer(frame, view, this->TextSize()));
}

void RadarScene::DrawCaptions()
{
  const int letters = this->TextSize();
  Props props = MakeColourBar(scale, size, letters);
  const double line = 1.4 * letters / size[1];
  const auto add = [&](const std::string& text, double x, double y, int height,
                     const Colour& colour, LabelSide side)
  {
    const auto caption = MakeCaption(text, {x, y}, height, colour, side);
    caption->GetTextProperty()->SetVerticalJustificationToTop();
    props.push_back(caption);
    return caption;
  };
  add(TimeText(information), 0.02, 0.975, letters * 3 / 2, titleColour, LabelSide::Right)
    ->GetTextProperty()
    ->BoldOn();
  add(SourceText(scale.title, information), 0.02, 0.975 - 1.7 * line, letters, noteColour,
    LabelSide::Right);
  add(note, 0.02, 0.02 + line, letters, noteColour, LabelSide::Right);
  if (information.synthetic)
  {
    add("SYNTHETIC", 0.5, 0.975, letters * 5 / 2, warningColour, LabelSide::Below)
      ->GetTextProperty()
      ->BoldOn();
  }
  this->Replace(captions, std::move(props));
}

void RadarScene::Aim()
{
  const double aspect = static_cast<double>(size[0]) / size[1];
  PointCamera(
    renderer->GetActiveCamera(), view, frame.Bounds(), aspect, SceneArea(size, this->TextSize()));
  this->FitClippingRange();
}

// From the volume and its scales, which hold the rest: the ground may still be that of another
// volume, and a picture must not depend on it.
void RadarScene::FitClippingRange()
{
  vtkBoundingBox box;
  for (const Props& group : {Props{volume.Get()}, plan, scales})
  {
    for (const auto& prop : group)
    {
      const double* bounds = prop->GetBounds();
      if (bounds != nullptr && vtkMath::AreBoundsInitialized(bounds))
      {
        box.AddBounds(bounds);
      }
    }
  }
  double bounds[6];
  box.GetBounds(bounds);
  bounds[4] = std::min(bounds[4], groundHeight);
  renderer->ResetCameraClippingRange(bounds);
}

} // namespace nexrad::scene
