// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkNexradArraySettings_h
#define vtkNexradArraySettings_h

#include <string>

/**
 * Tells ParaView how the arrays of radar moments are coloured where nobody chose: each in the first
 * preset of its own (vtkNexradTransferFunction), never rescaled to the data, with what is no number
 * transparent, and with a legend that has the moment's name and unit. These settings are not
 * written to the user's: what a user saves as the default of an array counts before them. Servers
 * have no such settings, so nothing happens there.
 */
void vtkNexradAddArraySettings();

/**
 * The text that vtkNexradAddArraySettings gives to vtkSMSettings.
 */
std::string vtkNexradArraySettings();

#endif
