// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/Settings/Setting.h"

namespace nexrad
{

/// All settings of the merge. A new one is a row here, and the place where it acts.
const SettingTable<MergeOptions>& MergeSettings();

} // namespace nexrad
