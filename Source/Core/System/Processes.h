// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace nexrad
{

/// This process among several that do one piece of work together, or one alone.
class Processes
{
public:
  /// Hands `mine` to all processes, and returns what each handed over, in the order of their ranks.
  /// All processes call it.
  using ExchangeFunction = std::function<std::vector<std::string>(const std::string& mine)>;

  /// One process alone.
  Processes() = default;
  /// `rank` of this process, from 0, among `count`.
  Processes(std::size_t rank, std::size_t count, ExchangeFunction exchange);

  std::size_t Rank() const { return rank; }
  std::size_t Count() const { return count; }
  /// True for the process that speaks to the user and writes what there is once.
  bool IsFirst() const { return rank == 0; }

  /// The part [first, second) of `things` things that this process works on: neighbours, and as
  /// many as the others have, or one more.
  std::pair<std::size_t, std::size_t> Part(std::size_t things) const;
  /// The part of the process of another rank.
  std::pair<std::size_t, std::size_t> PartOf(std::size_t things, std::size_t ofRank) const;

  /// What each process hands over, in the order of their ranks. All of them call it.
  std::vector<std::string> Exchange(const std::string& mine) const;

  /// True when it is true in all processes, which all call this.
  bool InAll(bool mine) const;

  /// Throws an Error of this text in all processes, which all call this, unless all hand over the
  /// same.
  void RequireSame(const std::string& mine, const std::string& otherwise) const;

  /// Runs `work`, as all processes do, and returns when all are done. When it throws in one of
  /// them, this throws in all: there what was thrown, elsewhere an Error of the same text.
  void Together(const std::function<void()>& work) const;

private:
  std::size_t rank = 0;
  std::size_t count = 1;
  ExchangeFunction exchange;
};

} // namespace nexrad
