// SPDX-License-Identifier: BSD-3-Clause
#include "Output/StopSignal.h"

#include <csignal>

namespace nexrad::application
{
namespace
{

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

} // namespace nexrad::application
