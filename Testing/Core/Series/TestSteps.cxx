// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/Steps.h"

#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

namespace nexrad
{
namespace
{

using namespace std::chrono_literals;

const Time noon = *ParseIso8601("2006-03-12T12:00:00Z");

TEST(Steps, AreDueUntilTheyAreMadeOfTheSame)
{
  Steps steps;
  EXPECT_TRUE(steps.IsDue(noon, ""));
  steps.Make(noon, "KEAX 1");
  EXPECT_FALSE(steps.IsDue(noon, "KEAX 1"));
  EXPECT_TRUE(steps.IsDue(noon, "KEAX 2"));
  EXPECT_TRUE(steps.IsDue(noon + 5min, "KEAX 1"));
  steps.Make(noon, "KEAX 2");
  EXPECT_FALSE(steps.IsDue(noon, "KEAX 2"));
}

// Whatever bytes the names of files have.
TEST(Steps, ComeBackAsTheyWerePacked)
{
  const std::string odd = "\nREF \"\x80\xff\"\\\x01";
  Steps steps;
  steps.Make(noon, odd);
  steps.Make(noon + 5min, "two");
  const std::string text = steps.Pack();
  EXPECT_EQ(text.find('\n'), std::string::npos);
  Steps same;
  same.Make(noon, "another");
  same.Make(noon - 5min, "before");
  same.Unpack(text);
  EXPECT_FALSE(same.IsDue(noon, odd));
  EXPECT_EQ(same.Made(), (std::vector<Time>{noon - 5min, noon, noon + 5min}));
  Steps copy;
  copy.Unpack(same.Pack());
  EXPECT_EQ(copy.Pack(), same.Pack());
  EXPECT_EQ(Steps().Pack(), "[]");
}

TEST(Steps, RefuseWhatIsNone)
{
  Steps steps;
  for (const char* text :
    {"", "[[", "[[1]]", "[[\"noon\",\"\"]]", "[[1,2]]", "[[1,\"a\"],[1e300,\"\"]]"})
  {
    EXPECT_THROW(steps.Unpack(text), Error) << text;
  }
  EXPECT_TRUE(steps.Made().empty());
}

TEST(Steps, ThatAreClosedOrDroppedHaveNoText)
{
  Steps steps;
  steps.Make(noon, "one");
  steps.Make(noon + 5min, "two");
  steps.Make(noon + 10min, "three");
  steps.Close(noon + 5min);
  EXPECT_TRUE(steps.IsDue(noon + 5min, "two"));
  EXPECT_FALSE(steps.IsDue(noon + 10min, "three"));
  steps.Drop(noon + 5min);
  EXPECT_EQ(steps.Made(), (std::vector<Time>{noon + 5min, noon + 10min}));
}

} // namespace
} // namespace nexrad
