// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace nexrad
{

/// Throws Error when lists and objects of a JSON text lie more than 16 deep within each other. Who
/// writes JSON out again calls itself once for each depth, so a deep text would overflow the stack.
/// Nothing else of the text is checked.
void RequireShallowJson(std::string_view text);

/// The first `longest` bytes of a text that goes into a message, with "…" when there are more.
std::string Excerpt(const std::string& text, std::size_t longest = 80);

} // namespace nexrad
