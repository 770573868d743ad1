#include "modal/checks/run_residues.hpp"

#include "modal/checks/modal_constants.hpp"
#include "modal/checks/run_poles.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <utility>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using complex = std::complex<double>;

/// Runs whose sensors sit at the same points.
struct SetUp {
  std::vector<std::size_t> channels;  ///< of the sensors, ascending
  std::vector<std::size_t> runs;
  std::vector<MatrixXcd> z;  ///< per run: sensors x modes
  std::vector<MatrixXd> sd;
};

using Place = std::pair<std::size_t, Dof>;

// Modal constants as heights of peaks: poles of heavy damping, which stand for
// what lies beside the band, then count for no more than they show.
std::vector<SetUp> set_ups_of(const signal::FrfSet& set,
                              const std::vector<ModalConstants>& of,
                              const VectorXcd& poles) {
  const VectorXd heights =
      0.5 * poles.cwiseAbs().cwiseQuotient((-poles.real()).cwiseMax(1e-9));
  std::map<std::size_t, std::map<Place, std::size_t>> by_run;
  for (std::size_t f = 0; f < set.frfs.size(); ++f) {
    const signal::Frf& frf = set.frfs[f];
    by_run[frf.run][{frf.channel, frf.response}] = f;
  }
  std::map<std::vector<Place>, SetUp> set_ups;
  for (const auto& [run, frfs] : by_run) {
    std::vector<Place> places;
    for (const auto& [place, f] : frfs) places.push_back(place);
    SetUp& set_up = set_ups[places];
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
    set_up.z.push_back(std::move(z));
    set_up.sd.push_back(std::move(sd));
  }
  std::vector<SetUp> found;
  for (auto& [places, set_up] : set_ups) found.push_back(std::move(set_up));
  return found;
}

// Share of v that is not along u, both of unit length: sin^2 of the angle.
double apart(const VectorXcd& u, const VectorXcd& v) {
  return std::max(1.0 - std::norm(u.dot(v)), 0.0);
}

// The pattern over the sensors that most of the runs' strength agrees on: of
// the runs' own patterns the one with the least sum of distances to all.
VectorXcd common_pattern(const SetUp& set_up, Index mode) {
  double least = std::numeric_limits<double>::infinity();
  VectorXcd best = VectorXcd::Zero(set_up.z.front().rows());
  for (const MatrixXcd& tried : set_up.z) {
    const VectorXcd u = tried.col(mode).normalized();
    double sum = 0.0;
    for (const MatrixXcd& other : set_up.z) {
      const double size = other.col(mode).norm();
      sum += size * std::sqrt(apart(u, other.col(mode).normalized()));
    }
    if (sum < least) {
      least = sum;
      best = u;
    }
  }
  // The mean of those near it, strong runs first.
  MatrixXcd outer = MatrixXcd::Zero(best.size(), best.size());
  for (const MatrixXcd& z : set_up.z) {
    const VectorXcd v = z.col(mode);
    if (apart(best, v.normalized()) > 0.01) continue;
    outer += v * v.adjoint();
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXcd> eigen(outer);
  return eigen.eigenvectors().col(best.size() - 1);
}

/// How a run's sensors differ from the common pattern.
struct Pattern {
  double error = 0.0;      ///< relative, after the amplitude of each mode
  std::size_t sensor = 0;  ///< one factor on it explains the most
  complex factor = 1.0;    ///< that factor
  double left = 0.0;       ///< error with it
};

// Relative error of z against the patterns, each mode with its own amplitude;
// noise that is stated is taken off.
double pattern_error(const MatrixXcd& z,
                     const MatrixXd& sd,
                     const MatrixXcd& patterns) {
  double rest = 0.0;
  double all = 0.0;
  for (Index k = 0; k < z.cols(); ++k) {
    const VectorXcd u = patterns.col(k).normalized();
    const complex q = u.dot(z.col(k));
    rest += (z.col(k) - q * u).squaredNorm() - 2.0 * sd.col(k).squaredNorm();
    all += z.col(k).squaredNorm();
  }
  return std::sqrt(std::max(rest, 0.0) / std::max(all, 1e-300));
}

// The factor on one sensor that the others' amplitudes ask for.
complex factor_on(Index sensor, const MatrixXcd& z, const MatrixXcd& patterns) {
  complex along = 0.0;
  double square = 0.0;
  for (Index k = 0; k < z.cols(); ++k) {
    VectorXcd others = patterns.col(k);
    const complex own = others(sensor);
    others(sensor) = 0.0;
    const double size = others.squaredNorm();
    if (size < 1e-6) continue;  // only this sensor sees the mode
    VectorXcd seen = z.col(k);
    seen(sensor) = 0.0;
    const complex predicted = own * others.dot(seen) / size;
    along += std::conj(predicted) * z(sensor, k);
    square += std::norm(predicted);
  }
  return square > 0.0 ? along / square : complex(1.0);
}

Pattern look_at(const MatrixXcd& z,
                const MatrixXd& sd,
                const MatrixXcd& patterns) {
  Pattern found;
  found.error = pattern_error(z, sd, patterns);
  found.left = found.error;
  for (Index c = 0; c < z.rows(); ++c) {
    const complex factor = factor_on(c, z, patterns);
    if (std::abs(factor) < 1e-6) continue;
    MatrixXcd corrected = z;
    MatrixXd noise = sd;
    corrected.row(c) /= factor;
    noise.row(c) /= std::abs(factor);
    const double left = pattern_error(corrected, noise, patterns);
    if (left >= found.left) continue;
    found.left = left;
    found.sensor = static_cast<std::size_t>(c);
    found.factor = factor;
  }
  return found;
}

std::string name_of(const acquisition::TestBundle& bundle,
                    const SetUp& set_up,
                    std::size_t sensor) {
  return bundle.channels.at(set_up.channels[sensor]).name;
}

// With two sensors what one has too much the other has too little.
std::string against(const acquisition::TestBundle& bundle,
                    const SetUp& set_up,
                    std::size_t sensor) {
  return set_up.channels.size() == 2 ? name_of(bundle, set_up, 1 - sensor)
                                     : std::string("the other sensors");
}

Finding gain_finding(const acquisition::TestBundle& bundle,
                     const SetUp& set_up,
                     const std::vector<std::size_t>& runs,
                     const Pattern& pattern) {
  const std::string who = name_of(bundle, set_up, pattern.sensor);
  const std::string other = against(bundle, set_up, pattern.sensor);
  const bool two = set_up.channels.size() == 2;
  const double factor = std::abs(pattern.factor);
  const bool turned = pattern.factor.real() < 0.0;
  return {
      Severity::Error,
      {runs, who, {}, {}},
      fmt::format("{} against {} is {}{:.3g} times what it is in the other "
                  "runs, in every mode",
                  who,
                  other,
                  turned ? "minus " : "",
                  factor),
      turned && std::abs(factor - 1.0) < 0.1
          ? fmt::format("{}{} was turned over in these runs",
                        who,
                        two ? " or " + other : "")
          : fmt::format("the range or amplifier of {}{} was changed for these "
                        "runs",
                        who,
                        two ? " or " + other : ""),
      fmt::format("list {} a second time in `channels` with {:.4g} times the "
                  "sensitivity and use that channel in these runs, or take "
                  "them out",
                  who,
                  turned ? -factor : factor)};
}

Finding moved_finding(const acquisition::TestBundle& bundle,
                      const SetUp& set_up,
                      const std::vector<std::size_t>& runs,
                      double error) {
  std::string names;
  for (std::size_t c = 0; c < set_up.channels.size(); ++c) {
    names += (c == 0 ? "" : ", ") + name_of(bundle, set_up, c);
  }
  return {Severity::Error,
          {runs, {}, {}, {}},
          fmt::format("what {} show of each mode differs from the other runs "
                      "by {:.2g} %, mode by mode another way",
                      names,
                      100.0 * error),
          fmt::format("{} sat at another point or along another direction in "
                      "these runs",
                      set_up.channels.size() == 2
                          ? "one of the two"
                          : std::string("one of the sensors")),
          "correct `sensors` of these runs in test.json, or take them out"};
}

bool same_change(const Pattern& a, const Pattern& b, bool one_factor) {
  if (!one_factor) return true;
  return a.sensor == b.sensor &&
         std::abs(a.factor - b.factor) < 0.1 * std::abs(a.factor);
}

std::vector<Finding> findings_in(const acquisition::TestBundle& bundle,
                                 const SetUp& set_up,
                                 const RunResidueLimits& limits) {
  const Index modes = set_up.z.front().cols();
  MatrixXcd patterns(set_up.z.front().rows(), modes);
  for (Index k = 0; k < modes; ++k) {
    patterns.col(k) = common_pattern(set_up, k);
  }
  std::vector<Pattern> of;
  VectorXd errors(static_cast<Index>(set_up.runs.size()));
  for (std::size_t r = 0; r < set_up.runs.size(); ++r) {
    of.push_back(look_at(set_up.z[r], set_up.sd[r], patterns));
    errors(static_cast<Index>(r)) = of.back().error;
  }
  // Up to half of the runs may be changed: those that agree say what is usual.
  std::ranges::sort(errors);
  const double limit =
      std::max(limits.much, limits.times_usual * errors(errors.size() / 4));
  std::vector<Finding> findings;
  std::vector<bool> told(of.size(), false);
  for (std::size_t r = 0; r < of.size(); ++r) {
    if (told[r] || of[r].error <= limit) continue;
    const auto by_factor = [&](const Pattern& p) {
      return p.left < limits.one_factor * p.error || p.left < 0.5 * limits.much;
    };
    const bool one_factor = by_factor(of[r]);
    std::vector<std::size_t> runs;
    double largest = 0.0;
    for (std::size_t other = r; other < of.size(); ++other) {
      if (told[other] || of[other].error <= limit ||
          by_factor(of[other]) != one_factor ||
          !same_change(of[r], of[other], one_factor)) {
        continue;
      }
      told[other] = true;
      runs.push_back(set_up.runs[other]);
      largest = std::max(largest, of[other].error);
    }
    findings.push_back(one_factor
                           ? gain_finding(bundle, set_up, runs, of[r])
                           : moved_finding(bundle, set_up, runs, largest));
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
  for (const SetUp& set_up : set_ups_of(set, of, poles(alone))) {
    if (set_up.channels.size() < 2 || set_up.runs.size() < limits.fewest_runs) {
      continue;
    }
    append(findings_in(bundle, set_up, limits), findings);
  }
  return findings;
}

}  // namespace tapfit::modal
