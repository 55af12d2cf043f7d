// SPDX-License-Identifier: BSD-3-Clause
// Feeds texts to the reader of the site table. The program's own table is compiled in.
#include "FuzzTarget.h"

#include "nexrad/Model/SiteTable.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>

using namespace nexrad;
using namespace nexrad::testing;

namespace nexrad::testing
{

std::vector<Bytes> FuzzSeeds()
{
  const std::string heading =
    "icao,kind,name,state,latitude_deg,longitude_deg,ground_m_msl,antenna_m_msl\n";
  return {BytesOf(heading + "KAAA,wsr88d,Some Place,MO,38.698900,-90.682861,185,220.0\n"
                            "TBBB,tdwr,Other/Place,KS,-37.5,97.25,,28.5\n"),
    BytesOf(heading)};
}

} // namespace nexrad::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(data, data + size);
  try
  {
    const std::vector<KnownSite> sites = ParseSiteTable(text);
    const auto rows = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
    Require(sites.size() <= rows, "a row is one radar at most");
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      Require(!sites[i].name.empty(), "a radar has a name");
      Require(i == 0 || !(sites[i].name < sites[i - 1].name), "radars are ordered by name");
      const Position& position = sites[i].position;
      Require(std::abs(position.latitude) <= 90.0 && std::abs(position.longitude) <= 180.0 &&
                std::isfinite(position.altitude),
        "a radar is on Earth");
    }
  }
  catch (const Error& error)
  {
    RequireMessage(error.what());
  }
  return 0;
}
