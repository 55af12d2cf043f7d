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
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <vector>

vtkStandardNewMacro(vtkNexradEchoOnly);

namespace
{

// The states of a moment; of the active scalars where the name is empty.
vtkUnsignedCharArray* FindStates(vtkImageData* image, const std::string& moment)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const std::string name = !moment.empty()                 ? moment
                           : scalars && scalars->GetName() ? scalars->GetName()
                                                           : "";
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

// Makes voxels of a lattice of corners, each corner once.
class CellBuilder
{
public:
  // `theSize`: corners along x, y and z. `theFirst`: the first corner.
  CellBuilder(const std::array<vtkIdType, 3>& theSize, const std::array<double, 3>& theFirst,
    const double* theSpacing)
    : size(theSize)
    , first(theFirst)
    , spacing(theSpacing)
    , numbers(static_cast<std::size_t>(theSize[0] * theSize[1] * theSize[2]), -1)
  {
    points->SetDataTypeToDouble();
  }

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

  // Of the corners in the order of their points: their places in the lattice.
  vtkIdList* Places() { return places; }

  void Finish(vtkUnstructuredGrid* output)
  {
    output->SetPoints(points);
    output->SetCells(VTK_VOXEL, cells);
  }

private:
  vtkIdType Point(vtkIdType x, vtkIdType y, vtkIdType z)
  {
    const vtkIdType place = x + size[0] * (y + size[1] * z);
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

  const std::array<vtkIdType, 3> size;
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

// The lattice of an image's voxels.
struct Lattice
{
  std::array<vtkIdType, 3> size{};
  std::array<double, 3> origin{};

  explicit Lattice(vtkImageData* image)
  {
    const int* dimensions = image->GetDimensions();
    std::copy_n(dimensions, 3, size.begin());
    image->GetPoint(0, origin.data());
  }

  vtkIdType Place(vtkIdType x, vtkIdType y, vtkIdType z) const
  {
    return x + size[0] * (y + size[1] * z);
  }

  template <class Visit>
  static void ForEach(const std::array<vtkIdType, 3>& counts, const Visit& visit)
  {
    for (vtkIdType z = 0; z < counts[2]; ++z)
    {
      for (vtkIdType y = 0; y < counts[1]; ++y)
      {
        for (vtkIdType x = 0; x < counts[0]; ++x)
        {
          visit(x, y, z);
        }
      }
    }
  }
};

void MakeCellsBetween(
  vtkImageData* image, const std::vector<bool>& counts, vtkUnstructuredGrid* output)
{
  const Lattice lattice(image);
  CellBuilder builder(lattice.size, lattice.origin, image->GetSpacing());
  const auto row = [&](vtkIdType at)
  {
    const auto first = static_cast<std::size_t>(at);
    return counts[first] && counts[first + 1];
  };
  Lattice::ForEach({lattice.size[0] - 1, lattice.size[1] - 1, lattice.size[2] - 1},
    [&](vtkIdType x, vtkIdType y, vtkIdType z)
    {
      if (row(lattice.Place(x, y, z)) && row(lattice.Place(x, y + 1, z)) &&
          row(lattice.Place(x, y, z + 1)) && row(lattice.Place(x, y + 1, z + 1)))
      {
        builder.Add(x, y, z);
      }
    });
  builder.Finish(output);
  CopyArrays(image, builder.Places(), output->GetPointData());
}

void MakeVoxels(vtkImageData* image, const std::vector<bool>& counts, vtkUnstructuredGrid* output)
{
  const Lattice lattice(image);
  const double* spacing = image->GetSpacing();
  const std::array<double, 3> corner = {lattice.origin[0] - spacing[0] / 2.0,
    lattice.origin[1] - spacing[1] / 2.0, lattice.origin[2] - spacing[2] / 2.0};
  CellBuilder builder(
    {lattice.size[0] + 1, lattice.size[1] + 1, lattice.size[2] + 1}, corner, spacing);
  vtkNew<vtkIdList> voxels;
  Lattice::ForEach(lattice.size,
    [&](vtkIdType x, vtkIdType y, vtkIdType z)
    {
      const vtkIdType place = lattice.Place(x, y, z);
      if (counts[static_cast<std::size_t>(place)])
      {
        builder.Add(x, y, z);
        voxels->InsertNextId(place);
      }
    });
  builder.Finish(output);
  CopyArrays(image, voxels, output->GetCellData());
}

} // namespace

vtkNexradEchoOnly::vtkNexradEchoOnly() = default;

vtkNexradEchoOnly::~vtkNexradEchoOnly() = default;

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
