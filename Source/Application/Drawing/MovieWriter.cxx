// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/MovieWriter.h"

#include "Drawing/FfmpegWriter.h"
#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"
#include "vtkNexradMessages.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <string>

namespace fs = std::filesystem;

namespace nexrad::scene
{
namespace
{

// True when the file ends with a whole Ogg page that is marked as the stream's last (RFC 3533,
// section 6). VTK's writer does not look whether its bytes arrived, as on a full disk they do not.
bool IsCompleteOgg(const std::filesystem::path& path)
{
  constexpr std::streamoff longestPage = 27 + 255 + 255 * 255;
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream.tellg();
  stream.seekg(std::max<std::streamoff>(0, size - longestPage));
  const std::string tail{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const std::size_t page = tail.rfind("OggS");
  if (page == std::string::npos || page + 27 > tail.size())
  {
    return false;
  }
  const auto byte = [&](std::size_t offset)
  { return static_cast<unsigned char>(tail[page + offset]); };
  const std::size_t segments = byte(26);
  std::size_t length = 27 + segments;
  for (std::size_t i = 0; i < segments && page + 27 + i < tail.size(); ++i)
  {
    length += byte(27 + i);
  }
  constexpr unsigned lastPage = 0x04;
  return (byte(5) & lastPage) != 0 && page + length == tail.size();
}

class TheoraWriter : public MovieWriter
{
public:
  TheoraWriter(const std::filesystem::path& path, int framesPerSecond)
    : name(path)
    , file(path)
  {
    messages.Watch(writer);
    writer->SetFileName(file.TemporaryPath().c_str());
    writer->SetRate(framesPerSecond);
    writer->SetQuality(2);
  }

  ~TheoraWriter() override
  {
    if (started)
    {
      writer->End();
    }
  }

  void AddFrame(vtkImageData* picture) override
  {
    writer->SetInputData(picture);
    if (!started)
    {
      writer->Start();
      started = true;
    }
    writer->Write();
    this->CheckMessages();
  }

  void Finish() override
  {
    writer->End();
    started = false;
    this->CheckMessages();
    if (!IsCompleteOgg(file.TemporaryPath()))
    {
      throw Error(name.string() + ": cannot be written: the movie is cut off (disk full?)");
    }
    file.Commit();
  }

private:
  void CheckMessages() const
  {
    if (!messages.Errors().empty())
    {
      throw Error(name.string() + ": cannot be written: " + messages.Errors().front());
    }
  }

  std::filesystem::path name;
  AtomicFile file;
  vtkNew<vtkOggTheoraWriter> writer;
  vtkNexradMessages messages;
  bool started = false;
};

} // namespace

fs::path PictureName(const fs::path& output, Time time, bool several)
{
  if (!several)
  {
    return output;
  }
  return output.parent_path() /
         (output.stem().string() + "-" + FormatForFileName(time) + output.extension().string());
}

std::unique_ptr<MovieWriter> MakeMovieWriter(
  const fs::path& output, const std::array<int, 2>& size, int framesPerSecond)
{
  return output.extension() == ".mp4" ? MakeFfmpegWriter(output, size.data(), framesPerSecond)
                                      : std::make_unique<TheoraWriter>(output, framesPerSecond);
}

} // namespace nexrad::scene
