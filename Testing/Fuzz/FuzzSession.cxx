// SPDX-License-Identifier: BSD-3-Clause
// Feeds texts to the reader of session files (.nxsession).
#include "FuzzTarget.h"

#include "Options/DrawingOptions.h"
#include "Options/SessionFile.h"
#include "nexrad/System/Error.h"

using namespace nexrad;
using namespace nexrad::application;
using namespace nexrad::testing;

namespace
{

std::string TextOf(const Session& session)
{
  std::string text;
  for (const OptionText& option : OptionTextsOf(session.drawing))
  {
    text += option.name + "=" + option.value + "\n";
  }
  return text;
}

Bytes SeedOf(const std::string& keys)
{
  return BytesOf(R"({"format":"nexrad3d session","version":1,)" + keys + "}");
}

} // namespace

namespace nexrad::testing
{

std::vector<Bytes> FuzzSeeds()
{
  return {SeedOf(R"("inputs":["a.nxv","/b/c.nxv.series"],"time":"2006-03-12T18:35:00.250Z",)"
                 R"("interval":"0.04s","options":{"size":"900x600","tilt":52.5,)"
                 R"("preset":"storm cores","no-walls":true})"),
    SeedOf(R"("synthetic":true,"options":{"azimuth":"-20","zoom":"2","look-at":"39,-92,5km",)"
           R"("parallel":true,"slices":"512","iso-values":"20:0.5,35","colour-by":"VEL",)"
           R"("shadow":"0.5","occlusion":"0.2","light":"200,30","exaggeration":"4","rings":"50km",)"
           R"("theme":"light","names":true})"),
    SeedOf(
      R"("inputs":["a"],"options":{"map":"vil","array":"REF","crop":"-50km,50km,-40km,40km,0km,)"
      R"(10km","clip":"0km,0km,30","section":"-92deg,38deg,-91deg,39deg"})"),
    SeedOf(R"("inputs":["a"],"options":{"dims":"64x64x32","moment":"REF,VEL","step":"5min",)"
           R"("box":"0km,0km,10km,10km","follow-from":"2006-03-12T18:00","quality":"off"})"),
    SeedOf(R"("inputs":["a"],"colours":[{"Name":"mine","RGBPoints":[0,0,0,0,70,1,1,1]}])")};
}

} // namespace nexrad::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const InputFile file("window.nxsession");
  static const InputFile again("again.nxsession");
  file.Write(data, size);
  Session session;
  try
  {
    session = ReadSession(file.Path());
  }
  catch (const Error& error)
  {
    Require(std::string(error.what()).rfind(file.Path().string() + ": ", 0) == 0,
      "a message names the file");
    RequireMessage(error.what());
    return 0;
  }
  WriteSession(again.Path(), session);
  const Session back = ReadSession(again.Path());
  Require(TextOf(back) == TextOf(session), "options come back as they were written");
  Require(back.shown == session.shown && back.interval == session.interval &&
            back.synthetic == session.synthetic && back.colours == session.colours,
    "a session comes back as it was written");
  return 0;
}
