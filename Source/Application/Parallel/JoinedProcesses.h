// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

class vtkMultiProcessController;

namespace nexrad::application
{

/// Joins the processes that mpiexec started together with this one, as long as the pointer lives.
/// nullptr without mpiexec: then MPI is not loaded. Throws Error when there are several processes
/// and the program was built without MPI.
std::shared_ptr<vtkMultiProcessController> JoinProcesses();

} // namespace nexrad::application
