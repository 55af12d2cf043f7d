// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkNexradUseThreads_h
#define vtkNexradUseThreads_h

/**
 * Lets VTK's loops use all cores of the machine where ParaView was built to use one, as Debian's
 * is: volumes are merged, lit and measured in about half the time on two cores. The environment
 * variable VTK_SMP_BACKEND_IN_USE, which chooses for all of VTK, counts before this. Several
 * processes of a server share the cores among themselves, and keep one thread each.
 */
void vtkNexradUseThreads();

#endif
