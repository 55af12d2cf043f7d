// SPDX-License-Identifier: BSD-3-Clause
// What all fuzz targets have: inputs to begin with, promises to check, and a file for readers that
// take a path.
#pragma once

#include "Level2Bytes.h"
#include "TestData.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::testing
{

/// Small inputs that are as they should be. Each target makes its own.
std::vector<Bytes> FuzzSeeds();

/// Ends the program when a promise does not hold: a fuzzer keeps the input. `promise` is a sentence
/// that says what was promised.
void Require(bool holds, const char* promise);

/// Requires that a message is one line of at most 2000 bytes.
void RequireMessage(const std::string& message);

/// Whether the address sanitiser makes everything larger and slower. Without it, targets use the
/// limits that users have.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool IsSanitised = true;
#elif defined(__has_feature)
constexpr bool IsSanitised = __has_feature(address_sanitizer);
#else
constexpr bool IsSanitised = false;
#endif

/// The bytes of a text.
Bytes BytesOf(const std::string& text);

/// A file below the temporary folder, written anew for each input.
class InputFile
{
public:
  /// `name`: of the file, with the ending that the reader wants.
  explicit InputFile(const std::string& name);

  const std::filesystem::path& Path() const { return path; }
  void Write(const std::uint8_t* data, std::size_t size) const;

private:
  TemporaryFolder folder;
  std::filesystem::path path;
};

} // namespace nexrad::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
