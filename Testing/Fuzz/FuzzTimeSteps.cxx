// SPDX-License-Identifier: BSD-3-Clause
// Feeds texts to the reader of the time steps that `watch` keeps between two runs.
#include "FuzzTarget.h"

#include "nexrad/Live/StepBook.h"
#include "nexrad/System/Error.h"

#include <algorithm>

using namespace nexrad;
using namespace nexrad::testing;
using namespace std::chrono_literals;

namespace
{

const Time start = *ParseIso8601("2006-03-12T18:00:00Z");

// What a run does with the steps of the one before.
void GoOn(StepBook& book)
{
  book.Extend(start, start + 1h);
  const std::vector<Time> open = book.Open();
  Require(std::is_sorted(open.begin(), open.end()), "steps ascend");
  for (const Time step : open)
  {
    if (book.IsDue(step, "now", true))
    {
      book.Make(step, "now");
    }
    Require(!book.IsDue(step, "now", true), "a step that was made is not due");
  }
  book.Close();
  for (const Time step : book.Open())
  {
    Require(!book.IsClosing(step), "steps that were closed are not open");
  }
  book.Drop(start + 30min);
  const std::vector<Time> made = book.Made();
  Require(made.empty() || made.front() >= start + 30min, "steps that were dropped are gone");
}

} // namespace

namespace nexrad::testing
{

std::vector<Bytes> FuzzSeeds()
{
  StepRules rules;
  StepBook book(rules);
  const std::string empty = book.Pack();
  book.Extend(start, start + 40min);
  book.Make(start, "KAAA 1");
  book.Make(start + 5min, "KAAA 2");
  const std::string open = book.Pack();
  book.Close();
  return {BytesOf(empty), BytesOf(open), BytesOf(book.Pack())};
}

} // namespace nexrad::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  StepBook book{StepRules()};
  try
  {
    book.Unpack(std::string(data, data + size));
  }
  catch (const Error& error)
  {
    RequireMessage(error.what());
    const bool isNew = book.Pack() == StepBook(StepRules()).Pack();
    Require(isNew, "a text that is refused changes nothing");
    return 0;
  }
  StepBook copy{StepRules()};
  copy.Unpack(book.Pack());
  Require(copy.Pack() == book.Pack(), "steps come back as they were packed");
  try
  {
    GoOn(book);
  }
  catch (const Error& error) // steps over thousands of years
  {
    RequireMessage(error.what());
  }
  return 0;
}
