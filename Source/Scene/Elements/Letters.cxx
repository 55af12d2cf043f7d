// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Elements/Letters.h"

#include <vtkTextProperty.h>

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>
#endif

#include <cstddef>
#include <string>

namespace nexrad::embedded
{
extern const unsigned char letters[];
extern const std::size_t lettersSize;
extern const unsigned char boldLetters[];
extern const std::size_t boldLettersSize;
} // namespace nexrad::embedded

namespace nexrad::scene
{
namespace
{

// VTK reads a face from a file alone. This one lies in memory, and lasts as long as the process.
std::string MakeFile(const unsigned char* bytes, std::size_t size)
{
#if defined(__linux__)
  const int file = memfd_create("letters", MFD_CLOEXEC);
  const std::string path = "/proc/self/fd/" + std::to_string(file);
  if (file >= 0 && write(file, bytes, size) == static_cast<ssize_t>(size) &&
      access(path.c_str(), R_OK) == 0)
  {
    return path;
  }
#else
  static_cast<void>(bytes);
  static_cast<void>(size);
#endif
  return "";
}

const std::string& FileOf(bool bold)
{
  static const std::string usual = MakeFile(embedded::letters, embedded::lettersSize);
  static const std::string strong = MakeFile(embedded::boldLetters, embedded::boldLettersSize);
  return bold ? strong : usual;
}

} // namespace

void SetFace(vtkTextProperty* property, bool bold)
{
  const std::string& file = FileOf(bold);
  if (file.empty())
  {
    property->SetFontFamilyToArial();
    property->SetBold(bold ? 1 : 0);
    return;
  }
  property->SetFontFamily(VTK_FONT_FILE);
  property->SetFontFile(file.c_str());
}

} // namespace nexrad::scene
