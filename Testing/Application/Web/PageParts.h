// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nexrad::testing
{

using Bytes = std::vector<std::uint8_t>;

/// The codes of all voxels from what PackColumns made of them, as Documentation/Formats/web-page.md
/// describes it. Empty where bytes are left over or missing.
Bytes UnpackColumns(const std::array<int, 3>& size, const Bytes& ends, const Bytes& codes);

/// The bytes of an element of a page, out of base64 and inflated. Nothing where the page has no
/// such element, or its text is damaged.
std::optional<Bytes> ReadPagePart(const std::string& page, const std::string& id);

} // namespace nexrad::testing
