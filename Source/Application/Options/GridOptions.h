// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/OptionText.h"
#include "nexrad/Merging/MergeOptions.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace nexrad::application
{

/// Adds the options of merging to a command, all in one group of its help. They store into
/// `options`, which must outlive the parsing.
void AddGridOptions(CLI::App& command, MergeOptions& options);

/// The level of quality control that a text names. Throws Error when it names none.
QualityLevel ParseQuality(const std::string& text);

/// Why an option of merging is wrong with these moments, because none of them is merged by it;
/// empty: it is right. `name` as in "--no-sharpening".
std::string RefusalFor(const std::string& name, const std::vector<MomentName>& moments);

/// Those options of merging that a command was given, as they were written.
std::vector<OptionText> GivenGridOptions(const CLI::App& command);

} // namespace nexrad::application
