// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeScene.h"

#include "Scene/DrawingSettings.h"
#include "Scene/EchoFraming.h"
#include "Scene/EchoSearch.h"
#include "Scene/Frame/PictureLayout.h"
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
using nexrad::scene::SceneContents;
using nexrad::scene::SceneFrame;
using nexrad::scene::SceneOptions;

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
  if (this->Wanted->volume != nullptr && asked.scene.cut.unit == nexrad::PlaceUnit::OfVolume)
  {
    asked.scene.cut.unit = nexrad::scene::PlaceUnitOf(this->Wanted->volume);
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
  , Wanted(std::make_unique<SceneContents>())
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
  this->Drawn.reset();
  this->Tried = 0;
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
  this->Set(this->Wanted->volume, volume);
}

vtkImageData* vtkNexradVolumeScene::GetVolume() const
{
  return this->Wanted->volume;
}

void vtkNexradVolumeScene::SetDetail(vtkImageData* detail)
{
  this->Set(this->Wanted->detail, detail);
}

vtkImageData* vtkNexradVolumeScene::GetDetail() const
{
  return this->Wanted->detail;
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
    const std::optional<EchoExtent>& held = this->Wanted->held;
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

std::optional<nexrad::BoxRequest> vtkNexradVolumeScene::SeenBox() const
{
  return this->Drawn ? this->Drawn->SeenBox() : std::nullopt;
}

void vtkNexradVolumeScene::HoldEcho(const std::optional<EchoExtent>& echo)
{
  this->Wanted->held = echo;
  if (this->Drawn)
  {
    this->Drawn->HoldEcho(echo);
  }
  this->Modified();
}

const SceneFrame* vtkNexradVolumeScene::GetSceneFrame() const
{
  return this->Drawn ? &this->Drawn->Frame() : nullptr;
}

vtkNexradTransferFunction* vtkNexradVolumeScene::GetTransferFunction() const
{
  return this->Drawn ? this->Drawn->TransferFunction() : nullptr;
}

void vtkNexradVolumeScene::ResetTransferFunction()
{
  if (this->Drawn)
  {
    this->Drawn->ResetColours();
  }
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
  if (!lookAt || this->Wanted->volume == nullptr)
  {
    return false;
  }
  const SceneFrame frame(this->Wanted->volume, 1.0);
  const bool has = !lookAt->geographic || frame.HasMap();
  if (has)
  {
    const std::array<double, 3> found = frame.PlaceOf(*lookAt);
    std::copy(found.begin(), found.end(), place);
  }
  return has;
}

bool vtkNexradVolumeScene::GetLookAtGeographic(double place[3])
{
  double found[3];
  if (!this->GetLookAt(found))
  {
    return false;
  }
  const SceneFrame frame(this->Wanted->volume, 1.0);
  if (frame.HasMap())
  {
    const std::array<double, 2> point = frame.FromVolume({found[0], found[1]});
    const std::array<double, 2> geographic = frame.Geographic(point[0], point[1]);
    place[0] = geographic[1];
    place[1] = geographic[0];
    place[2] = found[2];
  }
  return frame.HasMap();
}

bool vtkNexradVolumeScene::FindGround(double pixelX, double pixelY, double point[2])
{
  if (!this->Drawn)
  {
    return false;
  }
  const int* size = this->Renderer->GetSize();
  const nexrad::scene::ViewRay ray =
    nexrad::scene::RayThrough(this->Camera, {size[0], size[1]}, {pixelX, pixelY});
  const SceneFrame& frame = this->Drawn->Frame();
  const auto distance = nexrad::scene::DistanceToHeight(ray, frame.Bounds()[4]);
  if (distance)
  {
    const std::array<double, 3> place = frame.ToVolume(ray.At(*distance));
    std::copy_n(place.begin(), 2, point);
  }
  return distance.has_value();
}

bool vtkNexradVolumeScene::FindPixel(double x, double y, double pixel[2])
{
  if (this->Drawn)
  {
    const int* size = this->Renderer->GetSize();
    const SceneFrame& frame = this->Drawn->Frame();
    const auto [sceneX, sceneY] = frame.FromVolume({x, y});
    const auto found = nexrad::scene::Projection(this->Camera, {size[0], size[1]})(
      {sceneX, sceneY, frame.Bounds()[4]});
    std::copy(found.begin(), found.end(), pixel);
  }
  return this->Drawn != nullptr;
}

bool vtkNexradVolumeScene::VolumeToScene(const double point[3], double scenePoint[3])
{
  if (this->Drawn)
  {
    const auto place = this->Drawn->Frame().ToScene({point[0], point[1], point[2]});
    std::copy(place.begin(), place.end(), scenePoint);
  }
  return this->Drawn != nullptr;
}

bool vtkNexradVolumeScene::GetFrameBounds(double bounds[6])
{
  if (this->Drawn)
  {
    const auto framed = this->Drawn->Frame().FramedInVolume();
    std::copy(framed.begin(), framed.end(), bounds);
  }
  return this->Drawn != nullptr;
}

bool vtkNexradVolumeScene::SceneToVolume(const double scenePoint[3], double point[3])
{
  if (this->Drawn)
  {
    const auto place = this->Drawn->Frame().ToVolume({scenePoint[0], scenePoint[1], scenePoint[2]});
    std::copy(place.begin(), place.end(), point);
  }
  return this->Drawn != nullptr;
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
  return std::max({this->GetMTime(), this->Wanted->volume->GetMTime(),
    colors != nullptr ? colors->GetMTime() : vtkMTimeType(0)});
}

void vtkNexradVolumeScene::Draw()
{
  this->Succeeded = false;
  if (this->Wanted->volume == nullptr)
  {
    this->Drawn.reset();
    this->Succeeded = true;
    return;
  }
  this->Tried = this->TimeOfSettings();
  SceneContents contents = *this->Wanted;
  contents.options = this->GetOptions();
  if (this->Drawn && this->Drawn->CanFollow(contents))
  {
    this->Drawn->FollowSize();
    this->Drawn->Follow(contents);
  }
  else
  {
    this->Drawn = std::make_unique<RadarScene>(contents, this->Renderer, this->Drawn);
  }
  this->Succeeded = true;
  this->Tried = this->TimeOfSettings(); // of other colours, perhaps
}

bool vtkNexradVolumeScene::Update()
{
  if (this->Wanted->volume != nullptr && this->TimeOfSettings() == this->Tried)
  {
    return this->Succeeded; // an error is reported once
  }
  try
  {
    this->Draw();
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
  return this->Succeeded;
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
  this->Update();
  if (this->Drawn)
  {
    this->Drawn->FollowSize();
    this->Drawn->BeginFrame();
  }
  if (drawn != this->Camera && this->Camera->GetMTime() != before)
  {
    drawn->DeepCopy(this->Camera);
    drawn->SetViewAngle(angle * this->Camera->GetViewAngle());
    drawn->SetParallelScale(scale * this->Camera->GetParallelScale());
  }
  this->Renderer->SetActiveCamera(drawn);
}

void vtkNexradVolumeScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.Get() << "\n";
  os << indent << "Volume: " << this->Wanted->volume.Get() << "\n";
  os << indent << "Detail: " << this->Wanted->detail.Get() << "\n";
  for (const auto& setting : nexrad::scene::DrawingSettings())
  {
    os << indent << setting.key << ": " << this->GetOption(setting.key.c_str()) << "\n";
  }
  os << indent << "MarksBox: " << this->Wanted->mark.has_value() << "\n";
  os << indent << "LooksAtPlace: " << this->Wanted->view.lookAt.has_value() << "\n";
}
