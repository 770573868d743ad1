// How long work reports where it is and learns that it should stop.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <string_view>

namespace tapfit {

/// Thrown out of long work when its user asked to stop; nothing is lost.
struct Stopped {};

/// Looks on at more of some work than the share that is done; the work says at
/// what, in a type of its own.
struct Observer {
  Observer() = default;
  Observer(const Observer&) = default;
  Observer& operator=(const Observer&) = default;
  virtual ~Observer() = default;
};

/// Passed down into long work. A default-made Progress is silent.
struct Progress {
  /// Called with the name of the stage and the fraction done, 0..1.
  std::function<void(std::string_view stage, double fraction)> report;
  std::stop_token stop;
  std::shared_ptr<const Observer> observer = {};  ///< none: nobody looks on

  /// Reports, then throws Stopped when a stop was requested.
  void operator()(std::string_view stage, double fraction) const {
    if (report) report(stage, fraction);
    if (stop.stop_requested()) throw Stopped{};
  }
};

}  // namespace tapfit
