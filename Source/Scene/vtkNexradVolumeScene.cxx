// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeScene.h"

#include "Scene/EchoFraming.h"
#include "Scene/RadarScene.h"
#include "Scene/SceneSettings.h"
#include "nexrad/System/Error.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNexradTransferFunction.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

using nexrad::scene::CameraView;
using nexrad::scene::EchoExtent;
using nexrad::scene::LightOptions;
using nexrad::scene::LookAt;
using nexrad::scene::RadarScene;
using nexrad::scene::SceneFrame;
using nexrad::scene::SceneOptions;

namespace
{

bool SameColors(const SceneOptions& a, const SceneOptions& b)
{
  return a.preset == b.preset && a.colours == b.colours && a.opacities == b.opacities &&
         a.isoValues == b.isoValues && a.colourBy == b.colourBy;
}

bool SamePlan(const SceneOptions& a, const SceneOptions& b)
{
  return a.plan.has_value() == b.plan.has_value() &&
         (!a.plan || (a.plan->level == b.plan->level && a.plan->height == b.plan->height &&
                       a.plan->array == b.plan->array && a.plan->threshold == b.plan->threshold));
}

bool SameLight(const LightOptions& a, const LightOptions& b)
{
  return a.shadow == b.shadow && a.occlusion == b.occlusion &&
         a.direction.azimuth == b.direction.azimuth &&
         a.direction.elevation == b.direction.elevation;
}

// The number of slices, the light, what is cut away and the colours of the moment that is shown can
// be changed in a scene that is there: its volume stays in texture memory.
bool SameButForWhatCanChange(const SceneOptions& a, const SceneOptions& b)
{
  return a.colourBy == b.colourBy && (a.colourBy.empty() || SameColors(a, b)) && SamePlan(a, b) &&
         a.exaggeration == b.exaggeration && a.framing == b.framing &&
         a.opacityDistance == b.opacityDistance && a.mapper == b.mapper &&
         a.preIntegration == b.preIntegration && a.linearInterpolation == b.linearInterpolation &&
         a.ringSpacing == b.ringSpacing && a.theme == b.theme && a.heightWalls == b.heightWalls &&
         a.placeNames == b.placeNames;
}

bool SamePlace(const std::optional<LookAt>& a, const std::optional<LookAt>& b)
{
  return a.has_value() == b.has_value() &&
         (!a || (a->place == b->place && a->geographic == b->geographic));
}

bool SameView(const CameraView& a, const CameraView& b)
{
  return a.azimuth == b.azimuth && a.tilt == b.tilt && a.zoom == b.zoom &&
         a.parallel == b.parallel && SamePlace(a.lookAt, b.lookAt);
}

} // namespace

// What the renderer holds, and the settings that it was made with.
struct vtkNexradVolumeScene::Drawing
{
  SceneOptions options;
  CameraView view;
  std::array<int, 2> size = {1280, 720}; // of the renderer, once it is known
  vtkImageData* volume = nullptr;        // compared, never followed
  vtkMTimeType volumeTime = 0;
  vtkSmartPointer<vtkImageData> detail;
  std::optional<std::array<double, 4>> mark;
  vtkMTimeType colorTime = 0;
  bool remakeColors = false;
  std::optional<EchoExtent> held; // of AddToFrame
  std::unique_ptr<RadarScene> scene;
  vtkMTimeType tried = 0; // time of the settings that the last update was for
  bool succeeded = true;

  void Update(vtkNexradVolumeScene* self);
  static SceneOptions OptionsOf(vtkNexradVolumeScene* self);
  static CameraView ViewOf(const vtkNexradVolumeScene* self);
  void Rebuild(vtkNexradVolumeScene* self, const SceneOptions& wanted);
  void ShowVolume(vtkImageData* newVolume);
  void HoldEcho();
  void MakeColors(const SceneOptions& wanted);
  void FollowColors();
  void FollowBox(const vtkNexradVolumeScene* self, bool anew);
};

SceneOptions vtkNexradVolumeScene::Drawing::OptionsOf(vtkNexradVolumeScene* self)
{
  SceneOptions options = nexrad::scene::SettingsOf(self);
  options.namesOptions = false;
  for (const std::array<double, 2>& isoValue : self->IsoValues)
  {
    options.isoValues.push_back(
      {isoValue[0], isoValue[1] < 0.0 ? std::nullopt : std::optional(isoValue[1])});
  }
  return options;
}

// Throws Error for a place that the volume cannot have.
CameraView vtkNexradVolumeScene::Drawing::ViewOf(const vtkNexradVolumeScene* self)
{
  CameraView view{self->Azimuth, self->Tilt, self->Zoom, self->ParallelProjection, {}};
  if (self->LooksAtPlace)
  {
    view.lookAt = LookAt{{self->Place[0], self->Place[1], self->Place[2]}, self->PlaceIsGeographic};
    SceneFrame(self->Volume, 1.0).PlaceOf(*view.lookAt);
  }
  return view;
}

// An error leaves the old scene as it is.
void vtkNexradVolumeScene::Drawing::Rebuild(vtkNexradVolumeScene* self, const SceneOptions& wanted)
{
  RadarScene::Check(wanted, self->Volume);
  vtkSmartPointer<vtkNexradTransferFunction> colors;
  std::string array;
  if (scene && SameColors(wanted, options) && !remakeColors)
  {
    colors = scene->TransferFunction();
    array = scene->Array();
  }
  nexrad::scene::TextPictures letters;
  if (scene)
  {
    letters = scene->TakeLetters();
  }
  scene.reset();
  scene = std::make_unique<RadarScene>(wanted, self->Renderer);
  scene->SetLetters(std::move(letters));
  if (colors)
  {
    scene->SetTransferFunction(colors, array);
  }
  scene->HoldEcho(held);
  scene->SetCamera(view);
  scene->SetPictureSize(size);
  this->ShowVolume(self->Volume);
  this->FollowBox(self, true);
  options = wanted;
  remakeColors = false;
  colorTime = scene->TransferFunction()->GetMTime();
}

void vtkNexradVolumeScene::Drawing::ShowVolume(vtkImageData* newVolume)
{
  scene->SetVolume(newVolume);
  volume = newVolume;
  volumeTime = newVolume->GetMTime();
}

void vtkNexradVolumeScene::Drawing::HoldEcho()
{
  volume = nullptr; // shown again, within the other frame
  if (scene)
  {
    scene->HoldEcho(held);
  }
}

void vtkNexradVolumeScene::Drawing::MakeColors(const SceneOptions& wanted)
{
  scene->SetColours(wanted);
  options.preset = wanted.preset;
  options.colours = wanted.colours;
  options.opacities = wanted.opacities;
  options.isoValues = wanted.isoValues;
  remakeColors = false;
}

// The finer volume, and the edges of a box. `anew`: the scene has neither of them.
void vtkNexradVolumeScene::Drawing::FollowBox(const vtkNexradVolumeScene* self, bool anew)
{
  const double* faces = self->MarkedFaces;
  const std::optional<std::array<double, 4>> wanted =
    self->MarksBox ? std::optional(std::array<double, 4>{faces[0], faces[1], faces[2], faces[3]})
                   : std::nullopt;
  if (anew || mark != wanted)
  {
    mark = wanted;
    scene->MarkBox(mark);
  }
  if (anew || detail != self->Detail)
  {
    scene->SetDetail(self->Detail);
    detail = self->Detail;
  }
}

// Changes that the user made to the colours and opacities in use.
void vtkNexradVolumeScene::Drawing::FollowColors()
{
  const vtkMTimeType time = scene->TransferFunction()->GetMTime();
  if (time != colorTime)
  {
    colorTime = time;
    scene->TransferFunctionChanged();
    if (options.plan)
    {
      scene->SetVolume(volume);
    }
  }
}

void vtkNexradVolumeScene::Drawing::Update(vtkNexradVolumeScene* self)
{
  const SceneOptions wanted = OptionsOf(self);
  const CameraView camera = ViewOf(self);
  const bool sameView = SameView(camera, view);
  view = camera;
  const bool otherColors = remakeColors || (scene && !SameColors(wanted, options));
  const bool otherVolume = self->Volume != volume || self->Volume->GetMTime() != volumeTime;
  if (!scene || !SameButForWhatCanChange(wanted, options) || (otherColors && otherVolume))
  {
    this->Rebuild(self, wanted); // another volume may be of another moment, with other presets
    return;
  }
  if (otherVolume)
  {
    this->ShowVolume(self->Volume);
  }
  if (otherColors)
  {
    this->MakeColors(wanted);
  }
  this->FollowBox(self, false);
  this->FollowColors();
  if (wanted.slices != options.slices)
  {
    scene->SetSlices(wanted.slices);
    options.slices = wanted.slices;
  }
  if (!SameLight(wanted.light, options.light))
  {
    scene->SetLight(wanted.light);
    options.light = wanted.light;
  }
  if (wanted.cut != options.cut)
  {
    scene->SetCut(wanted.cut);
    options.cut = wanted.cut;
  }
  if (!sameView)
  {
    scene->SetCamera(view);
  }
}

vtkStandardNewMacro(vtkNexradVolumeScene);

vtkNexradVolumeScene::vtkNexradVolumeScene()
  : Renderer(vtkSmartPointer<vtkRenderer>::New())
  , Drawn(std::make_unique<Drawing>())
{
  this->ObserveRenderer();
}

vtkNexradVolumeScene::~vtkNexradVolumeScene()
{
  this->ForgetRenderer();
}

void vtkNexradVolumeScene::ObserveRenderer()
{
  this->Camera = this->Renderer->GetActiveCamera();
  this->RendererTag = this->Renderer->AddObserver(
    vtkCommand::StartEvent, this, &vtkNexradVolumeScene::FollowRendering);
}

void vtkNexradVolumeScene::ForgetRenderer()
{
  this->Drawn = std::make_unique<Drawing>();
  this->Renderer->RemoveObserver(this->RendererTag);
}

void vtkNexradVolumeScene::SetRenderer(vtkRenderer* renderer)
{
  if (renderer == this->Renderer)
  {
    return;
  }
  this->ForgetRenderer();
  this->Renderer = renderer;
  if (renderer == nullptr)
  {
    this->Renderer = vtkSmartPointer<vtkRenderer>::New();
  }
  this->ObserveRenderer();
  this->Modified();
}

vtkRenderer* vtkNexradVolumeScene::GetRenderer() const
{
  return this->Renderer;
}

void vtkNexradVolumeScene::SetVolume(vtkImageData* volume)
{
  if (volume != this->Volume)
  {
    this->Volume = volume;
    this->Modified();
  }
}

vtkImageData* vtkNexradVolumeScene::GetVolume() const
{
  return this->Volume;
}

void vtkNexradVolumeScene::SetDetail(vtkImageData* detail)
{
  if (detail != this->Detail)
  {
    this->Detail = detail;
    this->Modified();
  }
}

vtkImageData* vtkNexradVolumeScene::GetDetail() const
{
  return this->Detail;
}

void vtkNexradVolumeScene::MarkBox(double west, double east, double south, double north)
{
  const std::array<double, 4> faces = {west, east, south, north};
  if (!this->MarksBox || !std::equal(faces.begin(), faces.end(), this->MarkedFaces))
  {
    this->MarksBox = true;
    std::copy(faces.begin(), faces.end(), this->MarkedFaces);
    this->Modified();
  }
}

void vtkNexradVolumeScene::MarkNoBox()
{
  if (this->MarksBox)
  {
    this->MarksBox = false;
    this->Modified();
  }
}

void vtkNexradVolumeScene::SetRingSpacing(double spacing)
{
  if (!(spacing == 0.0 || spacing >= 1000.0))
  {
    vtkErrorMacro("ring spacing " << spacing << ": set 0 for no rings, or at least 1000 m");
    return;
  }
  if (this->RingSpacing != spacing)
  {
    this->RingSpacing = spacing;
    this->Modified();
  }
}

void vtkNexradVolumeScene::AddIsoValue(double value, double opacity)
{
  if (!std::isfinite(value) || !(opacity <= 1.0))
  {
    vtkErrorMacro("iso-value " << value << " of opacity " << opacity
                               << ": set a finite value, and an opacity up to 1");
    return;
  }
  this->IsoValues.push_back({value, opacity});
  this->Modified();
}

void vtkNexradVolumeScene::RemoveAllIsoValues()
{
  if (!this->IsoValues.empty())
  {
    this->IsoValues.clear();
    this->Modified();
  }
}

void vtkNexradVolumeScene::AddToFrame(vtkImageData* volume)
{
  try
  {
    const std::optional<EchoExtent>& held = this->Drawn->held;
    const auto echo = nexrad::scene::MeasureEcho(volume, Drawing::OptionsOf(this));
    this->HoldEcho(held && echo ? nexrad::scene::Join(*held, *echo) : (echo ? echo : held));
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
}

void vtkNexradVolumeScene::ClearFrame()
{
  this->HoldEcho(std::nullopt);
}

void vtkNexradVolumeScene::HoldEcho(const std::optional<EchoExtent>& echo)
{
  this->Drawn->held = echo;
  this->Drawn->HoldEcho();
  this->Modified();
}

const SceneFrame* vtkNexradVolumeScene::GetSceneFrame() const
{
  return this->Drawn->scene ? &this->Drawn->scene->Frame() : nullptr;
}

vtkNexradTransferFunction* vtkNexradVolumeScene::GetTransferFunction() const
{
  return this->Drawn->scene ? this->Drawn->scene->TransferFunction() : nullptr;
}

void vtkNexradVolumeScene::ResetTransferFunction()
{
  this->Drawn->remakeColors = true;
  this->Modified();
}

void vtkNexradVolumeScene::SetPlace(bool geographic, double x, double y, double height)
{
  if (!this->LooksAtPlace || this->PlaceIsGeographic != geographic || this->Place[0] != x ||
      this->Place[1] != y || this->Place[2] != height)
  {
    this->LooksAtPlace = true;
    this->PlaceIsGeographic = geographic;
    this->Place[0] = x;
    this->Place[1] = y;
    this->Place[2] = height;
    this->Modified();
  }
}

void vtkNexradVolumeScene::SetLookAt(double x, double y, double height)
{
  this->SetPlace(false, x, y, height);
}

void vtkNexradVolumeScene::SetLookAtGeographic(double latitude, double longitude, double height)
{
  this->SetPlace(true, longitude, latitude, height);
}

void vtkNexradVolumeScene::LookAtDomain()
{
  if (this->LooksAtPlace)
  {
    this->LooksAtPlace = false;
    this->Modified();
  }
}

bool vtkNexradVolumeScene::GetLookAt(double place[3])
{
  if (!this->LooksAtPlace || this->Volume == nullptr)
  {
    return false;
  }
  const SceneFrame frame(this->Volume, 1.0);
  if (this->PlaceIsGeographic && !frame.HasMap())
  {
    return false;
  }
  const std::array<double, 3> found =
    frame.PlaceOf({{this->Place[0], this->Place[1], this->Place[2]}, this->PlaceIsGeographic});
  std::copy(found.begin(), found.end(), place);
  return true;
}

bool vtkNexradVolumeScene::GetLookAtGeographic(double place[3])
{
  std::array<double, 3> found{};
  if (!this->GetLookAt(found.data()))
  {
    return false;
  }
  const SceneFrame frame(this->Volume, 1.0);
  if (!frame.HasMap())
  {
    return false;
  }
  const std::array<double, 3> point = frame.ToScene(found);
  const std::array<double, 2> geographic = frame.Geographic(point[0], point[1]);
  place[0] = geographic[1];
  place[1] = geographic[0];
  place[2] = found[2];
  return true;
}

bool vtkNexradVolumeScene::FindGround(double pixelX, double pixelY, double point[2])
{
  const auto found =
    this->Drawn->scene ? this->Drawn->scene->GroundAt({pixelX, pixelY}) : std::nullopt;
  if (found)
  {
    std::copy(found->begin(), found->end(), point);
  }
  return found.has_value();
}

bool vtkNexradVolumeScene::FindPixel(double x, double y, double pixel[2])
{
  if (this->Drawn->scene)
  {
    const auto found = this->Drawn->scene->PixelOf({x, y});
    std::copy(found.begin(), found.end(), pixel);
  }
  return this->Drawn->scene != nullptr;
}

bool vtkNexradVolumeScene::VolumeToScene(const double point[3], double scenePoint[3])
{
  if (this->Drawn->scene)
  {
    const auto place = this->Drawn->scene->Frame().ToScene({point[0], point[1], point[2]});
    std::copy(place.begin(), place.end(), scenePoint);
  }
  return this->Drawn->scene != nullptr;
}

bool vtkNexradVolumeScene::GetFrameBounds(double bounds[6])
{
  if (this->Drawn->scene)
  {
    const auto framed = this->Drawn->scene->Frame().FramedInVolume();
    std::copy(framed.begin(), framed.end(), bounds);
  }
  return this->Drawn->scene != nullptr;
}

bool vtkNexradVolumeScene::SceneToVolume(const double scenePoint[3], double point[3])
{
  if (this->Drawn->scene)
  {
    const auto place =
      this->Drawn->scene->Frame().ToVolume({scenePoint[0], scenePoint[1], scenePoint[2]});
    std::copy(place.begin(), place.end(), point);
  }
  return this->Drawn->scene != nullptr;
}

void vtkNexradVolumeScene::SetCameraFromAbove()
{
  this->SetAzimuth(180.0);
  this->SetTilt(90.0);
  this->ParallelProjectionOn();
}

bool vtkNexradVolumeScene::Update()
{
  if (this->Volume == nullptr)
  {
    this->Drawn = std::make_unique<Drawing>();
    return true;
  }
  vtkMTimeType time = std::max(this->GetMTime(), this->Volume->GetMTime());
  if (auto* colors = this->GetTransferFunction())
  {
    time = std::max(time, colors->GetMTime());
  }
  if (time == this->Drawn->tried)
  {
    return this->Drawn->succeeded; // an error is reported once
  }
  try
  {
    this->Drawn->Update(this);
    this->Drawn->succeeded = true;
  }
  catch (const std::exception& error)
  {
    this->Drawn->succeeded = false;
    vtkErrorMacro(<< error.what());
  }
  this->Drawn->tried =
    std::max(time, this->GetTransferFunction() != nullptr ? this->GetTransferFunction()->GetMTime()
                                                          : vtkMTimeType(0));
  return this->Drawn->succeeded;
}

void vtkNexradVolumeScene::FollowRendering()
{
  // vtkWindowToImageFilter draws with a copy of the camera, narrowed to a tile of the picture, and
  // throws the copy away afterwards.
  const vtkSmartPointer<vtkCamera> drawn = this->Renderer->GetActiveCamera();
  this->Renderer->SetActiveCamera(this->Camera);
  const vtkMTimeType before = this->Camera->GetMTime();
  const double angle = drawn->GetViewAngle() / this->Camera->GetViewAngle();
  const double scale = drawn->GetParallelScale() / this->Camera->GetParallelScale();
  this->FollowSize();
  this->Update();
  if (this->Drawn->scene)
  {
    this->Drawn->scene->UpdateShadows(); // a scene that is made now does not hear of this frame
  }
  if (drawn != this->Camera && this->Camera->GetMTime() != before)
  {
    drawn->DeepCopy(this->Camera);
    drawn->SetViewAngle(angle * this->Camera->GetViewAngle());
    drawn->SetParallelScale(scale * this->Camera->GetParallelScale());
  }
  this->Renderer->SetActiveCamera(drawn);
}

void vtkNexradVolumeScene::FollowSize()
{
  const int* rendererSize = this->Renderer->GetSize();
  const std::array<int, 2> size = {rendererSize[0], rendererSize[1]};
  const bool resized = size != this->Drawn->size && size[0] > 0 && size[1] > 0;
  if (resized)
  {
    this->Drawn->size = size;
    if (this->Drawn->scene)
    {
      this->Drawn->scene->SetPictureSize(size);
    }
  }
}

void vtkNexradVolumeScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.Get() << "\n";
  os << indent << "Volume: " << this->Volume.Get() << "\n";
  os << indent << "Detail: " << this->Detail.Get() << "\n";
  os << indent << "MarksBox: " << this->MarksBox << "\n";
  os << indent << "Azimuth: " << this->Azimuth << "\n";
  os << indent << "Tilt: " << this->Tilt << "\n";
  os << indent << "Zoom: " << this->Zoom << "\n";
  os << indent << "ParallelProjection: " << this->ParallelProjection << "\n";
  os << indent << "LookAt: ";
  if (this->LooksAtPlace)
  {
    os << this->Place[0] << ", " << this->Place[1] << ", " << this->Place[2]
       << (this->PlaceIsGeographic ? " (longitude, latitude, m)\n" : " (of the volume)\n");
  }
  else
  {
    os << "the domain\n";
  }
  os << indent << "Preset: " << this->Preset << "\n";
  os << indent << "ColorFileName: " << this->ColorFileName << "\n";
  os << indent << "OpacityFileName: " << this->OpacityFileName << "\n";
  os << indent << "IsoValues:";
  for (const std::array<double, 2>& isoValue : this->IsoValues)
  {
    os << " " << isoValue[0] << ":" << isoValue[1];
  }
  os << "\n";
  os << indent << "ColorArray: " << this->ColorArray << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
  os << indent << "Framing: " << this->Framing << "\n";
  os << indent << "OpacityDistance: " << this->OpacityDistance << "\n";
  os << indent << "Mapper: " << this->Mapper << "\n";
  os << indent << "PreIntegration: " << (this->PreIntegration ? "On" : "Off") << "\n";
  os << indent << "LinearInterpolation: " << (this->LinearInterpolation ? "On" : "Off") << "\n";
  os << indent << "NumberOfSlices: " << this->NumberOfSlices << "\n";
  os << indent << "ShadowStrength: " << this->ShadowStrength << "\n";
  os << indent << "OcclusionStrength: " << this->OcclusionStrength << "\n";
  os << indent << "LightAzimuth: " << this->LightAzimuth << "\n";
  os << indent << "LightElevation: " << this->LightElevation << "\n";
  os << indent << "RingSpacing: " << this->RingSpacing << "\n";
  os << indent << "Theme: " << this->Theme << "\n";
  os << indent << "HeightWalls: " << this->HeightWalls << "\n";
  os << indent << "PlaceNames: " << this->PlaceNames << "\n";
  os << indent << "Plan: " << this->Plan << "\n";
  os << indent << "PlanHeight: " << this->PlanHeight << "\n";
  os << indent << "EchoTopThreshold: " << this->EchoTopThreshold << "\n";
  os << indent << "PlanArray: " << this->PlanArray << "\n";
  os << indent << "Cropping: " << (this->Cropping ? "On" : "Off") << "\n";
  os << indent << "CropBounds:";
  for (const double bound : this->CropBounds)
  {
    os << " " << bound;
  }
  os << "\n";
  os << indent << "Clipping: " << (this->Clipping ? "On" : "Off") << "\n";
  os << indent << "ClipOrigin: " << this->ClipOrigin[0] << " " << this->ClipOrigin[1] << " "
     << this->ClipOrigin[2] << "\n";
  os << indent << "ClipNormal: " << this->ClipNormal[0] << " " << this->ClipNormal[1] << " "
     << this->ClipNormal[2] << "\n";
  os << indent << "Section: " << (this->Section ? "On" : "Off") << "\n";
  os << indent << "SectionA: " << this->SectionA[0] << " " << this->SectionA[1] << "\n";
  os << indent << "SectionB: " << this->SectionB[0] << " " << this->SectionB[1] << "\n";
}
