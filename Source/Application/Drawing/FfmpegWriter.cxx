// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/FfmpegWriter.h"

#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"

#include <vtkImageData.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

extern char** environ;

namespace nexrad::scene
{
namespace
{

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
    const int code = this->Spawn(arguments, ends[0]);
    close(ends[0]);
    input = ends[1];
    if (code != 0)
    {
      process = -1;
      this->Release();
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
    this->Release();
  }

  FfmpegProcess(const FfmpegProcess&) = delete;
  FfmpegProcess& operator=(const FfmpegProcess&) = delete;

  bool Write(const unsigned char* bytes, std::size_t size)
  {
    while (size > 0)
    {
      const ssize_t written = write(input, bytes, size);
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
    if (input >= 0)
    {
      close(input);
      input = -1;
    }
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

  void Release()
  {
    if (input >= 0)
    {
      close(input);
      input = -1;
    }
    std::fclose(complaints);
  }

  std::FILE* complaints;
  int input = -1;
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

std::unique_ptr<MovieWriter> MakeFfmpegWriter(
  const std::filesystem::path& path, const int size[2], int framesPerSecond)
{
  return std::make_unique<FfmpegWriter>(path, size, framesPerSecond);
}

} // namespace nexrad::scene
