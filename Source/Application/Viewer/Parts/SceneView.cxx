// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Parts/SceneView.h"

#include "Drawing/PictureWindow.h"
#include "Libraries/VtkErrors.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/SceneOptions.h"
#include "Viewer/Parts/CameraMouse.h"
#include "Viewer/Parts/Soon.h"
#include "Viewer/Parts/TurnAndZoom.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkNexradNavigator.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradVolumeScene.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWidgetRepresentation.h>

#include <vector>

namespace nexrad::viewer
{
namespace
{

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
  style->turn = [this](double azimuth, double tilt) { this->Turn(azimuth, tilt); };
  style->zoom = [this](double factor) { this->Zoom(factor); };
  window->GetInteractor()->SetInteractorStyle(style);
  navigator->SetScene(scene);
  new CameraMouse(*this);
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
    const std::string failure = application::NextVtkError();
    if (!failure.empty())
    {
      emit DrawingFailed(QString::fromStdString(failure));
    }
  }
}

std::array<int, 2> SceneView::PictureSize() const
{
  const int* size = window->GetSize();
  return {size[0], size[1]};
}

void SceneView::WritePicture(const std::filesystem::path& path)
{
  const WithoutHandles plain(scene->GetRenderer());
  scene::WritePng(scene::GrabPicture(window), path);
  this->DrawSoon(); // the screen has them
}

void SceneView::ShowMove()
{
  emit CameraMoved();
  this->DrawSoon();
}

void SceneView::Turn(double azimuth, double tilt)
{
  navigator->Turn(azimuth, tilt);
  this->ShowMove();
}

void SceneView::Zoom(double factor)
{
  navigator->Zoom(factor);
  this->ShowMove();
}

} // namespace nexrad::viewer
