// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <ostream>

namespace nexrad::application
{

/// As long as it lives, control characters that are written to a stream appear as text: a file's
/// name can neither move the cursor nor colour or clear the terminal. "\x1b" takes the place of the
/// escape character. Line ends, tabs and carriage returns, and all bytes of other characters, stay.
class PrintableOutput
{
public:
  /// `stream` is not owned, and must outlive this.
  explicit PrintableOutput(std::ostream& stream);
  ~PrintableOutput();
  PrintableOutput(const PrintableOutput&) = delete;
  PrintableOutput& operator=(const PrintableOutput&) = delete;

private:
  std::ostream& stream;
  std::streambuf* const before;
  const std::unique_ptr<std::streambuf> filter;
};

} // namespace nexrad::application
