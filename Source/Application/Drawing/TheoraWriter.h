// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/MovieWriter.h"

#include <filesystem>
#include <memory>

namespace nexrad::scene
{

/// Ogg Theora, through VTK.
std::unique_ptr<MovieWriter> MakeTheoraWriter(
  const std::filesystem::path& path, int framesPerSecond);

} // namespace nexrad::scene
