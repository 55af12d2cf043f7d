// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/HugePages.h"

#ifdef __linux__
#include <sys/mman.h>

#include <memory>
#endif

namespace nexrad
{

#ifdef __linux__
void UseHugePages(void* memory, std::size_t size)
{
  constexpr std::size_t hugePage = std::size_t(1) << 21;
  if (std::align(hugePage, hugePage, memory, size))
  {
    // A system that declines gives small pages.
    static_cast<void>(madvise(memory, size / hugePage * hugePage, MADV_HUGEPAGE));
  }
}
#else
void UseHugePages(void*, std::size_t) {}
#endif

} // namespace nexrad
