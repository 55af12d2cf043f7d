// SPDX-License-Identifier: BSD-3-Clause
#include "Options/SessionFile.h"

#include "Options/UnitOptions.h"
#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Codec/JsonText.h"
#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/MessageText.h"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr char formatName[] = "nexrad3d session";
constexpr int formatVersion = 1;
constexpr std::size_t dashes = 2; // before the name of an option

std::string TextOf(const Json& value, const char* what)
{
  if (!value.is_string())
  {
    throw Error(Excerpt(value.dump()) + " is no text; write " + what);
  }
  return value.get<std::string>();
}

void ReadInputs(const Json& value, const fs::path& folder, Session& session)
{
  if (!value.is_array())
  {
    throw Error("write a list of paths");
  }
  for (const Json& input : value)
  {
    session.drawing.input.inputs.push_back(folder / TextOf(input, "a path"));
  }
}

// A flag is `true`; numbers may be written as numbers.
OptionText OptionOf(const std::string& key, const Json& value)
{
  if (value.is_boolean() && value.get<bool>())
  {
    return {"--" + key, ""};
  }
  if (!value.is_string() && !value.is_number())
  {
    throw Error("--" + key + ": " + Excerpt(value.dump()) +
                " is no value of an option; write a text, a number, or true for a flag");
  }
  return {"--" + key, value.is_string() ? value.get<std::string>() : value.dump()};
}

void ReadOptions(const Json& value, Session& session)
{
  if (!value.is_object())
  {
    throw Error("write the options of nexrad3d render, as in {\"tilt\": \"20\"}");
  }
  std::vector<OptionText> texts;
  for (const auto& [key, text] : value.items())
  {
    texts.push_back(OptionOf(key, text));
  }
  ParseOptionTexts(texts, session.drawing);
}

void ReadKey(const std::string& key, const Json& value, const fs::path& folder, Session& session)
{
  if (key == "inputs")
  {
    ReadInputs(value, folder, session);
  }
  else if (key == "synthetic")
  {
    session.synthetic = value == true;
  }
  else if (key == "time")
  {
    session.shown = ParseTime(TextOf(value, "a time as in 2006-03-12T18:00"));
  }
  else if (key == "interval")
  {
    session.interval = ParseInterval(TextOf(value, "a duration as in 0.5s"));
  }
  else if (key == "options")
  {
    ReadOptions(value, session);
  }
  else if (key == "colours")
  {
    session.colours = value.dump();
  }
  else if (key != "format" && key != "version")
  {
    throw Error("there is no such key");
  }
}

Json ParseText(const std::string& text)
{
  RequireShallowJson(text);
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("format", Json()) != formatName)
  {
    throw Error(std::string("format: is not \"") + formatName + "\"; this is no session");
  }
  const Json version = json.value("version", Json());
  if (version != formatVersion)
  {
    throw Error("version: is " + Excerpt(version.dump()) + "; this program reads version " +
                std::to_string(formatVersion));
  }
  return json;
}

Session SessionOf(const Json& json, const fs::path& folder)
{
  Session session;
  for (const auto& [key, value] : json.items())
  {
    try
    {
      ReadKey(key, value, folder, session);
    }
    catch (const std::exception& problem)
    {
      throw Error(Excerpt(key) + ": " + problem.what());
    }
  }
  if (session.drawing.input.inputs.empty() && !session.synthetic)
  {
    throw Error("inputs: there is none");
  }
  return session;
}

std::string TextOf(const fs::path& path)
{
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file || fs::is_directory(path))
  {
    throw Error(std::string("cannot be read: ") + std::strerror(errno != 0 ? errno : EISDIR));
  }
  return text;
}

Json OptionsOf(const Session& session)
{
  Json options = Json::object();
  for (const OptionText& text : OptionTextsOf(session.drawing))
  {
    options[text.name.substr(dashes)] = text.value.empty() ? Json(true) : Json(text.value);
  }
  return options;
}

} // namespace

bool IsSessionFile(const fs::path& path)
{
  return path.extension() == SessionSuffix;
}

void WriteSession(const fs::path& path, const Session& session)
{
  Json json = {{"format", formatName}, {"version", formatVersion}};
  if (session.synthetic)
  {
    json["synthetic"] = true;
  }
  else
  {
    json["inputs"] = Json::array();
    for (const fs::path& input : session.drawing.input.inputs)
    {
      json["inputs"].push_back(fs::absolute(input).string());
    }
  }
  if (session.shown)
  {
    json["time"] = FormatIso8601(*session.shown);
  }
  json["interval"] = DurationText(session.interval);
  json["options"] = OptionsOf(session);
  if (!session.colours.empty())
  {
    json["colours"] = Json::parse(session.colours);
  }
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  WriteFileAtomically(path, text.data(), text.size());
}

Session ReadSession(const fs::path& path)
{
  RequireOrdinaryFile(path);
  try
  {
    return SessionOf(ParseText(TextOf(path)), fs::absolute(path).parent_path());
  }
  catch (const std::exception& problem)
  {
    throw FileError(path, problem.what());
  }
}

} // namespace nexrad::application
