// Shows on standard error how far long work has come, and stops it on Ctrl-C or
// where the system asks to end.
#pragma once

#include "acquisition/foundation/progress.hpp"

#include <stop_token>
#include <thread>

namespace tapfit::tui {

/// While it lives, the first SIGINT (Ctrl-C), SIGQUIT (Ctrl-\), SIGTERM or
/// SIGHUP asks the work to stop, and one more than half a second later ends the
/// program at once: timeout, say, signals a program and its group. At most one
/// may live at a time.
class ProgressLine {
 public:
  /// @param shown whether to draw the line (standard error is a terminal)
  explicit ProgressLine(bool shown);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// To be passed down; refers to this object.
  [[nodiscard]] Progress progress();

  /// Takes the line off the terminal again.
  void clear();

 private:
  void report(std::string_view stage, double fraction);

  bool shown_;
  bool drawn_ = false;
  std::stop_source stop_;
  std::thread watcher_;  // for a signal, whatever the work is at
};

}  // namespace tapfit::tui
