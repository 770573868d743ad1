#include "tui/options/progress_line.hpp"

#include "tui/options/standard_streams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <ctime>

namespace tapfit::tui {

namespace {

// What a signal handler may write to has to be global.
volatile std::sig_atomic_t interrupted = 0;
volatile std::sig_atomic_t interrupted_at = 0;  // [ms]

// What ends a program from outside often tells it and its group: a second
// signal within this time is the first again.
constexpr int same_cause_ms = 500;

int clock_ms() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  constexpr int wrap = 1'000'000;  // seconds whose milliseconds an int holds
  return static_cast<int>(now.tv_sec % wrap) * 1000 +
         static_cast<int>(now.tv_nsec / 1'000'000);
}

constexpr std::array<int, 4> asking{SIGINT, SIGTERM, SIGHUP, SIGQUIT};

extern "C" void on_interrupt(int signal) {
  const int now = clock_ms();
  if (interrupted == 0) {
    interrupted_at = now;
    interrupted = 1;
  } else if (now - interrupted_at > same_cause_ms) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

ProgressLine::ProgressLine(bool shown) : shown_(shown) {
  interrupted = 0;
  for (const int signal : asking) {
    // As nohup and shells in the background have set it, it stays.
    if (std::signal(signal, on_interrupt) == SIG_IGN) {
      std::signal(signal, SIG_IGN);
    }
  }
}

ProgressLine::~ProgressLine() {
  for (const int signal : asking) {
    if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  clear();
}

void ProgressLine::clear() {
  if (drawn_) say("\r\x1b[K");
  drawn_ = false;
}

Progress ProgressLine::progress() {
  return {.report = [this](std::string_view stage,
                           double fraction) { report(stage, fraction); },
          .stop = stop_.get_token()};
}

void ProgressLine::report(std::string_view stage, double fraction) {
  if (interrupted != 0) stop_.request_stop();
  if (!shown_) return;
  const double percent = 100.0 * std::clamp(fraction, 0.0, 1.0);
  say(fmt::format("\r\x1b[K{} {:.0f} %", stage, percent));
  drawn_ = true;
}

}  // namespace tapfit::tui
