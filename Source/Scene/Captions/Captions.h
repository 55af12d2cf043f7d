// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Shapes/Letters.h"
#include "Scene/Shapes/Theme.h"

#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;
class vtkProp;

namespace nexrad::scene
{

/// Age of the data of each radar of a merged volume, in the order of its `Sites`: the median, in
/// minutes, of the ancillary array `_age` over the voxels that this radar alone scanned. Nothing
/// for a radar without such voxels. Empty when the volume lacks the arrays that tell: `_age`, and
/// of several radars `_radars` and `_site` as well.
std::vector<std::optional<double>> AgesOfData(
  vtkImageData* volume, const std::string& array, std::size_t sites);

/// What the captions of a picture say.
struct CaptionTexts
{
  std::string title; ///< of what is shown
  std::string note;  ///< what the heights are, or which voxels a map shows
  VolumeInformation information;
  std::vector<std::optional<double>> ages; ///< min, of the sites' data; empty when unknown
  std::string nothing; ///< what is said in the middle of a picture that shows nothing; else empty
};

/// The captions, and the rectangles that they take. Their widths are rounded up to an eighth of the
/// picture's, so that a letter more does not move the scene.
struct CaptionLayer
{
  std::vector<vtkSmartPointer<vtkProp>> props;
  std::vector<PixelBox> taken;
  std::optional<PixelBox> overScene; ///< that of `nothing`, which labels alone stay off
};

/// Time, what is shown, and radars with the age of their data in the upper left corner, the note in
/// the lower left one, SYNTHETIC above where it is due. `right`: where the colour bar begins, in
/// pixels.
CaptionLayer MakeCaptions(const CaptionTexts& texts, const std::array<int, 2>& size, double right,
  int textSize, const Theme& theme, TextPictures& pictures);

/// "2010-09-11 01:20:00 UTC", or that it is unknown.
std::string TimeText(const VolumeInformation& information);

/// The names of radars; of more than 16 how many there are.
std::string NameSites(const std::vector<std::string>& sites);

/// Radars, each with the age of its data where it is known (of more than 16 the least and the
/// greatest age); then, where most of the echo is
/// biological, how much of it, and what else is to be said of their volumes.
std::vector<std::string> SiteWords(const CaptionTexts& texts);

} // namespace nexrad::scene
