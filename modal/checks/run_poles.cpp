#include "modal/checks/run_poles.hpp"

#include "acquisition/samples/statistics.hpp"
#include "modal/checks/modal_constants.hpp"
#include "signal/frf_set/set_ups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace tapfit::modal {
namespace {

using acquisition::median;
using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using signal::FrfSet;

// Standard deviations of a modal constant that shows.
constexpr double clearly_seen = 10.0;

/// Indices into FrfSet::frfs by the run that they stand for.
using Runs = std::map<std::size_t, std::vector<std::size_t>>;

Runs runs_of(const FrfSet& set) {
  Runs runs;
  for (std::size_t f = 0; f < set.frfs.size(); ++f) {
    runs[set.frfs[f].run].push_back(f);
  }
  return runs;
}

// 1.4826 times the median distance from the median: the sd of normal values.
double robust_sd(std::vector<double> values, double middle) {
  for (double& value : values) value = std::abs(value - middle);
  return 1.4826 * median(values);
}

double rms(const VectorXcd& H) {
  return std::sqrt(H.squaredNorm() / static_cast<double>(H.size()));
}

// Poles that the runs other than `run` show.
VectorXcd shown_by_others(const Runs& runs,
                          std::size_t run,
                          const std::vector<ModalConstants>& all,
                          const VectorXcd& poles,
                          const RunPoleLimits& limits) {
  const double least =
      std::max(2.0, limits.shown_by * static_cast<double>(runs.size() - 1));
  std::vector<std::complex<double>> kept;
  for (Index k = 0; k < poles.size(); ++k) {
    int showing = 0;
    for (const auto& [other, frfs] : runs) {
      if (other == run) continue;
      showing += std::ranges::any_of(frfs, [&](std::size_t f) {
        return std::abs(all[f].z(k)) > clearly_seen * all[f].sd(k);
      });
    }
    if (showing >= least) kept.push_back(poles(k));
  }
  return VectorXcd::Map(kept.data(), static_cast<Index>(kept.size()));
}

double left_in(const std::vector<std::size_t>& frfs,
               const std::vector<ModalConstants>& of) {
  double sum = 0.0;
  for (std::size_t i = 0; i < frfs.size(); ++i) sum += std::pow(of[i].left, 2);
  return std::sqrt(sum / static_cast<double>(frfs.size()));
}

FrfSet part_of(const FrfSet& set, const std::vector<std::size_t>& frfs) {
  FrfSet part;
  part.s = set.s;
  for (const std::size_t f : frfs) part.frfs.push_back(set.frfs[f]);
  return part;
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
          std::abs(of[f].z(k)) < clearly_seen * of[f].sd(k)) {
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
                                 const Runs& runs,
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

std::vector<Finding> shift_findings(const acquisition::TestBundle& bundle,
                                    const FrfSet& set,
                                    const Runs& runs,
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
  for (const RunShift& s : shifts) {
    const double off = s.shift - middle;
    if (std::abs(off) < worth ||
        std::abs(off) < limits.significance * scatter) {
      continue;
    }
    findings.push_back(
        {Severity::Warning,
         {{s.run}, {}, {}, {}},
         fmt::format("the frequencies of run {} ({}) lie {:.2g} % {} those of "
                     "the others",
                     s.run + 1,
                     bundle.runs[s.run].file.filename().string(),
                     100.0 * std::abs(off),
                     off < 0.0 ? "below" : "above"),
         "the structure was in another state: a mass left on it, a clamp "
         "tightened, another temperature",
         fmt::format("take runs[{}] out of test.json, or measure it again",
                     s.run)});
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

std::vector<std::vector<Index>> pole_groups(const VectorXcd& poles) {
  std::vector<Index> order(static_cast<std::size_t>(poles.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](Index k) { return poles(k).imag(); });
  std::vector<std::vector<Index>> groups;
  for (const Index k : order) {
    const bool near = !groups.empty() &&
                      poles(k).imag() - poles(groups.back().back()).imag() <
                          -poles(k).real() - poles(groups.back().back()).real();
    if (!near) groups.emplace_back();
    groups.back().push_back(k);
  }
  return groups;
}

VectorXcd poles_of(const ModeSet& modes) {
  VectorXcd poles(static_cast<Index>(modes.modes.size()));
  for (Index k = 0; k < poles.size(); ++k) {
    const std::complex<double> p =
        modes.modes[static_cast<std::size_t>(k)].pole;
    poles(k) = {p.real(), std::abs(p.imag())};
  }
  return poles;
}

std::vector<ForeignRun> foreign_runs(const FrfSet& set,
                                     const ModeSet& modes,
                                     const RunPoleLimits& limits) {
  const Runs runs = runs_of(set);
  const VectorXcd poles = poles_of(modes);
  if (runs.size() < limits.fewest_runs || poles.size() == 0) return {};
  const std::vector<ModalConstants> all = modal_constants(set, poles, false);
  std::vector<ForeignRun> each;
  std::vector<double> shares;
  for (const auto& [run, frfs] : runs) {
    const VectorXcd others = shown_by_others(runs, run, all, poles, limits);
    shares.push_back(
        left_in(frfs, modal_constants(part_of(set, frfs), others, false)));
    each.push_back({run, shares.back(), 0.0});
  }
  const double usual = median(shares);
  for (ForeignRun& one : each) one.usual = usual;
  std::erase_if(each, [&](const ForeignRun& one) {
    return one.left < std::max(limits.foreign, limits.foreign_times * usual);
  });
  return each;
}

std::string statement(const ForeignRun& foreign,
                      const acquisition::TestBundle& bundle) {
  return fmt::format(
      "the resonances of the other runs leave {:.0f} % of run {} ({}), and "
      "{:.2g} % of the others",
      100.0 * foreign.left,
      foreign.run + 1,
      bundle.runs[foreign.run].file.filename().string(),
      100.0 * foreign.usual);
}

std::vector<Finding> run_pole_findings(const acquisition::TestBundle& bundle,
                                       const FrfSet& set,
                                       const ModeSet& modes,
                                       const RunPoleLimits& limits) {
  const Runs runs = runs_of(set);
  const VectorXcd poles = poles_of(modes);
  if (runs.size() < limits.fewest_runs || poles.size() == 0 ||
      bundle.runs.empty()) {
    return {};
  }
  std::vector<Finding> findings;
  for (const ForeignRun& foreign : foreign_runs(set, modes, limits)) {
    findings.push_back(foreign_finding(bundle, foreign));
  }
  const std::vector<std::size_t> set_up = signal::set_ups(set);
  const bool sensors_stay =
      std::ranges::all_of(set_up, [](std::size_t one) { return one == 0; });
  if (sensors_stay && findings.empty()) {
    append(shift_findings(bundle, set, runs, merged(poles), limits), findings);
  }
  return findings;
}

}  // namespace tapfit::modal
