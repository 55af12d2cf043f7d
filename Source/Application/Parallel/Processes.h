// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkMultiProcessController;

namespace nexrad::application
{

/// This process among several that do one piece of work together, or one alone.
class Processes
{
public:
  /// The controller is not owned; nullptr: one process alone.
  explicit Processes(vtkMultiProcessController* ofAll = nullptr)
    : controller(ofAll)
  {
  }

  std::size_t Rank() const;
  std::size_t Count() const;
  /// True for the process that speaks to the user and writes what there is once.
  bool IsFirst() const { return this->Rank() == 0; }

  /// The part [first, second) of `count` things that this process works on: neighbours, and as many
  /// as the others have, or one more.
  std::pair<std::size_t, std::size_t> Part(std::size_t count) const;

  /// What each process hands over, in the order of their ranks. All of them call it.
  std::vector<std::string> Exchange(const std::string& mine) const;

  /// Runs `work`, as all processes do, and returns when all are done. When it throws in one of
  /// them, this throws in all: there what was thrown, elsewhere an Error of the same text.
  void Together(const std::function<void()>& work) const;

private:
  vtkMultiProcessController* controller;
};

} // namespace nexrad::application
