// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/MovieWriter.h"

#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"
#include "vtkNexradMessages.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;
extern char** environ;

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

// A running ffmpeg that reads raw frames from a pipe. What it complains of goes to a file without a
// name, for the error message.
class FfmpegProcess
{
public:
  explicit FfmpegProcess(std::vector<std::string> arguments)
    : complaints(std::tmpfile())
  {
    int ends[2];
    // Close-on-exec, else ffmpeg would hold the writing end open and wait for itself.
    if (complaints == nullptr || pipe2(ends, O_CLOEXEC) != 0)
    {
      throw Error(std::string("ffmpeg cannot be started: ") + std::strerror(errno));
    }
    const FileDescriptor readEnd(ends[0]);
    input = FileDescriptor(ends[1]);
    const int code = this->Spawn(arguments, readEnd.Number());
    if (code != 0)
    {
      std::fclose(complaints);
      throw Error(
        code == ENOENT
          ? "a movie as .mp4 needs the program ffmpeg, which is not installed; .ogv needs none"
          : std::string("ffmpeg cannot be started: ") + std::strerror(code));
    }
    // A broken pipe shall be an error of write, not the end of this program.
    std::signal(SIGPIPE, SIG_IGN);
  }

  ~FfmpegProcess()
  {
    this->Wait();
    std::fclose(complaints);
  }

  FfmpegProcess(const FfmpegProcess&) = delete;
  FfmpegProcess& operator=(const FfmpegProcess&) = delete;

  bool Write(const unsigned char* bytes, std::size_t size)
  {
    while (size > 0)
    {
      const ssize_t written = write(input.Number(), bytes, size);
      if (written < 0 && errno == EINTR)
      {
        continue;
      }
      if (written <= 0)
      {
        return false;
      }
      bytes += written;
      size -= static_cast<std::size_t>(written);
    }
    return true;
  }

  // Ends the input and waits; true when ffmpeg was content.
  bool Wait()
  {
    input.Close();
    if (process > 0)
    {
      waitpid(process, &status, 0);
      process = -1;
    }
    // When the disk is full, ffmpeg complains and returns 0.
    std::fseek(complaints, 0, SEEK_END);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 && std::ftell(complaints) == 0;
  }

  std::string LastComplaint() const
  {
    std::rewind(complaints);
    std::string last = "no reason given";
    char line[512];
    while (std::fgets(line, sizeof(line), complaints) != nullptr)
    {
      last = line;
    }
    return last.substr(0, last.find_last_not_of("\r\n") + 1);
  }

private:
  int Spawn(std::vector<std::string>& arguments, int readEnd)
  {
    std::vector<char*> pointers;
    for (std::string& argument : arguments)
    {
      pointers.push_back(argument.data());
    }
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, readEnd, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fileno(complaints), STDERR_FILENO);
    const int code =
      posix_spawnp(&process, pointers[0], &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return code;
  }

  std::FILE* complaints;
  FileDescriptor input;
  pid_t process = -1;
  int status = 0;
};

std::vector<std::string> Arguments(
  const std::filesystem::path& path, const int size[2], int framesPerSecond)
{
  return {"ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s",
    std::to_string(size[0]) + "x" + std::to_string(size[1]), "-r", std::to_string(framesPerSecond),
    "-i", "-",
    // The picture's first row is the lowest; H.264 wants even sizes.
    "-vf",
    "vflip,pad=ceil(iw/2)*2:ceil(ih/2)*2,"
    "scale=out_color_matrix=bt709:out_range=pc:flags=accurate_rnd+full_chroma_int,format=yuv420p",
    // Without these, players take small movies for BT.601 and large ones for BT.709. The full
    // range, because Chromium's conversion of the narrow one is up to 12 of 255 off in blue.
    "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range",
    "pc", "-c:v", "libx264", "-crf", "18", "-movflags", "+faststart", path.string()};
}

// H.264 in an .mp4, through the program ffmpeg.
class FfmpegWriter : public MovieWriter
{
public:
  FfmpegWriter(const std::filesystem::path& path, const int size[2], int framesPerSecond)
    : name(path)
    , file(path)
    , process(Arguments(file.TemporaryPath(), size, framesPerSecond))
  {
  }

  void AddFrame(vtkImageData* picture) override
  {
    const auto* bytes = static_cast<const unsigned char*>(picture->GetScalarPointer());
    if (!process.Write(bytes, 3 * static_cast<std::size_t>(picture->GetNumberOfPoints())))
    {
      process.Wait();
      this->Fail();
    }
  }

  void Finish() override
  {
    if (!process.Wait())
    {
      this->Fail();
    }
    file.Commit();
  }

private:
  [[noreturn]] void Fail() const
  {
    throw Error(name.string() + ": cannot be written: ffmpeg: " + process.LastComplaint());
  }

  std::filesystem::path name;
  // The process is destroyed, and has ended, before its unfinished file is removed.
  AtomicFile file;
  FfmpegProcess process;
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
  if (output.extension() == ".mp4")
  {
    return std::make_unique<FfmpegWriter>(output, size.data(), framesPerSecond);
  }
  return std::make_unique<TheoraWriter>(output, framesPerSecond);
}

} // namespace nexrad::scene
