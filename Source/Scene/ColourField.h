// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Scales/ColourScale.h"
#include "Scene/SceneOptions.h"

#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkVolumeProperty;

namespace nexrad::scene
{

/// A volume whose colours come from another array than the moment that gives the opacities.
struct ColourField
{
  vtkSmartPointer<vtkImageData> volume; ///< its active scalars: colour and opacity
  ColourScale scale;                    ///< of the colours, with a title that names both arrays
  vtkSmartPointer<vtkColorTransferFunction> colours;
  std::string note;        ///< what brown means, where there is some; else empty
  bool categories = false; ///< values stand for names: nothing lies between two of them

  /// Sets what differs from a volume of one array.
  void FillProperty(vtkVolumeProperty* property) const;
};

/// The field of the options' `colourBy`. A moment has the colours of its preset, or those of the
/// options' file; an ancillary array those of its map. Throws Error for an array that the volume
/// does not have, and for a file of colours with an ancillary array.
ColourField MakeColourField(
  const SceneOptions& options, vtkImageData* volume, const VolumeInformation& information);

} // namespace nexrad::scene
