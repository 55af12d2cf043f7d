// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   TestFailures.cxx
 * @brief  what a filter says of an input that it cannot use
 */
#include "vtkNexradEchoOnly.h"
#include "vtkNexradHistogram.h"
#include "vtkNexradTwoFields.h"
#include "vtkNexradVerticalSection.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStringOutputWindow.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

template <class Filter>
class FailingFilter : public testing::Test
{
};

using Filters = testing::Types<vtkNexradEchoOnly, vtkNexradHistogram, vtkNexradTwoFields,
  vtkNexradVerticalSection>;
TYPED_TEST_SUITE(FailingFilter, Filters);

// As in ParaView, which shows what goes to the output window; also when it fails again.
TYPED_TEST(FailingFilter, SaysItInOneMessage)
{
  const vtkNew<vtkImageData> image; // without arrays
  image->SetDimensions(4, 4, 4);
  const vtkNew<TypeParam> filter;
  filter->SetInputData(image);
  const vtkSmartPointer<vtkOutputWindow> shown = vtkOutputWindow::GetInstance();
  for (int run = 0; run < 2; ++run)
  {
    const vtkNew<vtkStringOutputWindow> messages;
    vtkOutputWindow::SetInstance(messages);
    filter->Modified();
    filter->Update();
    vtkOutputWindow::SetInstance(shown);
    const std::string text = messages->GetOutput();
    EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
    EXPECT_NE(text.find("ERROR:"), std::string::npos) << text;
    EXPECT_EQ(text.find("ERROR:"), text.rfind("ERROR:")) << text;
  }
}

} // namespace
