// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

class vtkColorTransferFunction;

namespace nexrad::scene
{

/// Red, green and blue, 0…1.
using Colour = std::array<double, 3>;

/// One colour, from a value up to that of the next bin.
struct ColourBin
{
  double from = 0.0; ///< dBZ
  Colour colour{};
};

/// At least two bins, their values ascending.
using ColourTable = std::vector<ColourBin>;

/// Reads lines "dbz,#rrggbb" below a heading. `name` stands in the messages. Throws Error, naming
/// the line, when a row is something else, values do not ascend, or rows are fewer than two.
ColourTable ParseColourTable(const std::string& text, const std::string& name);

/// The same for a file. Throws Error when it cannot be read.
ColourTable ReadColourTable(const std::filesystem::path& path);

/// The National Weather Service's colours of reflectivity (Formulas R4).
const ColourTable& WeatherServiceColours();

/// Width of the last bin, which has no successor: as wide as the one before it.
double UpperEnd(const ColourTable& table);

/// Colours between the bins' centres are linear, so that the volume shows no bands that
/// interpolation between voxels would turn into noise; beyond the first and last centre they stay
/// as they are.
void FillSmooth(vtkColorTransferFunction* function, const ColourTable& table);

} // namespace nexrad::scene
