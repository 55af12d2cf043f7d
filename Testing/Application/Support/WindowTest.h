// SPDX-License-Identifier: BSD-3-Clause
// A window of the program, and what a user does in it.
#pragma once

#include "TestData.h"
#include "Viewer/MainWindow.h"

#include <QApplication>
#include <QImage>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <functional>
#include <memory>

namespace nexrad::testing
{

/// Visibly different pixels, of all.
double Difference(const QImage& a, const QImage& b);

/// Writes a path into the next dialog of files, and accepts it, until the dialog closes.
void AnswerDialog(const std::filesystem::path& path);

/// A window with settings of its own, on synthetic storms.
class WindowTest : public ::testing::Test
{
protected:
  static void SetUpTestSuite();
  static void TearDownTestSuite();

  /// A window on some steps of a synthetic storm, all of them loaded.
  void OpenSteps(int steps);
  void OpenWindow(const std::array<int, 2>& size = {900, 600});
  static bool Wait(const std::function<bool()>& condition);
  /// Until all that was asked for is drawn.
  QImage WaitForPicture();

  template <typename Widget>
  Widget* Find(const char* name)
  {
    auto* found = window->findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }

  void Click(const char* button);
  /// Chooses an entry of a box as a user does with the keys; up where `down` is below 0.
  void Choose(const char* name, int down);
  /// How much of the picture an action changes.
  double Changes(const std::function<void()>& action);

  static std::unique_ptr<QApplication> application;
  static std::unique_ptr<QTemporaryDir> settings;
  TemporaryFolder folder;
  viewer::ViewRequest request;
  std::unique_ptr<viewer::MainWindow> window;
};

} // namespace nexrad::testing
