// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class vtkMultiProcessController;

namespace nexrad::application
{

/// The function that the program looks for in nexrad3d-mpi: starts MPI and gives a controller of
/// all processes, which the caller finalizes and deletes.
using JoinFunction = vtkMultiProcessController* (*)();
constexpr char joinFunctionName[] = "nexrad3dJoinProcesses";

} // namespace nexrad::application
