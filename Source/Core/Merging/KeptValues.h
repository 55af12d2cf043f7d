// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <mutex>
#include <optional>

namespace nexrad
{

/// Values that are kept up to a limit of memory for the times that may ask for them again. A value
/// is cheap to copy, as a pointer is; those in use by a caller live on beside the limit. Safe to
/// call from several threads.
template <class Key, class Value>
class KeptValues
{
public:
  /// `limit` in bytes; 0 keeps nothing.
  explicit KeptValues(std::size_t theLimit)
    : limit(theLimit)
  {
  }

  /// Keeps a value when there is room for it without dropping another: during a scan the earliest
  /// volumes stay, which are those that a run through the day asks for first.
  void Offer(const Key& key, const Value& value, std::size_t bytes)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (used + bytes <= limit)
    {
      this->Add(key, value, bytes);
    }
  }

  /// Keeps a value; those that were not asked for longest make room for it. One that is larger than
  /// the limit is not kept.
  void Keep(const Key& key, const Value& value, std::size_t bytes)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (bytes <= limit)
    {
      this->Add(key, value, bytes);
    }
  }

  /// Empty when it is not kept.
  std::optional<Value> Find(const Key& key)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    const auto entry = this->Place(key);
    if (entry == entries.end())
    {
      return std::nullopt;
    }
    entries.splice(entries.begin(), entries, entry);
    return entry->value;
  }

  void Clear()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    entries.clear();
    used = 0;
  }

  /// Bytes that the values take, at most the limit.
  std::size_t Used() const
  {
    const std::lock_guard<std::mutex> lock(mutex);
    return used;
  }

private:
  struct Entry
  {
    Key key;
    Value value;
    std::size_t bytes;
  };

  auto Place(const Key& key)
  {
    return std::find_if(
      entries.begin(), entries.end(), [&key](const Entry& each) { return each.key == key; });
  }

  void Add(const Key& key, const Value& value, std::size_t bytes)
  {
    if (this->Place(key) != entries.end())
    {
      return;
    }
    while (used + bytes > limit)
    {
      used -= entries.back().bytes;
      entries.pop_back();
    }
    entries.push_front({key, value, bytes});
    used += bytes;
  }

  const std::size_t limit;
  mutable std::mutex mutex;
  std::list<Entry> entries; // the one asked for last stands first
  std::size_t used = 0;
};

} // namespace nexrad
