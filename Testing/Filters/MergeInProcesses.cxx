// SPDX-License-Identifier: BSD-3-Clause
// Run by mpiexec: each process makes its piece of a merge of eight radars, as those of a parallel
// server do, and the first compares all of them with the volume that it makes alone. Exits with 0
// when they are alike, 1 when not, 77 without the real radar files.
#include "TestData.h"

#include "vtkNexradDayReader.h"

#include "nexrad/Model/Time.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace
{

const double mergeTime = nexrad::ToSeconds(*nexrad::ParseIso8601("2010-09-11T01:20:00Z"));

void SetUp(vtkNexradDayReader* reader, const std::filesystem::path& data)
{
  reader->AddFileName((data / "level2/multisite-20100911").c_str());
  reader->SetDimensions(61, 47, 9);
  reader->SetMoment("REF,VEL");
  reader->SetMaximumGap(2700.0);
}

// The values of an image, x fastest.
std::vector<float> ValuesOf(vtkImageData* image)
{
  vtkDataArray* array = image->GetPointData()->GetScalars();
  std::vector<float> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(static_cast<float>(array->GetTuple1(i)));
  }
  return values;
}

// Compares pieces with the whole, and keeps account of what they cover.
class Comparison
{
public:
  explicit Comparison(vtkImageData* expected)
    : whole(expected)
    , covered(static_cast<std::size_t>(expected->GetNumberOfPoints()))
  {
  }

  void Add(const std::array<int, 6>& extent, const float* values)
  {
    vtkDataArray* expected = whole->GetPointData()->GetScalars();
    for (int z = extent[4]; z <= extent[5]; ++z)
    {
      for (int y = extent[2]; y <= extent[3]; ++y)
      {
        for (int x = extent[0]; x <= extent[1]; ++x)
        {
          int at[3] = {x, y, z};
          const vtkIdType point = whole->ComputePointId(at);
          differences += static_cast<float>(expected->GetTuple1(point)) != *values++;
          covered[static_cast<std::size_t>(point)] = true;
        }
      }
    }
  }

  bool IsWhole() const { return std::find(covered.begin(), covered.end(), false) == covered.end(); }
  int Differences() const { return differences; }

private:
  vtkImageData* whole;
  std::vector<bool> covered;
  int differences = 0;
};

bool AreAlike(
  vtkMultiProcessController* controller, vtkImageData* piece, const std::filesystem::path& data)
{
  const auto count = static_cast<std::size_t>(controller->GetNumberOfProcesses());
  const std::vector<float> mine = ValuesOf(piece);
  const auto length = static_cast<vtkIdType>(mine.size());
  std::vector<vtkIdType> lengths(count);
  std::vector<vtkIdType> offsets(count, 0);
  controller->AllGather(&length, lengths.data(), 1);
  for (std::size_t rank = 1; rank < count; ++rank)
  {
    offsets[rank] = offsets[rank - 1] + lengths[rank - 1];
  }
  const vtkIdType total = offsets.back() + lengths.back();
  std::vector<float> all(static_cast<std::size_t>(total));
  controller->GatherV(mine.data(), all.data(), length, lengths.data(), offsets.data(), 0);
  std::vector<std::array<int, 6>> extents(count);
  controller->Gather(piece->GetExtent(), extents.front().data(), 6, 0);
  if (controller->GetLocalProcessId() != 0)
  {
    return true;
  }
  vtkNew<vtkNexradDayReader> alone;
  SetUp(alone, data);
  alone->UpdateInformation();
  alone->UpdateTimeStep(mergeTime);
  Comparison comparison(alone->GetOutput());
  for (std::size_t rank = 0; rank < count; ++rank)
  {
    comparison.Add(extents[rank], all.data() + offsets[rank]);
  }
  std::cout << total << " voxels in " << count << " pieces, " << comparison.Differences()
            << " of them unlike\n";
  return comparison.Differences() == 0 && comparison.IsWhole();
}

} // namespace

int main(int argc, char** argv)
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  const auto data = nexrad::testing::TestDataFolder();
  int status = 77;
  if (data)
  {
    vtkNew<vtkNexradDayReader> reader;
    SetUp(reader, *data);
    reader->UseGlobalControllerOn();
    reader->UpdateInformation();
    reader->UpdateTimeStep(
      mergeTime, controller->GetLocalProcessId(), controller->GetNumberOfProcesses());
    status = AreAlike(controller, reader->GetOutput(), *data) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return status;
}
