#include "modal/checks/run_residues.hpp"

#include "modal/checks/modal_constants.hpp"
#include "modal/checks/run_poles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

using Place = std::pair<std::size_t, Dof>;

// Modal constants as heights of peaks: poles of heavy damping, which stand for
// what lies beside the band, then count for no more than they show.
std::vector<SensorSetUp> set_ups_of(const signal::FrfSet& set,
                                    const std::vector<ModalConstants>& of,
                                    const VectorXcd& poles) {
  const VectorXd heights =
      0.5 * poles.cwiseAbs().cwiseQuotient((-poles.real()).cwiseMax(1e-9));
  std::map<std::size_t, std::map<Place, std::size_t>> by_run;
  for (std::size_t f = 0; f < set.frfs.size(); ++f) {
    const signal::Frf& frf = set.frfs[f];
    by_run[frf.run][{frf.channel, frf.response}] = f;
  }
  std::map<std::vector<Place>, SensorSetUp> set_ups;
  for (const auto& [run, frfs] : by_run) {
    std::vector<Place> places;
    for (const auto& [place, f] : frfs) places.push_back(place);
    SensorSetUp& set_up = set_ups[places];
    set_up.channels.clear();
    const Index modes = of[frfs.begin()->second].z.size();
    MatrixXcd z(static_cast<Index>(frfs.size()), modes);
    MatrixXd sd(z.rows(), modes);
    Index row = 0;
    for (const auto& [place, f] : frfs) {
      set_up.channels.push_back(place.first);
      z.row(row) = of[f].z.cwiseProduct(heights).transpose();
      sd.row(row) = of[f].sd.cwiseProduct(heights).transpose();
      ++row;
    }
    set_up.runs.push_back(run);
    set_up.poles = poles;
    set_up.z.push_back(std::move(z));
    set_up.sd.push_back(std::move(sd));
  }
  std::vector<SensorSetUp> found;
  for (auto& [places, set_up] : set_ups) found.push_back(std::move(set_up));
  return found;
}

std::string name_of(const acquisition::TestBundle& bundle,
                    const SensorSetUp& set_up,
                    std::size_t sensor) {
  return bundle.channels.at(set_up.channels[sensor]).name;
}

// With two sensors what one has too much the other has too little.
std::string against(const acquisition::TestBundle& bundle,
                    const SensorSetUp& set_up,
                    std::size_t sensor) {
  return set_up.channels.size() == 2 ? name_of(bundle, set_up, 1 - sensor)
                                     : std::string("the other sensors");
}

/// Runs that differ from the others by the same.
struct Change {
  std::vector<std::size_t> runs;
  std::vector<SensorPattern> patterns;

  /// What one factor leaves of the modes, see SensorPattern::scatter: the
  /// median.
  [[nodiscard]] double scatter() const {
    std::vector<double> all;
    for (const SensorPattern& p : patterns) all.push_back(p.scatter);
    const auto middle =
        all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::ranges::nth_element(all, middle);
    return *middle;
  }
  [[nodiscard]] bool in_one_mode_only() const {
    return std::ranges::all_of(
        patterns, [](const SensorPattern& p) { return p.modes < 2; });
  }
};

// Runs that differ and are the first or the last of their set-up show one
// change; a single one may as well be odd by itself. Empty for others.
std::string changed_once(const SensorSetUp& set_up,
                         const std::vector<std::size_t>& runs) {
  const std::vector<std::size_t>& all = set_up.runs;
  if (runs.size() < 2 || runs.size() >= all.size()) return {};
  const auto count = static_cast<std::ptrdiff_t>(runs.size());
  std::size_t from = 0;
  if (std::equal(runs.begin(), runs.end(), all.begin())) {
    from = all[runs.size()];
  } else if (std::equal(runs.begin(), runs.end(), all.end() - count)) {
    from = runs.front();
  } else {
    return {};
  }
  return fmt::format("; it changed once, from run {} on", from + 1);
}

Finding gain_finding(const acquisition::TestBundle& bundle,
                     const SensorSetUp& set_up,
                     const Change& change) {
  const SensorPattern& pattern = change.patterns.front();
  const std::string who = name_of(bundle, set_up, pattern.sensor);
  const std::string other = against(bundle, set_up, pattern.sensor);
  const bool two = set_up.channels.size() == 2;
  const std::string either = two ? who + " or " + other : who;
  const double factor = std::abs(pattern.factor);
  const bool turned = pattern.factor.real() < 0.0;
  const bool one_mode = change.in_one_mode_only();
  const std::string once = changed_once(set_up, change.runs);
  std::string cause =
      turned && std::abs(factor - 1.0) < 0.1
          ? either + " was turned over in these runs"
          : fmt::format(
                "the range or amplifier of {} was changed for these runs",
                either);
  // Of two the other may be the one that changed.
  if (!turned && (two || factor < 1.0)) {
    cause +=
        fmt::format(", or {} was coming loose", factor < 1.0 ? who : other);
  }
  // Of one mode any change of a sensor is one factor.
  if (one_mode) {
    cause += fmt::format(
        ", or {} sat at another point or along another "
        "direction in them: one mode does not tell",
        either);
  }
  return {
      Severity::Error,
      {change.runs, who, {}, {}},
      fmt::format("{} against {} is {}{:.3g} times what it is in the other "
                  "runs, in {}{}",
                  who,
                  other,
                  turned ? "minus " : "",
                  factor,
                  one_mode ? "the one mode that tells" : "every mode",
                  once),
      std::move(cause),
      fmt::format("list {} a second time in `channels` with {:.4g} times "
                  "the sensitivity{} and use that channel in these runs, or "
                  "take them out",
                  who,
                  turned ? -factor : factor,
                  two ? fmt::format(" (or {} with {:.4g} times)",
                                    other,
                                    turned ? -1.0 / factor : 1.0 / factor)
                      : std::string())};
}

// Of an integral and a derivative, and of a sensor that is late.
Finding law_finding(const acquisition::TestBundle& bundle,
                    const SensorSetUp& set_up,
                    const Change& change) {
  const SensorPattern& pattern = change.patterns.front();
  const std::string who = name_of(bundle, set_up, pattern.sensor);
  const std::string other = against(bundle, set_up, pattern.sensor);
  const SensorLaw& law = pattern.law;
  const Subject where{change.runs, who, {}, {}};
  if (law.power == 0) {
    const std::string& late = law.delay_s > 0.0 ? who : other;
    return {Severity::Error,
            where,
            fmt::format("{} is {:.3g} ms {} {} in every mode, which it is not "
                        "in the other runs",
                        who,
                        1e3 * std::abs(law.delay_s),
                        law.delay_s > 0.0 ? "behind" : "before",
                        other),
            fmt::format("{} is late: another filter or another recorder's "
                        "clock in these runs",
                        late),
            fmt::format("shift the samples of {0} in these runs, or take {0} "
                        "out of their `sensors`",
                        late)};
  }
  const bool integrated = law.power < 0;
  const std::string& faulty = integrated ? who : other;
  const std::string times = std::abs(law.power) == 1 ? "once" : "twice";
  const std::string quantity =
      std::abs(law.power) == 1 ? "velocity" : "displacement";
  return {
      Severity::Error,
      where,
      fmt::format("{} against {} is {} {} in these runs, mode by mode",
                  who,
                  other,
                  integrated ? "integrated" : "differentiated",
                  times),
      fmt::format("{} measured {} in these runs, or an amplifier "
                  "integrated",
                  faulty,
                  quantity),
      fmt::format("list {0} a second time in `channels` with \"quantity\": "
                  "\"{1}\" and its unit, for these runs, or take {0} out of "
                  "their `sensors`",
                  faulty,
                  quantity)};
}

Finding moved_finding(const acquisition::TestBundle& bundle,
                      const SensorSetUp& set_up,
                      const Change& change) {
  std::string names;
  for (std::size_t c = 0; c < set_up.channels.size(); ++c) {
    names += (c == 0 ? "" : ", ") + name_of(bundle, set_up, c);
  }
  const double most =
      std::ranges::max(change.patterns, {}, &SensorPattern::error).error;
  return {Severity::Error,
          {change.runs, {}, {}, {}},
          fmt::format("what {} show of each mode differs from the other runs "
                      "by {:.2g} %, mode by mode another way{}",
                      names,
                      100.0 * most,
                      changed_once(set_up, change.runs)),
          fmt::format("{} sat at another point or along another direction in "
                      "these runs",
                      set_up.channels.size() == 2
                          ? "one of the two"
                          : std::string("one of the sensors")),
          "correct `sensors` of these runs in test.json, or take them out"};
}

// Of two sensors what one has too much the other has too little: as one on the
// first of them.
SensorPattern on_first(const SensorSetUp& set_up, SensorPattern of) {
  if (set_up.channels.size() != 2 || of.sensor == 0) return of;
  of.sensor = 0;
  of.factor = 1.0 / of.factor;
  of.law.power = -of.law.power;
  of.law.delay_s = -of.law.delay_s;
  return of;
}

bool same_factor(const SensorPattern& a, const SensorPattern& b) {
  const bool as_late =
      a.law.power != 0 ||
      std::abs(a.law.delay_s - b.law.delay_s) <= 0.1 * std::abs(a.law.delay_s);
  return a.sensor == b.sensor && a.law.power == b.law.power && as_late &&
         std::abs(a.factor - b.factor) < 0.1 * std::abs(a.factor);
}

std::vector<Finding> findings_in(const acquisition::TestBundle& bundle,
                                 const SensorSetUp& set_up,
                                 const RunResidueLimits& limits) {
  const std::vector<SensorPattern> of = compare_patterns(set_up, limits);
  VectorXd errors(static_cast<Index>(of.size()));
  std::ranges::transform(of, errors.begin(), &SensorPattern::error);
  const double limit = usual_limit(errors, limits);
  std::vector<Change> by_factor;
  Change moved;
  for (std::size_t r = 0; r < of.size(); ++r) {
    const SensorPattern& p = of[r];
    if (p.error <= std::max(limit, limits.times_noise * p.noise)) continue;
    const bool one_factor =
        p.left < limits.one_factor * p.error || p.left < 0.5 * limits.much;
    Change* change = &moved;
    if (one_factor) {
      const auto same =
          std::ranges::find_if(by_factor, [&](const Change& other) {
            return same_factor(on_first(set_up, other.patterns.front()),
                               on_first(set_up, p));
          });
      change = same != by_factor.end() ? &*same : &by_factor.emplace_back();
    }
    change->runs.push_back(set_up.runs[r]);
    change->patterns.push_back(p);
  }
  std::vector<Finding> findings;
  for (const Change& change : by_factor) {
    if (change.scatter() <= limits.scatter) {
      const bool gain = change.patterns.front().law.is_plain();
      findings.push_back(gain ? gain_finding(bundle, set_up, change)
                              : law_finding(bundle, set_up, change));
      continue;
    }
    std::ranges::copy(change.runs, std::back_inserter(moved.runs));
    std::ranges::copy(change.patterns, std::back_inserter(moved.patterns));
  }
  std::ranges::sort(moved.runs);
  if (!moved.runs.empty()) {
    findings.push_back(moved_finding(bundle, set_up, moved));
  }
  return findings;
}

}  // namespace

std::vector<Finding> run_residue_findings(const acquisition::TestBundle& bundle,
                                          const signal::FrfSet& set,
                                          const ModeSet& modes,
                                          const RunResidueLimits& limits) {
  if (bundle.runs.empty() || modes.modes.empty()) return {};
  const VectorXcd poles = poles_of(modes);
  std::vector<ModalConstants> of = modal_constants(set, poles, false);
  // Close modes share what they explain: their patterns depend on the point
  // that is hit.
  std::vector<Index> alone;
  for (const std::vector<Index>& group : pole_groups(poles)) {
    if (group.size() == 1) alone.push_back(group.front());
  }
  if (alone.empty()) return {};
  for (ModalConstants& one : of) {
    one.z = VectorXcd(one.z(alone));
    one.sd = VectorXd(one.sd(alone));
  }
  std::vector<Finding> findings;
  for (const SensorSetUp& set_up : set_ups_of(set, of, poles(alone))) {
    if (set_up.channels.size() < 2 || set_up.runs.size() < limits.fewest_runs) {
      continue;
    }
    append(findings_in(bundle, set_up, limits), findings);
  }
  return findings;
}

}  // namespace tapfit::modal
