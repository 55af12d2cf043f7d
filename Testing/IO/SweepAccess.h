// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStructuredGrid.h"

#include <string>

namespace nexrad::testing
{

/// The grid of one gate geometry of one sweep; nullptr when there is none.
inline vtkStructuredGrid* GridOf(
  vtkPartitionedDataSetCollection* sweeps, unsigned int sweep, unsigned int geometry = 0)
{
  vtkPartitionedDataSet* grids = sweeps->GetPartitionedDataSet(sweep);
  return grids && geometry < grids->GetNumberOfPartitions()
           ? vtkStructuredGrid::SafeDownCast(grids->GetPartition(geometry))
           : nullptr;
}

inline std::string NameOf(vtkPartitionedDataSetCollection* sweeps, unsigned int sweep)
{
  return sweeps->GetMetaData(sweep)->Get(vtkCompositeDataSet::NAME());
}

} // namespace nexrad::testing
