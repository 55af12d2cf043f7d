// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradArrayChoice.h
 * @brief  which moments and ancillary arrays a reader of merged volumes is asked for
 */
#ifndef vtkNexradArrayChoice_h
#define vtkNexradArrayChoice_h

#include "vtkNexradIOModule.h" // For export macro

#include <string>
#include <vector>

class vtkDataArraySelection;

namespace nexrad
{
enum class MomentName : unsigned char;
}

/**
 * The moments of a text as "VEL,REF"; empty: all that a file has. Throws nexrad::Error for another
 * text.
 */
VTKNEXRADIO_EXPORT std::vector<nexrad::MomentName> vtkNexradMomentsToRead(const std::string& names);

/**
 * Names of the arrays that are off.
 */
VTKNEXRADIO_EXPORT std::vector<std::string> vtkNexradNamesToLeaveOut(
  vtkDataArraySelection* selection);

/**
 * Makes a selection list these names: those that it knows keep what the user chose for them, new
 * ones are on.
 */
VTKNEXRADIO_EXPORT void vtkNexradListArrays(
  const std::vector<std::string>& names, vtkDataArraySelection* selection);

#endif
// VTK-HeaderTest-Exclude: vtkNexradArrayChoice.h
