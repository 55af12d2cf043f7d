// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/RadarScene.h"

#include "Scene/Captions/Captions.h"
#include "Scene/Captions/EchoShown.h"
#include "Scene/EchoFraming.h"
#include "Scene/Frame/PictureLayout.h"
#include "Scene/Map/MapLayer.h"
#include "Scene/Plan/PlanLayer.h"
#include "Scene/Scales/ColourScale.h"
#include "Scene/Scales/ScaleLayer.h"
#include "Scene/Shapes/Shapes.h"
#include "Scene/VolumeAppearance.h"
#include "Scene/VolumeCut.h"
#include "nexrad/Settings/ValueTexts.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradThreads.h"
#include "vtkNexradTransferFunction.h"

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace nexrad::scene
{
namespace
{

// The ground is drawn a little lower than mean sea level, in scene units.
constexpr double groundHeight = -0.0032;

std::string SizeText(vtkImageData* volume)
{
  const int* size = volume->GetDimensions();
  return DimensionsText({size[0], size[1], size[2]});
}

// A volume of one layer has no thickness, and VTK draws nothing of it.
void RequireVoxels(vtkImageData* data, const SceneOptions& options)
{
  if (data == nullptr || data->GetNumberOfPoints() == 0 ||
      data->GetPointData()->GetScalars() == nullptr)
  {
    throw Error("the volume holds no voxels to draw");
  }
  const int* size = data->GetDimensions();
  if (!options.plan && std::min({size[0], size[1], size[2]}) < 2)
  {
    throw Error("the volume of " + SizeText(data) +
                " voxels is one layer without thickness; merge it with two layers or more "
                "(--dims), or draw it as a map (--map)");
  }
}

std::string ScaleText(double exaggeration)
{
  std::ostringstream stream;
  stream << "Height above mean sea level, stretched " << exaggeration << " times";
  return exaggeration == 1.0 ? "Height above mean sea level, to scale" : stream.str();
}

PresetWords NamesOfPresets(const SceneOptions& options)
{
  return options.namesOptions ? PresetWords::Option : PresetWords::Setting;
}

} // namespace

RadarScene::RadarScene(const SceneOptions& sceneOptions, vtkRenderer* filled)
  : options(sceneOptions)
  , theme(ThemeOf(sceneOptions.theme))
  , renderer(filled)
  , detail(renderer)
  , transferFunction(MakeTransferFunction(sceneOptions, ""))
{
  renderer->SetBackground(theme.skyBottom[0], theme.skyBottom[1], theme.skyBottom[2]);
  renderer->SetBackground2(theme.skyTop[0], theme.skyTop[1], theme.skyTop[2]);
  renderer->GradientBackgroundOn();
  volume->SetProperty(MakeVolumeProperty());
  startTag = renderer->AddObserver(vtkCommand::StartEvent, this, &RadarScene::BeginFrame);
  this->TransferFunctionChanged();
}

RadarScene::~RadarScene()
{
  renderer->RemoveObserver(startTag);
  for (Props* group : {&plan, &ground, &scales, &section, &mark, &captions, &labels})
  {
    this->Replace(*group, {});
  }
  renderer->RemoveVolume(volume);
}

int RadarScene::TextSize() const
{
  return std::max(9, std::min(size[1] / 45, size[0] / 50));
}

TextStyle RadarScene::NoteStyle() const
{
  return {this->TextSize(), theme.scale, theme.rim};
}

void RadarScene::SetColours(const SceneOptions& other)
{
  SceneOptions wanted = WithColoursOf(options, other);
  transferFunction = MakeTransferFunction(wanted, array);
  const bool otherPreset = wanted.preset != options.preset;
  options = std::move(wanted);
  if (otherPreset && shownData != nullptr && !holdsEcho)
  {
    echo.reset(); // another preset may show other echo
    this->SetVolume(vtkSmartPointer<vtkImageData>(shownData));
  }
}

void RadarScene::SetTransferFunction(
  vtkNexradTransferFunction* function, const std::string& ofArray)
{
  transferFunction = function;
  array = ofArray;
  this->TransferFunctionChanged();
}

void RadarScene::TransferFunctionChanged()
{
  this->FillProperty();
  this->FollowIsoValues();
  if (!options.plan)
  {
    scale = field ? field->scale : ScaleOf(array, transferFunction);
  }
  this->LookForEcho();
  this->DrawCaptions();
  this->Aim();
}

// Iso-values are drawn as lit surfaces.
void RadarScene::FollowIsoValues()
{
  const bool surfaces = transferFunction->GetNumberOfIsoValues() > 0;
  ShadeSurfaces(volume->GetProperty(), surfaces,
    options.mapper == MapperChoice::TextureSlice && options.light.HasShadows());
  for (vtkVolumeMapper* mapper : this->Mappers())
  {
    DrawSurfaces(mapper, surfaces);
    scene::SetLight(mapper, options.light);
  }
  this->UpdateSlices();
}

// What draws the volume, and the finer one in it.
std::vector<vtkVolumeMapper*> RadarScene::Mappers() const
{
  std::vector<vtkVolumeMapper*> mappers = detail.Mappers();
  if (auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper()))
  {
    mappers.push_back(mapper);
  }
  return mappers;
}

void RadarScene::FillProperty()
{
  transferFunction->FillProperty(volume->GetProperty());
  volume->GetProperty()->SetInterpolationType(
    options.linearInterpolation ? VTK_LINEAR_INTERPOLATION : VTK_NEAREST_INTERPOLATION);
  if (field)
  {
    field->FillProperty(volume->GetProperty());
  }
}

bool RadarScene::CanFollow(const SceneOptions& other) const
{
  SceneOptions same = other;
  same.slices = options.slices;
  same.light = options.light;
  same.cut = options.cut;
  const bool oneArray = other.colourBy.empty() && options.colourBy.empty();
  return (oneArray ? WithColoursOf(same, options) : same) == options;
}

void RadarScene::Follow(const SceneOptions& other)
{
  if (other.slices != options.slices)
  {
    options.slices = other.slices;
    this->UpdateSlices();
  }
  if (!(other.light == options.light))
  {
    options.light = other.light;
    this->FollowIsoValues();
  }
  if (other.cut != options.cut)
  {
    this->SetCut(other.cut);
  }
}

void RadarScene::UpdateSlices()
{
  auto* whole = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  auto* image = vtkImageData::SafeDownCast(whole != nullptr ? whole->GetDataSetInput() : nullptr);
  if (image == nullptr)
  {
    return; // before the first volume
  }
  const int slices = options.slices > 0 ? options.slices : SlicesFor(image);
  for (vtkVolumeMapper* mapper : this->Mappers())
  {
    const double edge = vtkImageData::SafeDownCast(mapper->GetDataSetInput())->GetSpacing()[0];
    scene::SetSlices(mapper, slices, mapper->GetInput()->GetLength());
    SetPixelSize(mapper, options.slices > 0 ? 1.0 : this->PixelsOf(edge));
  }
}

// About how wide a length of the scene is in the picture.
double RadarScene::PixelsOf(double length) const
{
  const auto& framed = frame.Framed();
  return view.zoom * length * size[0] / (framed[1] - framed[0]);
}

void RadarScene::HoldEcho(const std::optional<EchoExtent>& held)
{
  echo = held;
  holdsEcho = held.has_value();
}

// The frame of a volume. It follows the echo only as far as it must: a series does not pump.
SceneFrame RadarScene::FollowEcho(vtkImageData* newData, const VolumeInformation& read)
{
  if (!holdsEcho)
  {
    const bool sameGrid =
      shownData != nullptr && ArrayOf(newData) == array &&
      read.projection == information.projection &&
      SceneFrame(newData, read, frame.Exaggeration()).Bounds() == frame.Bounds();
    const auto found = MeasureEcho(newData, options);
    if (!sameGrid || !echo)
    {
      echo = found;
    }
    else if (found && !frame.Holds(found->box))
    {
      echo->box = Join(*echo, *found).box;
    }
  }
  return FrameVolume(newData, read, echo, options);
}

// The ground is drawn before the volume.
void RadarScene::BeginFrame()
{
  this->FitTexture();
  detail.Follow(volume);
  auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  if (mapper == nullptr || ground.empty())
  {
    return;
  }
  // The coarse light of an interaction is followed by that of the next picture at rest.
  vtkRenderWindow* window = renderer->GetRenderWindow();
  const bool moves = window != nullptr && window->GetDesiredUpdateRate() > 1.0;
  groundShadow.Show(vtkActor::SafeDownCast(ground.front()),
    options.light.HasShadows() ? UpdateLight(mapper, renderer, volume) : nullptr, options.light,
    vtkImageData::SafeDownCast(mapper->GetDataSetInput()), moves);
}

void RadarScene::SetCut(const CutOptions& cut)
{
  CheckCut(cut);
  const bool sameSection = cut.section == options.cut.section;
  const bool sameBox = cut.box == options.cut.box;
  options.cut = cut;
  for (vtkVolumeMapper* mapper : this->Mappers())
  {
    mapper->SetClippingPlanes(CutPlanesOf(cut, frame));
  }
  if (!sameSection && !ground.empty())
  {
    this->DrawSection();
    this->DrawLabels();
  }
  if (!sameBox && shownData)
  {
    this->LookForEcho();
    this->DrawCaptions();
    this->DrawLabels();
  }
}

// An empty box says why it is empty. A map has its words from DrawPlan.
void RadarScene::LookForEcho()
{
  if (options.plan)
  {
    return;
  }
  nothing.clear();
  if (shownData)
  {
    nothing =
      WordsForNothing(FindEchoShown(shownData, options.cut.box, OpacitiesOf(transferFunction)),
        array, LeastShown(transferFunction), information.biologicalShare, NamesOfPresets(options));
  }
}

std::optional<std::array<double, 2>> RadarScene::GroundAt(const std::array<double, 2>& pixel)
{
  std::array<std::array<double, 4>, 2> ends{}; // of the line of sight, homogeneous
  for (std::size_t end = 0; end < ends.size(); ++end)
  {
    renderer->SetDisplayPoint(pixel[0], pixel[1], static_cast<double>(end));
    renderer->DisplayToWorld();
    renderer->GetWorldPoint(ends[end].data());
    std::transform(ends[end].begin(), ends[end].end(), ends[end].begin(),
      [scale = ends[end][3]](double part) { return part / scale; });
  }
  const auto& [near, far] = ends;
  const double share = (frame.Bounds()[4] - near[2]) / (far[2] - near[2]);
  if (ground.empty() || !(share >= 0.0))
  {
    return std::nullopt;
  }
  const auto [x, y, height] = frame.ToVolume(
    {near[0] + share * (far[0] - near[0]), near[1] + share * (far[1] - near[1]), 0.0});
  return std::array{x, y};
}

std::array<double, 2> RadarScene::PixelOf(const std::array<double, 2>& groundPoint) const
{
  const auto [x, y] = frame.FromVolume(groundPoint);
  return Projection(renderer->GetActiveCamera(), size)({x, y, frame.Bounds()[4]});
}

void RadarScene::SetPictureSize(const std::array<int, 2>& pictureSize)
{
  size = pictureSize;
  this->UpdateSlices();
  this->DrawGround();
  this->DrawSection();
  this->DrawScales();
  this->DrawMark();
  this->DrawCaptions();
  this->Aim();
}

void RadarScene::SetCamera(const CameraView& cameraView)
{
  view = cameraView;
  this->UpdateSlices();
  this->DrawScales();
  this->Aim();
}

namespace
{

// Values in place of codes, which the slices of one moment alone can draw.
vtkSmartPointer<vtkImageData> AsDrawn(vtkImageData* data, const SceneOptions& options)
{
  const bool slices = options.mapper == MapperChoice::TextureSlice && options.colourBy.empty();
  const bool codes =
    vtkUnsignedCharArray::SafeDownCast(data->GetPointData()->GetScalars()) != nullptr;
  if (slices || options.plan || !codes)
  {
    return data;
  }
  auto values = vtkSmartPointer<vtkImageData>::New();
  vtkNexradVolumeToImage(vtkNexradImageToVolume(data), values);
  return values;
}

} // namespace

void RadarScene::Check(const SceneOptions& options, vtkImageData* data)
{
  RequireVoxels(data, options);
  CheckCut(options.cut);
  CheckCutUnit(options.cut, data);
  const vtkSmartPointer<vtkImageData> values = AsDrawn(data, options);
  MakeTransferFunction(options, ArrayOf(values));
  if (options.plan)
  {
    MakePlanView(SourceOf(data), *options.plan, vtkNexradRangeLoop());
  }
  else if (!options.colourBy.empty())
  {
    MakeColourField(options, values, ReadVolumeInformation(values));
  }
}

void RadarScene::SetVolume(vtkImageData* newVolume)
{
  RequireVoxels(newVolume, options);
  CheckCutUnit(options.cut, newVolume);
  const vtkSmartPointer<vtkImageData> drawn = AsDrawn(newVolume, options);
  VolumeInformation read = ReadVolumeInformation(drawn);
  std::optional<PlanView> planView;
  if (options.plan)
  {
    planView = MakePlanView(SourceOf(drawn), *options.plan, vtkNexradRangeLoop());
  }
  std::optional<ColourField> newField;
  if (!options.plan && !options.colourBy.empty())
  {
    newField = MakeColourField(options, drawn, read);
  }
  if (view.lookAt)
  {
    SceneFrame(drawn, read, 1.0).PlaceOf(*view.lookAt); // throws before anything changes
  }
  SceneFrame newFrame = this->FollowEcho(drawn, read);
  note = ScaleText(newFrame.Exaggeration());
  note += newField && !newField->note.empty() ? "; " + newField->note : "";
  if (options.plan)
  {
    newFrame.Flatten();
  }
  const bool sameBox = newFrame.Bounds() == frame.Bounds() && !ground.empty();
  const bool sameGround = sameBox && newFrame.Framed() == frame.Framed();
  const std::vector<std::string> oldSites = information.sites;
  field = std::move(newField);
  this->FollowArray(drawn);
  if (field)
  {
    this->TransferFunctionChanged(); // the scale of the colours is this volume's
  }
  frame = newFrame;
  shownData = newVolume;
  volume->GetProperty()->SetScalarOpacityUnitDistance(frame.OpacityDistance());
  information = std::move(read);
  ages = AgesOfData(drawn, array, information.sites.size());
  this->LookForEcho();

  vtkNew<vtkImageData> placed;
  placed->ShallowCopy(field ? field->volume.Get() : drawn.Get());
  frame.MoveToScene(placed);
  if (planView)
  {
    this->DrawPlan(*planView, placed);
  }
  else
  {
    this->DrawVolume(placed, sameBox);
  }
  if (!sameGround)
  {
    this->DrawScales();
    this->DrawMark();
  }
  if (!sameGround || information.sites != oldSites)
  {
    this->DrawGround();
  }
  if (!sameGround || section.empty())
  {
    this->DrawSection();
  }
  this->DrawCaptions();
  this->Aim();
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

// How many voxels a texture may have is known once the renderer has a context.
void RadarScene::FitTexture()
{
  auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  auto* whole = vtkImageData::SafeDownCast(mapper != nullptr ? mapper->GetDataSetInput() : nullptr);
  const int most = vtkTextureObject::GetMaximumTextureSize3D(
    vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  if (whole == nullptr || most < 1)
  {
    return;
  }
  const ThinnedVolume drawn = ThinOut(whole, most);
  if (drawn.left.empty())
  {
    return;
  }
  mapper->SetInputDataObject(drawn.volume);
  this->PlaceDetail();
  this->UpdateSlices();
  note += "; drawn: " + drawn.left;
  this->DrawCaptions();
  if (drawn.left != thinned)
  {
    thinned = drawn.left;
    vtkWarningWithObjectMacro(renderer, << "OpenGL takes at most " << most
      << " voxels along an axis, and the volume has " << SizeText(whole) << ": " << drawn.left
      << " is drawn; fewer voxels (--dims), or those of a part (--bounds), are all drawn");
  }
}

void RadarScene::DrawVolume(vtkImageData* placed, bool sameMapper)
{
  if (!sameMapper)
  {
    volume->SetMapper(MakeVolumeMapper(options.mapper, options.preIntegration));
    this->FollowIsoValues();
    renderer->AddVolume(volume);
  }
  volume->GetMapper()->SetInputDataObject(placed);
  this->PlaceDetail();
  this->UpdateSlices();
  this->SetCut(options.cut);
}

void RadarScene::SetDetail(vtkImageData* newDetail)
{
  if (newDetail == detailData)
  {
    return;
  }
  if (newDetail != nullptr)
  {
    RequireVoxels(newDetail, options);
    if (ArrayOf(newDetail) != array ||
        ReadVolumeInformation(newDetail).projection != information.projection)
    {
      throw Error("the finer volume is none of the moment and the projection of the volume");
    }
  }
  detailData = newDetail;
  this->PlaceDetail();
  this->DrawMark(); // which names its time
  this->UpdateSlices();
  this->SetCut(options.cut);
}

void RadarScene::PlaceDetail()
{
  auto* whole = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  if (detailData == nullptr || options.plan || whole == nullptr)
  {
    detail.Hide(volume);
    return;
  }
  const vtkSmartPointer<vtkImageData> data = AsDrawn(detailData, options);
  vtkNew<vtkImageData> placed;
  placed->ShallowCopy(
    field ? MakeColourField(options, data, ReadVolumeInformation(data)).volume.Get() : data.Get());
  frame.MoveToScene(placed);
  if (detail.IsShown())
  {
    const std::vector<vtkVolumeMapper*> mappers = detail.Mappers();
    detail.Show(placed, volume, mappers[0], mappers[1]);
    return;
  }
  detail.Show(placed, volume, MakeVolumeMapper(options.mapper, options.preIntegration),
    MakeVolumeMapper(options.mapper, options.preIntegration));
  this->FollowIsoValues();
}

void RadarScene::MarkBox(const std::optional<std::array<double, 4>>& faces)
{
  if (faces != markFaces)
  {
    markFaces = faces;
    this->DrawMark();
  }
}

void RadarScene::DrawMark()
{
  LineBuilder lines;
  markLabels.clear();
  if (markFaces)
  {
    const auto& [west, east, south, north] = *markFaces;
    const ScenePoint lower = frame.ToScene({west, south, 0.0});
    const ScenePoint upper = frame.ToScene({east, north, 0.0});
    const std::array<double, 6> box = {
      lower[0], upper[0], lower[1], upper[1], frame.Bounds()[4], frame.Bounds()[5]};
    const auto corner = [&](int x, int y, int z) -> ScenePoint
    {
      return {box[static_cast<std::size_t>(x)], box[static_cast<std::size_t>(2 + y)],
        box[static_cast<std::size_t>(4 + z)]};
    };
    const auto time = detailData ? ReadVolumeInformation(detailData).time : std::nullopt;
    if (time)
    {
      constexpr std::size_t day = 11; // letters before the time of day
      constexpr std::size_t ofTime = 8;
      const ScenePoint top = {0.5 * (box[0] + box[1]), box[3], box[5]}; // of the northern face
      markLabels.push_back({FormatIso8601(*time).substr(day, ofTime) + " UTC", top,
        {this->TextSize(), theme.marker, theme.rim},
        {LabelSide::Above, LabelSide::Right, LabelSide::Left, LabelSide::Below},
        0.5 * this->TextSize(), false});
    }
    for (const int z : {0, 1})
    {
      lines.Add(
        {corner(0, 0, z), corner(1, 0, z), corner(1, 1, z), corner(0, 1, z), corner(0, 0, z)});
    }
    for (const int x : {0, 1})
    {
      for (const int y : {0, 1})
      {
        lines.Add({corner(x, y, 0), corner(x, y, 1)});
      }
    }
  }
  this->Replace(mark, {lines.MakeActor(theme.marker, 1.5)});
  if (!outline.empty())
  {
    this->DrawLabels();
  }
}

void RadarScene::DrawPlan(const PlanView& shown, vtkImageData* placed)
{
  scale = ScaleFor(shown, *options.plan, information.sites, ScaleOf(array, transferFunction));
  const std::string key = PlanKey(shown, scale);
  note = shown.where + (key.empty() ? "" : "; " + key);
  nothing = WordsForMap(
    shown, *options.plan, scale, shownData, information.biologicalShare, NamesOfPresets(options));
  this->Replace(
    plan, {MakePlanLayer(shown, scale, placed, HeightOf(frame, GroundLevel::Picture), theme)});
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
  for (const Props* group : {&scales, &ground, &section, &mark, &labels, &captions})
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
  SceneLayer layer = MakeMapLayer(
    frame, {information.sites, options.ringSpacing, options.placeNames}, this->TextSize(), theme);
  this->Replace(ground, std::move(layer.props));
  groundLabels = std::move(layer.labels);
}

void RadarScene::DrawSection()
{
  SceneLayer layer;
  if (options.cut.section)
  {
    layer = MakeSectionMark(
      *options.cut.section, frame, HeightOf(frame, GroundLevel::Section), this->TextSize(), theme);
  }
  this->Replace(section, std::move(layer.props));
  sectionLabels = std::move(layer.labels);
}

void RadarScene::DrawScales()
{
  ScaleLayer layer = MakeScaleLayer(frame, view, options.heightWalls, this->TextSize(), theme);
  this->Replace(scales, std::move(layer.props));
  scaleLabels = std::move(layer.labels);
  outline = std::move(layer.outline);
}

void RadarScene::DrawCaptions()
{
  Props props = MakeColourBar(scale, size, this->NoteStyle(), theme.frame, pictures);
  right = LeftOfColourBar(scale, size, this->NoteStyle(), pictures);
  CaptionLayer layer = MakeCaptions({scale.title, note, information, ages, nothing}, size, right,
    this->TextSize(), theme, pictures);
  props.insert(props.end(), layer.props.begin(), layer.props.end());
  taken = std::move(layer.taken);
  overScene = layer.overScene;
  this->Replace(captions, std::move(props));
}

// Labels of the scales first: they have one place each.
void RadarScene::DrawLabels()
{
  std::vector<Label> all = scaleLabels;
  all.insert(all.end(), sectionLabels.begin(), sectionLabels.end());
  all.insert(all.end(), markLabels.begin(), markLabels.end());
  all.insert(all.end(), groundLabels.begin(), groundLabels.end());
  std::vector<PixelBox> boxes = taken;
  if (overScene)
  {
    boxes.push_back(*overScene);
  }
  boxes.push_back({right, 0.0, static_cast<double>(size[0]), static_cast<double>(size[1])});
  // The ground's corners come first in the outline, those in the north after those in the south.
  const auto sides = ChooseSides(all, {outline[0], outline[1], outline[3], outline[2]},
    Projection(renderer->GetActiveCamera(), size), pictures, boxes);
  Props props;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (sides[i])
    {
      if (all[i].dot > 0.0)
      {
        props.push_back(
          MakeMarker(all[i].point, all[i].dot, all[i].style.colour, all[i].style.rim));
      }
      props.push_back(
        pictures.Get(all[i].text, all[i].style).MakeLabel(all[i].point, *sides[i], all[i].gap));
    }
  }
  this->Replace(labels, std::move(props));
}

void RadarScene::Aim()
{
  if (outline.empty())
  {
    return; // before the first size, camera or volume
  }
  FrameScene(
    renderer->GetActiveCamera(), view, {outline, scaleLabels}, {size, right, taken}, pictures);
  if (view.lookAt && (!view.lookAt->geographic || frame.HasMap())) // not before the first volume
  {
    CentreOn(renderer->GetActiveCamera(), frame.ToScene(frame.PlaceOf(*view.lookAt)));
  }
  this->FitClippingRange();
  this->DrawLabels();
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
