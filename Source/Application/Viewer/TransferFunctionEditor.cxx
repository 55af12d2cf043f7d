// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/TransferFunctionEditor.h"

#include "Scene/DrawingSettings.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Shapes/Theme.h"
#include "Scene/VolumeAppearance.h"
#include "Viewer/TransferFunctionChart.h"
#include "Viewer/Widgets.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/System/Error.h"

#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkNexradHistogram.h>
#include <vtkNexradMessages.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradTwoFields.h>
#include <vtkNexradVolumeScene.h>
#include <vtkRenderer.h>

#include <QAction>
#include <QButtonGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QShortcut>
#include <QSignalBlocker>
#include <QToolButton>
#include <QUndoCommand>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace nexrad::viewer
{

TransferFunctionState TransferFunctionState::Of(vtkNexradVolumeScene* scene)
{
  TransferFunctionState state;
  state.preset = scene->GetPreset();
  if (auto* shown = scene->GetTransferFunction())
  {
    state.function = vtkSmartPointer<vtkNexradTransferFunction>::New();
    state.function->DeepCopy(shown);
  }
  return state;
}

bool TransferFunctionState::operator==(const TransferFunctionState& other) const
{
  return preset == other.preset &&
         (function ? function->IsEqual(other.function) : other.function == nullptr);
}

namespace
{

using Function = vtkNexradTransferFunction;

// A change from one state to another, which was made already when it is pushed.
class Change : public QUndoCommand
{
public:
  using State = TransferFunctionState;

  // `applyState` gives the scene a state.
  Change(const QString& text, State stateBefore, State stateAfter,
    std::function<void(const State&)> applyState)
    : QUndoCommand(text)
    , before(std::move(stateBefore))
    , after(std::move(stateAfter))
    , apply(std::move(applyState))
  {
  }

  void undo() override
  {
    made = false;
    apply(before);
  }

  void redo() override
  {
    if (!std::exchange(made, true))
    {
      apply(after);
    }
  }

private:
  State before;
  State after;
  std::function<void(const State&)> apply;
  bool made = true;
};

/// Voxels that a histogram looks at: some milliseconds on the window's thread.
constexpr vtkIdType mostVoxels = 1 << 23;
constexpr char changed[] = ", changed";
constexpr int histogramPause = 200; // ms

QString UnitOfArray(const std::string& array)
{
  const auto moment = ParseMomentName(array);
  return moment ? QString::fromUtf8(UnitOf(*moment)) : QString();
}

QString TitleOfArray(const std::string& array, const QString& unit)
{
  const auto moment = ParseMomentName(array);
  const QString title = moment ? TitleOf(*moment) : QString::fromStdString(array);
  return unit.isEmpty() ? title : title + " (" + unit + ")";
}

QString TextOfIsoValues(Function* function, const scene::LabelUnit& labels)
{
  QStringList entries;
  for (int i = 0; i < function->GetNumberOfIsoValues(); ++i)
  {
    const double value = function->GetIsoValue(i);
    entries << QString("%1:%2")
                 .arg(labels.ToLabel(value))
                 .arg(function->Evaluate(Function::OPACITY, value));
  }
  return entries.join(", ");
}

// The nodes of one channel of another function.
void CopyChannel(Function* from, Function* to, int channel)
{
  to->RemoveAllNodes(channel);
  double node[2];
  for (int i = 0; from->GetNode(channel, i, node); ++i)
  {
    to->AddNode(channel, node[0], node[1]);
  }
  to->SetLinear(channel, from->IsLinear(channel));
}

// Whether colours and opacities are those of a preset.
bool IsPreset(Function* function, const QString& name)
{
  vtkNew<Function> preset;
  return preset->ApplyPreset(name.toUtf8()) && preset->IsEqual(function);
}

} // namespace

TransferFunctionEditor::TransferFunctionEditor(vtkNexradVolumeScene* shownScene, QWidget* parent)
  : QWidget(parent)
  , scene(shownScene)
  , renderer(shownScene->GetRenderer())
  , chart(new TransferFunctionChart(this))
  , follow(new Soon(this, [this] { chart->IsHeld() ? this->FollowFunction() : this->Follow(); }))
{
  this->setObjectName("transfer function editor");
  auto* column = new QVBoxLayout(this);
  this->AddPresets(column);
  this->AddChannels(column);
  column->addWidget(chart, 1);
  this->AddPointRow(column);
  this->AddIsoValues(column);
  for (QWidget* numbers : std::array<QWidget*, 3>{point, value, level})
  {
    numbers->installEventFilter(this);
  }
  message = new QLabel(this);
  message->setObjectName("transfer function message");
  message->setWordWrap(true);
  message->hide();
  column->addWidget(message);
  connect(chart, &TransferFunctionChart::Edited, this,
    [this]
    {
      emit Changed();
      follow->Ask();
    });
  connect(chart, &TransferFunctionChart::EditFinished, this,
    [this]
    {
      this->Finish("Move point");
      emit Changed();
    });
  auto* deletes = new QShortcut(QKeySequence::Delete, chart);
  deletes->setContext(Qt::WidgetShortcut);
  connect(deletes, &QShortcut::activated, this, &TransferFunctionEditor::DeletePoint);
  pause.setSingleShot(true);
  pause.setInterval(histogramPause);
  connect(&pause, &QTimer::timeout, this, &TransferFunctionEditor::FollowVolume);
  drawnTag =
    renderer->AddObserver(vtkCommand::EndEvent, this, &TransferFunctionEditor::FollowDrawing);
  this->Follow();
}

TransferFunctionEditor::~TransferFunctionEditor()
{
  renderer->RemoveObserver(drawnTag);
}

Function* TransferFunctionEditor::Shown() const
{
  return scene->GetTransferFunction();
}

QToolButton* TransferFunctionEditor::AddButton(QBoxLayout* row, const QString& text,
  const QString& name, const QString& tip, const std::function<void()>& press)
{
  auto* button = Named(new QToolButton(this), name, tip);
  button->setText(text);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(button, &QToolButton::clicked, this, press);
  row->addWidget(button);
  return button;
}

void TransferFunctionEditor::AddPresets(QBoxLayout* column)
{
  presets = Named(new QComboBox(this), "Transfer function preset",
    "Colours and opacities to begin with: takes the place of what was edited; undo brings it back");
  connect(
    presets, qOverload<int>(&QComboBox::activated), this, &TransferFunctionEditor::ChoosePreset);
  presets->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  column->addWidget(presets);
  auto* row = new QHBoxLayout;
  column->addLayout(row);
  const std::array<QAction*, 2> actions = {
    history.createUndoAction(this, "Undo"), history.createRedoAction(this, "Redo")};
  for (QAction* action : actions)
  {
    auto* button = Named(new QToolButton(this), action == actions[0] ? "Undo" : "Redo", "");
    button->setDefaultAction(action);
    button->setText(button->objectName());
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    row->addWidget(button);
    // The action's text, and with it the button's, is that of the change.
    connect(action, &QAction::changed, button, [button] { button->setText(button->objectName()); });
  }
  this->AddButton(row, "Open…", "Open transfer function",
    "Read colours and opacities from a file: ParaView's .json, a .pal table of GRLevelX, or .csv",
    [this] { this->AskForFile(); });
  this->AddButton(row, "Save…", "Save transfer function",
    "Write colours and opacities: .json (ParaView's, everything comes back as it was) or .pal "
    "(colours in bytes)",
    [this] { this->AskWhereToWrite(); });
}

void TransferFunctionEditor::AddActions(QMenu* menu)
{
  QAction* undo = history.createUndoAction(menu, "&Undo");
  undo->setShortcut(QKeySequence("Ctrl+Z"));
  QAction* redo = history.createRedoAction(menu, "&Redo");
  redo->setShortcut(QKeySequence("Ctrl+Shift+Z"));
  menu->addActions({undo, redo});
}

void TransferFunctionEditor::AddChannels(QBoxLayout* column)
{
  auto* row = new QHBoxLayout;
  column->addLayout(row);
  channels = new QButtonGroup(this);
  for (int channel = 0; channel < 4; ++channel)
  {
    const QString name = ChannelNames[static_cast<std::size_t>(channel)];
    auto* button = this->AddButton(row, name, name + " channel",
      "Edit the points of the thick curve: " + name.toLower() + ", from 0 to 1",
      [this, channel] { this->ChooseChannel(channel); });
    button->setCheckable(true);
    button->setChecked(channel == Function::OPACITY);
    channels->addButton(button, channel);
  }
}

QDoubleSpinBox* TransferFunctionEditor::AddNumber(
  QBoxLayout* row, const QString& name, const QString& tip)
{
  auto* box = Named(new QDoubleSpinBox(this), name, tip);
  box->setKeyboardTracking(false);
  connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
    &TransferFunctionEditor::MovePoint);
  row->addWidget(box, 1);
  return box;
}

void TransferFunctionEditor::AddPointRow(QBoxLayout* column)
{
  auto* row = new QHBoxLayout;
  column->addLayout(row);
  row->addWidget(new QLabel("Point", this));
  point =
    Named(new QSpinBox(this), "Point", "Which point of the thick curve is selected, from the left");
  point->setSpecialValueText("–");
  connect(
    point, qOverload<int>(&QSpinBox::valueChanged), this, &TransferFunctionEditor::ChoosePoint);
  row->addWidget(point);
  value = this->AddNumber(row, "Value of the point", "Value of the selected point");
  value->setDecimals(2);
  level = this->AddNumber(row, "Level of the point", "Colour or opacity at the point, from 0 to 1");
  level->setRange(0.0, 1.0);
  level->setDecimals(3);
  level->setSingleStep(0.01);
  this->AddButton(
    row, "+", "Add point", "Add a point midway to the next one", [this] { this->AddPoint(); });
  remove = this->AddButton(row, "−", "Delete point",
    "Delete the selected point (Delete, or the right button of the mouse)",
    [this] { this->DeletePoint(); });
}

void TransferFunctionEditor::AddIsoValues(QBoxLayout* column)
{
  auto* row = new QHBoxLayout;
  column->addLayout(row);
  row->addWidget(new QLabel("Iso-values", this));
  isoValues = Named(new QLineEdit(this), "Iso-values",
    "Values whose surfaces are drawn, in the unit of the colour bar, each with an opacity above 0 "
    "and up to 1 if it is not to have the usual one: 20:0.3, 40:0.6, 50. Empty: the volume is "
    "drawn. A point of opacity that is "
    "edited makes the surfaces shells of the volume.");
  isoValues->setPlaceholderText("none; as in 20:0.3, 40:0.6, 50");
  connect(isoValues, &QLineEdit::editingFinished, this, &TransferFunctionEditor::SetIsoValues);
  row->addWidget(isoValues, 1);
}

// Undo and redo of the fields with numbers are those of the editor, not of their text.
bool TransferFunctionEditor::eventFilter(QObject* watched, QEvent* event)
{
  auto* key = event->type() == QEvent::ShortcutOverride ? static_cast<QKeyEvent*>(event) : nullptr;
  if (key != nullptr && (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)))
  {
    event->ignore();
    return true;
  }
  return this->QWidget::eventFilter(watched, event);
}

void TransferFunctionEditor::showEvent(QShowEvent* event)
{
  this->QWidget::showEvent(event);
  this->Follow();
}

// At the end of a picture; what it takes must not delay that.
void TransferFunctionEditor::FollowDrawing()
{
  if (this->isVisible() && !chart->IsHeld())
  {
    follow->Ask();
  }
}

void TransferFunctionEditor::Follow()
{
  if (chart->IsHeld())
  {
    return;
  }
  this->FollowMoment(scene::ArrayOf(scene->GetVolume()));
  Function* function = this->Shown();
  const scene::SceneOptions options = scene->GetOptions();
  const Settings now = {function, function != nullptr ? function->GetMTime() : 0, options.theme,
    scene->GetPreset(), options.colourBy};
  if (now != followed)
  {
    followed = now;
    this->setEnabled(function != nullptr);
    chart->SetTheme(options.theme);
    for (const int channel : {Function::RED, Function::GREEN, Function::BLUE})
    {
      channels->button(channel)->setEnabled(options.colourBy.empty());
    }
    if (!channels->button(chart->Channel())->isEnabled())
    {
      this->ChooseChannel(Function::OPACITY); // another array gives the colours
    }
    chart->SetFunction(function);
    this->Finish("Preset"); // whatever was changed elsewhere
  }
  this->FollowVolume();
}

void TransferFunctionEditor::FollowMoment(const std::string& name)
{
  if (name == moment)
  {
    return;
  }
  moment = name;
  this->FollowUnit();
  history.clear();
  known = TransferFunctionState::Of(scene);
}

// Values are in the unit of the colour bar.
void TransferFunctionEditor::FollowUnit()
{
  labels = scene::LabelUnitOf(this->Shown(), UnitOfArray(moment).toStdString());
  const QString unit = QString::fromStdString(labels.name);
  double usual[2] = {-1000.0, 1000.0};
  vtkNexradTwoFields::GetUsualRange(moment.c_str(), usual);
  const double width = usual[1] - usual[0];
  chart->SetTitle(TitleOfArray(moment, unit));
  const QSignalBlocker quiet(value);
  value->setRange(labels.ToLabel(usual[0] - width), labels.ToLabel(usual[1] + width));
  value->setSingleStep(width > 50.0 ? 1.0 : width > 5.0 ? 0.1 : 0.01);
  value->setSuffix(unit.isEmpty() ? "" : " " + unit);
  value->setToolTip("Value of the selected point" + (unit.isEmpty() ? "" : " in " + unit));
}

void TransferFunctionEditor::FollowVolume()
{
  vtkImageData* volume = scene->GetVolume();
  const vtkMTimeType time = volume != nullptr ? volume->GetMTime() : 0;
  if (this->isVisible() && !pause.isActive() && (volume != counted || time != countedTime))
  {
    pause.start();
    counted = volume;
    countedTime = time;
    this->ShowHistogram();
  }
}

void TransferFunctionEditor::ShowHistogram()
{
  if (counted == nullptr)
  {
    chart->SetHistogram(nullptr);
    return;
  }
  vtkNew<vtkNexradHistogram> histogram;
  vtkNexradMessages messages; // without a histogram there are no bars
  messages.Watch(histogram);
  histogram->SetInputData(counted);
  histogram->SetMaximumNumberOfVoxels(mostVoxels);
  histogram->Update();
  chart->SetHistogram(histogram->GetOutput());
}

void TransferFunctionEditor::FollowFunction()
{
  chart->FollowFunction();
  this->FollowUnit();
  this->FollowPoint();
  if (!chart->IsHeld())
  {
    this->FollowPresets();
    const QSignalBlocker quiet(isoValues);
    isoValues->setText(this->Shown() != nullptr ? TextOfIsoValues(this->Shown(), labels) : "");
  }
}

void TransferFunctionEditor::FollowPoint()
{
  Function* function = this->Shown();
  const int selected = chart->SelectedPoint();
  double node[2] = {0.0, 0.0};
  const bool any = function != nullptr && function->GetNode(chart->Channel(), selected, node);
  const int count = function != nullptr ? function->GetNumberOfNodes(chart->Channel()) : 0;
  const QSignalBlocker quietPoint(point);
  const QSignalBlocker quietValue(value);
  const QSignalBlocker quietLevel(level);
  point->setRange(0, count);
  point->setSuffix(QString(" of %1").arg(count));
  point->setValue(any ? selected + 1 : 0);
  value->setEnabled(any);
  level->setEnabled(any);
  remove->setEnabled(any && count > 1);
  value->setValue(labels.ToLabel(node[0]));
  level->setValue(node[1]);
}

// What was changed has an entry of its own, before the presets.
void TransferFunctionEditor::FollowPresets()
{
  QStringList names;
  for (int i = 0; const char* name = Function::FindPreset(moment.c_str(), i); ++i)
  {
    names << name;
  }
  const QString preset = QString::fromStdString(scene->GetPreset());
  auto index = std::max<int>(0, static_cast<int>(names.indexOf(preset)));
  if (this->Shown() != nullptr && index < names.size() && !IsPreset(this->Shown(), names[index]))
  {
    names.prepend(names[index] + changed);
    index = 0;
  }
  SetEntries(presets, names);
  presets->setCurrentIndex(index);
}

// Chosen again, a preset drops what was edited.
void TransferFunctionEditor::ChoosePreset(int index)
{
  if (presets->itemText(index).endsWith(changed))
  {
    return;
  }
  scene->SetPreset(presets->itemText(index).toStdString());
  scene->SetOption("iso-values", "");
  scene->ResetTransferFunction();
  scene->Update();
  chart->SetFunction(this->Shown());
  this->Finish("Preset " + QString::fromStdString(scene->GetPreset()));
  emit Changed();
  emit PresetChanged();
}

void TransferFunctionEditor::ChooseChannel(int channel)
{
  channels->button(channel)->setChecked(true);
  chart->SetChannel(channel);
  this->FollowPoint();
}

void TransferFunctionEditor::ChoosePoint(int number)
{
  chart->SelectPoint(number - 1);
  this->FollowPoint();
}

void TransferFunctionEditor::MovePoint()
{
  if (this->Shown() != nullptr && chart->SelectedPoint() >= 0)
  {
    this->Shown()->MoveNode(
      chart->Channel(), chart->SelectedPoint(), labels.ToValue(value->value()), level->value());
    this->Finish("Set point");
    emit Changed();
  }
}

// On the curve, so that it keeps nearly its course.
void TransferFunctionEditor::AddPoint()
{
  Function* function = this->Shown();
  const int channel = chart->Channel();
  const int count = function != nullptr ? function->GetNumberOfNodes(channel) : 0;
  const int before = std::clamp(chart->SelectedPoint(), 0, std::max(0, count - 2));
  double from[2];
  double to[2];
  if (count < 2 || !function->GetNode(channel, before, from) ||
      !function->GetNode(channel, before + 1, to))
  {
    return;
  }
  const double middle = 0.5 * (from[0] + to[0]);
  chart->SelectPoint(function->AddNode(channel, middle, function->Evaluate(channel, middle)));
  this->Finish("Add point");
  emit Changed();
}

void TransferFunctionEditor::DeletePoint()
{
  Function* function = this->Shown();
  const int selected = chart->SelectedPoint();
  if (function != nullptr && function->GetNumberOfNodes(chart->Channel()) > 1 &&
      function->RemoveNode(chart->Channel(), selected))
  {
    chart->SelectPoint(std::min(selected, function->GetNumberOfNodes(chart->Channel()) - 1));
    this->Finish("Delete point");
    emit Changed();
  }
}

// Without values the volume is drawn, with the opacity of the moment's first preset.
void TransferFunctionEditor::SetIsoValues()
{
  Function* function = this->Shown();
  const QString text = isoValues->text().remove(' ');
  if (function == nullptr || text == TextOfIsoValues(function, labels).remove(' '))
  {
    return;
  }
  try
  {
    if (text.isEmpty())
    {
      vtkNew<vtkNexradTransferFunction> usual;
      if (const char* first = Function::FindPreset(moment.c_str()))
      {
        usual->ApplyPreset(first);
      }
      CopyChannel(usual, function, Function::OPACITY);
    }
    else
    {
      std::vector<scene::IsoValue> wanted = scene::ParseIsoValues(text.toStdString());
      for (scene::IsoValue& isoValue : wanted)
      {
        isoValue.value = labels.ToValue(isoValue.value);
      }
      scene::SetIsoValues(std::move(wanted), function);
    }
    this->Finish("Iso-values");
    emit Changed();
  }
  catch (const Error& error)
  {
    this->Say(error.what());
  }
}

void TransferFunctionEditor::AskForFile()
{
  const QString path = QFileDialog::getOpenFileName(
    this, "Open colours and opacities", "", "Colours and opacities (*.json *.pal *.csv)");
  if (!path.isEmpty())
  {
    this->ReadFile(path);
  }
}

void TransferFunctionEditor::AskWhereToWrite()
{
  const QString path = QFileDialog::getSaveFileName(
    this, "Save colours and opacities", "colours.json", "ParaView (*.json);;GRLevelX (*.pal)");
  if (!path.isEmpty())
  {
    this->WriteFile(path);
  }
}

void TransferFunctionEditor::ReadFile(const QString& path)
{
  Function* function = this->Shown();
  if (function == nullptr)
  {
    return; // before the first volume
  }
  vtkNexradMessages messages;
  messages.Watch(function);
  if (function->ReadFile(path.toUtf8()))
  {
    this->Finish("Open " + QFileInfo(path).fileName());
    emit Changed();
    for (const std::string& line : messages.Warnings())
    {
      this->Say(
        (message->isHidden() ? QString() : message->text() + '\n') + QString::fromStdString(line));
    }
  }
  else if (!messages.Errors().empty())
  {
    this->Say(QString::fromStdString(messages.Errors().front()));
  }
}

void TransferFunctionEditor::WriteFile(const QString& path)
{
  Function* function = this->Shown();
  if (function == nullptr)
  {
    return; // before the first volume
  }
  vtkNexradMessages messages;
  messages.Watch(function);
  this->Say(function->WriteFile(path.toUtf8()) ? "wrote " + path
            : messages.Errors().empty()        ? path + ": cannot be written"
                                               : QString::fromStdString(messages.Errors().front()));
}

// Ends a change: the history has an entry for it, the numbers follow.
void TransferFunctionEditor::Finish(const QString& what)
{
  this->Say("");
  TransferFunctionState now = TransferFunctionState::Of(scene);
  if (known.function && now.function && !(now == known))
  {
    history.push(new Change(
      what, known, now, [this](const TransferFunctionState& state) { this->Apply(state); }));
  }
  known = std::move(now);
  this->FollowFunction();
}

void TransferFunctionEditor::Apply(const TransferFunctionState& state)
{
  const bool other = state.preset != scene->GetPreset();
  scene->SetPreset(state.preset);
  scene->Update();
  this->Shown()->DeepCopy(state.function);
  known = state;
  chart->SetFunction(this->Shown());
  this->FollowFunction();
  emit Changed();
  if (other)
  {
    emit PresetChanged();
  }
}

void TransferFunctionEditor::Say(const QString& text)
{
  message->setText(text);
  message->setVisible(!text.isEmpty());
}

} // namespace nexrad::viewer
