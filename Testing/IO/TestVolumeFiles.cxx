// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorMessage.h"
#include "EventCounter.h"
#include "Scans/RadarsOfMissouri.h"
#include "TestData.h"
#include "VolumeMaker.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradVolumeReader.h"
#include "vtkNexradVolumeWriter.h"

#include "vtkDataArraySelection.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringOutputWindow.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>

namespace
{

using nexrad::GriddedVolume;
using nexrad::NxvBandWriter;
using nexrad::VoxelState;
using nexrad::testing::AnyHolds;
using nexrad::testing::EventCounter;
using nexrad::testing::MessageOf;
using nexrad::testing::start;
using nexrad::testing::TemporaryFolder;

/// 6 × 5 × 4 voxels of all states; the echoes count up from `first` dBZ.
GriddedVolume MakeVolume(nexrad::Time time, float first = 10.0F)
{
  GriddedVolume volume;
  volume.grid.dimensions = {6, 5, 4};
  volume.grid.origin = {-1000.0, -2000.0, 500.0};
  volume.grid.spacing = {400.0, 800.0, 1000.0};
  volume.grid.centreLatitude = 38.76;
  volume.grid.centreLongitude = -92.48;
  volume.time = time;
  volume.method = "thesis";
  volume.sites = {"KEAX", "KLSX"};
  volume.synthetic = true;
  volume.fill = 0.0F;
  for (std::size_t i = 0; i < volume.grid.VoxelCount(); ++i)
  {
    const auto state = static_cast<VoxelState>(i % 7 == 0 ? 3 : i % 5 == 0 ? 1 : 0);
    volume.states.push_back(state);
    volume.values.push_back(
      state == VoxelState::Echo ? first + static_cast<float>(i % 50) : volume.fill);
  }
  return volume;
}

void ExpectSame(const GriddedVolume& volume, const GriddedVolume& expected)
{
  EXPECT_EQ(volume.grid.dimensions, expected.grid.dimensions);
  EXPECT_EQ(volume.grid.origin, expected.grid.origin);
  EXPECT_EQ(volume.grid.spacing, expected.grid.spacing);
  EXPECT_EQ(volume.grid.Projection(), expected.grid.Projection());
  EXPECT_EQ(volume.time, expected.time);
  EXPECT_EQ(volume.method, expected.method);
  EXPECT_EQ(volume.sites, expected.sites);
  EXPECT_EQ(volume.synthetic, expected.synthetic);
  EXPECT_EQ(volume.fill, expected.fill);
  EXPECT_EQ(volume.values, expected.values);
  EXPECT_EQ(volume.states, expected.states);
}

/// A source of three time steps, whose values tell the step.
class StepSource : public vtkImageAlgorithm
{
public:
  static StepSource* New();

protected:
  StepSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    vtkInformation* info = output->GetInformationObject(0);
    const double steps[3] = {
      nexrad::ToSeconds(start), nexrad::ToSeconds(start) + 300.0, nexrad::ToSeconds(start) + 600.0};
    const int extent[6] = {0, 5, 0, 4, 0, 3};
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), steps, 3);
    const double range[2] = {steps[0], steps[2]};
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    const double time =
      output->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    const auto step = static_cast<float>((time - nexrad::ToSeconds(start)) / 300.0);
    vtkNexradVolumeToImage(
      MakeVolume(nexrad::FromSeconds(time), 10.0F + step), vtkImageData::GetData(output));
    return 1;
  }
};
vtkStandardNewMacro(StepSource);

TEST(VolumeFiles, ImageHoldsWhatTheContractSays)
{
  const GriddedVolume volume = MakeVolume(start);
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "REF");
  EXPECT_EQ(image->GetScalarType(), VTK_FLOAT);
  EXPECT_EQ(image->GetPointData()->GetArray("REF_state")->GetDataType(), VTK_UNSIGNED_CHAR);
  vtkDataArray* ghosts = image->GetPointData()->GetArray("vtkGhostType");
  EXPECT_EQ(ghosts->GetComponent(0, 0), vtkDataSetAttributes::HIDDENPOINT); // not scanned
  EXPECT_EQ(ghosts->GetComponent(1, 0), 0.0);                               // an echo
  EXPECT_EQ(ghosts->GetComponent(5, 0), 0.0);                               // no echo
  EXPECT_EQ(image->GetPointData()->GetArray("REF_state")->GetComponent(5, 0), 1.0);
  EXPECT_EQ(
    image->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), nexrad::ToSeconds(start));
  double bounds[6];
  image->GetBounds(bounds);
  EXPECT_EQ(bounds[0], -1000.0);
  EXPECT_EQ(bounds[5], 3500.0);
  ExpectSame(vtkNexradImageToVolume(image), volume);
}

TEST(VolumeFiles, RangesAreThoseOfPlainArrays)
{
  const float none = std::numeric_limits<float>::quiet_NaN();
  GriddedVolume volume = MakeVolume(start);
  volume.grid.dimensions = {90, 80, 50}; // more than one thread's share
  volume.states.assign(volume.grid.VoxelCount(), VoxelState::NoEcho);
  volume.values.assign(volume.grid.VoxelCount(), -33.0F);
  volume.values.front() = none;
  volume.values[7] = 61.5F;
  volume.values.back() = -40.0F;
  volume.states.back() = VoxelState::Filtered;
  for (const bool anyValue : {true, false})
  {
    vtkNew<vtkImageData> image;
    vtkNexradVolumeToImage(volume, image);
    vtkPointData* points = image->GetPointData();
    ASSERT_GE(points->GetNumberOfArrays(), 3);
    for (int i = 0; i < points->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = points->GetArray(i);
      const auto plain = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
      EXPECT_STREQ(plain->GetClassName(), array->GetClassName());
      plain->DeepCopy(array);
      for (const bool finite : {false, true})
      {
        double found[2] = {};
        double expected[2] = {};
        finite ? array->GetFiniteRange(found) : array->GetRange(found);
        finite ? plain->GetFiniteRange(expected) : plain->GetRange(expected);
        EXPECT_EQ(found[0], expected[0]) << array->GetName() << " " << anyValue << finite;
        EXPECT_EQ(found[1], expected[1]) << array->GetName() << " " << anyValue << finite;
      }
    }
    volume.values.assign(volume.grid.VoxelCount(), none);
  }
}

// No echo is a low reflectivity, but no velocity at all.
TEST(VolumeFiles, WhereThereIsNoVelocityThePointIsHidden)
{
  GriddedVolume volume = MakeVolume(start);
  volume.moment = nexrad::MomentName::VEL;
  volume.states[1] = VoxelState::RangeFolded;
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  vtkDataArray* ghosts = image->GetPointData()->GetArray("vtkGhostType");
  EXPECT_EQ(ghosts->GetComponent(0, 0), vtkDataSetAttributes::HIDDENPOINT); // not scanned
  EXPECT_EQ(ghosts->GetComponent(1, 0), vtkDataSetAttributes::HIDDENPOINT); // range folded
  EXPECT_EQ(ghosts->GetComponent(2, 0), 0.0);                               // an echo
  EXPECT_EQ(ghosts->GetComponent(5, 0), vtkDataSetAttributes::HIDDENPOINT); // no echo
}

// The ghost flags are the first moment's; where a further one has no value, it is not a number.
TEST(VolumeFiles, SeveralMomentsAreArraysOfOneImage)
{
  GriddedVolume velocity = MakeVolume(start);
  velocity.moment = nexrad::MomentName::VEL;
  velocity.states[2] = VoxelState::RangeFolded;
  velocity.values[2] = velocity.fill;
  const GriddedVolume both = nexrad::JoinMoments({MakeVolume(start), velocity});
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(both, image);
  vtkPointData* points = image->GetPointData();
  EXPECT_STREQ(points->GetScalars()->GetName(), "REF");
  EXPECT_EQ(points->GetArray("REF")->GetComponent(5, 0), 0.0); // no echo: the fill value
  EXPECT_TRUE(std::isnan(points->GetArray("VEL")->GetComponent(5, 0)));
  EXPECT_TRUE(std::isnan(points->GetArray("VEL")->GetComponent(2, 0)));
  EXPECT_EQ(points->GetArray("VEL_state")->GetComponent(2, 0), 2.0);
  EXPECT_EQ(points->GetArray("vtkGhostType")->GetComponent(5, 0), 0.0);
  const GriddedVolume back = vtkNexradImageToVolume(image);
  ExpectSame(back, both);
  ASSERT_EQ(back.further.size(), 1U);
  ExpectSame(back.further[0], both.further[0]);
}

TEST(VolumeFiles, AMomentOfSeveralIsReadAsTheOnlyOne)
{
  GriddedVolume velocity = MakeVolume(start);
  velocity.moment = nexrad::MomentName::VEL;
  const TemporaryFolder folder;
  const std::string path = folder.Path() / "two.nxv";
  nexrad::WriteNxv(path, nexrad::JoinMoments({MakeVolume(start), velocity}));
  nexrad::WriteNxv(folder.Path() / "one.nxv", velocity);
  vtkNew<vtkNexradVolumeReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_TRUE(reader->GetOutput()->GetPointData()->HasArray("VEL"));
  reader->SetMoments("VEL");
  reader->Update();
  EXPECT_FALSE(reader->GetOutput()->GetPointData()->HasArray("REF"));
  const GriddedVolume read = vtkNexradImageToVolume(reader->GetOutput());
  ExpectSame(read, nexrad::ReadNxv(folder.Path() / "one.nxv"));
  for (const char* names : {"SW", "speed"})
  {
    vtkNew<EventCounter> events;
    events->Observe(reader);
    events->Observe(reader->GetExecutive());
    reader->SetMoments(names);
    reader->Update();
    EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileFormatError));
    EXPECT_TRUE(AnyHolds(events->errors, names));
  }
}

// As in ParaView, which shows what goes to the output window.
TEST(VolumeFiles, ACutFileIsOneMessage)
{
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.Path() / "cut.nxv";
  nexrad::WriteNxv(path, MakeVolume(start));
  for (const double part : {0.9, 0.01}) // without some voxels, and without a whole header
  {
    const auto size = static_cast<double>(std::filesystem::file_size(path));
    std::filesystem::resize_file(path, static_cast<std::uintmax_t>(part * size));
    const vtkSmartPointer<vtkOutputWindow> shown = vtkOutputWindow::GetInstance();
    const vtkNew<vtkStringOutputWindow> messages;
    vtkOutputWindow::SetInstance(messages);
    const vtkNew<vtkNexradVolumeReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkOutputWindow::SetInstance(shown);
    const std::string text = messages->GetOutput();
    EXPECT_NE(text.find(path.string() + ": "), std::string::npos) << text;
    EXPECT_EQ(text.find("ERROR:"), text.rfind("ERROR:")) << text;
  }
}

TEST(VolumeFiles, ImageWithoutTheArraysIsRefusedByName)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  image->AllocateScalars(VTK_FLOAT, 1);
  EXPECT_THROW(vtkNexradImageToVolume(image), nexrad::Error);
  image->GetPointData()->GetScalars()->SetName("REF");
  const std::string error = MessageOf([&] { vtkNexradImageToVolume(image); });
  EXPECT_NE(error.find("REF_state"), std::string::npos);
}

TEST(VolumeFiles, WhatIsWrittenIsRead)
{
  const TemporaryFolder folder;
  const std::string path = (folder.Path() / "volume.nxv").string();
  const GriddedVolume volume = MakeVolume(start);
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  vtkNew<vtkNexradVolumeWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  for (const int encoding : {vtkNexradVolumeWriter::AUTOMATIC, vtkNexradVolumeWriter::FLOAT,
         vtkNexradVolumeWriter::RADAR_STEPS})
  {
    writer->SetEncoding(encoding);
    ASSERT_EQ(writer->Write(), 1);
    ASSERT_EQ(writer->GetNumberOfWrittenFiles(), 1);
    EXPECT_EQ(vtkNexradVolumeReader::CanReadFile(path.c_str()), 1);
    vtkNew<vtkNexradVolumeReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    ExpectSame(vtkNexradImageToVolume(reader->GetOutput()), volume);
    EXPECT_EQ(reader->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()),
      nexrad::ToSeconds(start));
  }
}

// Whole, and a box of the voxels.
TEST(VolumeFiles, ScalarsMayBeTheCodesOfTheFile)
{
  const TemporaryFolder folder;
  const std::string path = (folder.Path() / "volume.nxv").string();
  const GriddedVolume volume = MakeVolume(start);
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  vtkNew<vtkNexradVolumeWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  vtkNew<vtkNexradVolumeReader> reader;
  reader->SetFileName(path.c_str());
  reader->ScalarsAsCodesOn();
  for (const int encoding : {vtkNexradVolumeWriter::RADAR_STEPS, vtkNexradVolumeWriter::AUTOMATIC})
  {
    writer->SetEncoding(encoding);
    ASSERT_EQ(writer->Write(), 1);
    reader->Modified();
    reader->UpdateWholeExtent();
    vtkImageData* coded = reader->GetOutput();
    ASSERT_EQ(coded->GetScalarType(), VTK_UNSIGNED_CHAR);
    EXPECT_STREQ(coded->GetPointData()->GetScalars()->GetName(), "REF");
    EXPECT_FALSE(coded->GetPointData()->HasArray("REF_state"));
    EXPECT_FALSE(coded->GetPointData()->HasArray("vtkGhostType"));
    vtkFieldData* field = coded->GetFieldData();
    const auto notScanned =
      static_cast<vtkIdType>(coded->GetPointData()->GetScalars()->GetTuple1(0));
    const auto echo = static_cast<vtkIdType>(coded->GetPointData()->GetScalars()->GetTuple1(1));
    EXPECT_EQ(field->GetArray("REF_code_states")->GetTuple1(notScanned), 3.0);
    EXPECT_EQ(
      field->GetArray("REF_code_ghosts")->GetTuple1(notScanned), vtkDataSetAttributes::HIDDENPOINT);
    EXPECT_EQ(field->GetArray("REF_code_values")->GetTuple1(notScanned), 0.0);
    EXPECT_EQ(field->GetArray("REF_code_values")->GetTuple1(echo), 11.0);
    EXPECT_EQ(field->GetArray("REF_code_ghosts")->GetTuple1(echo), 0.0);
    ExpectSame(vtkNexradImageToVolume(coded), volume);
    int box[6] = {1, 4, 2, 3, 0, 2};
    reader->Modified(); // or the whole would do
    reader->UpdateExtent(box);
    coded = reader->GetOutput();
    EXPECT_EQ(coded->GetNumberOfPoints(), 4 * 2 * 3);
    const vtkIdType point = coded->FindPoint(-1000.0 + 400.0 * 4, -2000.0 + 800.0 * 3, 2500.0);
    EXPECT_EQ(vtkNexradImageToVolume(coded).values[static_cast<std::size_t>(point)],
      volume.values[4 + 6 * (3 + 5 * 2)]);
  }
  // Floats stay floats.
  writer->SetEncoding(vtkNexradVolumeWriter::FLOAT);
  ASSERT_EQ(writer->Write(), 1);
  reader->Modified();
  reader->UpdateWholeExtent();
  EXPECT_EQ(reader->GetOutput()->GetScalarType(), VTK_FLOAT);
}

// A box of a file in bricks, as floats and as codes, is that part of the whole image.
TEST(VolumeFiles, ABoxOfBricksIsPartOfTheWhole)
{
  const TemporaryFolder folder;
  const std::string path = (folder.Path() / "volume.nxv").string();
  const GriddedVolume volume = MakeVolume(start);
  NxvBandWriter bricks(path, volume.grid);
  bricks.Add(volume);
  bricks.Commit();
  vtkNew<vtkNexradVolumeReader> reader;
  reader->SetFileName(path.c_str());
  for (const bool codes : {false, true})
  {
    reader->SetScalarsAsCodes(codes);
    reader->UpdateWholeExtent();
    vtkNew<vtkImageData> whole;
    whole->DeepCopy(reader->GetOutput());
    ExpectSame(vtkNexradImageToVolume(whole), volume);
    int box[6] = {1, 4, 2, 3, 0, 2};
    reader->Modified();
    reader->UpdateExtent(box);
    vtkImageData* part = reader->GetOutput();
    ASSERT_TRUE(std::equal(box, box + 6, part->GetExtent()));
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      const vtkIdType same = whole->FindPoint(part->GetPoint(i));
      EXPECT_EQ(part->GetPointData()->GetScalars()->GetTuple1(i),
        whole->GetPointData()->GetScalars()->GetTuple1(same));
    }
  }
}

// Of a file that has the volume in voxels of several sizes, those of a level.
TEST(VolumeFiles, ALevelIsReadInItsOwnVoxels)
{
  const TemporaryFolder folder;
  const std::string path = (folder.Path() / "volume.nxv").string();
  GriddedVolume volume = nexrad::testing::MakeGriddedVolume({1026, 3, 2});
  nexrad::testing::AddAncillary(volume);
  NxvBandWriter bricks(path, volume.grid);
  bricks.Add(volume);
  bricks.Commit();
  vtkNew<vtkNexradVolumeReader> reader;
  reader->SetFileName(path.c_str());
  const int columns[] = {1026, 513, 257, 257}; // the last: there is no such level
  for (int level = 0; level < 4; ++level)
  {
    reader->SetLevel(level);
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    EXPECT_EQ(image->GetDimensions()[0], columns[level]);
    EXPECT_EQ(image->GetSpacing()[0], volume.grid.spacing[0] * (1 << std::min(level, 2)));
    EXPECT_EQ(image->GetPointData()->HasArray("REF_age"), level == 0 ? 1 : 0);
    EXPECT_EQ(reader->GetAncillaryArraySelection()->GetNumberOfArrays(), level == 0 ? 4 : 0);
  }
  int box[6] = {100, 120, 0, 0, 1, 1};
  reader->SetLevel(1);
  reader->Update();
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(reader->GetOutput());
  reader->Modified();
  reader->UpdateExtent(box);
  for (vtkIdType i = 0; i < reader->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const vtkIdType same = whole->FindPoint(reader->GetOutput()->GetPoint(i));
    EXPECT_EQ(reader->GetOutput()->GetPointData()->GetScalars()->GetTuple1(i),
      whole->GetPointData()->GetScalars()->GetTuple1(same));
  }
}

/// MakeVolume with ancillary arrays, whose numbers need no rounding in a file.
GriddedVolume MakeAncillaryArrayVolume()
{
  GriddedVolume volume = MakeVolume(start);
  volume.method = "beam";
  for (std::size_t i = 0; i < volume.grid.VoxelCount(); ++i)
  {
    const bool scanned = volume.states[i] != VoxelState::NotScanned;
    volume.ancillary.age.push_back(scanned ? static_cast<float>(i) : 0.0F);
    volume.ancillary.radars.push_back(static_cast<std::uint8_t>(scanned ? 1 + i % 2 : 0));
    volume.ancillary.weight.push_back(scanned ? 0.25F : 0.0F);
    volume.ancillary.nearestSite.push_back(
      scanned ? static_cast<std::uint8_t>(i % 2) : nexrad::AncillaryArrays::NoSite);
  }
  return volume;
}

void ExpectSameAncillaryArrays(const GriddedVolume& volume, const GriddedVolume& expected)
{
  EXPECT_EQ(volume.ancillary.age, expected.ancillary.age);
  EXPECT_EQ(volume.ancillary.radars, expected.ancillary.radars);
  EXPECT_EQ(volume.ancillary.weight, expected.ancillary.weight);
  EXPECT_EQ(volume.ancillary.nearestSite, expected.ancillary.nearestSite);
}

TEST(VolumeFiles, AncillaryArraysAreWrittenAndReadAndCanBeLeftOut)
{
  const TemporaryFolder folder;
  const std::string path = (folder.Path() / "volume.nxv").string();
  const GriddedVolume volume = MakeAncillaryArrayVolume();
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  ExpectSameAncillaryArrays(vtkNexradImageToVolume(image), volume);
  vtkNew<vtkNexradVolumeWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  ASSERT_EQ(writer->Write(), 1);

  vtkNew<vtkNexradVolumeReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  ExpectSame(vtkNexradImageToVolume(reader->GetOutput()), volume);
  ExpectSameAncillaryArrays(vtkNexradImageToVolume(reader->GetOutput()), volume);
  EXPECT_STREQ(reader->GetOutput()->GetPointData()->GetScalars()->GetName(), "REF");
  vtkDataArraySelection* selection = reader->GetAncillaryArraySelection();
  ASSERT_EQ(selection->GetNumberOfArrays(), 4);
  EXPECT_STREQ(selection->GetArrayName(3), "REF_site");

  selection->DisableArray("REF_age");
  reader->Update();
  vtkPointData* points = reader->GetOutput()->GetPointData();
  EXPECT_FALSE(points->HasArray("REF_age"));
  EXPECT_TRUE(points->HasArray("REF_radars"));
  // A file without ancillary arrays lists none.
  const std::string plain = (folder.Path() / "plain.nxv").string();
  vtkNexradVolumeToImage(MakeVolume(start), image);
  writer->SetFileName(plain.c_str());
  ASSERT_EQ(writer->Write(), 1);
  reader->SetFileName(plain.c_str());
  reader->Update();
  EXPECT_EQ(selection->GetNumberOfArrays(), 0);
  EXPECT_FALSE(reader->GetOutput()->GetPointData()->HasArray("REF_radars"));
}

TEST(VolumeFiles, AncillaryArraysOfAnotherTypeAreRefusedByName)
{
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(MakeVolume(start), image);
  vtkNew<vtkFloatArray> radars;
  radars->SetName("REF_radars");
  radars->SetNumberOfTuples(image->GetNumberOfPoints());
  radars->Fill(1.0);
  image->GetPointData()->AddArray(radars);
  const std::string error = MessageOf([&] { vtkNexradImageToVolume(image); });
  EXPECT_NE(error.find("REF_radars"), std::string::npos);
}

TEST(VolumeFiles, SeriesIsWrittenAndReadStepByStep)
{
  const TemporaryFolder folder;
  const std::string path = (folder.Path() / "storm.nxv.series").string();
  vtkNew<StepSource> source;
  vtkNew<vtkNexradVolumeWriter> writer;
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetFileName(path.c_str());
  ASSERT_EQ(writer->Write(), 1);
  EXPECT_EQ(writer->GetNumberOfWrittenFiles(), 4);
  EXPECT_TRUE(std::filesystem::exists(folder.Path() / "20060312T180500Z.nxv"));

  EXPECT_EQ(vtkNexradVolumeReader::CanReadFile(path.c_str()), 1);
  vtkNew<vtkNexradVolumeReader> reader;
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  ASSERT_EQ(
    reader->GetOutputInformation(0)->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 3);
  const auto firstEcho = [&](double after)
  {
    reader->UpdateTimeStep(nexrad::ToSeconds(start) + after);
    return reader->GetOutput()->GetPointData()->GetScalars()->GetComponent(1, 0);
  };
  EXPECT_EQ(firstEcho(0.0), 11.0);
  EXPECT_EQ(firstEcho(300.0), 12.0);
  EXPECT_EQ(firstEcho(600.0), 13.0);
  EXPECT_EQ(firstEcho(599.0), 12.0);  // the latest at or before
  EXPECT_EQ(firstEcho(-100.0), 11.0); // the first
}

TEST(VolumeFiles, TimeAndAncillaryArraysSurviveVtkXmlFiles)
{
  const TemporaryFolder folder;
  const std::string path = (folder.Path() / "volume.vti").string();
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(MakeAncillaryArrayVolume(), image);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  ExpectSame(vtkNexradImageToVolume(reader->GetOutput()), MakeAncillaryArrayVolume());
  ExpectSameAncillaryArrays(
    vtkNexradImageToVolume(reader->GetOutput()), MakeAncillaryArrayVolume());
}

TEST(VolumeFiles, BrokenFilesAreErrors)
{
  const TemporaryFolder folder;
  const std::string good = (folder.Path() / "volume.nxv").string();
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(MakeVolume(start), image);
  vtkNew<vtkNexradVolumeWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(good.c_str());
  ASSERT_EQ(writer->Write(), 1);
  const std::string cut = (folder.Path() / "cut.nxv").string();
  std::filesystem::copy(good, cut);
  std::filesystem::resize_file(cut, std::filesystem::file_size(cut) - 1);
  const std::string text = (folder.Path() / "text.nxv").string();
  std::ofstream(text) << "no volume";
  EXPECT_EQ(vtkNexradVolumeReader::CanReadFile(text.c_str()), 0);

  vtkNew<vtkNexradVolumeReader> reader;
  vtkNew<EventCounter> events;
  events->Observe(reader);
  events->Observe(reader->GetExecutive());
  const auto codeOf = [&](const std::string& path)
  {
    reader->SetFileName(path.c_str());
    reader->Update();
    EXPECT_TRUE(AnyHolds(events->errors, path));
    return reader->GetErrorCode();
  };
  EXPECT_EQ(codeOf(cut), static_cast<unsigned long>(vtkErrorCode::FileFormatError));
  EXPECT_EQ(codeOf(text), static_cast<unsigned long>(vtkErrorCode::FileFormatError));
  EXPECT_EQ(codeOf((folder.Path() / "absent.nxv").string()),
    static_cast<unsigned long>(vtkErrorCode::FileNotFoundError));
}

TEST(VolumeFiles, WriterFailsWithACodeAndLeavesNothing)
{
  const TemporaryFolder folder;
  vtkNew<StepSource> source;
  vtkNew<vtkNexradVolumeWriter> writer;
  vtkNew<EventCounter> events;
  events->Observe(writer);
  events->Observe(writer->GetExecutive());
  writer->SetInputConnection(source->GetOutputPort());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoFileNameError));
  writer->SetFileName((folder.Path() / "no-such-folder/storm.nxv.series").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::CannotOpenFileError));
  EXPECT_TRUE(AnyHolds(events->errors, "no-such-folder"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.Path()));
}

} // namespace
