// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/SceneView.h"

#include "Drawing/PictureWindow.h"
#include "Libraries/VtkErrors.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/SceneOptions.h"
#include "Viewer/Widgets.h"
#include "nexrad/System/Error.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkInteractorStyle.h>
#include <vtkNexradNavigator.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradVolumeScene.h>
#include <vtkObjectFactory.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWidgetRepresentation.h>

#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace nexrad::viewer
{

/// What dragging with the mouse asks of the view: with the left button it turns and tilts, with the
/// right button it zooms. VTK's own keys are off.
class TurnAndZoom : public vtkInteractorStyle
{
public:
  static TurnAndZoom* New();
  vtkTypeMacro(TurnAndZoom, vtkInteractorStyle);

  std::function<void(double degrees, double tilt)> turn; ///< by degrees to the right and upwards
  std::function<void(double factor)> zoom;               ///< above 0

  void OnLeftButtonDown() override { this->StartRotate(); }
  void OnLeftButtonUp() override { this->EndRotate(); }
  void OnRightButtonDown() override { this->StartDolly(); }
  void OnRightButtonUp() override { this->EndDolly(); }
  void OnMouseMove() override;
  void OnChar() override {}

protected:
  TurnAndZoom() = default;
  ~TurnAndZoom() override = default;

private:
  TurnAndZoom(const TurnAndZoom&) = delete;
  void operator=(const TurnAndZoom&) = delete;
};

namespace
{

constexpr double turnOfWidth = 180.0; // degrees, of a drag across the window
constexpr double zoomOfHeight = 4.0;  // factor, of a drag over its height

// From the place before to that now, as parts of the window.
std::array<double, 2> Dragged(vtkRenderWindowInteractor* interactor)
{
  const int* now = interactor->GetEventPosition();
  const int* before = interactor->GetLastEventPosition();
  const int* size = interactor->GetSize();
  return {static_cast<double>(now[0] - before[0]) / std::max(size[0], 1),
    static_cast<double>(now[1] - before[1]) / std::max(size[1], 1)};
}

} // namespace

vtkStandardNewMacro(TurnAndZoom);

void TurnAndZoom::OnMouseMove()
{
  const std::array<double, 2> way = Dragged(this->Interactor);
  if (this->State == VTKIS_ROTATE)
  {
    this->turn(way[0] * turnOfWidth, -way[1] * turnOfWidth);
  }
  else if (this->State == VTKIS_DOLLY)
  {
    this->zoom(std::pow(zoomOfHeight, way[1]));
  }
}

namespace
{

constexpr double zoomOfNotch = 1.1; // factor, of one notch of the wheel
constexpr double notch = 120.0;     // eighths of a degree

// Brings the camera near with the mouse.
class CameraMouse : public QObject
{
public:
  // What is given must outlive it; `show` draws the scene after a move.
  CameraMouse(SceneView& view, vtkNexradNavigator* navigator, std::function<void()> show);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  bool Press(const QMouseEvent& event);
  void Zoom(const QWheelEvent& event);

  SceneView& view;
  vtkNexradNavigator* navigator;
  std::function<void()> show;
  Qt::MouseButton panning = Qt::NoButton; // the button that is held for it
};

CameraMouse::CameraMouse(
  SceneView& sceneView, vtkNexradNavigator* sceneNavigator, std::function<void()> showMove)
  : QObject(&sceneView)
  , view(sceneView)
  , navigator(sceneNavigator)
  , show(std::move(showMove))
{
  view.installEventFilter(this);
}

bool CameraMouse::eventFilter(QObject* watched, QEvent* event)
{
  switch (event->type())
  {
  case QEvent::MouseButtonPress:
    return this->Press(*static_cast<QMouseEvent*>(event));
  case QEvent::MouseMove:
    if (panning != Qt::NoButton)
    {
      const auto [x, y] = ScenePixel(view, static_cast<QMouseEvent*>(event)->localPos());
      navigator->Pan(x, y);
      show();
      return true;
    }
    return false;
  case QEvent::MouseButtonRelease:
    if (panning != Qt::NoButton && static_cast<QMouseEvent*>(event)->button() == panning)
    {
      panning = Qt::NoButton;
      return true;
    }
    return false;
  case QEvent::MouseButtonDblClick:
    if (static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton)
    {
      const auto [x, y] = ScenePixel(view, static_cast<QMouseEvent*>(event)->localPos());
      navigator->CentreOn(x, y);
      show();
      return true;
    }
    return false;
  case QEvent::Wheel:
    this->Zoom(*static_cast<QWheelEvent*>(event));
    return true;
  default:
    return QObject::eventFilter(watched, event);
  }
}

bool CameraMouse::Press(const QMouseEvent& event)
{
  const bool left = event.button() == Qt::LeftButton && event.modifiers() == Qt::ShiftModifier;
  if (panning != Qt::NoButton || (!left && event.button() != Qt::MiddleButton))
  {
    return false;
  }
  panning = event.button();
  const auto [x, y] = ScenePixel(view, event.localPos());
  navigator->Grab(x, y);
  return true;
}

void CameraMouse::Zoom(const QWheelEvent& event)
{
  const auto [x, y] = ScenePixel(view, event.position());
  navigator->ZoomAt(x, y, std::pow(zoomOfNotch, event.angleDelta().y() / notch));
  show();
}

// Whether a preset is for the moment of a volume, or that has none of its own.
bool SuitsMoment(const std::string& preset, vtkImageData* volume)
{
  const std::string moment = scene::ArrayOf(volume);
  if (preset.empty() || vtkNexradTransferFunction::FindPreset(moment.c_str()) == nullptr)
  {
    return true;
  }
  for (int i = 0; const char* name = vtkNexradTransferFunction::FindPreset(moment.c_str(), i); ++i)
  {
    if (preset == name)
    {
      return true;
    }
  }
  return false;
}

// Hides what the mouse takes hold of as long as it exists: handles are no part of a picture.
class WithoutHandles
{
public:
  explicit WithoutHandles(vtkRenderer* renderer)
  {
    vtkPropCollection* props = renderer->GetViewProps();
    for (int i = 0; i < props->GetNumberOfItems(); ++i)
    {
      auto* handles = vtkWidgetRepresentation::SafeDownCast(props->GetItemAsObject(i));
      if (handles != nullptr && handles->GetVisibility() != 0)
      {
        handles->VisibilityOff();
        hidden.emplace_back(handles);
      }
    }
  }
  ~WithoutHandles()
  {
    for (vtkWidgetRepresentation* handles : hidden)
    {
      handles->VisibilityOn();
    }
  }
  WithoutHandles(const WithoutHandles&) = delete;
  WithoutHandles& operator=(const WithoutHandles&) = delete;

private:
  std::vector<vtkSmartPointer<vtkWidgetRepresentation>> hidden;
};

} // namespace

std::array<double, 2> ScenePixel(const SceneView& view, const QPointF& place)
{
  const double ratio = view.devicePixelRatioF();
  return {ratio * place.x(), ratio * (view.height() - 1 - place.y())};
}

SceneView::SceneView(QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
  , style(vtkSmartPointer<TurnAndZoom>::New())
  , drawing(new Soon(this, [this] { this->Draw(); }))
{
  this->setObjectName("scene");
  this->setAccessibleName("Radar volume");
  this->setFocusPolicy(Qt::StrongFocus);
  window->SetMultiSamples(4); // as the pictures of the command render
  window->AddRenderer(scene->GetRenderer());
  this->setRenderWindow(window.Get());
  style->turn = [this](double azimuth, double tilt)
  {
    navigator->Turn(azimuth, tilt);
    this->ShowMove();
  };
  style->zoom = [this](double factor)
  {
    navigator->Zoom(factor);
    this->ShowMove();
  };
  window->GetInteractor()->SetInteractorStyle(style);
  navigator->SetScene(scene);
  new CameraMouse(*this, navigator, [this] { this->ShowMove(); });
}

SceneView::~SceneView()
{
  scene->SetRenderer(nullptr);
}

void SceneView::Apply(const scene::SceneOptions& options, const scene::CameraView& camera)
{
  scene::SceneOptions shown = options;
  shown.namesOptions = false;           // captions name settings of the window
  shown.cut.unit = PlaceUnit::OfVolume; // checked once the first volume is there
  scene->SetOptions(shown);
  scene->SetParallelProjection(camera.parallel);
  first = camera;
  this->ResetCamera();
}

void SceneView::ResetCamera()
{
  scene::CameraView view = first;
  view.parallel = scene->GetParallelProjection();
  scene->SetView(view);
  this->DrawSoon();
}

void SceneView::LeavePlace()
{
  first.lookAt.reset();
  first.zoom = scene::CameraView().zoom;
  scene->SetZoom(first.zoom);
  scene->LookAtDomain();
  scene->SectionOff();
  scene->CroppingOff();
  scene->ClippingOff();
}

void SceneView::SetVolume(vtkImageData* volume)
{
  if (!SuitsMoment(scene->GetPreset(), volume))
  {
    scene->SetPreset("");
  }
  scene->SetVolume(volume);
  failure.clear();
  emit VolumeShown();
  this->DrawSoon();
}

void SceneView::DrawSoon()
{
  drawing->Ask();
}

void SceneView::Draw()
{
  if (this->isVisible() && window->GetReadyForRendering())
  {
    window->Render();
    ++drawn;
    const std::string problem = application::NextVtkError();
    if (!problem.empty())
    {
      failure = problem;
      emit DrawingFailed(QString::fromStdString(problem));
    }
    emit PictureDrawn();
  }
}

std::array<int, 2> SceneView::PictureSize() const
{
  const int* size = window->GetSize();
  return {size[0], size[1]};
}

void SceneView::WritePicture(const std::filesystem::path& path)
{
  if (!failure.empty())
  {
    throw Error("the picture would lack what cannot be drawn: " + failure);
  }
  const WithoutHandles plain(scene->GetRenderer());
  scene::WritePng(scene::GrabPicture(window), path);
  this->DrawSoon(); // the screen has them
}

void SceneView::ShowMove()
{
  emit CameraMoved();
  this->DrawSoon();
}

} // namespace nexrad::viewer
