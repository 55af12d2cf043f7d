// SPDX-License-Identifier: BSD-3-Clause
#include "EventCounter.h"
#include "TestData.h"

#include "vtkNexradDayReader.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

namespace
{

using nexrad::testing::EventCounter;

void UseSmallGrid(vtkNexradDayReader* reader)
{
  reader->SetDimensions(64, 64, 16);
}

TEST(DayReader, PublishesTheTimeStepsOfTheRun)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  vtkNew<vtkNexradDayReader> reader;
  UseSmallGrid(reader);
  reader->AddFileName((data / "level2/run-kbgm-20050821").c_str());
  reader->UpdateInformation();
  vtkDoubleArray* steps = reader->GetTimeSteps();
  // The rays run from 02:43:19 to 03:12:12: 02:45, 02:50, … 03:10.
  ASSERT_EQ(steps->GetNumberOfValues(), 6);
  EXPECT_EQ(steps->GetValue(0), 1124592300.0);
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  image->Print(std::cout);
}

} // namespace
