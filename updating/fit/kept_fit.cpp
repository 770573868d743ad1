#include "updating/fit/kept_fit.hpp"

#include "updating/fit/fit_watch.hpp"

#include <fmt/format.h>

#include <utility>

namespace tapfit::updating {

Fit fit_kept(const std::function<Fit(const Progress&)>& fit,
             int steps,
             const Progress& progress) {
  const FitWatch* outer = fit_watch(progress);
  if (outer == nullptr && steps == 0) return fit(progress);
  FitWatch watch = outer != nullptr ? *outer : FitWatch();
  int taken = 0;
  int stopped = 0;
  watch.step = [&taken, tell = watch.step](const FitMoment& moment) {
    ++taken;
    if (tell) tell(moment);
  };
  watch.enough = [&, asked = watch.enough] {
    const bool enough = (steps > 0 && taken >= steps) || (asked && asked());
    if (enough && stopped == 0) stopped = taken;
    return enough;
  };
  Progress watched = progress;
  watched.watch = std::make_shared<const FitWatch>(std::move(watch));
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
