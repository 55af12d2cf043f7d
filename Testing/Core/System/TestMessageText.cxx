// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/MessageText.h"

#include <gtest/gtest.h>

#include <string>

using namespace nexrad;

TEST(MessageTexts, AreOneLineWithoutControlCharacters)
{
  EXPECT_EQ(
    MessageLine("a\nb\r\x1b[31m\tc\x7f\xc2\x9b"), "a\\x0ab\\x0d\\x1b[31m\\x09c\\x7f\xc2\\x9b");
  EXPECT_EQ(MessageLine("Zürich – 中"), "Zürich – 中");
}

TEST(MessageTexts, KeepTheBeginAndTheEndOfALongOne)
{
  const std::string line = MessageLine("begin " + std::string(10'000, 'x') + " end");
  EXPECT_LE(line.size(), 2'010U);
  EXPECT_EQ(line.rfind("begin x", 0), 0U);
  EXPECT_NE(line.find("x…x"), std::string::npos);
  EXPECT_EQ(line.substr(line.size() - 4), " end");
  std::string letters;
  for (int i = 0; i < 2'000; ++i)
  {
    letters += "中";
  }
  const std::string cut = MessageLine(letters);
  EXPECT_EQ(cut.size() % 3, 0U) << "a letter was cut";
}

// What a file says of itself is quoted in part, its name as a whole.
TEST(MessageTexts, OfAFileNameIt)
{
  const std::string name = "/" + std::string(1'000, 'n') + ".nxv";
  const std::string message = FileError(name, "key \"" + std::string(5'000, 'k') + "\n").what();
  EXPECT_EQ(message.rfind(name + ": key ", 0), 0U);
  EXPECT_LT(message.size(), name.size() + 310);
  EXPECT_EQ(std::string(FileError("f", "two\nlines").what()), "f: two\\x0alines");
}
