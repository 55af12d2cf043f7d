// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Settings/Setting.h"

#include <nlohmann/json.hpp>

namespace nexrad
{

std::string SettingRow::Option() const
{
  return (IsFlag() && usual == "on" ? "--no-" : "--") + key;
}

std::string SettingRow::TextOf(double number) const
{
  const auto index = static_cast<std::size_t>(number);
  if (value.kind == "choice" && number >= 0.0 && index < value.choices.size())
  {
    return value.choices[index];
  }
  if (IsFlag())
  {
    return number != 0.0 ? "on" : "off";
  }
  const char* unit = value.kind == "length" ? "m" : value.kind == "duration" ? "s" : "";
  return NumberText(number) + unit;
}

std::string SettingsJson(const std::vector<SettingRow>& rows)
{
  constexpr const char* uses[] = {"result", "machine", "library", "picture", "program"};
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SettingRow& row : rows)
  {
    json.push_back({{"key", row.key}, {"option", row.Option()}, {"kind", row.value.kind},
      {"choices", row.value.choices}, {"least", row.value.least}, {"most", row.value.most},
      {"default", row.Default()}, {"excludes", row.excludes},
      {"use", uses[static_cast<int>(row.use)]}, {"says", row.says}});
  }
  return json.dump(1);
}

} // namespace nexrad
