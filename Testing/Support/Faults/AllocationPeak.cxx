// SPDX-License-Identifier: BSD-3-Clause
#include "Faults/AllocationPeak.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace
{

std::atomic<std::size_t> allocated{0};
std::atomic<std::size_t> most{0};

// nullptr where there is no memory.
void* TryToAllocate(std::size_t size)
{
  void* const place = std::malloc(size > 0 ? size : 1);
  if (place == nullptr)
  {
    return nullptr;
  }
  const std::size_t bytes = malloc_usable_size(place);
  const std::size_t now = allocated.fetch_add(bytes) + bytes;
  std::size_t before = most.load();
  while (now > before && !most.compare_exchange_weak(before, now))
  {
  }
  return place;
}

void* Allocate(std::size_t size)
{
  void* const place = TryToAllocate(size);
  if (place == nullptr)
  {
    throw std::bad_alloc();
  }
  return place;
}

void Release(void* place)
{
  if (place != nullptr)
  {
    allocated.fetch_sub(malloc_usable_size(place));
    std::free(place);
  }
}

} // namespace

void* operator new(std::size_t size)
{
  return Allocate(size);
}

void* operator new[](std::size_t size)
{
  return Allocate(size);
}

// std::stable_sort takes its room by these; the sanitisers have some of their own.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return TryToAllocate(size);
}

void* operator new[](std::size_t size, const std::nothrow_t&) noexcept
{
  return TryToAllocate(size);
}

void operator delete(void* place) noexcept
{
  Release(place);
}

void operator delete[](void* place) noexcept
{
  Release(place);
}

void operator delete(void* place, std::size_t) noexcept
{
  Release(place);
}

void operator delete[](void* place, std::size_t) noexcept
{
  Release(place);
}

namespace nexrad::testing
{

AllocationPeak::AllocationPeak()
  : start(allocated.load())
{
  most = start;
}

std::size_t AllocationPeak::Bytes() const
{
  return most.load() - start;
}

} // namespace nexrad::testing
