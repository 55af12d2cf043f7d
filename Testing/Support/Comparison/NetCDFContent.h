// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

#include "vtk_netcdf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::testing
{

/// A NetCDF file of merged volumes (Documentation/Formats/netcdf.md), read with the NetCDF library
/// alone.
class NetCDFContent
{
public:
  explicit NetCDFContent(const std::filesystem::path& path)
  {
    EXPECT_EQ(nc_open(path.c_str(), NC_NOWRITE, &file), NC_NOERR) << path;
  }
  ~NetCDFContent() { nc_close(file); }
  NetCDFContent(const NetCDFContent&) = delete;
  NetCDFContent& operator=(const NetCDFContent&) = delete;

  bool Has(const std::string& name) const
  {
    int variable = -1;
    return nc_inq_varid(file, name.c_str(), &variable) == NC_NOERR;
  }

  /// All numbers of a variable.
  std::vector<double> Numbers(const std::string& name) const
  {
    std::vector<double> numbers(this->SizeOf(name));
    EXPECT_EQ(nc_get_var_double(file, this->VariableOf(name), numbers.data()), NC_NOERR) << name;
    return numbers;
  }

  /// An attribute of a variable.
  double Number(const std::string& variable, const char* name) const
  {
    double number = 0.0;
    EXPECT_EQ(nc_get_att_double(file, this->VariableOf(variable), name, &number), NC_NOERR) << name;
    return number;
  }

  /// An attribute of the file; empty without it.
  std::string Text(const char* name) const
  {
    std::size_t length = 0;
    nc_inq_attlen(file, NC_GLOBAL, name, &length);
    std::string text(length, '\0');
    nc_get_att_text(file, NC_GLOBAL, name, text.data());
    return text;
  }

  std::vector<std::string> RadarNames() const
  {
    std::vector<char*> texts(this->SizeOf("radar_name"));
    EXPECT_EQ(nc_get_var_string(file, this->VariableOf("radar_name"), texts.data()), NC_NOERR);
    std::vector<std::string> names(texts.begin(), texts.end());
    nc_free_string(texts.size(), texts.data());
    return names;
  }

private:
  int VariableOf(const std::string& name) const
  {
    int variable = -1;
    EXPECT_EQ(nc_inq_varid(file, name.c_str(), &variable), NC_NOERR) << name;
    return variable;
  }

  std::size_t SizeOf(const std::string& name) const
  {
    int dimensions[NC_MAX_VAR_DIMS] = {};
    int count = 0;
    const int variable = this->VariableOf(name);
    nc_inq_varndims(file, variable, &count);
    nc_inq_vardimid(file, variable, dimensions);
    std::size_t size = 1;
    for (int i = 0; i < count; ++i)
    {
      std::size_t length = 0;
      nc_inq_dimlen(file, dimensions[i], &length);
      size *= length;
    }
    return size;
  }

  int file = -1;
};

/// Expects the arrays of one moment at one of the file's times, counted from 0.
inline void ExpectMoment(const NetCDFContent& file, std::size_t time, const GriddedVolume& volume)
{
  const std::size_t voxels = volume.values.size();
  const std::string moment = ToString(volume.moment);
  const std::vector<std::string> radars = file.RadarNames();
  const auto arrayOf = [&](const std::string& name)
  {
    const std::vector<double> all = file.Numbers(name);
    EXPECT_LE((time + 1) * voxels, all.size()) << name;
    return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(time * voxels),
      all.begin() + static_cast<std::ptrdiff_t>((time + 1) * voxels));
  };
  const std::vector<double> values = arrayOf(moment);
  const std::vector<double> states = arrayOf(moment + "_state");
  EXPECT_EQ(file.Number(moment, "no_echo_value"), static_cast<double>(volume.fill));
  for (std::size_t i = 0; i < voxels; ++i)
  {
    ASSERT_EQ(states[i], static_cast<double>(volume.states[i])) << i;
    if (volume.states[i] == VoxelState::Echo)
    {
      ASSERT_EQ(values[i], static_cast<double>(volume.values[i])) << i;
    }
    else
    {
      ASSERT_TRUE(std::isnan(values[i])) << i;
    }
  }
  const auto expect = [&](const std::string& name, const auto& expected)
  {
    const std::string full = AncillaryArrayName(volume.moment, name);
    ASSERT_EQ(file.Has(full), !expected.empty()) << full;
    const std::vector<double> found = expected.empty() ? std::vector<double>() : arrayOf(full);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      if (name == "site")
      {
        const auto site = static_cast<std::size_t>(expected[i]);
        const auto place = static_cast<std::size_t>(std::max(found[i], 0.0));
        const std::string radar = found[i] < 0.0 ? "" : radars[place];
        ASSERT_EQ(radar, site < volume.sites.size() ? volume.sites[site] : "") << full << ' ' << i;
      }
      else // an age is not known where no radar scanned
      {
        ASSERT_EQ(std::isnan(found[i]) ? 0.0 : found[i], static_cast<double>(expected[i]))
          << full << ' ' << i;
      }
    }
  };
  ForEachAncillaryArray(volume.ancillary, expect);
}

/// Expects a volume, with its further moments, at one of the file's times, counted from 0.
inline void ExpectVolume(const NetCDFContent& file, std::size_t time, const GriddedVolume& volume)
{
  EXPECT_EQ(file.Numbers("time").at(time), ToSeconds(volume.time));
  EXPECT_EQ(file.Text("method"), volume.method);
  EXPECT_EQ(file.Text("synthetic"), volume.synthetic ? "yes" : "no");
  EXPECT_EQ(file.Text("one_radar"), volume.ofOneRadar ? "yes" : "");
  const std::vector<std::string> radars = file.RadarNames();
  const std::vector<double> used = file.Numbers("radar_used");
  const std::vector<double> latitudes = file.Numbers("radar_latitude");
  std::size_t count = 0;
  for (std::size_t radar = 0; radar < radars.size(); ++radar)
  {
    const auto site = std::find(volume.sites.begin(), volume.sites.end(), radars[radar]);
    const bool takesPart = site != volume.sites.end();
    EXPECT_EQ(used[time * radars.size() + radar], takesPart ? 1.0 : 0.0) << radars[radar];
    count += takesPart ? 1 : 0;
    if (takesPart && !volume.sitePositions.empty())
    {
      const auto place = static_cast<std::size_t>(site - volume.sites.begin());
      EXPECT_EQ(latitudes[radar], volume.sitePositions[place].latitude) << radars[radar];
    }
  }
  EXPECT_EQ(count, volume.sites.size());
  ExpectMoment(file, time, volume);
  for (const GriddedVolume& further : volume.further)
  {
    ExpectMoment(file, time, further);
  }
}

} // namespace nexrad::testing
