// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

#include <map>
#include <string>
#include <vector>

namespace nexrad
{

/// Time steps, and of what the volume of each was made, as text (MadeOf). This one rule tells what
/// must be made by a run that learnt more of its files, by one that continues another, and by one
/// that follows a feed: a step is due when its text now differs from the text then.
class Steps
{
public:
  bool Has(Time step) const { return made.count(step) > 0; }
  /// True for a step that was not made, or not of this.
  bool IsDue(Time step, const std::string& of) const;
  /// The volume of a step was made of this.
  void Make(Time step, const std::string& of);
  /// Forgets of what the steps up to a time were made: they are never compared again.
  void Close(Time until);
  /// Forgets steps before a time.
  void Drop(Time before);
  /// Steps that were made, ascending.
  std::vector<Time> Made() const;

  /// All of it as one line of text, a JSON array.
  std::string Pack() const;
  /// Adds what Pack gave, in place of what there is of the same steps. Throws Error, and changes
  /// nothing, when it is none.
  void Unpack(const std::string& text);

private:
  std::map<Time, std::string> made; ///< the texts as JSON, which holds names of any bytes
};

} // namespace nexrad
