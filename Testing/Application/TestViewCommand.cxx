// SPDX-License-Identifier: BSD-3-Clause
// The program's window, driven by key events through the X server.
#include "ProgramRun.h"
#include "StormVolume.h"
#include "TestData.h"

#include <gtest/gtest.h>

#include <X11/Xlib.h>
#include <X11/keysym.h>
#include <poll.h>

#include <future>
#include <optional>
#include <string>
#include <vector>

using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

// The windows of an X server, as one who sits before it has them.
class Desktop
{
public:
  Desktop()
    : display(XOpenDisplay(nullptr))
  {
    // A window that goes away while the others are looked through is no reason to end the test.
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
  }
  ~Desktop() { XCloseDisplay(display); }
  Desktop(const Desktop&) = delete;
  Desktop& operator=(const Desktop&) = delete;

  // The window of that title, as soon as it is on the screen; nothing when the server tells of no
  // change for a time.
  std::optional<Window> WaitFor(const std::string& name) const
  {
    auto window = this->Find(DefaultRootWindow(display), name);
    while (!window && this->WaitForChange())
    {
      window = this->Find(DefaultRootWindow(display), name);
    }
    return window;
  }

  void Press(Window window, KeySym key) const
  {
    XKeyEvent event{};
    event.display = display;
    event.window = window;
    event.root = DefaultRootWindow(display);
    event.time = CurrentTime;
    event.same_screen = True;
    event.keycode = XKeysymToKeycode(display, key);
    event.type = KeyPress;
    XSendEvent(display, window, True, KeyPressMask, reinterpret_cast<XEvent*>(&event));
    event.type = KeyRelease;
    XSendEvent(display, window, True, KeyReleaseMask, reinterpret_cast<XEvent*>(&event));
    XSync(display, False);
  }

private:
  // Waits for events, and takes all that there are.
  bool WaitForChange() const
  {
    constexpr int milliseconds = 40'000;
    pollfd connection = {ConnectionNumber(display), POLLIN, 0};
    if (XPending(display) == 0 && poll(&connection, 1, milliseconds) <= 0)
    {
      return false;
    }
    while (XPending(display) > 0)
    {
      XEvent event;
      XNextEvent(display, &event);
    }
    return true;
  }

  std::optional<Window> Find(Window parent, const std::string& name) const
  {
    // Asked for first, so that nothing changes unheard of after the window was looked at.
    XSelectInput(display, parent, SubstructureNotifyMask | PropertyChangeMask);
    char* own = nullptr;
    XWindowAttributes attributes{};
    const bool named = XFetchName(display, parent, &own) != 0 && own != nullptr && name == own;
    XFree(own);
    if (named && XGetWindowAttributes(display, parent, &attributes) != 0 &&
        attributes.map_state == IsViewable)
    {
      return parent;
    }
    Window root = 0;
    Window above = 0;
    Window* children = nullptr;
    unsigned int count = 0;
    std::optional<Window> found;
    if (XQueryTree(display, parent, &root, &above, &children, &count) != 0)
    {
      for (unsigned int i = 0; i < count && !found; ++i)
      {
        found = this->Find(children[i], name);
      }
      XFree(children);
    }
    return found;
  }

  Display* display;
};

} // namespace

TEST(ViewCommand, KeysThroughTheXServerChangeItsScreenshots)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 6);
  const fs::path pictures = folder.Path() / "pictures";
  fs::create_directory(pictures);
  // Whatever happens, the window is gone after a minute. It is known by its first time, which no
  // window of another test on this screen has.
  auto program = std::async(std::launch::async,
    [&]
    {
      return RunProgram(
        "/usr/bin/timeout", {"60", Nexrad3dPath(), "view", "--plain", series, "--size", "480x300",
                              "--pictures", pictures, "--begin", "2006-03-12T18:45"});
    });
  const Desktop desktop;
  const auto window = desktop.WaitFor("nexrad3d 2006-03-12T18:45:00.000Z");
  ASSERT_TRUE(window) << "no window: " << program.get().errors;
  const std::vector<KeySym> keys = {XK_s, XK_Right, XK_s, XK_a, XK_s, XK_2, XK_s, XK_q};
  for (const KeySym key : keys)
  {
    desktop.Press(*window, key);
  }
  const ProgramRun run = program.get();
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  const std::vector<std::string> names = {"nexrad3d-20060312T184500Z.png",
    "nexrad3d-20060312T185000Z.png", "nexrad3d-20060312T185000Z-2.png",
    "nexrad3d-20060312T185000Z-3.png"};
  std::vector<std::string> contents;
  for (const std::string& name : names)
  {
    EXPECT_NE(run.output.find(name), std::string::npos) << name;
    const std::string content = FileContent(pictures / name);
    EXPECT_FALSE(content.empty()) << name;
    for (const std::string& other : contents)
    {
      EXPECT_NE(content, other) << name << " is like an earlier one";
    }
    contents.push_back(content);
  }
}

TEST(ViewCommand, WrongUsageIsOneLine)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 1);
  const auto errors = [&](const std::vector<std::string>& more)
  {
    std::vector<std::string> arguments = {"view", series};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 2);
    return run.errors;
  };
  EXPECT_NE(errors({"--interval", "0.001s"}).find("no interval"), std::string::npos);
  EXPECT_NE(errors({"--preset", "rainbow"}).find("storm cores"), std::string::npos);
  EXPECT_NE(errors({"--pictures", "/nonexistent"}).find("--pictures"), std::string::npos);
}
