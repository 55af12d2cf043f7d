// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/Processes.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <exception>

namespace nexrad
{

Processes::Processes(std::size_t theRank, std::size_t theCount, ExchangeFunction theExchange)
  : rank(theRank)
  , count(theCount)
  , exchange(std::move(theExchange))
{
}

std::pair<std::size_t, std::size_t> Processes::Part(std::size_t things) const
{
  return this->PartOf(things, rank);
}

std::pair<std::size_t, std::size_t> Processes::PartOf(std::size_t things, std::size_t ofRank) const
{
  return {things * ofRank / count, things * (ofRank + 1) / count};
}

std::vector<std::string> Processes::Exchange(const std::string& mine) const
{
  return count > 1 ? exchange(mine) : std::vector<std::string>{mine};
}

bool Processes::InAll(bool mine) const
{
  const std::vector<std::string> all = this->Exchange(mine ? "1" : "0");
  return std::all_of(all.begin(), all.end(), [](const std::string& each) { return each == "1"; });
}

void Processes::RequireSame(const std::string& mine, const std::string& otherwise) const
{
  const std::vector<std::string> all = this->Exchange(mine);
  if (std::any_of(
        all.begin(), all.end(), [&all](const std::string& each) { return each != all.front(); }))
  {
    throw Error(otherwise);
  }
}

void Processes::Together(const std::function<void()>& work) const
{
  std::exception_ptr own;
  std::string failure; // empty: none
  try
  {
    work();
  }
  catch (const std::exception& error)
  {
    own = std::current_exception();
    failure = std::string("!") + error.what();
  }
  const std::vector<std::string> failures = this->Exchange(failure);
  if (own)
  {
    std::rethrow_exception(own);
  }
  for (const std::string& other : failures)
  {
    if (!other.empty())
    {
      throw Error(other.substr(1));
    }
  }
}

} // namespace nexrad
