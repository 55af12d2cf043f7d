// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradSmpLoop.h
 * @brief  the loops of the core library on VTK's threads
 */
#ifndef vtkNexradSmpLoop_h
#define vtkNexradSmpLoop_h

#include "vtkNexradIOModule.h" // For export macro

#include "nexrad/System/RangeLoop.h"

/**
 * A loop that vtkSMPTools runs.
 */
VTKNEXRADIO_EXPORT nexrad::RangeLoop vtkNexradSmpLoop();

/**
 * Number of threads that vtkSMPTools uses, at least 1.
 */
VTKNEXRADIO_EXPORT unsigned vtkNexradThreadCount();

#endif
// VTK-HeaderTest-Exclude: vtkNexradSmpLoop.h
