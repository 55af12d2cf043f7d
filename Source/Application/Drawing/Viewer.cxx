// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Viewer.h"

#include "Drawing/PictureWindow.h"
#include "Drawing/ViewerStyle.h"
#include "Libraries/VtkErrors.h"
#include "Output/Counted.h"
#include "Scene/Elements/SceneText.h"

#include "nexrad/System/Error.h"
#include "vtkNexradTransferFunction.h"

#include <vtkCallbackCommand.h>
#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace nexrad::scene
{
namespace
{

constexpr std::array<double, 2> keysPlace = {0.02, 0.56};
constexpr std::array<double, 2> statusPlace = {0.42, 0.045};

constexpr Duration shortestInterval = std::chrono::milliseconds(16);
constexpr Duration longestInterval = std::chrono::seconds(8);
constexpr int fewestSlices = 16;
constexpr int mostSlices = 4096;
constexpr double leastIsoValue = -20.0; // dBZ
constexpr double mostIsoValue = 75.0;   // dBZ

} // namespace

/// A key of the viewer: what it is called, what it does.
struct Viewer::Key
{
  std::vector<std::string> symbols;
  std::string name; ///< on screen; empty: not shown
  std::string does;
  void (*act)(Viewer& viewer);
};

const std::vector<Viewer::Key>& Viewer::Keys()
{
  static const std::vector<Key> keys = {
    {{"space"}, "space", "play, pause", [](Viewer& v) { v.Play(!v.playing); }},
    {{"Left"}, "left, right", "one step back, on", [](Viewer& v) { v.Step(-1); }},
    {{"Right"}, "", "", [](Viewer& v) { v.Step(1); }},
    {{"Down"}, "down, up", "slower, faster", [](Viewer& v) { v.ScaleInterval(2.0); }},
    {{"Up"}, "", "", [](Viewer& v) { v.ScaleInterval(0.5); }},
    {{"bracketleft"}, "[ ]", "fewer, more slices", [](Viewer& v) { v.ScaleSlices(0.5); }},
    {{"bracketright"}, "", "", [](Viewer& v) { v.ScaleSlices(2.0); }},
    {{"1"}, "1 to 6", "presets of colour and opacity", [](Viewer& v) { v.ApplyPreset(0); }},
    {{"2"}, "", "", [](Viewer& v) { v.ApplyPreset(1); }},
    {{"3"}, "", "", [](Viewer& v) { v.ApplyPreset(2); }},
    {{"4"}, "", "", [](Viewer& v) { v.ApplyPreset(3); }},
    {{"5"}, "", "", [](Viewer& v) { v.ApplyPreset(4); }},
    {{"6"}, "", "", [](Viewer& v) { v.ApplyPreset(5); }},
    {{"i"}, "i", "one iso-value alone", [](Viewer& v) { v.MoveIsoValue(0.0); }},
    {{"comma"}, ", .", "iso-value 5 dBZ lower, higher", [](Viewer& v) { v.MoveIsoValue(-5.0); }},
    {{"period"}, "", "", [](Viewer& v) { v.MoveIsoValue(5.0); }},
    {{"plus", "KP_Add"}, "+ -", "nearer, farther (or the wheel)", [](Viewer& v) { v.Zoom(1.25); }},
    {{"minus", "KP_Subtract"}, "", "", [](Viewer& v) { v.Zoom(0.8); }},
    {{"a"}, "a d w x", "turn, tilt (or the mouse)", [](Viewer& v) { v.Turn(-15.0, 0.0); }},
    {{"d"}, "", "", [](Viewer& v) { v.Turn(15.0, 0.0); }},
    {{"w"}, "", "", [](Viewer& v) { v.Turn(0.0, 10.0); }},
    {{"x"}, "", "", [](Viewer& v) { v.Turn(0.0, -10.0); }},
    {{"r"}, "r", "the camera as it was at first",
      [](Viewer& v)
      {
        v.camera = v.options.camera;
        v.Turn(0.0, 0.0);
      }},
    {{"s"}, "s", "write a picture", [](Viewer& v) { v.WritePicture(); }},
    {{"h"}, "h", "hide or show these keys",
      [](Viewer& v)
      {
        v.help = !v.help;
        v.Draw();
      }},
    {{"q", "Escape"}, "q", "quit", [](Viewer& v) { v.interactor->TerminateApp(); }},
  };
  return keys;
}

Viewer::Viewer(RadarSession& shownSession, const Options& viewerOptions)
  : session(shownSession)
  , options(viewerOptions)
  , camera(viewerOptions.camera)
  , style(vtkSmartPointer<ViewerStyle>::New())
{
  RequireDisplay();
  std::string text;
  for (const Key& key : Keys())
  {
    text += key.name.empty() ? "" : key.name + "    " + key.does + "\n";
  }
  const Colour& letters = session.Scene().GetTheme().note;
  keysCaption = MakeCaption(text, keysPlace, 14, letters, LabelSide::Right);
  keysCaption->GetTextProperty()->SetVerticalJustificationToTop();
  keysCaption->GetTextProperty()->SetLineSpacing(1.3);
  statusCaption = MakeCaption("", statusPlace, 14, letters, LabelSide::Right);
  vtkRenderer* renderer = session.Scene().GetRenderer();
  renderer->AddViewProp(keysCaption);
  renderer->AddViewProp(statusCaption);
  window->SetMultiSamples(4);
  window->SetSize(options.size[0], options.size[1]);
  window->AddRenderer(renderer);
  session.Show(0);
  session.Scene().SetCamera(camera);

  style->turn = [this](double azimuth, double tilt) { this->Turn(azimuth, tilt); };
  style->zoom = [this](double factor) { this->Zoom(factor); };
  style->press = [this](const std::string& key) { this->Press(key); };
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(style);
  interactor->Initialize();
  this->Draw();
}

Viewer::~Viewer()
{
  vtkRenderer* renderer = session.Scene().GetRenderer();
  renderer->RemoveViewProp(keysCaption);
  renderer->RemoveViewProp(statusCaption);
}

void Viewer::Run()
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback(
    [](vtkObject*, unsigned long event, void* client, void*)
    {
      auto* viewer = static_cast<Viewer*>(client);
      event == vtkCommand::TimerEvent ? viewer->Tick() : viewer->FollowSize();
    });
  interactor->AddObserver(vtkCommand::TimerEvent, command);
  interactor->AddObserver(vtkCommand::ConfigureEvent, command);
  this->StartClock();
  interactor->Start();
  interactor->RemoveObserver(command);
}

void Viewer::Press(const std::string& key)
{
  for (const Key& each : Keys())
  {
    if (std::find(each.symbols.begin(), each.symbols.end(), key) != each.symbols.end())
    {
      message.clear();
      each.act(*this);
      return;
    }
  }
}

void Viewer::Tick()
{
  if (playing)
  {
    this->Step(1);
    // The next one counts from here, so that slow drawing never piles steps up.
    this->StartClock();
  }
}

void Viewer::StartClock()
{
  if (playing)
  {
    interactor->CreateOneShotTimer(static_cast<unsigned long>(options.interval.count()));
  }
}

void Viewer::Play(bool on)
{
  playing = on && session.Count() > 1;
  message = on && !playing ? "there is one time alone: nothing to play" : "";
  this->StartClock();
  this->Draw();
}

void Viewer::Step(int by)
{
  const auto count = static_cast<int>(session.Count());
  const int next = (static_cast<int>(session.Shown().value_or(0)) + by + count) % count;
  try
  {
    session.Show(static_cast<std::size_t>(next));
  }
  catch (const Error& error)
  {
    playing = false;
    this->Report(error.what());
  }
  this->Draw();
}

void Viewer::ScaleInterval(double factor)
{
  const Duration scaled(std::llround(static_cast<double>(options.interval.count()) * factor));
  options.interval = std::clamp(scaled, shortestInterval, longestInterval);
  this->Draw();
}

void Viewer::ScaleSlices(double factor)
{
  const double slices = session.Scene().Slices() * factor;
  session.Scene().SetSlices(static_cast<int>(std::clamp<double>(slices, fewestSlices, mostSlices)));
  this->Draw();
}

void Viewer::ApplyPreset(int number)
{
  const std::string& array = session.Scene().Array();
  if (const char* preset = vtkNexradTransferFunction::FindPreset(array.c_str(), number))
  {
    session.Scene().TransferFunction()->ApplyPreset(preset);
    session.Scene().TransferFunctionChanged();
    message = preset;
  }
  else
  {
    message = array + " has no preset " + std::to_string(number + 1);
  }
  this->Draw();
}

void Viewer::MoveIsoValue(double by)
{
  if (session.Scene().Array() != "REF")
  {
    message = "iso-values are of REF alone";
    this->Draw();
    return;
  }
  isoValue = std::clamp(isoValue + by, leastIsoValue, mostIsoValue);
  session.Scene().TransferFunction()->SetOpacityToIsoValues(&isoValue, 1);
  session.Scene().TransferFunctionChanged();
  std::ostringstream text;
  text << "iso-value " << isoValue << " dBZ";
  message = text.str();
  this->Draw();
}

void Viewer::Turn(double azimuth, double tilt)
{
  camera.azimuth = std::fmod(camera.azimuth + azimuth + 360.0, 360.0);
  camera.tilt = std::clamp(camera.tilt + tilt, -90.0, 90.0);
  session.Scene().SetCamera(camera);
  this->Draw();
}

void Viewer::Zoom(double factor)
{
  camera.zoom = std::clamp(camera.zoom * factor, 0.1, 100.0);
  session.Scene().SetCamera(camera);
  this->Draw();
}

void Viewer::FollowSize()
{
  const int* now = window->GetSize();
  if (now[0] != size[0] || now[1] != size[1])
  {
    this->Draw();
  }
}

void Viewer::DrawStatus()
{
  std::ostringstream text;
  text << "step " << session.Shown().value_or(0) + 1 << " of " << session.Count() << ", "
       << (playing ? "playing" : "paused") << ", " << options.interval.count() << " ms a step, "
       << application::Counted(static_cast<std::uintmax_t>(session.Scene().Slices()), "slice")
       << (message.empty() ? "" : "    ") << message;
  statusCaption->SetInput(text.str().c_str());
  const int letters = std::max(9, size[1] / 55);
  for (vtkTextActor* caption : {keysCaption.Get(), statusCaption.Get()})
  {
    caption->GetTextProperty()->SetFontSize(letters);
  }
  keysCaption->SetVisibility(help);
}

void Viewer::Draw()
{
  const int* now = window->GetSize();
  if (now[0] != size[0] || now[1] != size[1])
  {
    size = {now[0], now[1]};
    session.Scene().SetPictureSize(size);
  }
  this->DrawStatus();
  const Time time = session.TimeAt(session.Shown().value_or(0));
  window->SetWindowName(("nexrad3d " + FormatIso8601(time)).c_str());
  window->Render();
  const std::string failure = application::NextVtkError();
  if (!failure.empty())
  {
    this->Report(failure);
    this->DrawStatus();
    window->Render();
  }
}

// The keys are not part of the picture.
void Viewer::WritePicture()
{
  keysCaption->VisibilityOff();
  statusCaption->VisibilityOff();
  window->Render();
  const vtkSmartPointer<vtkImageData> picture = GrabPicture(window);
  statusCaption->VisibilityOn();
  try
  {
    const std::filesystem::path path =
      FreePictureName(options.pictures, session.TimeAt(session.Shown().value_or(0)));
    WritePng(picture, path);
    written.push_back(path);
    message = "wrote " + path.string();
  }
  catch (const Error& error)
  {
    this->Report(error.what());
  }
  this->Draw();
}

void Viewer::Report(const std::string& problem)
{
  message = problem;
  problems.push_back(problem);
}

} // namespace nexrad::scene
