// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/MainWindow.h"

#include "Commands/SimulatedFiles.h"
#include "Drawing/PictureWindow.h"
#include "Export/SceneState.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Viewer/BoxMouse.h"
#include "Viewer/ChosenArrays.h"
#include "Viewer/CutPanel.h"
#include "Viewer/FileActions.h"
#include "Viewer/HelpPage.h"
#include "Viewer/LookPanel.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"
#include "Viewer/SectionPanel.h"
#include "Viewer/TimeLine.h"
#include "Viewer/TransferFunctionChart.h"
#include "Viewer/TransferFunctionEditor.h"
#include "Viewer/WelcomePage.h"
#include "Viewer/Widgets.h"
#include "nexrad/System/Error.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include <vtkImageData.h>
#include <vtkNexradVolumeScene.h>
#include <vtkRenderWindow.h>

#include <QAction>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QMenuBar>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QShortcut>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTimer>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <utility>

namespace nexrad::viewer
{
namespace
{

constexpr int mostRecent = 8;
constexpr char recentKey[] = "recent";
constexpr char syntheticTitle[] = "synthetic day";

// Writes the synthetic files, as the first quarter of the work, and opens them.
std::unique_ptr<VolumeSeries> OpenSimulated(
  InputRequest input, const std::filesystem::path& folder, const Progress& progress)
{
  constexpr double part = 0.25;
  const SimulatedDayOptions hour = application::DemoDay(std::chrono::hours(1));
  input.inputs = application::WriteSimulatedFiles(hour, folder, ShareOf(progress, 0.0, part)).files;
  return OpenInputs(input, ShareOf(progress, part, 1.0));
}

// Whether two volumes show the same part of the earth.
bool SamePlace(vtkImageData* one, vtkImageData* other)
{
  std::array<double, 6> faces{};
  std::array<double, 6> otherFaces{};
  one->GetBounds(faces.data());
  other->GetBounds(otherFaces.data());
  return faces == otherFaces && scene::ReadVolumeInformation(one).projection ==
                                  scene::ReadVolumeInformation(other).projection;
}

// Where files are looked for: beside what was opened last.
QString RecentFolder()
{
  const QStringList paths = QSettings().value(recentKey).toStringList();
  return paths.isEmpty() ? QString() : QFileInfo(paths.front()).absolutePath();
}

// Pictures a second that are asked for. While a point is dragged, light comes in larger cells, and
// pixels become larger only where a picture takes half a second.
constexpr double rateOfDrag = 2.0;
constexpr double rateOfRest = 0.0001; // that of a window in which nothing moves

// A dock behind another one is not hidden for Qt, but is for the user.
void ShowOrHide(QDockWidget* dock)
{
  const bool seen = dock->isVisible() && !dock->visibleRegion().isEmpty();
  dock->setVisible(!seen);
  if (!seen)
  {
    dock->raise();
  }
}

} // namespace

MainWindow::MainWindow(const ViewRequest& viewRequest)
  : request(viewRequest)
  , playback(new Playback(this))
  , view(new SceneView(this))
{
  files = new FileActions(
    this, *view, *playback, [this] { return this->Shown(); }, request.pictures);
  connect(files, &FileActions::Said, this, &MainWindow::Announce);
  connect(files, &FileActions::Failed, this, &MainWindow::Report);
  connect(
    files, &FileActions::PathWanted, this, [this](const QString& path) { this->Open({path}); });
  connect(files, &FileActions::SessionRead, this, &MainWindow::Show);
  this->setObjectName("nexrad3d");
  this->setWindowTitle("nexrad3d");
  this->setAcceptDrops(true);
  this->setAnimated(false); // each step of a moving panel would draw the volume in another size
  auto* middle = new QWidget(this);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(view, 1);
  column->addWidget(new TimeLine(*playback, middle));
  this->setCentralWidget(middle);
  view->Apply(request.scene, request.camera);
  playback->SetInterval(static_cast<int>(request.interval.count()));
  this->MakeDocks();
  this->MakeCutting();
  this->MakeMenus();
  this->MakeStatus();
  this->MakeWelcome();
  connect(playback, &Playback::Changed, this, &MainWindow::FollowPlayback);
  connect(playback, &Playback::Loaded, this, &MainWindow::ShowVolume);
  connect(playback, &Playback::Failed, this, &MainWindow::Report);
  this->resize(request.size[0], request.size[1]);
  this->FollowPlayback();
  if (!request.input.inputs.empty())
  {
    QStringList paths;
    for (const std::filesystem::path& path : request.input.inputs)
    {
      paths << QString::fromStdString(path.string());
    }
    this->Open(paths);
  }
}

MainWindow::~MainWindow()
{
  delete playback; // before the folder of what it reads
  playback = nullptr;
}

QDockWidget* MainWindow::AddDock(
  const QString& title, const QString& name, QWidget* widget, Qt::DockWidgetArea area)
{
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(widget);
  this->addDockWidget(area, dock);
  return dock;
}

void MainWindow::MakeDocks()
{
  look = new LookPanel(view->Scene(), this);
  auto* scroll = new SettingsScroll(look, this);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(look->sizeHint().width() + 24);
  QDockWidget* lookDock = this->AddDock("Look", "look", scroll);
  connect(look, &LookPanel::Changed, view, &SceneView::DrawSoon);
  connect(view, &SceneView::DrawingFailed, this, &MainWindow::Report);
  this->MakeTransferFunction(lookDock);
  connect(look, &LookPanel::MomentChosen, this, &MainWindow::ShowMoment);
  connect(look, &LookPanel::ColoursChosen, this, &MainWindow::ColourBy);
  connect(look, &LookPanel::MapArrayChosen, this, &MainWindow::ShowMapOf);

  damage = new QListWidget(this);
  damage->setObjectName("damage");
  damage->setAccessibleName("Files that were damaged or left out");
  damage->setWordWrap(true);
  damageDock =
    this->AddDock("Damaged or left out", "damage dock", damage, Qt::BottomDockWidgetArea);
  damageDock->hide();
}

// The editor of colours and opacities is a dock behind that of the settings, hidden at first.
void MainWindow::MakeTransferFunction(QDockWidget* lookDock)
{
  colours = new TransferFunctionEditor(view->Scene(), this);
  QDockWidget* dock = this->AddDock("Transfer function", "transfer function", colours);
  this->tabifyDockWidget(lookDock, dock);
  dock->hide();
  // The menu names the key, which is not the action's: the action hides a dock that is behind.
  dock->toggleViewAction()->setText("Transfer function\tT");
  connect(dock->toggleViewAction(), &QAction::triggered, dock,
    [dock](bool on)
    {
      if (on)
      {
        dock->raise();
      }
    });
  connect(new QShortcut(QKeySequence("T"), this), &QShortcut::activated, dock,
    [dock] { ShowOrHide(dock); });
  connect(colours, &TransferFunctionEditor::Changed, view,
    [this]
    {
      const bool held = colours->Chart()->IsHeld();
      view->renderWindow()->SetDesiredUpdateRate(held ? rateOfDrag : rateOfRest);
      view->DrawSoon();
    });
  connect(colours, &TransferFunctionEditor::PresetChanged, look, &LookPanel::Follow);
}

void MainWindow::MakeCutting()
{
  section = new SectionPanel(*view, this);
  QDockWidget* dock = this->AddDock("Section", "section dock", section, Qt::BottomDockWidgetArea);
  dock->setFeatures(QDockWidget::DockWidgetClosable); // a chart of OpenGL stays in its window
  dock->hide();
  drawSection = new QAction("Draw a &section", dock);
  drawSection->setShortcut(QKeySequence("X"));
  drawSection->setToolTip("Drag on the ground from A to B: the vertical section along that line");
  connect(drawSection, &QAction::triggered, dock,
    [this, dock]
    {
      dock->show();
      section->DrawLine(true);
    });
  connect(look, &LookPanel::Changed, section, &SectionPanel::FollowSoon);
  connect(playback, &Playback::Loaded, section, &SectionPanel::FollowSoon);
  auto* cut = new CutPanel(*view, this);
  auto* lookDock = this->findChild<QDockWidget*>("look");
  box = new BoxMouse(*view, *playback);
  this->MakeSeenVoxels();
  this->tabifyDockWidget(lookDock, this->AddDock("Cut", "cut dock", new SettingsScroll(cut, this)));
  this->tabifyDockWidget(lookDock, this->AddDock("Box", "box dock", MakeBoxPanel(*box)));
  lookDock->raise();
  connect(box, &BoxMouse::Said, this, &MainWindow::Announce);
  // A drag on the ground makes the box or draws the line.
  QAction* make = box->MakeAction();
  connect(section, &SectionPanel::Draws, make, [make] { make->setChecked(false); });
  connect(make, &QAction::toggled, section,
    [this](bool on)
    {
      if (on)
      {
        section->DrawLine(false);
      }
    });
  connect(look, &LookPanel::Changed, cut, &CutPanel::FollowSoon);
  connect(playback, &Playback::Loaded, cut, &CutPanel::FollowSoon);
}

// Shows a volume in voxels as fine as the pixels, where its file has them: once the picture rests,
// the part of the volume that is seen is read in them, and drawn in place of that part. A box that
// the user makes goes first.
void MainWindow::MakeSeenVoxels()
{
  constexpr int milliseconds = 250; // without another picture: it rests
  auto* rest = new QTimer(view);
  rest->setSingleShot(true);
  rest->setInterval(milliseconds);
  connect(rest, &QTimer::timeout, playback,
    [this]
    {
      if (playback->State().leavesOutFiner)
      {
        playback->SetSeen(view->Scene()->SeenBox());
      }
    });
  connect(view, &SceneView::PictureDrawn, rest, qOverload<>(&QTimer::start));
  connect(view, &SceneView::CameraMoved, rest, qOverload<>(&QTimer::start));
}

void MainWindow::MakeMenus()
{
  QMenu* file = this->menuBar()->addMenu("&File");
  file->addAction("&Open files…", this, &MainWindow::AskForFiles, QKeySequence::Open);
  file->addAction("Open &folder…", this, &MainWindow::AskForFolder, QKeySequence("Ctrl+Shift+O"));
  recent = file->addMenu("Open &recent");
  file->addAction("Open the &synthetic day", this, &MainWindow::OpenSyntheticDay);
  file->addSeparator();
  ofVolume << file->addAction("&Take a picture", this, &MainWindow::TakePicture, QKeySequence("S"));
  ofVolume << file->addAction(
    "Save &picture as…", this, &MainWindow::AskForPicture, QKeySequence::Save);
  ofVolume << files->AddTo(file);
  file->addSeparator();
  file->addAction("&Quit", this, &QWidget::close, QKeySequence::Quit);
  colours->AddActions(this->menuBar()->addMenu("&Edit"));
  windows = this->menuBar()->addMenu("&View");
  ofVolume << windows->addAction(
    "&Camera as at first", view, &SceneView::ResetCamera, QKeySequence("R"));
  windows->addAction(drawSection);
  windows->addActions(box->Actions());
  ofVolume << drawSection << box->MakeAction();
  windows->addSeparator();
  for (QDockWidget* dock : this->findChildren<QDockWidget*>())
  {
    windows->addAction(dock->toggleViewAction());
  }
  QMenu* help = this->menuBar()->addMenu("&Help");
  help->addAction("&Keys and mouse", this, &MainWindow::ShowHelp, QKeySequence::HelpContents);
}

void MainWindow::MakeStatus()
{
  doing = new QLabel(this);
  doing->setObjectName("doing");
  progress = new QProgressBar(this);
  progress->setObjectName("progress");
  progress->setAccessibleName("Progress");
  progress->setRange(0, 1000);
  progress->setTextVisible(false);
  progress->setMaximumWidth(200);
  cancel = new QPushButton("Cancel", this);
  cancel->setObjectName("cancel");
  cancel->setToolTip("Stop opening, or stop loading the times that are not shown");
  cancel->setFocusPolicy(Qt::NoFocus);
  this->statusBar()->addWidget(doing, 1);
  this->statusBar()->addPermanentWidget(MakePointerReadout(*view));
  this->statusBar()->addPermanentWidget(progress);
  this->statusBar()->addPermanentWidget(cancel);
  connect(cancel, &QPushButton::clicked, playback,
    [this] { playback->PauseLoading(!playback->State().paused); });
}

void MainWindow::MakeWelcome()
{
  welcome = new WelcomePage(view);
  connect(welcome, &WelcomePage::FilesWanted, this, &MainWindow::AskForFiles);
  connect(welcome, &WelcomePage::FolderWanted, this, &MainWindow::AskForFolder);
  connect(welcome, &WelcomePage::SyntheticDayWanted, this, &MainWindow::OpenSyntheticDay);
  connect(
    welcome, &WelcomePage::PathWanted, this, [this](const QString& path) { this->Open({path}); });
  this->FollowRecent();
}

void MainWindow::Open(const QStringList& paths)
{
  application::Session session = this->NewSession();
  session.drawing.input.inputs.clear();
  for (const QString& path : paths)
  {
    session.drawing.input.inputs.emplace_back(path.toStdString());
  }
  asked = paths;
  playback->Watch(paths);
  const QString name = QFileInfo(paths.front()).fileName();
  if (application::IsSessionFile(session.drawing.input.inputs.front()))
  {
    files->OpenSession(session.drawing.input.inputs.front());
    return;
  }
  this->OpenInputs(session,
    paths.size() > 1 ? QString("%1 and %2 more").arg(name).arg(paths.size() - 1) : name, true);
}

void MainWindow::OpenSyntheticDay()
{
  playback->Watch({}); // nothing is added to it
  asked.clear();
  application::Session session = this->NewSession();
  session.synthetic = true;
  this->OpenInputs(session, syntheticTitle, true);
}

// For other inputs: drawn as those that are open, but with the colours of the array that the
// program was started with.
application::Session MainWindow::NewSession() const
{
  application::Session session;
  session.drawing = request;
  if (view->Scene()->GetVolume() != nullptr)
  {
    session.drawing.scene = OptionsOf(view->Scene());
    session.drawing.input.box.reset();
    session.drawing.scene.isoValues.clear(); // the colour map in use stays as it was edited
    session.drawing.scene.colourBy = request.scene.colourBy;
    if (session.drawing.scene.plan)
    {
      session.drawing.scene.plan->array.clear(); // the next inputs may not have it
    }
  }
  return session;
}

application::Session MainWindow::Shown() const
{
  application::Session session = opened;
  const BackgroundSeries::State& state = playback->State();
  session.shown.reset();
  if (playback->Step() < state.times.size())
  {
    session.shown = state.times[playback->Step()];
  }
  session.interval = std::chrono::milliseconds(playback->Interval());
  session.drawing.size = view->PictureSize();
  session.drawing.input.box = playback->Box();
  session.drawing.camera = CameraOf(view->Scene());
  session.drawing.scene = OptionsOf(view->Scene());
  session.colours = EditedColours(view->Scene());
  return session;
}

void MainWindow::Show(const application::Session& session, const QString& name)
{
  view->Apply(session.drawing.scene, session.drawing.camera);
  look->Follow();
  playback->SetInterval(static_cast<int>(session.interval.count()));
  // Once the window is laid out.
  QTimer::singleShot(0, this, [this, size = session.drawing.size] { this->FitPicture(size); });
  this->OpenInputs(session, name);
}

void MainWindow::ShowMoment(const QString& moment)
{
  const std::optional<MomentName> chosen = ParseMomentName(moment.toStdString());
  if (chosen && moment.toStdString() != scene::ArrayOf(view->Scene()->GetVolume()))
  {
    this->OpenInputs(WithMoment(this->Shown(), *chosen), title);
  }
}

void MainWindow::ColourBy(const QString& array)
{
  if (array.toStdString() != view->Scene()->GetOptions().colourBy)
  {
    this->OpenInputs(WithColoursOf(this->Shown(), array.toStdString()), title);
  }
}

// Inputs are merged again only for an array that the volume does not have.
void MainWindow::ShowMapOf(const QString& array)
{
  if (array.isEmpty() || HasArray(view->Scene()->GetVolume(), array.toStdString()))
  {
    view->Scene()->SetOption("array", array.toStdString().c_str());
    return;
  }
  this->OpenInputs(WithMapOf(this->Shown(), array.toStdString()), title);
}

void MainWindow::FitPicture(const std::array<int, 2>& size)
{
  const std::array<int, 2> now = view->PictureSize();
  const double pixels = view->devicePixelRatioF();
  if (!this->isMaximized() && !this->isFullScreen())
  {
    this->resize(this->width() + qRound((size[0] - now[0]) / pixels),
      this->height() + qRound((size[1] - now[1]) / pixels));
  }
}

void MainWindow::OpenInputs(
  const application::Session& session, const QString& name, bool otherInputs)
{
  opened = session;
  title = name;
  first = true;
  other = otherInputs;
  failures.clear();
  BackgroundSeriesOptions options;
  const InputRequest input = session.drawing.input;
  auto folder = session.synthetic ? std::make_shared<QTemporaryDir>() : nullptr;
  if (folder && !folder->isValid())
  {
    this->Report("no folder for synthetic files: " + folder->errorString());
    return;
  }
  // The folder lives as long as the series that reads its files.
  options.open = [input, folder](const Progress& done)
  {
    auto series = folder ? OpenSimulated(input, folder->path().toStdString(), done)
                         : nexrad::OpenInputs(input, done);
    series->AllowCodes(true);
    return series;
  };
  options.choose = [input](const VolumeSeries& series) { return ChooseTimes(series, input); };
  options.prepare = [](vtkImageData* volume)
  { vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(volume, nullptr); };
  playback->Open(std::move(options), session.shown);
  box->Set(session.drawing.input.box);
}

void MainWindow::ShowVolume(vtkImageData* volume)
{
  if (first) // the settings that depend on what the volume holds
  {
    scene::SceneOptions options = WithColoursOf(view->Scene()->GetOptions(), opened.drawing.scene);
    options.isoValues = view->Scene()->GetOptions().isoValues; // set once the volume is there
    view->Scene()->SetOptions(options);
    if (other && view->Scene()->GetVolume() && !SamePlace(view->Scene()->GetVolume(), volume))
    {
      view->LeavePlace();
    }
  }
  view->SetVolume(volume);
  if (first)
  {
    look->SetMoments(playback->State().moments);
    look->SetMakesAncillary(playback->State().makesAncillary);
    if (const std::string problem = FitToVolume(opened.drawing.scene, view->Scene());
        !problem.empty())
    {
      this->Report(title + ": " + QString::fromStdString(problem));
    }
    try
    {
      SetColours(opened.colours, opened.drawing.scene.isoValues, view->Scene());
    }
    catch (const Error& error)
    {
      this->Report(title + ": colours: " + error.what());
    }
    look->Follow(); // its moment may be another than that of the series before
    first = false;
    this->Remember(asked); // what could be opened alone
    asked.clear();
  }
}

void MainWindow::FollowPlayback()
{
  using Phase = BackgroundSeries::Phase;
  const BackgroundSeries::State& state = playback->State();
  const bool opening = playback->HasSeries() && state.phase == Phase::Opening;
  const bool busy = opening || state.loads.has_value();
  progress->setVisible(busy);
  cancel->setVisible(busy || state.paused);
  cancel->setText(!state.paused || opening ? "Cancel" : "Go on");
  progress->setValue(static_cast<int>(1000.0 * state.fraction));
  const auto loaded = std::count(state.loaded.begin(), state.loaded.end(), true);
  QString text = "Nothing is open";
  if (opening)
  {
    text = "Opening " + title;
  }
  else if (playback->HasSeries() && state.phase == Phase::Open)
  {
    text = state.loaded.size() == 1
             ? QString("%1: one time, %2").arg(title, loaded == 1 ? "loaded" : "not loaded yet")
             : QString("%1: %2 of %3 times loaded").arg(title).arg(loaded).arg(state.loaded.size());
  }
  doing->setText(text);
  const bool none = title.isEmpty() || state.phase == Phase::Failed;
  this->setWindowTitle(none ? QString("nexrad3d") : title + " - nexrad3d");
  const QStringList problems = this->Problems();
  if (problems.size() != damage->count())
  {
    damage->clear();
    damage->addItems(problems);
    damageDock->setVisible(!problems.isEmpty());
  }
  this->FollowEmptiness();
}

// What could not be opened shows nothing of what was open before it.
void MainWindow::FollowEmptiness()
{
  using Phase = BackgroundSeries::Phase;
  const BackgroundSeries::State& state = playback->State();
  const bool failed = playback->HasSeries() && state.phase == Phase::Failed;
  if (failed && view->Scene()->GetVolume() != nullptr)
  {
    view->LeavePlace();
    view->SetVolume(nullptr);
    look->Follow();
  }
  const bool shows = view->Scene()->GetVolume() != nullptr;
  for (QAction* each : ofVolume)
  {
    each->setEnabled(shows);
  }
  colours->setEnabled(shows);
  this->findChild<QDockWidget*>("cut dock")->widget()->setEnabled(shows);
  if (shows)
  {
    welcome->Leave();
  }
  else if (playback->HasSeries() && !failed && playback->IsWaiting())
  {
    welcome->TellOpening(opened.synthetic
                           ? QString("Opening the synthetic day: three radars scan an hour of "
                                     "SYNTHETIC storms first, which takes about half a minute")
                           : "Opening " + title);
  }
  else
  {
    const QStringList problems = this->Problems();
    welcome->OfferToOpen(problems.isEmpty() ? QString() : "Not opened: " + problems.last());
  }
}

QStringList MainWindow::Problems() const
{
  QStringList lines;
  for (const std::string& line : playback->State().damage)
  {
    lines << QString::fromStdString(line);
  }
  return lines + failures;
}

void MainWindow::Report(const QString& problem)
{
  failures << problem;
  this->FollowPlayback();
}

void MainWindow::Announce(const QString& message)
{
  constexpr int shown = 5000; // ms
  this->statusBar()->showMessage(message, shown);
}

void MainWindow::AskForFiles()
{
  const QStringList paths =
    QFileDialog::getOpenFileNames(this, "Open radar files or volumes", RecentFolder());
  if (!paths.isEmpty())
  {
    this->Open(paths);
  }
}

void MainWindow::AskForFolder()
{
  const QString path =
    QFileDialog::getExistingDirectory(this, "Open a folder of radar files", RecentFolder());
  if (!path.isEmpty())
  {
    this->Open({path});
  }
}

void MainWindow::AskForPicture()
{
  const BackgroundSeries::State& state = playback->State();
  const bool timed = playback->Step() < state.times.size();
  const QString name = timed ? QString::fromStdString(
                                 scene::FreePictureName({}, state.times[playback->Step()]).string())
                             : QString("nexrad3d.png");
  const QString path = QFileDialog::getSaveFileName(this, "Save picture", name, "Pictures (*.png)");
  if (!path.isEmpty())
  {
    this->WritePicture(path.toStdString());
  }
}

void MainWindow::TakePicture()
{
  const BackgroundSeries::State& state = playback->State();
  if (view->Scene()->GetVolume() != nullptr && playback->Step() < state.times.size())
  {
    this->WritePicture(scene::FreePictureName(request.pictures, state.times[playback->Step()]));
  }
}

void MainWindow::WritePicture(const std::filesystem::path& path)
{
  try
  {
    view->WritePicture(path);
    pictures.push_back(path);
    const std::filesystem::path whole = std::filesystem::absolute(path).lexically_normal();
    this->Announce("wrote " + QString::fromStdString(whole.string()));
  }
  catch (const Error& error)
  {
    this->Report(error.what());
  }
}

void MainWindow::ShowHelp()
{
  (new HelpPage(this->findChildren<QAction*>(), this))->show();
}

void MainWindow::Remember(const QStringList& paths)
{
  QSettings settings;
  QStringList entries = settings.value(recentKey).toStringList();
  for (const QString& path : paths.mid(0, 1))
  {
    const QString whole = QFileInfo(path).absoluteFilePath();
    entries.removeAll(whole);
    entries.prepend(whole);
  }
  settings.setValue(recentKey, QStringList(entries.mid(0, mostRecent)));
  this->FollowRecent();
}

void MainWindow::FollowRecent()
{
  recent->clear();
  const QStringList paths = QSettings().value(recentKey).toStringList();
  welcome->SetRecent(paths);
  for (const QString& path : paths)
  {
    recent->addAction(path, this, [this, path] { this->Open({path}); });
  }
  recent->setEnabled(!recent->isEmpty());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (event->mimeData()->hasUrls())
  {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event)
{
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
  {
    if (url.isLocalFile())
    {
      paths << url.toLocalFile();
    }
  }
  if (!paths.isEmpty())
  {
    event->acceptProposedAction();
    this->Open(paths);
  }
}

} // namespace nexrad::viewer
