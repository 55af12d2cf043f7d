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

/**
 * Lets vtkSMPTools use this many threads, at least 1 and at most as many as the machine has cores;
 * until it is called, as many as VTK_SMP_MAX_THREADS says, or all.
 */
VTKNEXRADIO_EXPORT void vtkNexradSetThreadCount(unsigned count);

#endif
// VTK-HeaderTest-Exclude: vtkNexradThreads.h
