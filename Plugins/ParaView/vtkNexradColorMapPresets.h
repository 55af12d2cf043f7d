// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkNexradColorMapPresets_h
#define vtkNexradColorMapPresets_h

/**
 * Gives ParaView the presets of vtkNexradTransferFunction, named like "NEXRAD all echo". ParaView
 * keeps them in the user's settings, with the user's own; those of an earlier version of the plugin
 * get the colours and opacities of this one. Servers have no presets, so nothing happens there.
 */
void vtkNexradAddColorMapPresets();

#endif
