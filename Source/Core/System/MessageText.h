// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/Error.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace nexrad
{

/// True for a byte that a terminal obeys in place of showing it: a control character of ASCII, or
/// the second byte of one of U+0080 to U+009F in UTF-8. `before` is the byte before it, 0 for none.
bool IsControlByte(unsigned char byte, unsigned char before);

/// A control character as text: "\x0a" for a line end.
std::string ControlText(unsigned char byte);

/// "1 ray", "12 rays".
std::string CountText(std::size_t count, const std::string& noun);

/// One line that can be printed: control characters, line ends among them, appear as text
/// (ControlText). Of more than 2000 bytes, the middle is left out ("…").
std::string MessageLine(const std::string& message);

/// The message of a library for a line of ours: at most 300 bytes of it, then "…". Parsers repeat
/// what they read in theirs, at any length.
std::string Shortened(const std::string& message);

/// An error of a file: its path, and what is wrong with it. A file may choose the words that a
/// message quotes, so of `what` there are no control characters, and at most 300 bytes.
Error FileError(const std::filesystem::path& path, const std::string& what);

} // namespace nexrad
