// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradFraming.h"

#include "Scene/EchoFraming.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/VolumeAppearance.h"
#include "WholeVolume.h"
#include "nexrad/Geometry/Angles.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <optional>

vtkStandardNewMacro(vtkNexradFraming);

namespace
{

using nexrad::scene::EchoExtent;
using nexrad::scene::SceneFrame;

std::optional<EchoExtent> EchoOf(vtkImageData* part, vtkImageData* whole, int parts)
{
  const vtkSmartPointer<vtkImageData> volume =
    parts > 1 ? GatherThinned(part, whole) : vtkSmartPointer<vtkImageData>(part);
  return volume->GetPointData()->GetScalars() != nullptr
           ? MeasureEcho(volume, nexrad::scene::SceneOptions())
           : std::nullopt;
}

// In the volume's coordinates, of a line of sight of one unit of the scene.
double LengthOfSight(const SceneFrame& frame)
{
  const nexrad::scene::CameraView view;
  const double azimuth = view.azimuth * nexrad::RadiansPerDegree;
  const double tilt = view.tilt * nexrad::RadiansPerDegree;
  const auto from = frame.ToVolume({0.0, 0.0, 0.0});
  const auto to = frame.ToVolume(
    {std::sin(azimuth) * std::cos(tilt), std::cos(azimuth) * std::cos(tilt), std::sin(tilt)});
  return std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
}

} // namespace

vtkNexradFraming::vtkNexradFraming() = default;

vtkNexradFraming::~vtkNexradFraming() = default;

int vtkNexradFraming::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkNexradFraming::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  AskForOwnPart(input[0]->GetInformationObject(0), output->GetInformationObject(0));
  return 1;
}

int vtkNexradFraming::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformation* asked = output->GetInformationObject(0);
  const auto volume = DescribeWhole(input[0]->GetInformationObject(0));
  const SceneFrame frame = FrameVolume(volume, nexrad::scene::ReadVolumeInformation(volume),
    EchoOf(vtkImageData::GetData(input[0]), volume,
      asked->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES())),
    nexrad::scene::SceneOptions());
  const auto origin = frame.ToScene({0.0, 0.0, 0.0});
  const auto unit = frame.ToScene({1.0, 1.0, 1.0});
  const auto framed = frame.FramedInVolume();
  std::copy(framed.begin(), framed.end(), this->Framed);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Scale[axis] = (unit[axis] - origin[axis]) / (unit[1] - origin[1]);
  }
  this->OpacityDistance = frame.OpacityDistance() * LengthOfSight(frame);
  frame.MoveToScene(volume);
  this->Slices = nexrad::scene::SlicesFor(volume);
  return 1;
}

void vtkNexradFraming::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scale: " << this->Scale[0] << " " << this->Scale[1] << " " << this->Scale[2]
     << "\n";
  os << indent << "Framed:";
  for (const double face : this->Framed)
  {
    os << " " << face;
  }
  os << "\n" << indent << "OpacityDistance: " << this->OpacityDistance << "\n";
  os << indent << "Slices: " << this->Slices << "\n";
}
