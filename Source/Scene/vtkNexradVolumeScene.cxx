// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeScene.h"

#include "Scene/DrawingSettings.h"
#include "Scene/EchoFraming.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/RadarScene.h"
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
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

using nexrad::scene::CameraView;
using nexrad::scene::EchoExtent;
using nexrad::scene::LookAt;
using nexrad::scene::RadarScene;
using nexrad::scene::SceneFrame;
using nexrad::scene::SceneOptions;

// What is asked of the scene.
struct vtkNexradVolumeScene::Settings
{
  SceneOptions options; // but what is cut away
  CameraView view;
  std::optional<std::array<double, 4>> mark; // west, east, south, north
};

// What the renderer holds.
struct vtkNexradVolumeScene::Drawing
{
  CameraView view;
  std::array<int, 2> size = {1280, 720}; // of the renderer, once it is known
  vtkImageData* volume = nullptr;        // compared, never followed
  vtkMTimeType volumeTime = 0;
  vtkMTimeType colorTime = 0;
  bool remakeColors = false;
  std::optional<EchoExtent> held; // of AddToFrame
  std::unique_ptr<RadarScene> scene;
  vtkMTimeType tried = 0; // time of the settings that the last update was for
  bool succeeded = true;

  void Update(const vtkNexradVolumeScene* self);
  void Rebuild(const vtkNexradVolumeScene* self, const SceneOptions& wanted);
  void ShowVolume(vtkImageData* newVolume);
  void HoldEcho();
  void FollowColors();
};

// Throws Error, and leaves the old scene as it is, for what the volume cannot be drawn with.
void vtkNexradVolumeScene::Drawing::Rebuild(
  const vtkNexradVolumeScene* self, const SceneOptions& wanted)
{
  vtkSmartPointer<vtkNexradTransferFunction> colors;
  std::string array;
  nexrad::scene::TextPictures letters;
  if (scene)
  {
    RadarScene::Check(wanted, self->Volume);
    if (WithColoursOf(scene->Options(), wanted) == scene->Options() && !remakeColors)
    {
      colors = scene->TransferFunction();
      array = scene->Array();
    }
    letters = scene->TakeLetters();
    scene.reset(); // it fills the same renderer
  }
  auto made = std::make_unique<RadarScene>(wanted, self->Renderer);
  made->SetLetters(std::move(letters));
  if (colors)
  {
    made->SetTransferFunction(colors, array);
  }
  made->HoldEcho(held);
  made->SetCamera(view);
  made->SetPictureSize(size);
  made->SetVolume(self->Volume);
  scene = std::move(made);
  volume = self->Volume;
  volumeTime = volume->GetMTime();
  scene->MarkBox(self->Wanted->mark);
  scene->SetDetail(self->Detail);
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

// Changes that the user made to the colours and opacities in use.
void vtkNexradVolumeScene::Drawing::FollowColors()
{
  const vtkMTimeType time = scene->TransferFunction()->GetMTime();
  if (time != colorTime)
  {
    colorTime = time;
    scene->TransferFunctionChanged();
    if (scene->Options().plan)
    {
      scene->SetVolume(volume);
    }
  }
}

void vtkNexradVolumeScene::Drawing::Update(const vtkNexradVolumeScene* self)
{
  const SceneOptions wanted = self->GetOptions();
  const CameraView& wantedView = self->Wanted->view;
  if (wantedView.lookAt)
  {
    SceneFrame(self->Volume, 1.0).PlaceOf(*wantedView.lookAt); // throws where it cannot have it
  }
  const bool sameView = wantedView == view;
  view = wantedView;
  const bool otherColors =
    scene && (remakeColors || !(WithColoursOf(scene->Options(), wanted) == scene->Options()));
  const bool otherVolume = self->Volume != volume || self->Volume->GetMTime() != volumeTime;
  if (!scene || !scene->CanFollow(wanted) || (otherColors && otherVolume))
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
    scene->SetColours(wanted);
    remakeColors = false;
  }
  scene->MarkBox(self->Wanted->mark);
  scene->SetDetail(self->Detail);
  this->FollowColors();
  scene->Follow(wanted);
  if (!sameView)
  {
    scene->SetCamera(view);
  }
}

namespace
{

const nexrad::Setting<nexrad::scene::DrawingOptions>* FindOption(const char* key)
{
  const auto* setting = nexrad::FindSetting(nexrad::scene::DrawingSettings(), key);
  const bool has = setting != nullptr && setting->use != nexrad::SettingUse::Program;
  return has ? setting : nullptr;
}

} // namespace

template <typename Held, typename Value>
void vtkNexradVolumeScene::Set(Held& held, const Value& value)
{
  if (!(held == Held(value)))
  {
    held = Held(value);
    this->Modified();
  }
}

// Settings that programs set by hand: the name, the type, where it is held, and what becomes of a
// `value`. All others are set by their keys.
#define NEXRAD_SET_AND_GET(name, type, held, wanted)                                               \
  void vtkNexradVolumeScene::Set##name(type value)                                                 \
  {                                                                                                \
    this->Set(this->Wanted->held, wanted);                                                         \
  }                                                                                                \
  type vtkNexradVolumeScene::Get##name() const                                                     \
  {                                                                                                \
    return this->Wanted->held;                                                                     \
  }
NEXRAD_SET_AND_GET(Azimuth, double, view.azimuth, value)
NEXRAD_SET_AND_GET(Tilt, double, view.tilt, std::clamp(value, -90.0, 90.0))
NEXRAD_SET_AND_GET(Zoom, double, view.zoom, std::clamp(value, 0.01, 1000.0))
NEXRAD_SET_AND_GET(ParallelProjection, bool, view.parallel, value)
NEXRAD_SET_AND_GET(Preset, std::string, options.preset, value)

nexrad::scene::DrawingOptions vtkNexradVolumeScene::Asked() const
{
  nexrad::scene::DrawingOptions asked;
  asked.camera = this->Wanted->view;
  asked.scene = this->GetOptions();
  return asked;
}

void vtkNexradVolumeScene::SetOption(const char* key, const char* text)
{
  const auto* setting = FindOption(key);
  if (setting == nullptr)
  {
    vtkErrorMacro("there is no option " << key << "; GetOptionTable lists them");
    return;
  }
  try
  {
    nexrad::scene::DrawingOptions asked = this->Asked();
    nexrad::SetText(*setting, *text == 0 ? setting->usual : text, asked);
    this->SetOptions(asked.scene);
    this->SetView(asked.camera);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
}

void vtkNexradVolumeScene::SetOption(const char* key, double number)
{
  const auto* setting = FindOption(key);
  this->SetOption(key, setting != nullptr ? setting->TextOf(number).c_str() : "");
}

std::string vtkNexradVolumeScene::GetOption(const char* key) const
{
  const auto* setting = FindOption(key);
  nexrad::scene::DrawingOptions asked = this->Asked();
  if (this->Volume != nullptr && asked.scene.cut.unit == nexrad::PlaceUnit::OfVolume)
  {
    asked.scene.cut.unit = nexrad::scene::PlaceUnitOf(this->Volume);
  }
  return setting != nullptr ? setting->text(asked) : "";
}

std::string vtkNexradVolumeScene::GetOptionTable()
{
  const auto& table = nexrad::scene::DrawingSettings();
  return nexrad::SettingsJson({table.begin(), table.end()});
}

SceneOptions vtkNexradVolumeScene::GetOptions() const
{
  SceneOptions options = this->Wanted->options;
  if (this->Cropping)
  {
    std::copy(
      std::begin(this->CropBounds), std::end(this->CropBounds), options.cut.box.emplace().begin());
  }
  if (this->Clipping)
  {
    const auto& [x, y, z] = this->ClipOrigin;
    const auto& [east, north, up] = this->ClipNormal;
    options.cut.plane = {{x, y, z}, {east, north, up}};
  }
  if (this->Section)
  {
    options.cut.section = {
      {this->SectionA[0], this->SectionA[1]}, {this->SectionB[0], this->SectionB[1]}};
  }
  return options;
}

void vtkNexradVolumeScene::SetOptions(const SceneOptions& options)
{
  this->Wanted->options = options;
  this->Wanted->options.cut = {};
  this->Wanted->options.cut.unit = options.cut.unit;
  const nexrad::scene::CutOptions& cut = options.cut;
  this->Cropping = cut.box.has_value();
  if (cut.box)
  {
    std::copy(cut.box->begin(), cut.box->end(), this->CropBounds);
  }
  this->Clipping = cut.plane.has_value();
  if (cut.plane)
  {
    std::copy(cut.plane->origin.begin(), cut.plane->origin.end(), this->ClipOrigin);
    std::copy(cut.plane->normal.begin(), cut.plane->normal.end(), this->ClipNormal);
  }
  this->Section = cut.section.has_value();
  if (cut.section)
  {
    std::copy(cut.section->from.begin(), cut.section->from.end(), this->SectionA);
    std::copy(cut.section->to.begin(), cut.section->to.end(), this->SectionB);
  }
  this->Modified();
}

void vtkNexradVolumeScene::SetView(const CameraView& view)
{
  this->Set(this->Wanted->view, view);
}

const CameraView& vtkNexradVolumeScene::GetView() const
{
  return this->Wanted->view;
}

vtkStandardNewMacro(vtkNexradVolumeScene);

vtkNexradVolumeScene::vtkNexradVolumeScene()
  : Renderer(vtkSmartPointer<vtkRenderer>::New())
  , Wanted(std::make_unique<Settings>())
  , Drawn(std::make_unique<Drawing>())
{
  this->Wanted->options.namesOptions = false;
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
  this->Set(this->Wanted->mark, std::array{west, east, south, north});
}

void vtkNexradVolumeScene::MarkNoBox()
{
  this->Set(this->Wanted->mark, std::nullopt);
}

void vtkNexradVolumeScene::AddToFrame(vtkImageData* volume)
{
  try
  {
    const std::optional<EchoExtent>& held = this->Drawn->held;
    const auto echo = nexrad::scene::MeasureEcho(volume, this->GetOptions());
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

void vtkNexradVolumeScene::SetLookAt(double x, double y, double height)
{
  this->Set(this->Wanted->view.lookAt, LookAt{{x, y, height}, false});
}

void vtkNexradVolumeScene::SetLookAtGeographic(double latitude, double longitude, double height)
{
  this->Set(this->Wanted->view.lookAt, LookAt{{longitude, latitude, height}, true});
}

void vtkNexradVolumeScene::LookAtDomain()
{
  this->Set(this->Wanted->view.lookAt, std::nullopt);
}

bool vtkNexradVolumeScene::GetLookAt(double place[3])
{
  const std::optional<LookAt>& lookAt = this->Wanted->view.lookAt;
  if (!lookAt || this->Volume == nullptr)
  {
    return false;
  }
  const SceneFrame frame(this->Volume, 1.0);
  if (lookAt->geographic && !frame.HasMap())
  {
    return false;
  }
  const std::array<double, 3> found = frame.PlaceOf(*lookAt);
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

// The newest of the settings, the volume, and the colours and opacities in use.
vtkMTimeType vtkNexradVolumeScene::TimeOfSettings()
{
  auto* colors = this->GetTransferFunction();
  return std::max({this->GetMTime(), this->Volume->GetMTime(),
    colors != nullptr ? colors->GetMTime() : vtkMTimeType(0)});
}

void vtkNexradVolumeScene::Draw()
{
  if (this->Volume == nullptr)
  {
    this->Drawn = std::make_unique<Drawing>();
    return;
  }
  this->FollowSize();
  this->Drawn->succeeded = false;
  this->Drawn->tried = this->TimeOfSettings();
  this->Drawn->Update(this);
  this->Drawn->succeeded = true;
  this->Drawn->tried = this->TimeOfSettings(); // of other colours, perhaps
}

bool vtkNexradVolumeScene::Update()
{
  if (this->Volume != nullptr && this->TimeOfSettings() == this->Drawn->tried)
  {
    return this->Drawn->succeeded; // an error is reported once
  }
  try
  {
    this->Draw();
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
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
    this->Drawn->scene->BeginFrame(); // a scene that is made now does not hear of this frame
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
  for (const auto& setting : nexrad::scene::DrawingSettings())
  {
    os << indent << setting.key << ": " << this->GetOption(setting.key.c_str()) << "\n";
  }
  os << indent << "MarksBox: " << this->Wanted->mark.has_value() << "\n";
  os << indent << "LooksAtPlace: " << this->Wanted->view.lookAt.has_value() << "\n";
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
