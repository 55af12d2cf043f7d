// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradEchoOnly.h"

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/System/Error.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradVoxels.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <vector>

vtkStandardNewMacro(vtkNexradEchoOnly);

namespace
{

// The states of a moment; of the active scalars where the name is empty.
vtkUnsignedCharArray* FindStates(vtkImageData* image, const std::string& moment)
{
  const std::string name = moment.empty() ? vtkNexradScalarsName(image) : moment;
  if (name.empty())
  {
    throw nexrad::Error("the image has no active scalars: name its moment");
  }
  auto* states =
    vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetArray((name + "_state").c_str()));
  if (!states || states->GetNumberOfComponents() != 1)
  {
    throw nexrad::Error("the image has no point array " + name +
                        "_state: the input must be a merged volume with the moment " + name);
  }
  return states;
}

// Which points count.
std::vector<bool> FindCounting(vtkUnsignedCharArray* states, bool noEchoCounts)
{
  std::vector<bool> counts(static_cast<std::size_t>(states->GetNumberOfTuples()));
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const auto state = nexrad::ToVoxelState(states->GetValue(static_cast<vtkIdType>(i)));
    counts[i] =
      state == nexrad::VoxelState::Echo || (noEchoCounts && state == nexrad::VoxelState::NoEcho);
  }
  return counts;
}

// Numbers along x, y and z.
using Size = std::array<vtkIdType, 3>;

vtkIdType PlaceIn(const Size& size, vtkIdType x, vtkIdType y, vtkIdType z)
{
  return x + size[0] * (y + size[1] * z);
}

// Makes voxels of a lattice of corners, each corner once.
class CellBuilder
{
public:
  // `theSize`: of corners. `theFirst`: the first corner.
  CellBuilder(const Size& theSize, const std::array<double, 3>& theFirst, const double* theSpacing)
    : size(theSize)
    , first(theFirst)
    , spacing(theSpacing)
    , numbers(static_cast<std::size_t>(theSize[0] * theSize[1] * theSize[2]), -1)
  {
    points->SetDataTypeToDouble();
  }

  // Adds those whose first corner is at a place that `isWanted` takes.
  template <class IsWanted>
  void AddWhere(const IsWanted& isWanted)
  {
    for (vtkIdType z = 0; z + 1 < size[2]; ++z)
    {
      for (vtkIdType y = 0; y + 1 < size[1]; ++y)
      {
        for (vtkIdType x = 0; x + 1 < size[0]; ++x)
        {
          if (isWanted(x, y, z))
          {
            this->Add(x, y, z);
          }
        }
      }
    }
  }

  // Of the corners in the order of their points: their places in the lattice.
  vtkIdList* Places() { return places; }

  void Finish(vtkUnstructuredGrid* output)
  {
    output->SetPoints(points);
    output->SetCells(VTK_VOXEL, cells);
  }

private:
  void Add(vtkIdType x, vtkIdType y, vtkIdType z)
  {
    std::array<vtkIdType, 8> corners{};
    for (std::size_t corner = 0; corner < corners.size(); ++corner)
    {
      const auto one = [corner](unsigned axis)
      { return static_cast<vtkIdType>(corner >> axis & 1U); };
      corners[corner] = this->Point(x + one(0), y + one(1), z + one(2));
    }
    cells->InsertNextCell(8, corners.data());
  }

  vtkIdType Point(vtkIdType x, vtkIdType y, vtkIdType z)
  {
    const vtkIdType place = PlaceIn(size, x, y, z);
    vtkIdType& number = numbers[static_cast<std::size_t>(place)];
    if (number < 0)
    {
      number = points->InsertNextPoint(first[0] + static_cast<double>(x) * spacing[0],
        first[1] + static_cast<double>(y) * spacing[1],
        first[2] + static_cast<double>(z) * spacing[2]);
      places->InsertNextId(place);
    }
    return number;
  }

  const Size size;
  const std::array<double, 3> first;
  const double* spacing;
  std::vector<vtkIdType> numbers;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> places;
};

// The arrays of the image without its ghost flags, which speak of voxels that are not there.
void CopyArrays(vtkImageData* image, vtkIdList* places, vtkDataSetAttributes* attributes)
{
  attributes->CopyAllOn();
  attributes->CopyAllocate(image->GetPointData(), places->GetNumberOfIds());
  for (vtkIdType i = 0; i < places->GetNumberOfIds(); ++i)
  {
    attributes->CopyData(image->GetPointData(), places->GetId(i), i);
  }
  attributes->RemoveArray(vtkDataSetAttributes::GhostArrayName());
}

Size SizeOf(vtkImageData* image)
{
  const int* dimensions = image->GetDimensions();
  return {dimensions[0], dimensions[1], dimensions[2]};
}

void MakeCellsBetween(
  vtkImageData* image, const std::vector<bool>& counts, vtkUnstructuredGrid* output)
{
  const Size size = SizeOf(image);
  std::array<double, 3> first{};
  image->GetPoint(0, first.data());
  const auto row = [&](vtkIdType x, vtkIdType y, vtkIdType z)
  {
    const auto at = static_cast<std::size_t>(PlaceIn(size, x, y, z));
    return counts[at] && counts[at + 1];
  };
  CellBuilder builder(size, first, image->GetSpacing());
  builder.AddWhere([&](vtkIdType x, vtkIdType y, vtkIdType z)
    { return row(x, y, z) && row(x, y + 1, z) && row(x, y, z + 1) && row(x, y + 1, z + 1); });
  builder.Finish(output);
  CopyArrays(image, builder.Places(), output->GetPointData());
}

void MakeVoxels(vtkImageData* image, const std::vector<bool>& counts, vtkUnstructuredGrid* output)
{
  const Size size = SizeOf(image);
  const double* spacing = image->GetSpacing();
  std::array<double, 3> corner{};
  image->GetPoint(0, corner.data());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    corner[axis] -= spacing[axis] / 2.0;
  }
  CellBuilder builder({size[0] + 1, size[1] + 1, size[2] + 1}, corner, spacing);
  builder.AddWhere([&](vtkIdType x, vtkIdType y, vtkIdType z)
    { return counts[static_cast<std::size_t>(PlaceIn(size, x, y, z))]; });
  builder.Finish(output);
  vtkNew<vtkIdList> voxels;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    if (counts[static_cast<std::size_t>(i)])
    {
      voxels->InsertNextId(i);
    }
  }
  CopyArrays(image, voxels, output->GetCellData());
}

} // namespace

int vtkNexradEchoOnly::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkNexradEchoOnly::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkImageData* image = vtkImageData::GetData(input[0]);
  vtkUnstructuredGrid* cells = vtkUnstructuredGrid::GetData(output);
  cells->GetFieldData()->ShallowCopy(image->GetFieldData());
  if (image->GetNumberOfPoints() == 0)
  {
    return 1; // of several processes, one without a part of the volume
  }
  try
  {
    const std::vector<bool> counts =
      FindCounting(FindStates(image, this->Moment), this->NoEchoCounts);
    (this->Cells == VOXELS ? MakeVoxels : MakeCellsBetween)(image, counts, cells);
  }
  catch (const nexrad::Error& error)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    return vtkNexradFail(this, error.what());
  }
  return 1;
}

void vtkNexradEchoOnly::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Moment: " << this->Moment << "\n";
  os << indent << "Cells: " << this->Cells << "\n";
  os << indent << "NoEchoCounts: " << this->NoEchoCounts << "\n";
}
