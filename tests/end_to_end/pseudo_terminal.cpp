#include "tests/end_to_end/pseudo_terminal.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <stdexcept>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace tapfit::end_to_end {
namespace {

// Sanitizers make the program about ten times slower, beside other tests twice
// that.
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr int patience = 20;
#else
constexpr int patience = 1;
#endif

winsize size_of(int columns, int rows, const TerminalSetting& setting) {
  winsize size{};
  size.ws_col = static_cast<unsigned short>(columns);
  size.ws_row = static_cast<unsigned short>(rows);
  if (setting.window_tells_pixels) {
    size.ws_xpixel = static_cast<unsigned short>(columns * setting.cell.width);
    size.ws_ypixel = static_cast<unsigned short>(rows * setting.cell.height);
  }
  return size;
}

[[noreturn]] void become_program(const std::vector<std::string>& arguments,
                                 const TerminalSetting& setting) {
  setenv("TERM", setting.kind.c_str(), 1);
  setenv("LC_ALL", "C.UTF-8", 1);
  setenv("TAPFIT_NO_CACHE", "1", 1);
  for (const std::string& variable : setting.environment) {
    const std::size_t at = variable.find('=');
    setenv(variable.substr(0, at).c_str(), variable.c_str() + at + 1, 1);
  }
  std::vector<char*> argv{const_cast<char*>(TAPFIT_PROGRAM)};
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  execv(TAPFIT_PROGRAM, argv.data());
  _exit(127);
}

/// What a shell with job control does: the program runs in the foreground of a
/// session of its own; where it stops, the shell takes the terminal back. (A
/// session's leader itself cannot be stopped from its keyboard.)
[[noreturn]] void be_shell(int line,
                           int told,
                           int orders,
                           const std::vector<std::string>& arguments,
                           const TerminalSetting& setting) {
  setsid();
  ioctl(line, TIOCSCTTY, 0);
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    dup2(line, fd);
  }
  const pid_t program = fork();
  setpgid(program, program);
  if (program == 0) {
    while (tcgetpgrp(line) != getpid()) usleep(1000);
    become_program(arguments, setting);
  }
  tcsetpgrp(line, program);
  signal(SIGTTOU, SIG_IGN);
  signal(SIGHUP, SIG_IGN);
  (void)!write(told, &program, sizeof(program));
  int status = 0;
  while (waitpid(program, &status, WUNTRACED) == program) {
    (void)!write(told, &status, sizeof(status));
    if (!WIFSTOPPED(status)) break;
    tcsetpgrp(line, getpgrp());
    char order = 0;
    if (read(orders, &order, 1) != 1) break;
    tcsetpgrp(line, program);
    kill(-program, SIGCONT);
  }
  _exit(0);
}

}  // namespace

PseudoTerminal::PseudoTerminal(const std::vector<std::string>& arguments,
                               const TerminalSetting& setting)
    : setting_(setting),
      screen_(setting.columns, setting.rows, setting.graphics, setting.cell) {
  end_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (end_ < 0 || grantpt(end_) != 0 || unlockpt(end_) != 0) {
    throw std::runtime_error("no pseudo-terminal is to be had");
  }
  line_ = open(ptsname(end_), O_RDWR | O_NOCTTY | O_CLOEXEC);
  const winsize size = size_of(setting.columns, setting.rows, setting);
  ioctl(end_, TIOCSWINSZ, &size);
  tcgetattr(line_, &before_);
  std::array<int, 2> told{};
  std::array<int, 2> orders{};
  if (pipe2(told.data(), O_CLOEXEC) != 0 ||
      pipe2(orders.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error("no pipe is to be had");
  }
  shell_ = fork();
  if (shell_ == 0) {
    for (const int fd : {end_, told[0], orders[1]}) close(fd);
    be_shell(line_, told[1], orders[0], arguments, setting);
  }
  close(told[1]);
  close(orders[0]);
  told_ = told[0];
  orders_ = orders[1];
  if (read(told_, &program_, sizeof(program_)) != sizeof(program_)) {
    throw std::runtime_error("the program was not started");
  }
}

PseudoTerminal::~PseudoTerminal() {
  if (program_ > 0) kill(program_, SIGKILL);
  for (const int fd : {line_, end_, told_, orders_}) {
    if (fd >= 0) close(fd);
  }
  waitpid(shell_, nullptr, 0);
}

void PseudoTerminal::type(const std::string& bytes) {
  if (write(end_, bytes.data(), bytes.size()) !=
      static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("the terminal takes no keys");
  }
}

void PseudoTerminal::resize(int columns, int rows) {
  const winsize size = size_of(columns, rows, setting_);
  screen_.resize(columns, rows);
  ioctl(end_, TIOCSWINSZ, &size);  // the kernel sends SIGWINCH
}

void PseudoTerminal::send(int signal_number) { kill(program_, signal_number); }

void PseudoTerminal::resume() { (void)!write(orders_, "c", 1); }

void PseudoTerminal::hang_up() {
  close(line_);
  close(end_);
  line_ = end_ = -1;
}

bool PseudoTerminal::take(std::chrono::milliseconds within) {
  pollfd wait{end_, POLLIN, 0};
  if (poll(&wait, 1, static_cast<int>(within.count())) <= 0) return false;
  std::array<char, 65536> buffer{};
  const ssize_t n = read(end_, buffer.data(), buffer.size());
  if (n <= 0) return false;
  const std::string_view bytes(buffer.data(), static_cast<std::size_t>(n));
  read_ += bytes;
  screen_.take(bytes);
  const std::string answers = screen_.take_answers();
  if (setting_.answers && !answers.empty()) type(answers);
  return true;
}

template <class Done>
bool PseudoTerminal::read_until(const Done& done,
                                std::chrono::milliseconds within) {
  const Clock::time_point last = Clock::now() + patience * within;
  while (!done()) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        last - Clock::now());
    if (left.count() <= 0) return false;
    take(left);
  }
  return true;
}

bool PseudoTerminal::shows(const std::string& text,
                           std::chrono::milliseconds within) {
  return read_until([&] { return screen_.shows(text); }, within);
}

bool PseudoTerminal::wrote(const std::string& bytes,
                           std::chrono::milliseconds within) {
  return wrote_since(0, bytes, within);
}

bool PseudoTerminal::wrote_since(std::size_t first,
                                 const std::string& bytes,
                                 std::chrono::milliseconds within) {
  return read_until(
      [&] { return read_.find(bytes, first) != std::string::npos; }, within);
}

bool PseudoTerminal::draws(int pixels, std::chrono::milliseconds within) {
  return read_until([&] { return screen_.pictures().drawn_pixels() >= pixels; },
                    within);
}

bool PseudoTerminal::draws_at_most(int pixels,
                                   std::chrono::milliseconds within) {
  return read_until([&] { return screen_.pictures().drawn_pixels() <= pixels; },
                    within);
}

std::optional<int> PseudoTerminal::change(std::chrono::milliseconds within) {
  const Clock::time_point last = Clock::now() + patience * within;
  pollfd news{told_, POLLIN, 0};
  while (poll(&news, 1, end_ < 0 ? 5 : 0) <= 0) {
    if (Clock::now() > last) return std::nullopt;
    if (end_ >= 0) take(std::chrono::milliseconds(5));
  }
  int status = 0;
  if (read(told_, &status, sizeof(status)) != sizeof(status)) {
    return std::nullopt;
  }
  return status;
}

bool PseudoTerminal::stops(std::chrono::milliseconds within) {
  const std::optional<int> status = change(within);
  return status && WIFSTOPPED(*status);
}

std::optional<int> PseudoTerminal::ends(std::chrono::milliseconds within) {
  const std::optional<int> status = change(within);
  if (status) program_ = -1;
  if (end_ >= 0) take(std::chrono::milliseconds(0));
  return status;
}

termios PseudoTerminal::modes() const {
  termios now{};
  tcgetattr(line_, &now);
  return now;
}

bool same_modes(const termios& a, const termios& b) {
  return a.c_iflag == b.c_iflag && a.c_oflag == b.c_oflag &&
         a.c_lflag == b.c_lflag;
}

}  // namespace tapfit::end_to_end
