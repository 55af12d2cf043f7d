// SPDX-License-Identifier: BSD-3-Clause
// Feeds texts to the reader of the index of a series (.nxv.series).
#include "FuzzTarget.h"

#include "nexrad/Codec/NxvSeries.h"
#include "nexrad/Model/Time.h"
#include "nexrad/System/Error.h"

using namespace nexrad;
using namespace nexrad::testing;

namespace nexrad::testing
{

std::vector<Bytes> FuzzSeeds()
{
  const InputFile file("seed.nxv.series");
  WriteNxvSeries(file.Path(),
    {{"20060312T180000Z.nxv", 1142186400.0}, {"sub/20060312T180500Z.nxv", 1142186700.25}});
  return {BytesOf(FileContent(file.Path())), BytesOf(R"({"file-series-version":"1.0","files":[]})"),
    BytesOf(
      R"({"file-series-version":"1.0","files":[{"name":"\u00e9\n\u0000","time":-62135596800}]})")};
}

} // namespace nexrad::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const InputFile file("day.nxv.series");
  static const InputFile again("again.nxv.series");
  file.Write(data, size);
  NxvSeries series;
  try
  {
    series = ReadNxvSeries(file.Path());
  }
  catch (const Error& error)
  {
    Require(std::string(error.what()).rfind(file.Path().string() + ": ", 0) == 0,
      "a message names the file");
    RequireMessage(error.what());
    return 0;
  }
  for (const auto& [name, time] : series)
  {
    const std::string text = FormatIso8601(FromSeconds(time));
    Require(ParseIso8601(text) == FromSeconds(time), "times can be written as ISO 8601");
  }
  WriteNxvSeries(again.Path(), series);
  Require(ReadNxvSeries(again.Path()) == series, "an index comes back as it was written");
  return 0;
}
