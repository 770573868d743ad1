#include "tui/options/progress_line.hpp"

#include "tui/options/standard_streams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <ctime>
#include <semaphore.h>

namespace tapfit::tui {

namespace {

// What a signal handler may write to has to be global.
std::atomic<bool> interrupted = false;
std::atomic<int> interrupted_at = 0;  // [ms]
static_assert(std::atomic<int>::is_always_lock_free);
sem_t woken;  // the only one that a handler may post

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
  if (!interrupted) {
    interrupted_at = now;
    interrupted = true;
    sem_post(&woken);
  } else if (now - interrupted_at > same_cause_ms) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

ProgressLine::ProgressLine(bool shown) : shown_(shown) {
  interrupted = false;
  sem_init(&woken, 0, 0);
  watcher_ = std::thread([this] {
    while (sem_wait(&woken) != 0) {
    }
    if (interrupted) stop_.request_stop();
  });
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
  sem_post(&woken);
  watcher_.join();
  sem_destroy(&woken);
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
  if (!shown_) return;
  const double percent = 100.0 * std::clamp(fraction, 0.0, 1.0);
  say(fmt::format("\r\x1b[K{} {:.0f} %", stage, percent));
  drawn_ = true;
}

}  // namespace tapfit::tui
