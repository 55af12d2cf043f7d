// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkNexradOpening_h
#define vtkNexradOpening_h

/**
 * Makes one source of the radar files that a person opens together in ParaView's window. ParaView
 * itself makes a source of each name, or of each group of names that differ in a number at their
 * end, so it would make one for each radar, and of the archive's names, which end in _V06, one for
 * each file. Of sweeps
 * that are opened in the window REF alone is read at first. Without a window nothing happens.
 */
void vtkNexradWatchOpening();

#endif
