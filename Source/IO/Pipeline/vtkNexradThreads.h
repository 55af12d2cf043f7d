// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradThreads.h
 * @brief  how the core's loops run on vtkSMPTools
 */
#ifndef vtkNexradThreads_h
#define vtkNexradThreads_h

#include "vtkNexradIOModule.h" // For export macro

#include <functional>

/**
 * A loop (nexrad::RangeLoop) that vtkSMPTools runs.
 */
VTKNEXRADIO_EXPORT std::function<void(int, const std::function<void(int, int)>&)>
vtkNexradRangeLoop();

/**
 * Threads that vtkSMPTools uses, at least 1.
 */
VTKNEXRADIO_EXPORT unsigned vtkNexradThreadCount();

#endif
// VTK-HeaderTest-Exclude: vtkNexradThreads.h
