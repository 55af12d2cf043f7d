// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradGeographicCoordinates.h"

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"

#include <array>

namespace
{

using Convert = std::array<double, 2> (nexrad::GridSpecification::*)(double, double) const;

bool ConvertPairs(Convert convert, vtkImageData* volume, vtkDoubleArray* from, vtkDoubleArray* to)
{
  if (!to)
  {
    return false;
  }
  to->Initialize();
  if (!volume || !from || from->GetNumberOfComponents() != 2)
  {
    return false;
  }
  try
  {
    const nexrad::GridSpecification grid = vtkNexradImageToGrid(volume);
    const vtkIdType count = from->GetNumberOfTuples();
    to->SetNumberOfComponents(2);
    to->SetNumberOfTuples(count);
    constexpr vtkIdType pairsAtOnce = 4096;
    vtkSMPTools::For(0, count, pairsAtOnce,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const std::array<double, 2> pair =
            (grid.*convert)(from->GetTypedComponent(i, 0), from->GetTypedComponent(i, 1));
          to->SetTypedTuple(i, pair.data());
        }
      });
  }
  catch (const nexrad::Error&)
  {
    to->Initialize();
    return false;
  }
  return true;
}

} // namespace

vtkStandardNewMacro(vtkNexradGeographicCoordinates);

bool vtkNexradGeographicCoordinates::ToGeographic(
  vtkImageData* volume, vtkDoubleArray* from, vtkDoubleArray* to)
{
  return ConvertPairs(&nexrad::GridSpecification::ToGeographic, volume, from, to);
}

bool vtkNexradGeographicCoordinates::FromGeographic(
  vtkImageData* volume, vtkDoubleArray* from, vtkDoubleArray* to)
{
  return ConvertPairs(&nexrad::GridSpecification::FromGeographic, volume, from, to);
}

void vtkNexradGeographicCoordinates::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
