// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/SiteResolution.h"

#include "nexrad/Model/SiteTable.h"

#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <string>

namespace nexrad
{

namespace
{

// A known site's name in a file's name, as in "KLOT19950413_132143.gz" or "Level2_KFTG_20150430".
std::string FindNameInPath(const std::string& path)
{
  const std::string file = std::filesystem::path(path).filename().string();
  for (std::size_t place = 0; place + 4 <= file.size(); ++place)
  {
    if (const KnownSite* site = FindSite(std::string_view(file).substr(place, 4)))
    {
      return site->name;
    }
  }
  return {};
}

// Degrees; radars have been moved by less.
constexpr double farFromTable = 1.0;

bool IsNear(const KnownSite& known, double latitude, double longitude)
{
  return std::abs(latitude - known.position.latitude) <= farFromTable &&
         std::abs(longitude - known.position.longitude) <= farFromTable;
}

// Whether the rays are of another radar than the header says: they state its name, and its place
// by the site table, where the header's radar is not.
bool HeaderNamesOther(const std::string& headerName, const RadarOfRays& ofRays)
{
  const KnownSite* byRays = FindSite(ofRays.name);
  const KnownSite* byHeader = FindSite(headerName);
  if (byRays == nullptr || byHeader == nullptr || !ofRays.position || byRays == byHeader)
  {
    return false;
  }
  const StoredPosition& stated = *ofRays.position;
  return IsNear(*byRays, stated.latitude, stated.longitude) &&
         !IsNear(*byHeader, stated.latitude, stated.longitude);
}

std::string ResolveName(const std::string& headerName, const RadarOfRays& ofRays,
  const Level2Options& options, RadarVolume& volume)
{
  if (!options.siteName.empty())
  {
    return options.siteName;
  }
  if (HeaderNamesOther(headerName, ofRays))
  {
    volume.notes.push_back("the volume header names " + headerName + ", and the rays are of " +
                           ofRays.name + " and state its position: they count");
    return ofRays.name;
  }
  if (!headerName.empty())
  {
    return headerName;
  }
  if (!ofRays.name.empty())
  {
    return ofRays.name;
  }
  std::string name = FindNameInPath(volume.file);
  volume.notes.push_back(name.empty()
                           ? "the site has no name, neither in the file nor in the file's name"
                           : "the site's name, " + name + ", is from the file's name");
  return name;
}

bool IsOnEarth(const Position& position)
{
  return std::isfinite(position.latitude) && std::isfinite(position.longitude) &&
         std::abs(position.latitude) <= 90.0 && std::abs(position.longitude) <= 180.0 &&
         (position.latitude != 0.0 || position.longitude != 0.0);
}

std::optional<Position> ConvertStored(const StoredPosition& stored, RadarVolume& volume)
{
  Position position{stored.latitude, stored.longitude, double(stored.siteHeight)};
  if (std::abs(position.latitude) > 90.0)
  {
    position.latitude /= 1000.0;
    position.longitude /= 1000.0;
    volume.notes.push_back("the file has the site's position in thousandths of a degree");
  }
  const KnownSite* known = FindSite(volume.site.name);
  const bool isTerminal = known != nullptr
                            ? known->terminal
                            : IsTerminalPattern(volume.coveragePatternNumber.value_or(0));
  if (!isTerminal)
  {
    position.altitude += stored.feedhornHeight;
  }
  return IsOnEarth(position) ? std::optional(position) : std::nullopt;
}

// Some files have a height in feet that was taken for metres and turned into metres once more: 180
// m for KTYX, whose antenna stands at 597 m. Heights that contradict the site table in another way
// may be of a radar that has moved.
void CheckHeight(const KnownSite& known, RadarVolume& volume)
{
  constexpr double tolerated = 100.0; // m, more than the height of a tower
  constexpr double alike = 50.0;      // m, a tower and the rounding of the file
  constexpr double metresPerFoot = 0.3048;
  double& height = volume.site.position->altitude;
  const double listed = known.position.altitude;
  if (std::abs(height - listed) <= tolerated)
  {
    return;
  }
  const bool isInFeetTwice = std::abs(height / metresPerFoot - listed) <= alike;
  const auto inMetres = [](double value) { return std::to_string(std::lround(value)) + " m"; };
  volume.notes.push_back(
    "the antenna's height in the file, " + inMetres(height) + ", is not the site table's, " +
    inMetres(listed) +
    (isInFeetTwice ? ", but is it as feet turned into metres twice: the table's is used"
                   : ": the file's is used"));
  if (isInFeetTwice)
  {
    volume.storedAltitude = height;
    height = listed;
  }
}

// A radar far from where the site table has it is most likely one with a damaged position.
void CheckPlace(const KnownSite& known, RadarVolume& volume)
{
  const Position& stated = *volume.site.position;
  if (IsNear(known, stated.latitude, stated.longitude))
  {
    return;
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << "the file has " << volume.site.name << " at "
       << stated.latitude << ", " << stated.longitude << " degrees, the site table at "
       << known.position.latitude << ", " << known.position.longitude
       << " degrees: the file's position is used";
  volume.notes.push_back(text.str());
}

} // namespace

void ResolveSite(const std::string& headerName, const RadarOfRays& ofRays,
  const Level2Options& options, RadarVolume& volume)
{
  volume.site.name = ResolveName(headerName, ofRays, options, volume);
  if (options.position)
  {
    volume.site.position = options.position;
    return;
  }
  if (ofRays.position)
  {
    volume.site.position = ConvertStored(*ofRays.position, volume);
  }
  const KnownSite* known = FindSite(volume.site.name);
  if (volume.site.position)
  {
    if (known != nullptr)
    {
      CheckPlace(*known, volume);
      CheckHeight(*known, volume);
    }
  }
  else if (known != nullptr)
  {
    volume.site.position = known->position;
    volume.notes.push_back("the site's position is from the site table");
  }
  else
  {
    volume.notes.push_back("the site's position is unknown: neither in the file nor in the table");
  }
}

} // namespace nexrad
