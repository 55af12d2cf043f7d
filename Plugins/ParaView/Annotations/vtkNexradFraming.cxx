// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradFraming.h"

#include "Scene/EchoFraming.h"
#include "Scene/VolumeAppearance.h"
#include "WholeVolume.h"
#include "nexrad/Geometry/Angles.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <type_traits>
#include <vector>

vtkStandardNewMacro(vtkNexradFraming);

namespace
{

using nexrad::scene::EchoExtent;
using nexrad::scene::SceneFrame;

// What processes exchange: numbers alone.
struct Found
{
  double any = 0.0; // 1: there is echo
  EchoExtent echo;
};
constexpr std::size_t numbers = sizeof(Found) / sizeof(double);
static_assert(std::is_trivially_copyable_v<Found> && numbers * sizeof(double) == sizeof(Found));

std::optional<EchoExtent> JoinOfProcesses(const std::optional<EchoExtent>& own)
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  const Found mine = own ? Found{1.0, *own} : Found();
  std::array<double, numbers> sent{};
  std::memcpy(sent.data(), &mine, sizeof(mine));
  std::vector<double> all(numbers * static_cast<std::size_t>(processes->GetNumberOfProcesses()));
  processes->AllGather(sent.data(), all.data(), static_cast<vtkIdType>(numbers));
  std::optional<EchoExtent> joined;
  for (std::size_t first = 0; first < all.size(); first += numbers)
  {
    Found found;
    std::memcpy(static_cast<void*>(&found), all.data() + first, sizeof(found));
    if (found.any > 0.0)
    {
      joined = joined ? Join(*joined, found.echo) : found.echo;
    }
  }
  return joined;
}

std::optional<EchoExtent> EchoOf(vtkImageData* part, int parts)
{
  const std::optional<EchoExtent> own = part->GetPointData()->GetScalars() != nullptr
                                          ? MeasureEcho(part, nexrad::scene::SceneOptions())
                                          : std::nullopt;
  return parts > 1 ? JoinOfProcesses(own) : own;
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
  const SceneFrame frame = FrameVolume(volume,
    EchoOf(vtkImageData::GetData(input[0]),
      asked->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES())),
    nexrad::scene::SceneOptions());
  const auto origin = frame.ToScene({0.0, 0.0, 0.0});
  const auto unit = frame.ToScene({1.0, 1.0, 1.0});
  const auto& framed = frame.Framed();
  const auto lower = frame.ToVolume({framed[0], framed[2], framed[4]});
  const auto upper = frame.ToVolume({framed[1], framed[3], framed[5]});
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Scale[axis] = (unit[axis] - origin[axis]) / (unit[1] - origin[1]);
    this->Framed[2 * axis] = lower[axis];
    this->Framed[2 * axis + 1] = upper[axis];
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
