// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkNexradColorMapPresets_h
#define vtkNexradColorMapPresets_h

/**
 * Gives ParaView the presets of vtkNexradTransferFunction, named like "NEXRAD all echo". ParaView
 * keeps them with a user's other presets; one that is there already stays as the user has it.
 * Servers have no presets, so nothing happens there.
 */
void vtkNexradAddColorMapPresets();

#endif
