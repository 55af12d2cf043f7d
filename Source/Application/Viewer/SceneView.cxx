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
#include <vtkNexradEchoPicker.h>
#include <vtkNexradNavigator.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradVolumeScene.h>
#include <vtkObjectFactory.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWidgetRepresentation.h>

#include <QLabel>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace nexrad::viewer
{
namespace
{

constexpr double turnOfWidth = 180.0; // degrees, of a drag across the window
constexpr double zoomOfHeight = 4.0;  // factor, of a drag over its height
constexpr double zoomOfNotch = 1.1;   // factor, of one notch of the wheel
constexpr double notch = 120.0;       // eighths of a degree

// From the place before to that now, as parts of the window.
std::array<double, 2> Dragged(vtkRenderWindowInteractor* interactor)
{
  const int* now = interactor->GetEventPosition();
  const int* before = interactor->GetLastEventPosition();
  const int* size = interactor->GetSize();
  return {static_cast<double>(now[0] - before[0]) / std::max(size[0], 1),
    static_cast<double>(now[1] - before[1]) / std::max(size[1], 1)};
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

  void OnMouseMove() override
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

  void OnChar() override {}

protected:
  TurnAndZoom() = default;
  ~TurnAndZoom() override = default;

private:
  TurnAndZoom(const TurnAndZoom&) = delete;
  void operator=(const TurnAndZoom&) = delete;
};

vtkStandardNewMacro(TurnAndZoom);

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

bool SceneView::event(QEvent* event)
{
  switch (event->type())
  {
  case QEvent::MouseButtonPress:
    if (this->Grab(*static_cast<QMouseEvent*>(event)))
    {
      return true;
    }
    break;
  case QEvent::MouseMove:
    if (panning != Qt::NoButton)
    {
      const auto [x, y] = ScenePixel(*this, static_cast<QMouseEvent*>(event)->localPos());
      navigator->Pan(x, y);
      this->ShowMove();
      return true;
    }
    break;
  case QEvent::MouseButtonRelease:
    if (panning != Qt::NoButton && static_cast<QMouseEvent*>(event)->button() == panning)
    {
      panning = Qt::NoButton;
      return true;
    }
    break;
  case QEvent::MouseButtonDblClick:
    if (static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton)
    {
      const auto [x, y] = ScenePixel(*this, static_cast<QMouseEvent*>(event)->localPos());
      navigator->CentreOn(x, y);
      this->ShowMove();
      return true;
    }
    break;
  case QEvent::Wheel:
    this->ZoomByWheel(*static_cast<QWheelEvent*>(event));
    return true;
  default:
    break;
  }
  return QVTKOpenGLNativeWidget::event(event);
}

bool SceneView::Grab(const QMouseEvent& event)
{
  const bool left = event.button() == Qt::LeftButton && event.modifiers() == Qt::ShiftModifier;
  if (panning != Qt::NoButton || (!left && event.button() != Qt::MiddleButton))
  {
    return false;
  }
  panning = event.button();
  const auto [x, y] = ScenePixel(*this, event.localPos());
  navigator->Grab(x, y);
  return true;
}

void SceneView::ZoomByWheel(const QWheelEvent& event)
{
  const auto [x, y] = ScenePixel(*this, event.position());
  navigator->ZoomAt(x, y, std::pow(zoomOfNotch, event.angleDelta().y() / notch));
  this->ShowMove();
}

void SceneView::ShowMove()
{
  emit CameraMoved();
  this->DrawSoon();
}

namespace
{

class PointerReadout : public QLabel
{
public:
  explicit PointerReadout(SceneView& sceneView)
    : view(sceneView)
  {
    this->setObjectName("readout");
    this->setAccessibleName("What is under the pointer");
    this->setToolTip("Under the pointer: value in the unit of the moment, latitude and longitude "
                     "in degrees, height above sea level in km; the nearest radar, the distance "
                     "from it in km and the direction in degrees clockwise from north");
    this->setTextInteractionFlags(Qt::TextSelectableByMouse);
    picker->SetScene(view.Scene());
    view.setMouseTracking(true);
    view.installEventFilter(this);
    connect(&view, &SceneView::VolumeShown, this, &PointerReadout::Refresh);
    connect(&view, &SceneView::CameraMoved, this, &PointerReadout::Refresh);
  }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override
  {
    if (event->type() == QEvent::MouseMove)
    {
      place = static_cast<QMouseEvent*>(event)->localPos();
      inside = true;
      this->Refresh();
    }
    else if (event->type() == QEvent::Leave)
    {
      inside = false;
      this->clear();
    }
    return QLabel::eventFilter(watched, event);
  }

private:
  // Looks again at where the pointer is, as after a new volume.
  void Refresh()
  {
    if (inside)
    {
      const auto [x, y] = ScenePixel(view, place);
      picker->Pick(x, y, 0.0, view.Scene()->GetRenderer());
      this->setText(QString::fromStdString(picker->GetText()));
    }
  }

  SceneView& view;
  vtkNew<vtkNexradEchoPicker> picker;
  QPointF place; // of the pointer in the view
  bool inside = false;
};

} // namespace

QLabel* MakePointerReadout(SceneView& view)
{
  return new PointerReadout(view);
}

} // namespace nexrad::viewer
