// How long work reports where it is and learns that it should stop.
#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

namespace tapfit {

/// Thrown out of long work when its user asked to stop; nothing is lost.
struct Stopped {};

/// Passed down into long work. A default-made Progress is silent.
struct Progress {
  /// Called with the name of the stage and the fraction done, 0..1.
  std::function<void(std::string_view stage, double fraction)> report;
  std::stop_token stop;

  /// Reports, then throws Stopped when a stop was requested.
  void operator()(std::string_view stage, double fraction) const {
    if (report) report(stage, fraction);
    if (stop.stop_requested()) throw Stopped{};
  }
};

}  // namespace tapfit
