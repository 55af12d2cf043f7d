// SPDX-License-Identifier: BSD-3-Clause
#include "Output/ProgressBar.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <csignal>
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

volatile std::sig_atomic_t stopAsked = 0;

void AskToStop(int)
{
  stopAsked = 1;
}

} // namespace

void WatchStopSignals()
{
  struct sigaction action = {};
  action.sa_handler = AskToStop;
  action.sa_flags = SA_RESETHAND | SA_RESTART; // the next one acts as if it were not watched
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction hangUp = {};
  sigaction(SIGHUP, nullptr, &hangUp);
  if (hangUp.sa_handler != SIG_IGN) // as nohup wants it
  {
    sigaction(SIGHUP, &action, nullptr);
  }
}

bool IsStopAsked()
{
  return stopAsked != 0;
}

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
