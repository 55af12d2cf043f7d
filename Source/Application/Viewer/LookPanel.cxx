// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/LookPanel.h"

#include "Export/SceneState.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Viewer/ChosenArrays.h"
#include "Viewer/Widgets.h"

#include <vtkImageData.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradVolumeScene.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace nexrad::viewer
{
namespace
{

constexpr std::array<int, 5> sliceCounts = {64, 128, 256, 512, 1024};

// The nearest of the slice counts, after the automatic one.
int PlaceOf(int slices)
{
  if (slices == 0)
  {
    return 0;
  }
  const auto nearest = std::min_element(sliceCounts.begin(), sliceCounts.end(),
    [slices](int a, int b) { return std::abs(a - slices) < std::abs(b - slices); });
  return 1 + static_cast<int>(nearest - sliceCounts.begin());
}

// What the choice of views offers, in its order; nothing: the volume.
using View = std::optional<scene::PlanLevel>;
constexpr std::array<View, 7> offeredViews = {View(), scene::PlanLevel::Composite,
  scene::PlanLevel::Lowest, scene::PlanLevel::EchoTop, scene::PlanLevel::Liquid,
  scene::PlanLevel::LiquidDensity, scene::PlanLevel::Height};
constexpr double usualHeight = 3.0; // km, of a map at a height that was not set

constexpr char nothingOpen[] = "Nothing open";

View ViewOf(const scene::SceneOptions& options)
{
  return options.plan ? View(options.plan->level) : View();
}

// Computed of the reflectivity of all voxels of a column; other maps show one voxel of it.
bool IsProduct(const View& view)
{
  return view && scene::IsColumnProduct(*view);
}

struct Ancillary
{
  const char* ending; // of the name of the array
  const char* name;
  const char* tip;
};
constexpr Ancillary ancillaryArrays[] = {
  {"_radars", "Number of radars", "how many radars scanned each place"},
  {"_age", "Age of the data", "time between the volume and the nearest ray, in minutes"},
  {"_site", "Nearest radar", "which radar that scanned the place is nearest to it"},
  {"_weight", "Weight", "sum of the weights of the radars that scanned the place"}};

constexpr char missing[] =
  ". Off: these volumes were made without ancillary arrays. Merge the radar files with nexrad3d "
  "grid --ancillary (method beam), or open the radar files themselves.";

} // namespace

LookPanel::LookPanel(vtkNexradVolumeScene* shownScene, QWidget* parent)
  : QWidget(parent)
  , scene(shownScene)
{
  auto* column = new QVBoxLayout(this);
  this->AddDrawing(AddGroup(column, "Volume"));
  this->AddLight(AddGroup(column, "Light"));
  this->AddSurroundings(AddGroup(column, "Surroundings"));
  column->addStretch(1);
  this->Follow();
}

QComboBox* LookPanel::AddBox(
  QFormLayout* form, const QString& name, const QString& tip, const std::function<void(int)>& set)
{
  auto* box = Named(new QComboBox(this), name, tip);
  form->addRow(name, box);
  connect(box, qOverload<int>(&QComboBox::activated), this,
    [this, set](int index)
    {
      set(index);
      emit Changed();
    });
  return box;
}

QComboBox* LookPanel::AddChoice(QFormLayout* form, const QString& name, const QString& tip,
  const QStringList& entries, const std::function<int()>& get, const std::function<void(int)>& set)
{
  QComboBox* box = this->AddBox(form, name, tip, set);
  box->addItems(entries);
  follow.push_back([box, get] { box->setCurrentIndex(get()); });
  return box;
}

void LookPanel::Change(const std::function<void(scene::SceneOptions&)>& change)
{
  scene::SceneOptions options = scene->GetOptions();
  change(options);
  scene->SetOptions(options);
}

template <typename Choice>
void LookPanel::AddChoice(QFormLayout* form, const QString& name, const QString& tip,
  const QStringList& entries, Choice scene::SceneOptions::*member)
{
  this->AddChoice(
    form, name, tip, entries,
    [this, member] { return static_cast<int>(scene->GetOptions().*member); },
    [this, member](int index)
    { this->Change([&](auto& options) { options.*member = static_cast<Choice>(index); }); });
}

void LookPanel::AddSwitch(
  QFormLayout* form, const QString& name, const QString& tip, bool scene::SceneOptions::*member)
{
  auto* box = Named(new QCheckBox(name, this), name, tip);
  form->addRow(box);
  connect(box, &QCheckBox::clicked, this,
    [this, member](bool on)
    {
      this->Change([&](auto& options) { options.*member = on; });
      emit Changed();
    });
  follow.push_back([this, box, member] { box->setChecked(scene->GetOptions().*member); });
}

QDoubleSpinBox* LookPanel::AddNumber(QFormLayout* form, const QString& name, const QString& tip,
  double least, double most, double step, const QString& suffix, const QString& automatic,
  const std::function<double()>& get, const std::function<void(double)>& set)
{
  auto* box = Named(new QDoubleSpinBox(this), name, tip);
  box->setRange(least, most);
  box->setSingleStep(step);
  box->setDecimals(step < 1.0 ? 2 : 0);
  box->setSuffix(suffix);
  box->setKeyboardTracking(false);
  if (!automatic.isEmpty())
  {
    box->setSpecialValueText(automatic); // for the least value
  }
  form->addRow(name, box);
  connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
    [this, set](double value)
    {
      set(value);
      emit Changed();
    });
  follow.push_back(
    [box, get]
    {
      const QSignalBlocker quiet(box);
      box->setValue(get());
    });
  return box;
}

void LookPanel::AddNumber(QFormLayout* form, const QString& name, const QString& tip, double least,
  double most, double step, const QString& suffix, double& (*member)(scene::SceneOptions&))
{
  const auto get = [this, member]
  {
    scene::SceneOptions options = scene->GetOptions();
    return member(options);
  };
  const auto set = [this, member](double value)
  { this->Change([&](scene::SceneOptions& options) { member(options) = value; }); };
  this->AddNumber(form, name, tip, least, most, step, suffix, "", get, set);
}

void LookPanel::AddMoments(QFormLayout* form)
{
  shownMoment = this->AddBox(form, "Moment",
    "Which moment of the radars is shown, of those in the files: REF reflectivity, VEL radial "
    "velocity, SW spectrum width, ZDR, PHI and RHO of two polarisations",
    [this](int) { emit MomentChosen(shownMoment->currentText()); });
  colourArray = this->AddBox(form, "Colours of",
    "Another array gives the colours; the moment then gives the opacities alone",
    [this](int) { emit ColoursChosen(colourArray->currentData().toString()); });
  follow.push_back([this] { this->FollowMoments(); });
}

void LookPanel::AddDrawing(QFormLayout* form)
{
  this->AddMoments(form);
  presets = this->AddBox(form, "Preset",
    "Colours and opacities of the moment that is shown; iso-values draws surfaces",
    [this](int) { scene->SetPreset(presets->currentText().toStdString()); });
  follow.push_back([this] { this->FollowPresets(); });
  QStringList counts = {"automatic"};
  for (const int count : sliceCounts)
  {
    counts << QString::number(count);
  }
  this->AddChoice(
    form, "Slices", "Slices through the volume: more are finer, and take longer", counts,
    [this] { return PlaceOf(scene->GetOptions().slices); },
    [this](int index)
    {
      this->Change([index](scene::SceneOptions& options)
        { options.slices = index == 0 ? 0 : sliceCounts[static_cast<std::size_t>(index - 1)]; });
    });
  this->AddSwitch(form, "Pre-integrated",
    "Integrate colours and opacities between two slices: narrow steps of colour leave no rings",
    &scene::SceneOptions::preIntegration);
  this->AddSwitch(form, "Interpolated",
    "Interpolate values linearly between voxels; else each place has that of its nearest voxel",
    &scene::SceneOptions::linearInterpolation);
  this->AddChoice(form, "Drawn by",
    "The slices of this program, or VTK's GPU ray caster for comparison",
    {"Slices", "VTK's ray caster"}, &scene::SceneOptions::mapper);
  this->AddNumber(
    form, "Stretch", "How many times heights are stretched; 0: automatic, by the size of the frame",
    0.0, 50.0, 0.5, " ×", "automatic",
    [this] { return scene->GetOptions().exaggeration.value_or(0.0); },
    [this](double times)
    {
      this->Change([times](scene::SceneOptions& options)
        { options.exaggeration = times > 0.0 ? std::optional(times) : std::nullopt; });
    });
  this->AddChoice(form, "Frame",
    "What fills the view at a magnification of 1: the echo, or the whole domain",
    {"Echo", "Domain"}, &scene::SceneOptions::framing);
  this->AddChoice(
    form, "Projection", "Perspective, or parallel lines of sight", {"Perspective", "Parallel"},
    [this] { return scene->GetParallelProjection() ? 1 : 0; },
    [this](int index) { scene->SetParallelProjection(index == 1); });
  this->AddMaps(form);
  // They keep their width, and the picture beside the panel its size, when other entries come.
  constexpr int letters = 8;
  for (QComboBox* box : {shownMoment, colourArray, mapArray})
  {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(letters);
  }
}

void LookPanel::AddMaps(QFormLayout* form)
{
  views = this->AddChoice(
    form, "View", "The volume, or a map of one value of each column",
    {"Volume", "Largest value of each column", "Lowest value that was scanned",
      "Echo top at 18 dBZ", "Vertically integrated liquid (VIL)", "VIL density", "At a height"},
    [this]
    {
      const auto place =
        std::find(offeredViews.begin(), offeredViews.end(), ViewOf(scene->GetOptions()));
      return static_cast<int>(place - offeredViews.begin());
    },
    [this](int index) { this->ChooseView(offeredViews[static_cast<std::size_t>(index)]); });
  mapArray = this->AddBox(form, "Map of",
    "What a map shows of the voxel of each column: the moment, or how the radars saw the voxel",
    [this](int) { emit MapArrayChosen(mapArray->currentData().toString()); });
  mapHeight = this->AddNumber(
    form, "Map height", "Height of the map at a height, km above mean sea level", 0.0, 30.0, 0.5,
    " km", "", [] { return 0.0; },
    [this](double kilometres)
    {
      map.height = kilometre * kilometres;
      this->Change(
        [this](scene::SceneOptions& options)
        {
          if (options.plan)
          {
            options.plan->height = map.height;
          }
        });
    });
  follow.back() = [this] { this->FollowMaps(); };
}

void LookPanel::ChooseView(const std::optional<scene::PlanLevel>& level)
{
  if (level)
  {
    map.level = *level;
    map.array = IsProduct(level) ? "" : map.array;
    if (level == scene::PlanLevel::Height && map.height == 0.0)
    {
      this->FollowMaps(); // which knows the heights of the volume
      map.height = kilometre * std::min(usualHeight, mapHeight->maximum());
    }
  }
  this->PlaceCamera(level.has_value());
  this->Change([&](scene::SceneOptions& options)
    { options.plan = level ? std::optional(map) : std::nullopt; });
  this->Follow();
}

// A map is seen from above. The volume is seen after it as it was before, unless the camera was
// turned in the meantime.
void LookPanel::PlaceCamera(bool forMap)
{
  constexpr double fromAbove = 90.0; // degrees
  if (forMap)
  {
    if (!scene->GetOptions().plan)
    {
      before = CameraOf(scene);
    }
    scene->SetCameraFromAbove();
  }
  else if (before && scene->GetTilt() == fromAbove)
  {
    scene->SetAzimuth(before->azimuth);
    scene->SetTilt(before->tilt);
    scene->SetParallelProjection(before->parallel);
  }
}

// Echo tops and liquid are computed of reflectivity alone.
void LookPanel::FollowMaps()
{
  auto* entries = qobject_cast<QStandardItemModel*>(views->model());
  vtkImageData* volume = scene->GetVolume();
  const bool reflectivity = scene::ArrayOf(volume) == "REF";
  for (std::size_t i = 0; i < offeredViews.size(); ++i)
  {
    entries->item(static_cast<int>(i))->setEnabled(!IsProduct(offeredViews[i]) || reflectivity);
  }
  const View view = ViewOf(scene->GetOptions());
  mapArray->setEnabled(view && !IsProduct(view));
  const QSignalBlocker quiet(mapHeight);
  if (volume != nullptr)
  {
    const std::array<double, 6> faces = scene::FacesOf(volume);
    mapHeight->setRange(faces[4] / kilometre, faces[5] / kilometre);
  }
  mapHeight->setValue(map.height / kilometre);
  mapHeight->setEnabled(view == scene::PlanLevel::Height);
}

void LookPanel::AddLight(QFormLayout* form)
{
  this->AddNumber(form, "Shadow", "How strong the volume's shadows are, 0 (none) to 1", 0.0, 1.0,
    0.05, "", [](auto& options) -> double& { return options.light.shadow; });
  this->AddNumber(form, "Occlusion",
    "How much darker it is where little of the sky is seen, 0 (none) to 1", 0.0, 1.0, 0.05, "",
    [](auto& options) -> double& { return options.light.occlusion; });
  this->AddNumber(form, "From", "Direction to the light in degrees clockwise from north", 0.0,
    359.0, 5.0, "°", [](auto& options) -> double& { return options.light.direction.azimuth; });
  this->AddNumber(form, "Height", "Elevation of the light above the horizon in degrees", -90.0,
    90.0, 5.0, "°", [](auto& options) -> double& { return options.light.direction.elevation; });
}

void LookPanel::AddSurroundings(QFormLayout* form)
{
  this->AddChoice(form, "Theme",
    "Light letters over a grey ground, or dark letters over a pale one", {"Dark", "Light"},
    &scene::SceneOptions::theme);
  this->AddSwitch(form, "Height walls", "Lines of equal height on the walls behind the volume",
    &scene::SceneOptions::heightWalls);
  this->AddSwitch(
    form, "Names", "Names of states and provinces on the map", &scene::SceneOptions::placeNames);
  this->AddNumber(
    form, "Rings", "Distance between rings of range about each radar in kilometres; 0: none", 0.0,
    230.0, 10.0, " km", "none", [this] { return scene->GetOptions().ringSpacing / kilometre; },
    [this](double kilometres) { scene->SetOption("rings", kilometre * kilometres); });
}

// The entries are the moments of the inputs, and of the volume what may give colours.
void LookPanel::FollowMoments()
{
  vtkImageData* volume = scene->GetVolume();
  const auto shown = QString::fromStdString(scene::ArrayOf(volume));
  QStringList names;
  for (const MomentName moment : moments)
  {
    names << ToString(moment);
  }
  if (!shown.isEmpty() && !names.contains(shown))
  {
    names.prepend(shown);
  }
  shownMoment->setEnabled(volume != nullptr);
  colourArray->setEnabled(volume != nullptr);
  if (volume == nullptr)
  {
    SetEntries(shownMoment, {nothingOpen});
    SetEntries(colourArray, {nothingOpen});
    return;
  }
  SetEntries(shownMoment, names);
  shownMoment->setCurrentText(shown);
  names.removeAll(shown);
  this->OfferArrays(colourArray, names, scene->GetOptions().colourBy);
  this->OfferArrays(mapArray, {}, map.array);
}

void LookPanel::OfferArrays(QComboBox* box, const QStringList& others, const std::string& chosen)
{
  QStringList names = QStringList("Same moment") + others;
  for (const Ancillary& ancillary : ancillaryArrays)
  {
    names << ancillary.name;
  }
  SetEntries(box, names);
  int place = 0;
  box->setItemData(place++, QString());
  for (const QString& moment : others)
  {
    box->setItemData(place++, moment);
  }
  auto* entries = qobject_cast<QStandardItemModel*>(box->model());
  for (const Ancillary& ancillary : ancillaryArrays)
  {
    const std::string array = scene::ArrayOf(scene->GetVolume()) + ancillary.ending;
    const bool on = makesAncillary || HasArray(scene->GetVolume(), array);
    const auto name = QString::fromStdString(array);
    box->setItemData(place, name);
    entries->item(place)->setEnabled(on);
    const QString tip = name + ": " + ancillary.tip;
    box->setItemData(place++, on ? tip : tip + missing, Qt::ToolTipRole);
  }
  box->setCurrentIndex(std::max(0, box->findData(QString::fromStdString(chosen))));
}

void LookPanel::FollowPresets()
{
  vtkImageData* volume = scene->GetVolume();
  const std::string moment = scene::ArrayOf(volume);
  QStringList names;
  for (int i = 0; const char* name = vtkNexradTransferFunction::FindPreset(moment.c_str(), i); ++i)
  {
    names << name;
  }
  SetEntries(presets, volume != nullptr ? names : QStringList(nothingOpen));
  presets->setEnabled(volume != nullptr);
  presets->setCurrentIndex(
    std::max<int>(0, static_cast<int>(names.indexOf(QString::fromStdString(scene->GetPreset())))));
}

void LookPanel::Follow()
{
  map = scene->GetOptions().plan.value_or(map);
  for (const std::function<void()>& each : follow)
  {
    each();
  }
}

} // namespace nexrad::viewer
