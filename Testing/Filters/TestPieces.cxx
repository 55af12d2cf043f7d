// SPDX-License-Identifier: BSD-3-Clause
// Pieces of a volume as the processes of a parallel pipeline ask for them: put together they are,
// bit by bit, the volume of one process.
#include "TestData.h"

#include "vtkNexradDayReader.h"
#include "vtkNexradLevel2Reader.h"
#include "vtkNexradSeriesReader.h"
#include "vtkNexradVolumeReader.h"
#include "vtkNexradVolumeWriter.h"

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Time.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace
{

const double multisiteTime = nexrad::ToSeconds(*nexrad::ParseIso8601("2010-09-11T01:20:00Z"));

// The voxels of a piece against those at the same place of the whole, in all arrays.
void ExpectPartOf(vtkImageData* piece, vtkImageData* whole, std::vector<bool>& covered)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(piece->GetOrigin()[axis], whole->GetOrigin()[axis]);
    EXPECT_EQ(piece->GetSpacing()[axis], whole->GetSpacing()[axis]);
  }
  const int* extent = piece->GetExtent();
  const int arrays = whole->GetPointData()->GetNumberOfArrays();
  ASSERT_EQ(piece->GetPointData()->GetNumberOfArrays(), arrays);
  for (int i = 0; i < arrays; ++i)
  {
    vtkDataArray* expected = whole->GetPointData()->GetArray(i);
    vtkDataArray* found = piece->GetPointData()->GetArray(expected->GetName());
    ASSERT_NE(found, nullptr) << expected->GetName();
    int differences = 0;
    for (int z = extent[4]; z <= extent[5]; ++z)
    {
      for (int y = extent[2]; y <= extent[3]; ++y)
      {
        for (int x = extent[0]; x <= extent[1]; ++x)
        {
          int at[3] = {x, y, z};
          covered[static_cast<std::size_t>(whole->ComputePointId(at))] = true;
          differences += found->GetTuple1(piece->ComputePointId(at)) !=
                         expected->GetTuple1(whole->ComputePointId(at));
        }
      }
    }
    EXPECT_EQ(differences, 0) << expected->GetName();
  }
}

// The first algorithm makes the whole, the second one piece after the other. Neighbouring pieces
// share a layer of points, since VTK shares out cells. `look` sees each piece.
void ExpectPiecesMakeTheWhole(vtkImageAlgorithm* alone, vtkImageAlgorithm* inPieces, double time,
  int pieces, const std::function<void(vtkImageAlgorithm*)>& look)
{
  alone->UpdateTimeStep(time);
  vtkImageData* whole = alone->GetOutput();
  ASSERT_GT(whole->GetNumberOfPoints(), 0);
  std::vector<bool> covered(static_cast<std::size_t>(whole->GetNumberOfPoints()));
  for (int piece = 0; piece < pieces; ++piece)
  {
    inPieces->UpdateTimeStep(time, piece, pieces);
    vtkImageData* part = inPieces->GetOutput();
    if (part->GetNumberOfPoints() > 0)
    {
      EXPECT_TRUE(pieces == 1 || part->GetNumberOfPoints() < whole->GetNumberOfPoints());
      ExpectPartOf(part, whole, covered);
    }
    look(inPieces);
  }
  EXPECT_TRUE(std::all_of(covered.begin(), covered.end(), [](bool each) { return each; }));
}

void LookAway(vtkImageAlgorithm* /*piece*/) {}

void SetMultisite(vtkNexradDayReader* reader, const std::filesystem::path& data)
{
  reader->AddFileName((data / "level2/multisite-20100911").c_str());
  reader->SetDimensions(61, 47, 9);
  reader->SetMaximumGap(2700.0);
}

TEST(Pieces, OfEightRadarsMakeTheirMerge)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  vtkNew<vtkNexradDayReader> alone;
  SetMultisite(alone, data);
  vtkNew<vtkNexradDayReader> inPieces;
  SetMultisite(inPieces, data);
  for (const int pieces : {2, 4, 7})
  {
    ExpectPiecesMakeTheWhole(alone, inPieces, multisiteTime, pieces, LookAway);
  }
  // Also without memory for rays each file is decoded once for all pieces of a time.
  vtkNew<vtkNexradDayReader> forgetful;
  SetMultisite(forgetful, data);
  forgetful->SetMemoryLimit(0);
  ExpectPiecesMakeTheWhole(alone, forgetful, multisiteTime, 3, LookAway);
  EXPECT_EQ(forgetful->GetNumberOfDecodedFiles(), 8);
}

TEST(Pieces, OfAMergeAlongTheMotionWithAncillaryArrays)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const double time = nexrad::ToSeconds(*nexrad::ParseIso8601("2005-08-21T02:55:00Z"));
  vtkNew<vtkNexradDayReader> alone;
  vtkNew<vtkNexradDayReader> inPieces;
  for (vtkNexradDayReader* reader : {alone.Get(), inPieces.Get()})
  {
    reader->AddFileName((data / "level2/run-kbgm-20050821").c_str());
    reader->SetDimensions(31, 37, 11);
    reader->SetOption("ancillary", "on");
  }
  ExpectPiecesMakeTheWhole(alone, inPieces, time, 4, LookAway);
  EXPECT_NE(alone->GetOutput()->GetPointData()->GetArray("REF_age"), nullptr);
  alone->SetOption("method", "thesis");
  inPieces->SetOption("method", "thesis");
  ExpectPiecesMakeTheWhole(alone, inPieces, time, 3, LookAway);
}

TEST(Pieces, OfVolumeFiles)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path file = data / "level2/run-kbgm-20050821/KBGM20050821_025458.gz";
  const double time = nexrad::ToSeconds(*nexrad::ParseIso8601("2005-08-21T02:56:00Z"));
  vtkNew<vtkNexradDayReader> day;
  day->AddFileName(file.c_str());
  day->SetDimensions(33, 29, 10);
  day->SetOption("ancillary", "on");
  const nexrad::testing::TemporaryFolder folder;
  const std::string path = folder.Path() / "volume.nxv";
  vtkNew<vtkNexradVolumeWriter> writer;
  writer->SetInputConnection(day->GetOutputPort());
  writer->SetFileName(path.c_str());
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkNexradVolumeReader> read;
  vtkNew<vtkNexradVolumeReader> readInPieces;
  read->SetFileName(path.c_str());
  readInPieces->SetFileName(path.c_str());
  for (const int pieces : {2, 5})
  {
    ExpectPiecesMakeTheWhole(read, readInPieces, time, pieces, LookAway);
  }
}

// The sweeps of a file, each in one of the pieces, all named in all of them.
TEST(Pieces, ShareTheSweepsOut)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path run = data / "level2/run-kbgm-20050821";
  vtkNew<vtkNexradLevel2Reader> file;
  file->SetFileName((run / "KBGM20050821_025458.gz").c_str());
  vtkNew<vtkNexradSeriesReader> series;
  series->AddFileName((run / "KBGM20050821_025458.gz").c_str());
  for (vtkNexradSweepReader* reader : std::initializer_list<vtkNexradSweepReader*>{file, series})
  {
    const auto pointsOf = [reader](int piece, int pieces)
    {
      reader->UpdatePiece(piece, pieces, 0);
      auto* sweeps = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
      std::vector<vtkIdType> points;
      for (unsigned int i = 0; i < sweeps->GetNumberOfPartitionedDataSets(); ++i)
      {
        EXPECT_TRUE(sweeps->GetMetaData(i)->Has(vtkCompositeDataSet::NAME()));
        points.push_back(sweeps->GetPartitionedDataSet(i)->GetNumberOfPoints());
      }
      return points;
    };
    const std::vector<vtkIdType> whole = pointsOf(0, 1);
    ASSERT_EQ(whole.size(), 11U);
    std::vector<vtkIdType> together(whole.size(), 0);
    for (int piece = 0; piece < 3; ++piece)
    {
      const std::vector<vtkIdType> own = pointsOf(piece, 3);
      ASSERT_EQ(own.size(), whole.size());
      EXPECT_GE(std::count(own.begin(), own.end(), 0), 7);
      std::transform(own.begin(), own.end(), together.begin(), together.begin(), std::plus<>());
    }
    EXPECT_EQ(together, whole);
  }
}

// More processes than there are cells to share out: some have nothing to do, and say nothing.
TEST(Pieces, SomeOfThemMayBeEmpty)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  vtkNew<vtkNexradDayReader> alone;
  vtkNew<vtkNexradDayReader> inPieces;
  for (vtkNexradDayReader* reader : {alone.Get(), inPieces.Get()})
  {
    reader->AddFileName((data / "level2/run-kbgm-20050821/KBGM20050821_025458.gz").c_str());
    reader->SetDimensions(3, 2, 1);
  }
  const double time = nexrad::ToSeconds(*nexrad::ParseIso8601("2005-08-21T02:55:00Z"));
  int empty = 0;
  ExpectPiecesMakeTheWhole(alone, inPieces, time, 6,
    [&empty](vtkImageAlgorithm* each)
    {
      empty += each->GetOutput()->GetNumberOfPoints() == 0;
      EXPECT_EQ(each->GetErrorCode(), 0UL);
    });
  EXPECT_EQ(empty, 4);
}

} // namespace
