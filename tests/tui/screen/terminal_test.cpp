// The terminal's own program, in a child that has one.
#include "tui/screen/terminal.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/readers/mapped_file.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <pty.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace tapfit::tui {
namespace {

constexpr int refused = 3;

// The status as of waitpid() of what runs in a terminal.
int status_in_terminal(const std::function<int()>& work) {
  int end = -1;
  winsize size{24, 80, 0, 0};
  const pid_t child = ::forkpty(&end, nullptr, nullptr, &size);
  if (child == 0) {
    ::setenv("TERM", "xterm-256color", 1);
    ::_exit(work());
  }
  std::array<char, 4096> drawn{};
  while (::read(end, drawn.data(), drawn.size()) > 0) {
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(end);
  return status;
}

// A copy that begins anew while it is read: the bundle is opened before there
// are screens, and read while there are.
TEST(TerminalTest, AFileThatBecomesShorterIsRefusedOnItsScreens) {
  const tapfit::testing::TemporaryFolder folder;
  const std::string all(100'000, 'a');
  const std::filesystem::path path = folder.write("a.uff", all);
  const int status = status_in_terminal([&] {
    const acquisition::MappedFile file(path);
    const Terminal terminal(TerminalOptions{});
    std::filesystem::resize_file(path, 0);
    try {
      const auto count = file.reading([&file] {
        return std::count(file.text().begin(), file.text().end(), 'a');
      });
      return count == 0 ? 0 : 1;
    } catch (const InputError&) {
      return refused;
    }
  });
  ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), refused);
}

}  // namespace
}  // namespace tapfit::tui
