// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNetCDFOutput.h"

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"
#include "vtkNexradNetCDFFile.h"
#include "vtkNexradNetCDFGrid.h"
#include "vtkNexradNetCDFVoxels.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <system_error>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace
{

constexpr char NamesName[] = "radar_name";
constexpr char UsedName[] = "radar_used";

struct CoordinateTerms
{
  const char* Name;
  const char* StandardName;
  const char* LongName;
  const char* Units;
};
constexpr CoordinateTerms Coordinates[3] = {
  {"radar_latitude", "latitude", "latitude of the radar", "degrees_north"},
  {"radar_longitude", "longitude", "longitude of the radar", "degrees_east"},
  {"radar_altitude", "altitude", "height of the antenna above mean sea level", "m"}};

// A variable that grows along the dimension `radar`.
int DefineRadarVariable(const vtkNexradNetCDFFile& file, const std::string& name, nc_type type,
  const std::vector<int>& dimensions)
{
  // As many as the radars of the continent.
  const std::vector<std::size_t> chunk(dimensions.size(), 256);
  int variable = -1;
  file.Check(nc_def_var(file.Id(), name.c_str(), type, static_cast<int>(dimensions.size()),
               dimensions.data(), &variable),
    name);
  file.Check(nc_def_var_chunking(file.Id(), variable, NC_CHUNKED, chunk.data()), name);
  return variable;
}

// The radars that a file names while volumes are added to it: names, positions, and which of them
// took part at each time.
class Radars
{
public:
  // Defines the variables. `time` is the number of the dimension.
  Radars(const vtkNexradNetCDFFile& file, int time)
    : File(file)
  {
    int radar = -1;
    file.Check(nc_def_dim(file.Id(), "radar", NC_UNLIMITED, &radar), "radar");
    this->NameVariable = DefineRadarVariable(file, NamesName, NC_STRING, {radar});
    file.SetText(this->NameVariable, "long_name", "identifier of the radar");
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->PositionVariables[i] =
        DefineRadarVariable(file, Coordinates[i].Name, NC_DOUBLE, {radar});
      const int variable = this->PositionVariables[i];
      file.SetText(variable, "standard_name", Coordinates[i].StandardName);
      file.SetText(variable, "long_name", Coordinates[i].LongName);
      file.SetText(variable, "units", Coordinates[i].Units);
      file.SetNumbers(variable, "_FillValue", {std::numeric_limits<double>::quiet_NaN()});
    }
    file.SetText(this->PositionVariables[2], "positive", "up");
    this->UsedVariable = DefineRadarVariable(file, UsedName, NC_BYTE, {time, radar});
    file.SetText(this->UsedVariable, "long_name", "whether the radar's data are in the volume");
    file.SetNumbers<signed char>(this->UsedVariable, "flag_values", {0, 1});
    file.SetText(this->UsedVariable, "flag_meanings", "no yes");
  }

  // Writes those of a volume, `index` being its place among the times. Returns the places of its
  // sites among the radars of the file.
  std::vector<short> Add(const nexrad::GriddedVolume& volume, std::size_t index)
  {
    const bool placed = volume.sitePositions.size() == volume.sites.size();
    std::vector<short> places;
    for (std::size_t i = 0; i < volume.sites.size(); ++i)
    {
      const std::string& name = volume.sites[i];
      const auto known = std::find(this->Known.begin(), this->Known.end(), name);
      places.push_back(static_cast<short>(known - this->Known.begin()));
      if (known == this->Known.end())
      {
        const nexrad::KnownSite* listed = nexrad::FindSite(name);
        this->AddRadar(name, placed   ? &volume.sitePositions[i]
                             : listed ? &listed->position
                                      : nullptr);
        for (std::size_t before = 0; before < index; ++before)
        {
          this->WriteUse(before, this->Known.size() - 1, false);
        }
      }
    }
    for (std::size_t radar = 0; radar < this->Known.size(); ++radar)
    {
      const auto place = static_cast<short>(radar);
      this->WriteUse(index, radar, std::find(places.begin(), places.end(), place) != places.end());
    }
    return places;
  }

  // Of all volumes so far.
  const std::vector<std::string>& Names() const { return this->Known; }

private:
  void AddRadar(const std::string& name, const nexrad::Position* position)
  {
    const std::size_t place = this->Known.size();
    const char* text = name.c_str();
    this->File.Check(
      nc_put_var1_string(this->File.Id(), this->NameVariable, &place, &text), NamesName);
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const double numbers[3] = {position ? position->latitude : unknown,
      position ? position->longitude : unknown, position ? position->altitude : unknown};
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->File.Check(
        nc_put_var1_double(this->File.Id(), this->PositionVariables[i], &place, &numbers[i]),
        Coordinates[i].Name);
    }
    this->Known.push_back(name);
  }

  void WriteUse(std::size_t index, std::size_t radar, bool used)
  {
    const std::size_t start[2] = {index, radar};
    const auto flag = static_cast<signed char>(used ? 1 : 0);
    this->File.Check(
      nc_put_var1_schar(this->File.Id(), this->UsedVariable, start, &flag), UsedName);
  }

  const vtkNexradNetCDFFile& File;
  std::vector<std::string> Known;
  int NameVariable = -1;
  int PositionVariables[3] = {-1, -1, -1}; // latitude, longitude, altitude
  int UsedVariable = -1;
};

// Of this layout of NetCDF files, in the attribute of that name.
constexpr int Version = 1;
constexpr char VersionName[] = "vtk_nexrad_netcdf_version";

// Bytes of what does not depend on the number of voxels.
constexpr std::size_t ofAnyFile = std::size_t(4) << 20;

// A name beside that of an AtomicFile, made as its own: what another process that looks for
// abandoned files finds while the NetCDF library has it open and locked.
fs::path NameBeside(const fs::path& temporary)
{
  std::string stem = temporary.stem().string();
  stem.back() = stem.back() == '0' ? '1' : '0';
  return temporary.parent_path() / (stem + temporary.extension().string());
}

// The same where there is room for a file. A full disk would leave the NetCDF library with a file
// that it can neither write nor close, and end the program.
fs::path MakeRoomBeside(nexrad::AtomicFile& target)
{
  target.RequireRoom(ofAnyFile);
  return NameBeside(target.TemporaryPath());
}

// At least as many bytes as a volume takes in the file, other than what all files have.
std::size_t MostBytes(const nexrad::GriddedVolume& volume)
{
  // Values and states, the ancillary arrays, and the view of one radar.
  constexpr std::size_t ofVoxel = 4 + 1 + 4 + 1 + 4 + 2 + 3 * 4;
  return volume.values.size() * ofVoxel * (1 + volume.further.size());
}

std::string Joined(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

// The attributes of the file: conventions, title, where the data come from.
void WriteProvenance(
  const vtkNexradNetCDFFile& file, const nexrad::GriddedVolume& volume, const std::string& history)
{
  const std::string radars = Joined(volume.sites);
  const auto set = [&file](const char* name, const std::string& text)
  { file.SetText(NC_GLOBAL, name, text); };
  set("Conventions", "CF-1.8");
  set("title",
    std::string(volume.synthetic ? "SYNTHETIC: " : "") + "weather radar volumes on a regular grid");
  set("institution", volume.synthetic
                       ? "none: the radar data are SYNTHETIC, made by nexrad3d simulate"
                       : "radar data: the weather radars of the United States (NEXRAD, TDWR)");
  set("source", std::string(volume.synthetic ? "SYNTHETIC radar files" : "NEXRAD Level II files") +
                  (radars.empty() ? "" : " of " + radars) +
                  ", gridded by vtk-nexrad with the method " + volume.method);
  set("history", history);
  set("references",
    "vtk-nexrad, Documentation/Formats/netcdf.md; cfconventions.org (CF Metadata Conventions 1.8)");
  set("comment",
    "Where there is no value, the variable of a moment whose name ends in _state says why: no "
    "echo, range folded, not scanned, or filtered.");
  set("method", volume.method);
  if (volume.ofOneRadar)
  {
    set("one_radar", "yes");
  }
  set("synthetic", volume.synthetic ? "yes" : "no");
  set("sharpened", volume.sharpened ? "yes" : "no");
  file.SetNumbers(NC_GLOBAL, VersionName, {Version});
}

} // namespace

/// The library locks the files that it writes, and so does AtomicFile. So the library writes a file
/// of its own, whose bytes are copied when it is complete.
class vtkNexradNetCDFOutput::Parts
{
public:
  Parts(const fs::path& path, const std::string& theHistory)
    : target(path)
    , written(MakeRoomBeside(target))
    , file(written, path.string())
    , history(theHistory)
  {
  }

  ~Parts()
  {
    std::error_code ignored;
    fs::remove(written, ignored);
  }

  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void Add(const nexrad::GriddedVolume& volume)
  {
    target.RequireRoom(MostBytes(volume) + ofAnyFile);
    if (count == 0)
    {
      this->Begin(volume);
    }
    if (volume.grid != first.grid || volume.method != first.method)
    {
      file.Fail("a volume at " + nexrad::FormatIso8601(volume.time) +
                " has another grid or method than the first");
    }
    if (count > 0 && volume.time <= last)
    {
      file.Fail("the volume at " + nexrad::FormatIso8601(volume.time) + " follows one at " +
                nexrad::FormatIso8601(last) + ": times must ascend");
    }
    last = volume.time;
    const double seconds = nexrad::ToSeconds(volume.time);
    file.Check(nc_put_var1_double(file.Id(), timeVariable, &count, &seconds), "time");
    const std::vector<short> places = radars->Add(volume, count);
    voxels->Write(volume, count, places);
    ++count;
  }

  void Commit()
  {
    if (count == 0)
    {
      file.Fail("has no volume");
    }
    voxels->NameRadars(radars->Names());
    file.Close();
    this->Copy();
    target.Commit();
  }

private:
  void Begin(const nexrad::GriddedVolume& volume)
  {
    first.grid = volume.grid;
    first.method = volume.method;
    WriteProvenance(file, volume, history);
    const vtkNexradNetCDFDimensions dimensions = vtkNexradWriteGrid(file, volume.grid);
    file.Check(
      nc_def_var(file.Id(), "time", NC_DOUBLE, 1, &dimensions.Time, &timeVariable), "time");
    const std::size_t chunk = 512;
    file.Check(nc_def_var_chunking(file.Id(), timeVariable, NC_CHUNKED, &chunk), "time");
    file.SetText(timeVariable, "standard_name", "time");
    file.SetText(timeVariable, "long_name", "time of the volume, UTC");
    file.SetText(timeVariable, "units", "seconds since 1970-01-01T00:00:00Z");
    file.SetText(timeVariable, "calendar", "standard");
    file.SetText(timeVariable, "axis", "T");
    radars = std::make_unique<Radars>(file, dimensions.Time);
    voxels = std::make_unique<vtkNexradNetCDFVoxels>(file, dimensions, volume);
  }

  void Copy()
  {
    std::ifstream source(written, std::ios::binary);
    std::vector<char> block(std::size_t(1) << 20);
    while (source)
    {
      source.read(block.data(), static_cast<std::streamsize>(block.size()));
      target.Write(block.data(), static_cast<std::size_t>(source.gcount()));
    }
    if (!source.eof())
    {
      file.Fail("cannot be written: its temporary file cannot be read");
    }
  }

  nexrad::AtomicFile target;
  const fs::path written;
  vtkNexradNetCDFFile file;
  const std::string history;
  std::unique_ptr<Radars> radars;
  std::unique_ptr<vtkNexradNetCDFVoxels> voxels;
  int timeVariable = -1;
  std::size_t count = 0;
  nexrad::Time last{};
  nexrad::GriddedVolume first; // its grid and its method
};

vtkNexradNetCDFOutput::vtkNexradNetCDFOutput(const fs::path& path, const std::string& history)
{
  const auto lock = vtkNexradLockNetCDF();
  this->File = std::make_unique<Parts>(path, history);
}

vtkNexradNetCDFOutput::~vtkNexradNetCDFOutput()
{
  const auto lock = vtkNexradLockNetCDF();
  this->File.reset();
}

void vtkNexradNetCDFOutput::Add(const nexrad::GriddedVolume& volume)
{
  const auto lock = vtkNexradLockNetCDF();
  this->File->Add(volume);
}

void vtkNexradNetCDFOutput::Commit()
{
  const auto lock = vtkNexradLockNetCDF();
  this->File->Commit();
}

void vtkNexradWriteNetCDF(
  const fs::path& path, const nexrad::GriddedVolume& volume, const std::string& history)
{
  vtkNexradNetCDFOutput output(path, history);
  output.Add(volume);
  output.Commit();
}
