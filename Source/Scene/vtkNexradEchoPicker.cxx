// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradEchoPicker.h"

#include "Scene/EchoSearch.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/VolumeAppearance.h"
#include "vtkNexradVolumeScene.h"

#include "nexrad/Model/Moment.h"
#include "vtkImageData.h"
#include "vtkNexradTransferFunction.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

using nexrad::scene::SceneFrame;
using nexrad::scene::ViewRay;
using nexrad::scene::VoxelReader;

namespace
{

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// The distance at which the ray meets the ground of the domain.
std::optional<double> DistanceToGround(const SceneFrame& frame, const ViewRay& ray)
{
  const std::array<double, 6>& box = frame.Bounds();
  const std::optional<double> distance = nexrad::scene::DistanceToHeight(ray, box[4]);
  if (!distance)
  {
    return std::nullopt;
  }
  const auto point = ray.At(*distance);
  const bool within =
    point[0] >= box[0] && point[0] <= box[1] && point[1] >= box[2] && point[1] <= box[3];
  return within ? distance : std::nullopt;
}

// The echo that a ray shows. Where the finer volume is drawn, its values count.
std::optional<nexrad::scene::SeenEcho> FindEchoAlong(
  vtkNexradVolumeScene* scene, const VoxelReader& whole, const ViewRay& ray)
{
  std::optional<VoxelReader> detail;
  if (scene->GetDetail() != nullptr)
  {
    detail.emplace(scene->GetDetail());
  }
  return nexrad::scene::FindEcho(
    whole, detail ? &*detail : nullptr, *scene->GetSceneFrame(), scene->GetTransferFunction(), ray);
}

int DigitsOfArray(const std::string& array)
{
  const auto moment = nexrad::ParseMomentName(array);
  return moment ? nexrad::DigitsOf(*moment) : 1;
}

std::string Fixed(double number, int digits)
{
  std::ostringstream stream;
  stream << std::fixed << std::setprecision(digits) << number;
  return stream.str();
}

} // namespace

vtkStandardNewMacro(vtkNexradEchoPicker);

vtkNexradEchoPicker::vtkNexradEchoPicker()
{
  this->Forget();
}

vtkNexradEchoPicker::~vtkNexradEchoPicker() = default;

void vtkNexradEchoPicker::SetScene(vtkNexradVolumeScene* scene)
{
  if (scene != this->Scene)
  {
    this->Scene = scene;
    this->Modified();
  }
}

vtkNexradVolumeScene* vtkNexradEchoPicker::GetScene() const
{
  return this->Scene;
}

void vtkNexradEchoPicker::Forget()
{
  this->Initialize();
  this->Found = NOTHING;
  std::fill(this->Place, this->Place + 3, 0.0);
  this->Latitude = unknown;
  this->Longitude = unknown;
  this->Value = unknown;
  this->ArrayName.clear();
  this->Units.clear();
  this->SiteName.clear();
  this->SiteDistance = unknown;
  this->SiteAzimuth = unknown;
  this->NumberOfRadars = 0;
  this->Age = unknown;
}

int vtkNexradEchoPicker::Pick(double x, double y, double, vtkRenderer* renderer)
{
  return this->Look(x, y, renderer, true);
}

int vtkNexradEchoPicker::PickGround(double x, double y, vtkRenderer* renderer)
{
  return this->Look(x, y, renderer, false);
}

int vtkNexradEchoPicker::Look(double x, double y, vtkRenderer* renderer, bool forEcho)
{
  this->Forget();
  this->Renderer = renderer;
  this->SelectionPoint[0] = x;
  this->SelectionPoint[1] = y;
  this->SelectionPoint[2] = 0.0;
  if (!this->Scene || !this->Scene->Update() || this->Scene->GetVolume() == nullptr ||
      renderer == nullptr)
  {
    return NOTHING;
  }
  const int* size = renderer->GetSize();
  if (size[0] <= 0 || size[1] <= 0 || !(x >= 0.0 && y >= 0.0 && x <= size[0] && y <= size[1]))
  {
    return NOTHING;
  }
  const ViewRay ray =
    nexrad::scene::RayThrough(renderer->GetActiveCamera(), {size[0], size[1]}, {x, y});
  const SceneFrame frame = *this->Scene->GetSceneFrame();
  std::optional<double> distance;
  if (forEcho && !this->Scene->GetOptions().plan)
  {
    const VoxelReader voxels(this->Scene->GetVolume());
    if (const auto echo = FindEchoAlong(this->Scene, voxels, ray))
    {
      distance = echo->distance;
      this->Found = ECHO;
      this->Value = echo->value;
      this->ArrayName = voxels.Name();
      this->Units = voxels.Unit();
    }
  }
  if (!distance)
  {
    distance = DistanceToGround(frame, ray);
    this->Found = distance ? GROUND : NOTHING;
  }
  if (distance)
  {
    const auto point = ray.At(*distance);
    std::copy(point.begin(), point.end(), this->PickPosition);
    const auto place = frame.ToVolume(point);
    std::copy(place.begin(), place.end(), this->Place);
    if (frame.HasMap())
    {
      const auto [longitude, latitude] = frame.Geographic(point[0], point[1]);
      this->Longitude = longitude;
      this->Latitude = latitude;
    }
    this->FindRadar();
  }
  return this->Found;
}

void vtkNexradEchoPicker::FindRadar()
{
  vtkImageData* volume = this->Scene->GetVolume();
  std::vector<std::string> sites = nexrad::scene::ReadVolumeInformation(volume).sites;
  if (this->Found == ECHO)
  {
    const VoxelReader voxels(volume);
    const VoxelReader::Index index =
      voxels.IndexAt({this->Place[0], this->Place[1], this->Place[2]});
    const auto ancillary = [&](const char* end)
    { return voxels.NearestOf(this->ArrayName + end, index); };
    this->NumberOfRadars = static_cast<int>(ancillary("_radars").value_or(0.0));
    this->Age = ancillary("_age").value_or(unknown);
    const auto site = static_cast<std::size_t>(ancillary("_site").value_or(255.0));
    if (site < sites.size())
    {
      sites = {sites[site]};
    }
  }
  if (sites.size() == 1)
  {
    this->SiteName = sites.front();
  }
  if (!std::isnan(this->Latitude))
  {
    if (const auto nearest =
          nexrad::scene::FindNearestRadar(sites, this->Latitude, this->Longitude))
    {
      this->SiteName = nearest->site;
      this->SiteDistance = nearest->distance;
      this->SiteAzimuth = nearest->azimuth;
    }
  }
}

std::string vtkNexradEchoPicker::GetText() const
{
  if (this->Found == NOTHING)
  {
    return "";
  }
  std::string text;
  if (this->Found == ECHO)
  {
    const auto unit = nexrad::scene::LabelUnitOf(this->Scene->GetTransferFunction(), this->Units);
    text = Fixed(unit.ToLabel(this->Value), DigitsOfArray(this->ArrayName));
    text += unit.name.empty() ? "" : " " + unit.name;
    text += this->ArrayName.empty() ? ", " : " (" + this->ArrayName + "), ";
  }
  if (!std::isnan(this->Latitude))
  {
    text += Fixed(std::abs(this->Latitude), 3) + (this->Latitude < 0.0 ? "° S " : "° N ");
    text += Fixed(std::abs(this->Longitude), 3) + (this->Longitude < 0.0 ? "° W, " : "° E, ");
  }
  text += this->Found == GROUND ? "on the map"
                                : Fixed(this->Place[2] / 1000.0, 1) + " km above sea level";
  if (!this->SiteName.empty())
  {
    text += ", " + this->SiteName;
    text += std::isnan(this->SiteDistance) ? ""
                                           : " " + Fixed(this->SiteDistance / 1000.0, 0) + " km " +
                                               Fixed(this->SiteAzimuth, 0) + "°";
  }
  text +=
    this->NumberOfRadars > 1 ? ", seen by " + std::to_string(this->NumberOfRadars) + " radars" : "";
  text += std::isnan(this->Age) ? "" : ", " + Fixed(this->Age, 0) + " s from the nearest ray";
  return text;
}

void vtkNexradEchoPicker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scene: " << this->Scene.Get() << "\n";
  os << indent << "Found: " << this->Found << "\n";
  os << indent << "Place: " << this->Place[0] << ", " << this->Place[1] << ", " << this->Place[2]
     << "\n";
  os << indent << "Latitude: " << this->Latitude << "\n";
  os << indent << "Longitude: " << this->Longitude << "\n";
  os << indent << "Value: " << this->Value << "\n";
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "Units: " << this->Units << "\n";
  os << indent << "SiteName: " << this->SiteName << "\n";
  os << indent << "SiteDistance: " << this->SiteDistance << "\n";
  os << indent << "SiteAzimuth: " << this->SiteAzimuth << "\n";
  os << indent << "NumberOfRadars: " << this->NumberOfRadars << "\n";
  os << indent << "Age: " << this->Age << "\n";
}
