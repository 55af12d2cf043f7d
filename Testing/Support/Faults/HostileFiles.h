// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Level2Bytes.h"

#include <functional>
#include <string>
#include <vector>

/// Files that were made to cost a reader as much as possible: each repeats something small some
/// hundred thousand times, and takes a few kilobytes because the repetition compresses.
namespace nexrad::testing
{

struct HostileFile
{
  std::string name;            ///< what it repeats: "volume-headers"
  std::function<Bytes()> make; ///< the stored bytes
};

/// One file for each kind of repetition that is known.
std::vector<HostileFile> MakeHostileFiles();

/// The content, `count` times.
Bytes Repeat(const Bytes& content, std::size_t count);

/// A gzip stream of `content`, repeated `count` times. It is made without the repeated bytes.
Bytes GzipOfRepeated(const Bytes& content, std::size_t count);

} // namespace nexrad::testing
