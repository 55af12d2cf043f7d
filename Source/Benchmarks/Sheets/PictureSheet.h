// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkImageData;

namespace nexrad::scene
{

/// A picture (red, green, blue, a byte each) and what stands above it.
struct SheetPanel
{
  vtkSmartPointer<vtkImageData> picture;
  std::string label;
};

/// Pictures of one size in rows of `columns`, each below its label, under a title. At least one.
vtkSmartPointer<vtkImageData> MakeSheet(
  const std::string& title, const std::vector<SheetPanel>& panels, int columns);

/// How far a picture is from a reference.
struct PictureDifference
{
  double mean = 0.0;    ///< absolute, of 255, over the three channels of the covered pixels
  double covered = 0.0; ///< share of the pixels that are covered, 0…1
};

/// Over the pixels that the volume covers: those where `reference` is unlike `without`, the picture
/// without the volume. All three have one size. A mean over no pixel is 0.
PictureDifference CompareCovered(
  vtkImageData* picture, vtkImageData* reference, vtkImageData* without);

} // namespace nexrad::scene
