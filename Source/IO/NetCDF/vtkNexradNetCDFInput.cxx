// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNetCDFInput.h"

#include "nexrad/Grid/VolumeMoments.h"
#include "vtkNexradNetCDFFile.h"
#include "vtkNexradNetCDFGrid.h"
#include "vtkNexradNetCDFRadars.h"
#include "vtkNexradNetCDFTerms.h"
#include "vtkNexradNetCDFVoxels.h"

#include "vtk_netcdf.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{

// As many as 10 years of 5 minutes.
constexpr std::size_t MostTimes = std::size_t(1) << 20;
// Beyond, seconds since 1970 are no date of this calendar.
constexpr double LatestTime = 1e11;

std::vector<nexrad::Time> ReadTimes(const vtkNexradNetCDFFile& file)
{
  const std::optional<int> variable = file.FindVariable("time");
  const std::vector<std::size_t> shape =
    variable ? file.ShapeOf(*variable) : std::vector<std::size_t>();
  if (shape.size() != 1 || shape[0] < 1 || shape[0] > MostTimes)
  {
    file.Fail("must have a variable time with 1 to " + std::to_string(MostTimes) + " times");
  }
  std::vector<double> seconds(shape[0]);
  file.Check(nc_get_var_double(file.Id(), *variable, seconds.data()), "time");
  std::vector<nexrad::Time> times;
  for (const double each : seconds)
  {
    if (!(std::abs(each) < LatestTime))
    {
      file.Fail("has a time that is no date");
    }
    times.push_back(nexrad::FromSeconds(each));
    if (times.size() > 1 && times.back() <= times[times.size() - 2])
    {
      file.Fail("its times must ascend");
    }
  }
  return times;
}

vtkNexradNetCDFContents ReadContents(const vtkNexradNetCDFFile& file)
{
  if (file.Number(NC_GLOBAL, vtkNexradNetCDFVersionName) != vtkNexradNetCDFVersion)
  {
    file.Fail("is no NetCDF file of merged volumes: its attribute " +
              std::string(vtkNexradNetCDFVersionName) + " must be " +
              std::to_string(vtkNexradNetCDFVersion));
  }
  vtkNexradNetCDFContents contents;
  contents.Grid = vtkNexradReadGrid(file);
  contents.Times = ReadTimes(file);
  contents.OfOneRadar = file.Text(NC_GLOBAL, "one_radar").value_or("") == "yes";
  contents.Moments = vtkNexradReadNetCDFMoments(file);
  for (const nexrad::MomentName moment : contents.Moments)
  {
    for (std::string& name : vtkNexradReadNetCDFAncillaryNames(file, moment))
    {
      contents.Ancillary.push_back(std::move(name));
    }
  }
  return contents;
}

// Those that are wanted, each of which the file must have.
std::vector<nexrad::MomentName> MomentsOf(const vtkNexradNetCDFRequest& request,
  const vtkNexradNetCDFContents& contents, const vtkNexradNetCDFFile& file)
{
  for (const nexrad::MomentName moment : request.Moments)
  {
    if (std::find(contents.Moments.begin(), contents.Moments.end(), moment) ==
        contents.Moments.end())
    {
      file.Fail(std::string("has no moment ") + nexrad::ToString(moment));
    }
  }
  return request.Moments.empty() ? contents.Moments : request.Moments;
}

} // namespace

vtkNexradNetCDFContents vtkNexradReadNetCDFContents(const std::filesystem::path& path)
{
  const vtkNexradNetCDFLock lock;
  return ReadContents({path, vtkNexradNetCDFFile::Mode::Read, path.string()});
}

nexrad::GriddedVolume vtkNexradReadNetCDF(
  const std::filesystem::path& path, const vtkNexradNetCDFRequest& request)
{
  const vtkNexradNetCDFLock lock;
  const vtkNexradNetCDFFile file(path, vtkNexradNetCDFFile::Mode::Read, path.string());
  const vtkNexradNetCDFContents contents = ReadContents(file);
  if (request.Time >= contents.Times.size())
  {
    file.Fail("has " + std::to_string(contents.Times.size()) + " times, and none of index " +
              std::to_string(request.Time));
  }
  const std::vector<nexrad::MomentName> wanted = MomentsOf(request, contents, file);
  // Values, states and ancillary arrays, here and in the image that is made of them.
  constexpr std::size_t bytesPerVoxel = 2 * (3 * sizeof(float) + 3);
  const std::size_t bytes = contents.Grid.VoxelCount() * wanted.size() * bytesPerVoxel;
  if (bytes > request.MaximumBytes)
  {
    file.Fail("its voxels need up to " + std::to_string(bytes >> 20) + " MiB, and " +
              std::to_string(request.MaximumBytes >> 20) + " MiB are allowed");
  }
  std::vector<nexrad::GriddedVolume> moments;
  for (const nexrad::MomentName moment : wanted)
  {
    nexrad::GriddedVolume volume;
    volume.grid = contents.Grid;
    volume.time = contents.Times[request.Time];
    volume.moment = moment;
    volume.method = file.Text(NC_GLOBAL, "method").value_or("");
    volume.synthetic = file.Text(NC_GLOBAL, "synthetic").value_or("") == "yes";
    volume.sharpened = file.Text(NC_GLOBAL, "sharpened").value_or("") == "yes";
    const std::vector<int> places = vtkNexradReadRadars(file, request.Time, volume);
    volume.ofOneRadar = contents.OfOneRadar && volume.sitePositions.size() == 1;
    vtkNexradReadNetCDFVoxels(file, request.Time, places, request.LeaveOut, volume);
    moments.push_back(std::move(volume));
  }
  return nexrad::JoinMoments(std::move(moments));
}
