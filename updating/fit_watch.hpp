// Looking on while a fit runs. A FitWatch put into Progress::report is told of
// every step besides, and may have the fit end with what it has reached: all
// else that takes a Progress need not know of it.
#pragma once

#include "acquisition/progress.hpp"
#include "updating/update_history.hpp"

#include <functional>
#include <string_view>

namespace tapfit::updating {

struct FitWatch {
  std::function<void(std::string_view stage, double fraction)> report;
  std::function<void(const UpdateStep& step)> step;
  std::function<bool()> enough;  ///< true: end now, keep what is reached

  void operator()(std::string_view stage, double fraction) const {
    if (report) report(stage, fraction);
  }
};

/// Tells a watch, if there is one, of a step that was taken.
inline void tell(const Progress& progress, const UpdateStep& step) {
  const auto* watch = progress.report.target<FitWatch>();
  if (watch != nullptr && watch->step) watch->step(step);
}

/// Whether a watch has seen enough.
[[nodiscard]] inline bool is_enough(const Progress& progress) {
  const auto* watch = progress.report.target<FitWatch>();
  return watch != nullptr && watch->enough && watch->enough();
}

}  // namespace tapfit::updating
