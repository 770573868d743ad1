#include "updating/comparison/criteria.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

using acquisition::Limits;

/// What is no number keeps no limit.
bool within(const Criterion& one, double value, double limit) {
  return one.at_least ? value >= limit : value <= limit;
}

double cross(const Comparison& c, int measured, int model) {
  return std::sqrt(std::max(c.weighted_mac(measured, model), 0.0));
}

bool has_cross(const Comparison& c, const ModePair& pair) {
  return pair.has_shape && pair.measured < c.weighted_mac.rows() &&
         pair.model < c.weighted_mac.cols();
}

Criteria of_pair(const Comparison& c, const ModePair& pair) {
  Criteria found;
  found.paired = true;
  found.frequency_percent = std::abs(pair.error_percent);
  if (!pair.has_shape) return found;
  found.mac = pair.mac;
  if (!has_cross(c, pair)) return found;
  found.on_diagonal = cross(c, pair.measured, pair.model);
  for (const ModePair& other : c.pairs) {
    if (other.model == pair.model || !has_cross(c, other)) continue;
    found.off_diagonal = std::max(found.off_diagonal.value_or(0.0),
                                  cross(c, pair.measured, other.model));
  }
  return found;
}

}  // namespace

std::optional<bool> keeps_one(const Criterion& one,
                              const Criteria& mode,
                              const Limits& limits) {
  const std::optional<double>& limit = limits.*one.limit;
  const std::optional<double>& value = mode.*one.found;
  if (!limit || !value) return std::nullopt;
  return within(one, *value, *limit);
}

std::vector<Criteria> criteria_of(const Comparison& comparison,
                                  std::size_t measured_modes) {
  std::vector<Criteria> found(measured_modes);
  for (const ModePair& pair : comparison.pairs) {
    const auto mode = static_cast<std::size_t>(pair.measured);
    if (mode < measured_modes) found[mode] = of_pair(comparison, pair);
  }
  return found;
}

Criteria worst_of(const std::vector<Criteria>& modes) {
  Criteria worst;
  worst.paired =
      !modes.empty() && std::ranges::all_of(modes, &Criteria::paired);
  for (const Criteria& mode : modes) {
    for (const Criterion& one : criteria) {
      const std::optional<double>& value = mode.*one.found;
      std::optional<double>& so_far = worst.*one.found;
      if (!value) continue;
      // What is no number is the worst and stays it.
      const bool lost = so_far && std::isnan(*so_far);
      if (!lost && !(so_far && within(one, *value, *so_far))) so_far = value;
    }
  }
  return worst;
}

bool any_limit(const Limits& limits) {
  return std::ranges::any_of(criteria, [&limits](const Criterion& one) {
    return (limits.*one.limit).has_value();
  });
}

std::optional<bool> keeps(const Criteria& mode, const Limits& limits) {
  if (!any_limit(limits)) return std::nullopt;
  if (!mode.paired) return false;
  std::optional<bool> kept = true;
  for (const Criterion& one : criteria) {
    if (!(limits.*one.limit)) continue;
    const std::optional<bool> this_one = keeps_one(one, mode, limits);
    if (this_one == false) return false;
    if (!this_one) kept.reset();
  }
  return kept;
}

std::optional<bool> Tally::verdict() const {
  if (failed == 0 && (modes == 0 || kept < modes)) return std::nullopt;
  return failed == 0;
}

Tally tally(const std::vector<Criteria>& modes, const Limits& limits) {
  Tally found{.modes = modes.size()};
  for (const Criteria& mode : modes) {
    const std::optional<bool> kept = keeps(mode, limits);
    found.kept += kept == true ? 1 : 0;
    found.failed += kept == false ? 1 : 0;
  }
  return found;
}

}  // namespace tapfit::updating
