// SPDX-License-Identifier: BSD-3-Clause
#include "Tolerance.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace nexrad::testing
{

namespace
{

struct Noted
{
  double measured = 0.0;
  double bound = 0.0;
  std::string reason;
};

// How far inside the bound a figure is, as a part of the bound: the figure with the least is the
// worst.
double Margin(bool atMost, double measured, double bound)
{
  const double margin = atMost ? bound - measured : measured - bound;
  return bound != 0.0 ? margin / std::abs(bound) : margin;
}

// The worst figures of the running test; written when it ends.
class List : public ::testing::EmptyTestEventListener
{
public:
  explicit List(std::string file)
    : path(std::move(file))
  {
  }

  void Add(const BoundedFigure& figure, double measured, double bound)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    const auto [found, isNew] = figures.try_emplace({std::string(figure.what), figure.atMost});
    Noted& noted = found->second;
    if (isNew ||
        Margin(figure.atMost, measured, bound) < Margin(figure.atMost, noted.measured, noted.bound))
    {
      noted = {measured, bound, std::string(figure.reason)};
    }
  }

  void OnTestEnd(const ::testing::TestInfo& test) override
  {
    std::string lines;
    for (const auto& [what, noted] : figures)
    {
      char numbers[64];
      std::snprintf(numbers, sizeof(numbers), "\t%.6g\t%.6g\t", noted.measured, noted.bound);
      lines.append(test.test_suite_name()).append(".").append(test.name()).append("\t");
      lines.append(what.first).append(numbers).append(what.second ? "most" : "least");
      lines.append("\t").append(noted.reason).append("\n");
    }
    figures.clear();
    if (!lines.empty())
    {
      Append(lines);
    }
  }

private:
  // Other processes append to the same file: all lines go in one write.
  void Append(const std::string& lines) const
  {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    const bool written =
      file >= 0 && write(file, lines.data(), lines.size()) == static_cast<ssize_t>(lines.size());
    if (file >= 0)
    {
      close(file);
    }
    EXPECT_TRUE(written) << "cannot append to " << path;
  }

  std::string path;
  std::mutex mutex;
  std::map<std::pair<std::string, bool>, Noted> figures;
};

// The first figure of a process makes the list; GoogleTest deletes it.
List& TheList(const char* path)
{
  static List* const list = [path]
  {
    auto* made = new List(path);
    ::testing::UnitTest::GetInstance()->listeners().Append(made);
    return made;
  }();
  return *list;
}

} // namespace

void BoundedFigure::Record(double measured, double bound) const
{
  const char* path = std::getenv("NEXRAD_TOLERANCES");
  if (path != nullptr && *path != '\0')
  {
    TheList(path).Add(*this, measured, bound);
  }
}

::testing::AssertionResult Judge(const BoundedFigure& figure, const char* expression,
  const char* limit, double measured, double bound)
{
  figure.Record(measured, bound);
  if (figure.Holds(measured, bound))
  {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure()
         << figure.what << "\nExpected: (" << expression << ") " << (figure.atMost ? "<=" : ">=")
         << " (" << limit << "), actual: " << measured << " vs " << bound;
}

} // namespace nexrad::testing
