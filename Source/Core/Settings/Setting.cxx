// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Settings/Setting.h"

#include <nlohmann/json.hpp>

namespace nexrad
{

std::string SettingRow::Option() const
{
  return (IsFlag() && usual == "on" ? "--no-" : "--") + key;
}

std::string SettingsJson(const std::vector<SettingRow>& rows)
{
  constexpr const char* uses[] = {"result", "machine", "library"};
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
