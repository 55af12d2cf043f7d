// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/DecodingBudget.h"

#include <algorithm>

namespace nexrad
{

DecodingBudget::DecodingBudget(std::size_t theMost, std::size_t free)
  : most(theMost)
  , granted(std::min(theMost, free))
{
}

void DecodingBudget::AddStored(std::size_t bytes)
{
  const std::size_t room = most - granted;
  granted += bytes < room / BytesForStored ? bytes * BytesForStored : room;
}

bool DecodingBudget::Spend(std::size_t cost)
{
  const bool fits = cost <= this->Left();
  spent = fits ? spent + cost : granted;
  return fits;
}

std::string DecodingBudget::Explain() const
{
  return "decoding takes more than " + std::to_string(granted) +
         " bytes of memory, the most for a file of this size; the rest is left";
}

} // namespace nexrad
