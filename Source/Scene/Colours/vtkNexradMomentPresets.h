// SPDX-License-Identifier: BSD-3-Clause
// The presets of the moments beside reflectivity, one each.
#ifndef vtkNexradMomentPresets_h
#define vtkNexradMomentPresets_h

#include "vtkNexradColorMap.h"

#include <vector>

/// Colours in steps from value to value, and opacities.
struct vtkNexradMomentPreset
{
  struct Step
  {
    double From;    ///< unit of the moment
    unsigned Color; ///< 0xRRGGBB
  };

  const char* Name;
  const char* Array; ///< the moment's, as "VEL"
  std::vector<Step> Steps;
  double End; ///< of the last step
  std::vector<vtkNexradColorMap::Node> Opacity;
};

const std::vector<vtkNexradMomentPreset>& vtkNexradMomentPresets();

/// The colour of a code 0xRRGGBB.
vtkNexradColorMap::Color vtkNexradColorOf(unsigned code);

/// The colour map of a preset.
vtkNexradColorMap vtkNexradMakeColorMap(const vtkNexradMomentPreset& preset);

#endif
