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
#include "vtkNexradThreads.h"

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPlaneCollection.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

namespace nexrad::scene
{
namespace
{

// The ground is drawn a little lower than mean sea level, in scene units.
constexpr double groundHeight = -0.0032;

std::string ScaleText(double exaggeration)
{
  return "Height above mean sea level, " +
         (exaggeration == 1.0 ? "to scale" : "stretched " + NumberWord(exaggeration) + " times");
}

// Throws for a place that the camera cannot look at.
void RequirePlace(const SceneContents& contents, const VolumeInformation& information)
{
  if (contents.view.lookAt)
  {
    SceneFrame(contents.volume, information, 1.0).PlaceOf(*contents.view.lookAt);
  }
}

} // namespace

// All of a volume that can be refused, made before anything changes.
struct RadarScene::Prepared
{
  vtkSmartPointer<vtkImageData> given;
  vtkSmartPointer<vtkImageData> drawn; // values in place of codes, where codes cannot be drawn
  VolumeInformation information;
  std::optional<PlanView> plan;
  std::optional<ColourField> field;
  vtkSmartPointer<vtkNexradTransferFunction> colours; // of another array than before
};

RadarScene::RadarScene(
  const SceneContents& contents, vtkRenderer* filled, std::unique_ptr<RadarScene>& before)
  : options(contents.options)
  , theme(ThemeOf(options.theme))
  , view(contents.view)
  , renderer(filled)
  , detail(renderer)
{
  if (before && !before->OtherColours(options))
  {
    transferFunction = before->transferFunction;
    array = before->array;
  }
  Prepared prepared = Prepare(options, contents.volume, array);
  RequirePlace(contents, prepared.information);
  if (before)
  {
    pictures = std::move(before->pictures);
    size = before->size;
    before.reset(); // it fills the same renderer
  }
  renderer->SetBackground(theme.skyBottom[0], theme.skyBottom[1], theme.skyBottom[2]);
  renderer->SetBackground2(theme.skyTop[0], theme.skyTop[1], theme.skyTop[2]);
  renderer->GradientBackgroundOn();
  volume->SetProperty(MakeVolumeProperty());
  this->HoldEcho(contents.held);
  this->FollowSize();
  this->ShowVolume(std::move(prepared));
  this->SetMark(contents.mark);
  this->SetDetail(contents.detail);
  colourTime = transferFunction->GetMTime();
}

RadarScene::~RadarScene()
{
  for (SceneLayer* layer : {&plan, &ground, &scales, &section, &mark, &captions, &labels})
  {
    this->Replace(*layer, {});
  }
  renderer->RemoveVolume(volume);
}

int RadarScene::TextSize() const
{
  return std::max(9, std::min(size[1] / 45, size[0] / 50));
}

bool RadarScene::OtherColours(const SceneOptions& other) const
{
  return remakeColours || !(WithColoursOf(options, other) == options);
}

void RadarScene::SetColours(const SceneOptions& other)
{
  SceneOptions wanted = WithColoursOf(options, other);
  transferFunction = MakeTransferFunction(wanted, array);
  remakeColours = false;
  const bool otherPreset = wanted.preset != options.preset;
  options = std::move(wanted);
  if (otherPreset && !holdsEcho)
  {
    echo.reset(); // another preset may show other echo
    this->ShowAgain();
  }
}

// Changes that somebody made to the colours and opacities in use.
void RadarScene::FollowColours()
{
  const vtkMTimeType time = transferFunction->GetMTime();
  if (time != colourTime)
  {
    colourTime = time;
    this->TransferFunctionChanged();
    if (options.plan)
    {
      this->ShowAgain();
    }
  }
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
    SetLight(mapper, options.light, surfaces);
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

bool RadarScene::CanFollow(const SceneContents& contents) const
{
  SceneOptions same = contents.options;
  same.slices = options.slices;
  same.light = options.light;
  same.cut = options.cut;
  const bool oneArray = same.colourBy.empty() && options.colourBy.empty();
  // Another volume may be of another moment, with other presets.
  return (oneArray ? WithColoursOf(same, options) : same) == options &&
         !(this->OtherColours(contents.options) && this->IsOther(contents.volume));
}

bool RadarScene::IsOther(vtkImageData* data) const
{
  return reframed || data != shownData || data->GetMTime() != shownTime;
}

void RadarScene::Follow(const SceneContents& contents)
{
  const bool otherVolume = this->IsOther(contents.volume);
  std::optional<Prepared> prepared;
  if (otherVolume)
  {
    prepared = Prepare(options, contents.volume, array);
  }
  RequirePlace(contents, prepared ? prepared->information : information);
  if (prepared)
  {
    this->ShowVolume(std::move(*prepared));
  }
  const SceneOptions& other = contents.options;
  if (this->OtherColours(other))
  {
    this->SetColours(other);
  }
  this->SetMark(contents.mark);
  this->SetDetail(contents.detail);
  this->FollowColours();
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
  if (!(contents.view == view))
  {
    view = contents.view;
    this->UpdateSlices();
    this->DrawScales();
    this->Aim();
  }
}

// What the mapper of the volume draws; nullptr before the first volume.
vtkImageData* RadarScene::Drawn() const
{
  auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  return vtkImageData::SafeDownCast(mapper != nullptr ? mapper->GetDataSetInput() : nullptr);
}

void RadarScene::UpdateSlices()
{
  vtkImageData* image = this->Drawn();
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
  reframed = true;
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
  this->CheckSize();
  this->ShadeGround();
  detail.Follow(volume, detail.IsShown() ? FindSeen(renderer, size, frame.Bounds()) : std::nullopt);
}

void RadarScene::ShadeGround()
{
  auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  if (mapper == nullptr || ground.props.empty())
  {
    return;
  }
  // The coarse light of an interaction is followed by that of the next picture at rest.
  vtkRenderWindow* window = renderer->GetRenderWindow();
  const bool moves = window != nullptr && window->GetDesiredUpdateRate() > 1.0;
  if (!moves)
  {
    mapper->SetCropping(0); // the part that a finer volume takes the place of has its shadow
  }
  groundShadow.Show(vtkActor::SafeDownCast(ground.props.front()),
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
  if (!sameSection && !ground.props.empty())
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
    nothing = WordsForNothing(shownData, options.cut.box, transferFunction,
      information.biologicalShare, options.namesOptions);
  }
}

void RadarScene::FollowSize()
{
  const int* now = renderer->GetSize();
  if (now[0] <= 0 || now[1] <= 0 || (now[0] == size[0] && now[1] == size[1]))
  {
    return;
  }
  size = {now[0], now[1]};
  if (shownData != nullptr)
  {
    this->UpdateSlices();
    this->DrawGround();
    this->DrawSection();
    this->DrawScales();
    this->DrawMark();
    this->DrawCaptions();
    this->Aim();
  }
}

RadarScene::Prepared RadarScene::Prepare(
  const SceneOptions& options, vtkImageData* data, const std::string& ofArray)
{
  RequireVoxels(data, options);
  CheckCut(options.cut);
  CheckCutUnit(options.cut, data);
  Prepared prepared;
  prepared.given = data;
  prepared.drawn = AsDrawn(data, options);
  prepared.information = ReadVolumeInformation(prepared.drawn);
  if (ArrayOf(prepared.drawn) != ofArray)
  {
    prepared.colours = MakeTransferFunction(options, ArrayOf(prepared.drawn));
  }
  if (options.plan)
  {
    prepared.plan = MakePlanView(SourceOf(prepared.drawn), *options.plan, vtkNexradRangeLoop());
  }
  else if (!options.colourBy.empty())
  {
    prepared.field = MakeColourField(options, prepared.drawn, prepared.information);
  }
  return prepared;
}

void RadarScene::Check(const SceneOptions& options, vtkImageData* data)
{
  Prepare(options, data, "");
}

void RadarScene::ShowAgain()
{
  this->ShowVolume(Prepare(options, vtkSmartPointer<vtkImageData>(shownData), array));
}

void RadarScene::ShowVolume(Prepared prepared)
{
  vtkImageData* drawn = prepared.drawn;
  const std::optional<PlanView>& planView = prepared.plan;
  SceneFrame newFrame = this->FollowEcho(drawn, prepared.information);
  note = ScaleText(newFrame.Exaggeration());
  note += prepared.field && !prepared.field->note.empty() ? "; " + prepared.field->note : "";
  if (options.plan)
  {
    newFrame.Flatten();
  }
  const bool sameBox = newFrame.Bounds() == frame.Bounds() && !ground.props.empty();
  const bool sameGround = sameBox && newFrame.Framed() == frame.Framed();
  const std::vector<std::string> oldSites = information.sites;
  field = std::move(prepared.field);
  if (prepared.colours) // those of the same moment stay as they were changed
  {
    transferFunction = prepared.colours;
    array = ArrayOf(drawn);
  }
  if (prepared.colours || field || shownData == nullptr) // a field's scale is that of its volume
  {
    this->TransferFunctionChanged();
  }
  frame = newFrame;
  shownData = prepared.given;
  shownTime = shownData->GetMTime();
  reframed = false;
  volume->GetProperty()->SetScalarOpacityUnitDistance(frame.OpacityDistance());
  information = std::move(prepared.information);
  ages = AgesOfData(drawn, array, information.sites.size());
  this->LookForEcho();

  vtkNew<vtkImageData> placed;
  placed->ShallowCopy(field ? field->volume.Get() : drawn);
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
  if (!sameGround || section.props.empty())
  {
    this->DrawSection();
  }
  this->DrawCaptions();
  this->Aim();
}

// VTK's ray caster does not say what would help. How many voxels it takes is known once the
// renderer has a context.
void RadarScene::CheckSize() const
{
  vtkImageData* whole = this->Drawn();
  if (whole == nullptr || options.mapper != MapperChoice::RayCast)
  {
    return;
  }
  const int* voxels = whole->GetDimensions();
  const int most = vtkTextureObject::GetMaximumTextureSize3D(
    vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  if (most > 0 && *std::max_element(voxels, voxels + 3) > most)
  {
    vtkErrorWithObjectMacro(renderer,
      << "VTK's ray caster takes at most " << most << " voxels along an axis, and the volume has "
      << DimensionsText({voxels[0], voxels[1], voxels[2]})
      << ": draw it by --mapper texture-slice, or merge fewer voxels (--dims)");
  }
}

void RadarScene::DrawVolume(vtkImageData* placed, bool sameMapper)
{
  if (!sameMapper)
  {
    volume->SetMapper(MakeVolumeMapper(options));
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
  detail.Show(placed, volume, MakeVolumeMapper(options), MakeVolumeMapper(options));
  this->FollowIsoValues();
}

std::optional<BoxRequest> RadarScene::SeenBox() const
{
  vtkImageData* image = this->Drawn();
  const auto seen =
    options.plan || image == nullptr ? std::nullopt : FindSeen(renderer, size, frame.Bounds());
  constexpr double pixelsOfAVoxel = 1.25; // that need no finer one, linear between voxels
  if (!seen || image->GetSpacing()[0] <= pixelsOfAVoxel * seen->pixel)
  {
    return std::nullopt;
  }
  const auto [west, east, south, north] = seen->faces;
  // Faces move by a part of a voxel when the box is read: it holds all that is seen nevertheless.
  const double* voxel = image->GetSpacing();
  const auto lower = frame.ToVolume({west - voxel[0], south - voxel[1], 0.0});
  const auto upper = frame.ToVolume({east + voxel[0], north + voxel[1], 0.0});
  BoxRequest box;
  box.faces = {lower[0], upper[0], lower[1], upper[1]};
  box.spacing = std::max(1000.0 * seen->pixel, 1.0);
  return box;
}

void RadarScene::SetMark(const std::optional<std::array<double, 4>>& faces)
{
  if (faces != markFaces)
  {
    markFaces = faces;
    this->DrawMark();
  }
}

void RadarScene::DrawMark()
{
  const auto time = detailData ? ReadVolumeInformation(detailData).time : std::nullopt;
  this->Replace(
    mark, markFaces ? MakeBoxMark(*markFaces, time, frame, this->TextSize(), theme) : SceneLayer());
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
    shown, *options.plan, scale, shownData, information.biologicalShare, options.namesOptions);
  this->Replace(plan,
    {{MakePlanLayer(shown, scale, placed, HeightOf(frame, GroundLevel::Picture), theme)}, {}});
}

// Lines and letters that lie over each other are drawn in one order, whatever was replaced last.
void RadarScene::Replace(SceneLayer& layer, SceneLayer replacement)
{
  for (const auto& prop : layer.props)
  {
    renderer->RemoveViewProp(prop);
  }
  layer = std::move(replacement);
  for (const auto& prop : layer.props)
  {
    renderer->AddViewProp(prop);
  }
  vtkPropCollection* props = renderer->GetViewProps();
  for (const SceneLayer* each : {&scales, &ground, &section, &mark, &labels, &captions})
  {
    for (const auto& prop : each->props)
    {
      props->RemoveItem(prop);
      props->AddItem(prop);
    }
  }
}

void RadarScene::DrawGround()
{
  this->Replace(
    ground, MakeMapLayer(frame, {information.sites, options.ringSpacing, options.placeNames},
              this->TextSize(), theme));
}

void RadarScene::DrawSection()
{
  const std::optional<SectionLine>& line = options.cut.section;
  this->Replace(section, line ? MakeSectionMark(*line, frame, HeightOf(frame, GroundLevel::Section),
                                  this->TextSize(), theme)
                              : SceneLayer());
}

void RadarScene::DrawScales()
{
  ScaleLayer layer = MakeScaleLayer(frame, view, options.heightWalls, this->TextSize(), theme);
  outline = std::move(layer.outline);
  this->Replace(scales, std::move(layer));
}

void RadarScene::DrawCaptions()
{
  const TextStyle style = {this->TextSize(), theme.scale, theme.rim};
  ColourBar bar = MakeColourBar(scale, size, style, theme.frame, pictures);
  right = bar.left;
  CaptionLayer layer = MakeCaptions({scale.title, note, information, ages, nothing}, size, right,
    this->TextSize(), theme, pictures);
  bar.props.insert(bar.props.end(), layer.props.begin(), layer.props.end());
  taken = std::move(layer.taken);
  overScene = layer.overScene;
  this->Replace(captions, {std::move(bar.props), {}});
}

// Labels of the scales first: they have one place each. Which radars are named goes by the zoom
// alone, so that names stay when the camera turns or moves.
void RadarScene::DrawLabels()
{
  constexpr double lettersApart = 8.0;
  std::vector<Label> all;
  for (const SceneLayer* layer : {&scales, &section, &mark, &ground})
  {
    std::copy_if(layer->labels.begin(), layer->labels.end(), std::back_inserter(all),
      [&](const Label& label) {
        return label.spread <= 0.0 ||
               this->PixelsOf(label.spread) >= lettersApart * this->TextSize();
      });
  }
  std::vector<PixelBox> boxes = taken;
  if (overScene)
  {
    boxes.push_back(*overScene);
  }
  boxes.push_back({right, 0.0, static_cast<double>(size[0]), static_cast<double>(size[1])});
  // The ground's corners come first in the outline, those in the north after those in the south.
  const auto sides = ChooseSides(all, {outline[0], outline[1], outline[3], outline[2]},
    Projection(renderer->GetActiveCamera(), size), pictures, boxes);
  SceneLayer drawn;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (sides[i])
    {
      if (all[i].dot > 0.0)
      {
        drawn.props.push_back(
          MakeMarker(all[i].point, all[i].dot, all[i].style.colour, all[i].style.rim));
      }
      drawn.props.push_back(
        pictures.Get(all[i].text, all[i].style).MakeLabel(all[i].point, *sides[i], all[i].gap));
    }
  }
  this->Replace(labels, std::move(drawn));
}

void RadarScene::Aim()
{
  if (outline.empty())
  {
    return; // before the first size, camera or volume
  }
  FrameScene(
    renderer->GetActiveCamera(), view, {outline, scales.labels}, {size, right, taken}, pictures);
  if (view.lookAt && (!view.lookAt->geographic || frame.HasMap())) // not before the first volume
  {
    const auto point = frame.ToScene(frame.PlaceOf(*view.lookAt));
    CentreOn(renderer->GetActiveCamera(), point, view.nearness);
  }
  this->FitClippingRange();
  this->DrawLabels();
}

// From the volume and its scales, which hold the rest: the ground may still be that of another
// volume, and a picture must not depend on it.
void RadarScene::FitClippingRange()
{
  vtkBoundingBox box;
  for (const auto& props :
    {std::vector<vtkSmartPointer<vtkProp>>{volume.Get()}, plan.props, scales.props})
  {
    for (const auto& prop : props)
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
