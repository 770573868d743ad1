#include "tui/options/progress_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

namespace tapfit::tui {

namespace {

// The one thing a signal handler may write to has to be global.
volatile std::sig_atomic_t interrupted = 0;

extern "C" void on_interrupt(int /*signal*/) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

ProgressLine::ProgressLine(bool shown) : shown_(shown) {
  interrupted = 0;
  std::signal(SIGINT, on_interrupt);
}

ProgressLine::~ProgressLine() {
  std::signal(SIGINT, SIG_DFL);
  clear();
}

void ProgressLine::clear() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
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
  fmt::print(stderr, "\r\x1b[K{} {:.0f} %", stage, percent);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace tapfit::tui
