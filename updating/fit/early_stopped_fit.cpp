#include "updating/fit/early_stopped_fit.hpp"

#include "updating/fit/fit_observer.hpp"

#include <fmt/format.h>

#include <utility>

namespace tapfit::updating {

Fit fit_until_stopped(const std::function<Fit(const Progress&)>& fit,
                      int steps,
                      const Progress& progress) {
  const FitObserver* outer = fit_observer(progress);
  if (outer == nullptr && steps == 0) return fit(progress);
  FitObserver observer = outer != nullptr ? *outer : FitObserver();
  int taken = 0;
  int stopped = 0;
  observer.step = [&taken,
                   tell = observer.step](const IterationSummary& summary) {
    ++taken;
    if (tell) tell(summary);
  };
  observer.enough = [&, asked = observer.enough] {
    const bool enough = (steps > 0 && taken >= steps) || (asked && asked());
    if (enough && stopped == 0) stopped = taken;
    return enough;
  };
  Progress watched = progress;
  watched.observer = std::make_shared<const FitObserver>(std::move(observer));
  Fit result = fit(watched);
  result.stopped_after = stopped;
  if (stopped > 0) {
    // The last stage may have ended by itself, but not where it would have.
    result.result.converged = false;
    result.result.message = stopped_text(stopped);
  }
  return result;
}

std::string stopped_text(int steps) {
  if (steps == 0) return {};
  return fmt::format(
      "stopped early, after {} step{}", steps, steps == 1 ? "" : "s");
}

}  // namespace tapfit::updating
