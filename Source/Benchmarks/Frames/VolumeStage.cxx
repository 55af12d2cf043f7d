// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/VolumeStage.h"

#include "Drawing/PictureWindow.h"
#include "Report/Measurement.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/VolumeAppearance.h"
#include "vtkNexradTransferFunction.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <cmath>
#include <sstream>

namespace nexrad::scene
{
namespace
{

// How much heights are stretched, whatever is drawn: times of volumes are compared.
constexpr double exaggeration = 8.0;

// The value after "NAME:" in the lines of a report.
std::string Entry(const std::string& report, const std::string& name)
{
  std::istringstream lines(report);
  for (std::string line; std::getline(lines, line);)
  {
    if (line.compare(0, name.size() + 1, name + ':') == 0)
    {
      const std::size_t start = line.find_first_not_of(' ', name.size() + 1);
      return start == std::string::npos ? "unknown" : line.substr(start);
    }
  }
  return "unknown";
}

} // namespace

VolumeStage::VolumeStage(const std::array<int, 2>& pictureSize)
  : size(pictureSize)
{
  RequireDisplay();
  const SceneOptions options;
  for (const MapperChoice choice : {MapperChoice::TextureSlice, MapperChoice::RayCast})
  {
    mappers[static_cast<std::size_t>(choice)] = MakeVolumeMapper(choice, false);
  }
  volume->SetProperty(MakeVolumeProperty());
  MakeTransferFunction(options)->FillProperty(volume->GetProperty());
  renderer->AddVolume(volume);
  window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(size[0], size[1]);
  window->AddRenderer(renderer);
}

VolumeStage::~VolumeStage() = default;

void VolumeStage::SetVolume(MapperChoice choice, vtkImageData* data)
{
  const SceneFrame frame(data, exaggeration);
  placed = vtkSmartPointer<vtkImageData>::New();
  placed->ShallowCopy(data);
  frame.MoveToScene(placed);
  box = frame.Bounds();
  this->Mapper(choice)->SetInputDataObject(placed);
}

double VolumeStage::ThicknessAlongView() const
{
  const double* axis = renderer->GetActiveCamera()->GetDirectionOfProjection();
  const double* bounds = placed->GetBounds();
  double thickness = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    thickness += std::abs(axis[i]) * (bounds[2 * i + 1] - bounds[2 * i]);
  }
  return thickness;
}

double VolumeStage::Draw(MapperChoice choice, const CameraView& view, int slices)
{
  const double aspect = static_cast<double>(size[0]) / size[1];
  PointCamera(renderer->GetActiveCamera(), view, box, aspect, PictureArea());
  renderer->ResetCameraClippingRange();
  volume->SetMapper(this->Mapper(choice));
  SetSlices(this->Mapper(choice), slices, this->ThicknessAlongView());
  return application::SecondsOf(
    [this]
    {
      window->Render();
      window->WaitForCompletion();
    });
}

application::OpenGLNames VolumeStage::OpenGL()
{
  const std::string report = window->ReportCapabilities();
  return {Entry(report, "OpenGL vendor string"), Entry(report, "OpenGL renderer string"),
    Entry(report, "OpenGL version string")};
}

} // namespace nexrad::scene
