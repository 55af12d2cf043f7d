// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace nexrad::application
{

/// A file of the output, and how much is said of it.
struct InputSubject
{
  std::string file;
  bool ofFolder = false; ///< one of many: a line in the table
};

/// Each argument, with the radar files in it in place of a folder that is none of chunks, or of a
/// tar archive. What is wrong with a folder is said, and the folder stays as what cannot be read.
/// `leftOut` becomes true for a file in a folder that is no radar file.
std::vector<InputSubject> FindSubjects(const std::vector<std::string>& arguments, bool& leftOut);

} // namespace nexrad::application
