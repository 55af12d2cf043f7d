// SPDX-License-Identifier: BSD-3-Clause

#include "Faults/Unprivileged.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/RangeLoop.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <atomic>
#include <string>

using namespace nexrad;
using nexrad::testing::HoldsUnprivileged;

namespace
{

// Whether the system refuses every new thread of this process from now on.
bool AllowNoThread()
{
  const rlimit none = {0, 0};
  return setrlimit(RLIMIT_NPROC, &none) == 0;
}

} // namespace

TEST(ThreadGroup, EveryThreadRuns)
{
  std::atomic<int> runs{0};
  {
    const ThreadGroup threads(5, [&runs] { ++runs; });
    EXPECT_EQ(threads.Count(), 5U);
  }
  EXPECT_EQ(runs, 5);
}

TEST(ThreadGroup, GoesOnWithoutTheThreadsThatCannotStart)
{
  EXPECT_TRUE(HoldsUnprivileged(
    []
    {
      const bool none = AllowNoThread();
      const ThreadGroup threads(3, [] {});
      return none && threads.Count() == 0;
    }));
}

TEST(ThreadGroup, SaysWhenNoThreadCanStart)
{
  EXPECT_TRUE(HoldsUnprivileged(
    []
    {
      const bool none = AllowNoThread();
      try
      {
        const ThreadGroup threads(
          3, [] {}, 1);
        return false;
      }
      catch (const Error& error)
      {
        return none && std::string(error.what()).find("ulimit -u") != std::string::npos;
      }
    }));
}

// What leaves a thread of its own would end the program, as of a computation without memory.
TEST(RangeLoops, ThrowWhatTheirWorkThrows)
{
  const auto failing = [](int begin, int)
  {
    if (begin == 7)
    {
      throw Error("seven");
    }
  };
  EXPECT_THROW(ThreadLoop(4)(100, failing), Error);
  EXPECT_THROW(ThreadLoop(1)(100, failing), Error);
}
