// What the poles of each run say of it; see run_poles.hpp.
#include "acquisition/samples/statistics.hpp"
#include "modal/checks/frfs_by_run.hpp"
#include "modal/checks/run_poles.hpp"
#include "modal/checks/run_rate.hpp"
#include "signal/frf_set/set_ups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace tapfit::modal {
namespace {

using acquisition::median;
using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using signal::FrfSet;

// 1.4826 times the median distance from the median: the sd of normal values.
double robust_sd(std::vector<double> values, double middle) {
  for (double& value : values) value = std::abs(value - middle);
  return 1.4826 * median(values);
}

double rms(const VectorXcd& H) {
  return std::sqrt(H.squaredNorm() / static_cast<double>(H.size()));
}

Finding foreign_finding(const acquisition::TestBundle& bundle,
                        const ForeignRun& foreign) {
  return {Severity::Error,
          {{foreign.run}, {}, {}, {}},
          statement(foreign, bundle),
          "the recording is of another structure, or of another state of it",
          fmt::format("name the right file in runs[{}].file of test.json, or "
                      "take the run out",
                      foreign.run)};
}

Finding rate_finding(const acquisition::TestBundle& bundle,
                     std::size_t run,
                     double ratio) {
  return {
      Severity::Error,
      {{run}, {}, {}, {}},
      fmt::format("all frequencies of run {} ({}) are {:.4g} times those of "
                  "the other runs, with the same dampings",
                  run + 1,
                  bundle.runs[run].file.filename().string(),
                  ratio),
      "its file states another sampling rate than it was sampled at",
      fmt::format("write the file anew with {:.4g} times the sampling rate "
                  "that it states, or take runs[{}] out of test.json",
                  1.0 / ratio,
                  run)};
}

/// The common relative change of all frequencies in one run.
struct RunShift {
  std::size_t run = 0;
  double shift = 0.0;
};

// The lines thinned to what tells the scale of frequency.
FrfSet thinned_lines(const FrfSet& set, Index most) {
  const Index step = (set.lines() + most - 1) / most;
  if (step <= 1) return set;
  const Index count = (set.lines() + step - 1) / step;
  const auto every = Eigen::seqN(0, count, step);
  FrfSet thin;
  thin.s = set.s(every);
  for (const signal::Frf& frf : set.frfs) {
    signal::Frf& one = thin.frfs.emplace_back();
    one = frf;
    one.H = VectorXcd(frf.H(every));
    if (frf.variance.size() == frf.H.size()) {
      one.variance = VectorXd(frf.variance(every));
    }
  }
  return thin;
}

// One factor on all poles that leaves least of the run's FRFs.
double best_scale(const FrfSet& run, const VectorXcd& poles) {
  constexpr std::array<double, 9> steps{
      0.0, 0.003, 0.006, 0.01, 0.015, 0.022, 0.032, 0.045, 0.06};
  double best = 1.0;
  double least = std::numeric_limits<double>::infinity();
  for (const double step : steps) {
    for (const double scale : {1.0 + step, 1.0 - step}) {
      double left = 0.0;
      for (const ModalConstants& one :
           modal_constants(run, scale * poles, false)) {
        left += one.left * one.left;
      }
      if (left >= least) continue;
      least = left;
      best = scale;
    }
  }
  return best;
}

// What the FRFs' poles say to the first order; empty where none shows.
std::optional<double> first_order_shift(const FrfSet& part,
                                        const VectorXcd& poles,
                                        const RunPoleLimits& limits) {
  const std::vector<ModalConstants> of = modal_constants(part, poles, true);
  std::vector<double> values;
  for (std::size_t f = 0; f < of.size(); ++f) {
    for (Index k = 0; k < poles.size(); ++k) {
      // A peak that hardly shows says nothing of where it is.
      if (of[f].peak(k) < limits.shown * rms(part.frfs[f].H) ||
          !is_clear(of[f], k)) {
        continue;
      }
      values.push_back(of[f].shift(k));
    }
  }
  if (values.empty()) return {};
  return median(values);
}

// By steps first, as far as several bandwidths, then from where the first order
// leads: a pole that stands for two close ones may lead the steps astray.
std::vector<RunShift> run_shifts(const FrfSet& set,
                                 const FrfsByRun& runs,
                                 const VectorXcd& poles,
                                 const RunPoleLimits& limits) {
  constexpr Index most_lines = 800;
  constexpr int rounds = 3;
  std::vector<RunShift> found;
  for (const auto& [run, frfs] : runs) {
    const FrfSet part = thinned_lines(part_of(set, frfs), most_lines);
    double scale = best_scale(part, poles);
    std::optional<double> shift = 0.0;
    for (int round = 0; round < rounds && shift; ++round) {
      shift = first_order_shift(part, scale * poles, limits);
      scale *= 1.0 + shift.value_or(0.0);
    }
    if (shift) found.push_back({run, scale - 1.0});
  }
  return found;
}

double usual_damping(const VectorXcd& poles) {
  VectorXd ratios(poles.size());
  for (Index k = 0; k < poles.size(); ++k) {
    ratios(k) = -poles(k).real() / std::abs(poles(k));
  }
  return median(ratios);
}

// Slope over the runs' order, as change from the first to the last.
std::optional<Finding> trend_finding(const std::vector<RunShift>& shifts,
                                     double worth,
                                     const RunPoleLimits& limits) {
  const auto n = static_cast<double>(shifts.size());
  const double first = static_cast<double>(shifts.front().run);
  const double length = static_cast<double>(shifts.back().run) - first;
  double tt = 0.0;
  double tx = 0.0;
  double mean = 0.0;
  double middle = 0.0;
  for (const RunShift& s : shifts) {
    mean += s.shift / n;
    middle += (static_cast<double>(s.run) - first) / length / n;
  }
  for (const RunShift& s : shifts) {
    const double t = (static_cast<double>(s.run) - first) / length - middle;
    tt += t * t;
    tx += t * (s.shift - mean);
  }
  const double slope = tx / tt;
  double rest = 0.0;
  for (const RunShift& s : shifts) {
    const double t = (static_cast<double>(s.run) - first) / length - middle;
    rest += std::pow(s.shift - mean - slope * t, 2);
  }
  const double sd = std::sqrt(rest / (n - 2.0) / tt);
  if (std::abs(slope) < worth || std::abs(slope) < limits.significance * sd) {
    return {};
  }
  Subject where;
  for (const RunShift& s : shifts) where.runs.push_back(s.run);
  return Finding{
      Severity::Warning,
      std::move(where),
      fmt::format("the frequencies {} evenly by {:.2g} % from the first run to "
                  "the last",
                  slope < 0.0 ? "fall" : "rise",
                  100.0 * std::abs(slope)),
      "warmth, or a clamp or joint that works loose",
      "let the structure settle and measure again, and hit the first point "
      "again at the end"};
}

/// Each run against poles that the others show.
class OtherRuns {
 public:
  OtherRuns(const FrfSet& set, const VectorXcd& poles, double shown_by)
      : set_(set), runs_(frfs_by_run(set)) {
    const std::vector<ModalConstants> all = modal_constants(set, poles, false);
    std::vector<double> shares;
    for (const auto& [run, frfs] : runs_) {
      poles_[run] = shown_by_others(runs_, run, all, poles, shown_by);
      shares.push_back(left_by(poles_[run], part_of(set, frfs)));
    }
    usual_ = median(shares);
  }

  [[nodiscard]] std::optional<double> rate_ratio_of(std::size_t run) const {
    return rate_ratio(part_of(set_, runs_.at(run)), poles_.at(run), usual_);
  }

 private:
  const FrfSet& set_;
  FrfsByRun runs_;
  std::map<std::size_t, VectorXcd> poles_;
  double usual_ = 0.0;
};

std::vector<Finding> foreign_findings(const acquisition::TestBundle& bundle,
                                      const FrfSet& set,
                                      const ModeSet& modes,
                                      const RunPoleLimits& limits) {
  const std::vector<ForeignRun> found = foreign_runs(set, modes, limits);
  if (found.empty()) return {};
  const OtherRuns others(set, poles_of(modes), limits.shown_by);
  std::vector<Finding> findings;
  for (const ForeignRun& foreign : found) {
    const auto ratio = others.rate_ratio_of(foreign.run);
    findings.push_back(ratio ? rate_finding(bundle, foreign.run, *ratio)
                             : foreign_finding(bundle, foreign));
  }
  return findings;
}

Finding shift_finding(const acquisition::TestBundle& bundle,
                      std::size_t run,
                      double off) {
  return {
      Severity::Warning,
      {{run}, {}, {}, {}},
      fmt::format("the frequencies of run {} ({}) lie {:.2g} % {} those of "
                  "the others",
                  run + 1,
                  bundle.runs[run].file.filename().string(),
                  100.0 * std::abs(off),
                  off < 0.0 ? "below" : "above"),
      "the structure was in another state: a mass left on it, a clamp "
      "tightened, another temperature",
      fmt::format("take runs[{}] out of test.json, or measure it again", run)};
}

std::vector<Finding> shift_findings(const acquisition::TestBundle& bundle,
                                    const FrfSet& set,
                                    const FrfsByRun& runs,
                                    const VectorXcd& poles,
                                    const RunPoleLimits& limits) {
  const std::vector<RunShift> shifts = run_shifts(set, runs, poles, limits);
  if (shifts.size() < limits.fewest_runs) return {};
  const double worth = limits.worth_saying * usual_damping(poles);
  if (auto trend = trend_finding(shifts, worth, limits)) {
    return {std::move(*trend)};
  }
  std::vector<double> values;
  for (const RunShift& s : shifts) values.push_back(s.shift);
  const double middle = median(values);
  const double scatter = robust_sd(values, middle);
  std::vector<Finding> findings;
  std::optional<OtherRuns> others;
  for (const RunShift& s : shifts) {
    const double off = s.shift - middle;
    if (std::abs(off) < worth ||
        std::abs(off) < limits.significance * scatter) {
      continue;
    }
    if (!others) others.emplace(set, poles, limits.shown_by);
    const auto ratio = others->rate_ratio_of(s.run);
    findings.push_back(ratio ? rate_finding(bundle, s.run, *ratio)
                             : shift_finding(bundle, s.run, off));
  }
  return findings;
}

// One pole for each group, its mean.
VectorXcd merged(const VectorXcd& poles) {
  const auto groups = pole_groups(poles);
  VectorXcd means(static_cast<Index>(groups.size()));
  for (std::size_t g = 0; g < groups.size(); ++g) {
    means(static_cast<Index>(g)) = VectorXcd(poles(groups[g])).mean();
  }
  return means;
}

}  // namespace

std::vector<Finding> run_pole_findings(const acquisition::TestBundle& bundle,
                                       const FrfSet& set,
                                       const ModeSet& modes,
                                       const RunPoleLimits& limits) {
  const FrfsByRun runs = frfs_by_run(set);
  const VectorXcd poles = poles_of(modes);
  if (runs.size() < limits.fewest_runs || poles.size() == 0 ||
      bundle.runs.empty()) {
    return {};
  }
  std::vector<Finding> findings = foreign_findings(bundle, set, modes, limits);
  const std::vector<std::size_t> set_up = signal::set_ups(set);
  const bool sensors_stay =
      std::ranges::all_of(set_up, [](std::size_t one) { return one == 0; });
  if (sensors_stay && findings.empty()) {
    append(shift_findings(bundle, set, runs, merged(poles), limits), findings);
  }
  return findings;
}

}  // namespace tapfit::modal
