// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Series/Steps.h"

#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// Which time steps a series that grows has.
struct StepRules
{
  Duration step = std::chrono::minutes(5);  ///< above 0
  std::optional<Time> begin;                ///< in place of the first ray
  std::optional<Time> end;                  ///< no step after it
  Duration late = std::chrono::minutes(30); ///< a step that is older than the newest ray by more
                                            ///< than this changes no more
};

/// The time steps of a series that grows, of which some may still change. They are the multiples of
/// the rules' step between the first and the newest ray, as those of `grid` are.
class StepBook
{
public:
  explicit StepBook(const StepRules& rules);

  /// The first and the last ray of a volume that arrived. Where the newest ray of the series leaps
  /// by more than a day (LongestPause), there are no steps in between; a volume that is older than
  /// that, and than what may come late, is none of the series.
  void Extend(Time first, Time last);

  /// The steps that may have to be made or made again, ascending.
  std::vector<Time> Open() const;
  /// True for an open step that is older than the rules allow to change: it has its last chance.
  bool IsClosing(Time step) const;
  /// True when the volume of a step has to be made. `inputs`: of what it would be made now;
  /// `settled`: these will not change, as far as is known. A step is made at once, and once more
  /// when what it is made of has settled.
  bool IsDue(Time step, const std::string& inputs, bool settled) const;
  /// The volume of a step was made of this.
  void Make(Time step, const std::string& inputs) { made.Make(step, inputs); }
  /// All steps that are closing are done with.
  void Close();
  /// Forgets steps before a time; they are not made again.
  void Drop(Time before);
  /// The volumes of all steps are gone, as of a domain that changed: those that are open are made
  /// anew.
  void Restart() { made = Steps(); }

  /// Steps whose volumes were made, ascending.
  std::vector<Time> Made() const { return made.Made(); }
  /// No step is before it may change.
  std::optional<Time> ClosedUntil() const { return closedUntil; }

  /// All of it as text, for a run that goes on with it.
  std::string Pack() const;
  /// Takes what Pack gave, but for the newest ray: what is about a step has to arrive once more
  /// before it closes. Throws Error when it is none.
  void Unpack(const std::string& text);

private:
  StepRules rules;
  std::optional<Time> first;
  std::optional<Time> newest;
  std::optional<Time> closedUntil; ///< the steps at and before it
  Steps made;
};

} // namespace nexrad
