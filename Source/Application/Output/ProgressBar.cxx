// SPDX-License-Identifier: BSD-3-Clause
#include "Output/ProgressBar.h"

#include "Output/StopSignal.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <unistd.h>
#include <utility>

namespace nexrad::application
{
namespace
{
constexpr auto firstShown = std::chrono::seconds(2);
constexpr auto betweenUpdates = std::chrono::milliseconds(100);
constexpr int width = 40;
} // namespace

void AddQuietOption(CLI::App& command, bool& quiet)
{
  command.add_flag("--quiet", quiet, "No progress bar and no summary");
}

ProgressBar::ProgressBar(std::string whatIsDone, bool quiet)
  : what(std::move(whatIsDone))
  , enabled(!quiet && isatty(fileno(stderr)) == 1)
{
}

ProgressBar::~ProgressBar()
{
  this->Clear();
}

bool ProgressBar::Update(double fraction)
{
  this->Draw(fraction);
  return !IsStopAsked();
}

void ProgressBar::Draw(double fraction)
{
  const auto now = Clock::now();
  if (!enabled || now - start < firstShown || now - drawn < betweenUpdates)
  {
    return;
  }
  drawn = now;
  visible = true;
  const double part = std::clamp(fraction, 0.0, 1.0);
  const int filled = static_cast<int>(std::lround(part * width));
  std::cerr << '\r' << what << " [" << std::string(filled, '=') << std::string(width - filled, ' ')
            << "] " << std::lround(part * 100.0) << " %  " << std::flush;
}

void ProgressBar::Clear()
{
  if (visible)
  {
    std::cerr << '\r' << std::string(what.size() + width + 12, ' ') << '\r' << std::flush;
    visible = false;
  }
}

} // namespace nexrad::application
