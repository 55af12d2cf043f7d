// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/MachineMemory.h"

#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/mman.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>

namespace fs = std::filesystem;

namespace nexrad
{

namespace
{

std::optional<std::size_t> Less(
  const std::optional<std::size_t>& a, const std::optional<std::size_t>& b)
{
  return a && b ? std::min(*a, *b) : a ? a : b;
}

// A limit as the system writes it: a number, or "max".
std::optional<std::size_t> ReadLimit(const fs::path& path)
{
  std::ifstream file(path);
  std::uint64_t bytes = 0;
  return file >> bytes ? std::optional<std::size_t>(bytes) : std::nullopt;
}

// Of the folder of a group, and of all above it up to the root.
std::optional<std::size_t> LimitAbove(const fs::path& root, const fs::path& group, const char* file)
{
  std::optional<std::size_t> least = ReadLimit(root / file);
  fs::path folder = root;
  for (const fs::path& part : group.relative_path())
  {
    folder /= part;
    least = Less(least, ReadLimit(folder / file));
  }
  return least;
}

std::optional<std::size_t> PhysicalMemory()
{
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long pageBytes = sysconf(_SC_PAGESIZE);
  return pages > 0 && pageBytes > 0
           ? std::optional(static_cast<std::size_t>(pages) * static_cast<std::size_t>(pageBytes))
           : std::nullopt;
}

} // namespace

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

std::optional<std::size_t> ControlGroupMemory(const std::string& membership, const fs::path& root)
{
  std::optional<std::size_t> least;
  std::istringstream lines(membership);
  for (std::string line; std::getline(lines, line);)
  {
    // "4:memory:/group" of version 1, "0::/group" of version 2.
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos)
    {
      continue;
    }
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const fs::path group = line.substr(second + 1);
    if (controllers.empty())
    {
      least = Less(least, LimitAbove(root, group, "memory.max"));
    }
    else if (("," + controllers + ",").find(",memory,") != std::string::npos)
    {
      least = Less(least, LimitAbove(root / "memory", group, "memory.limit_in_bytes"));
    }
  }
  return least;
}

std::optional<std::size_t> MachineMemory()
{
  std::ifstream file("/proc/self/cgroup");
  const std::string membership(std::istreambuf_iterator<char>(file), {});
  return Less(PhysicalMemory(), ControlGroupMemory(membership, "/sys/fs/cgroup"));
}

void ReturnFreedMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

std::string MemoryText(std::size_t bytes)
{
  constexpr double mebibyte = 1024.0 * 1024.0;
  constexpr double gibibyte = 1024.0 * mebibyte;
  const auto size = static_cast<double>(bytes);
  std::array<char, 32> text{};
  if (size < gibibyte)
  {
    std::snprintf(text.data(), text.size(), "%.0f MiB", std::ceil(size / mebibyte));
  }
  else
  {
    std::snprintf(text.data(), text.size(), "%.1f GiB", size / gibibyte);
  }
  return text.data();
}

} // namespace nexrad
