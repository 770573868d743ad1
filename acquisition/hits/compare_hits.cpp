#include "acquisition/hits/compare_hits.hpp"

#include "acquisition/samples/statistics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

constexpr double usable_snr = 10.0;     // peak over noise, better than none
constexpr double weak_share = 0.15;     // of the run's median peak
constexpr double outlier_factor = 1.6;  // response per impulse, at least

// Lines with little force are no reason to have none at all.
bool usable(const Hit& hit, double noise) {
  return hit.peak_n > usable_snr * noise &&
         std::ranges::all_of(hit.reasons, [&hit](HitFault fault) {
           if (fault == HitFault::Double) {
             return hit.second && !hit.second->leaves_block;
           }
           return fault == HitFault::Weak || fault == HitFault::Soft ||
                  fault == HitFault::Outlier;
         });
}

std::string reasons(const Hit& hit) {
  std::vector<std::string> names;
  for (const HitFault fault : hit.reasons) names.push_back(name(fault));
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

bool any_accepted(const std::vector<Hit>& hits) {
  return std::ranges::any_of(hits, &Hit::accepted);
}

bool is_weak(double peak_n, const std::vector<double>& others) {
  return others.size() >= 3 && peak_n < weak_share * median(others);
}

void judge_weak(std::vector<Hit>& hits) {
  std::vector<double> peaks;
  for (const Hit& hit : hits) {
    if (hit.accepted) peaks.push_back(hit.peak_n);
  }
  for (Hit& hit : hits) {
    if (is_weak(hit.peak_n, peaks)) reject(hit, HitFault::Weak);
  }
}

Eigen::VectorXd response_per_impulse(const Run& run,
                                     const Recording& recording,
                                     const HammerSignal& hammer,
                                     const Hit& hit,
                                     const HitSet& set) {
  const auto width = static_cast<Index>(
      std::ceil(1.5 * hit.pulse_s * recording.sample_rate_hz));
  const Index from = std::max<Index>(0, hit.trigger - width);
  const Index to = std::min(hammer.force.size(), hit.trigger + 2 * width + 2);
  const double impulse =
      std::max(hammer.force.segment(from, to - from).sum(), 1e-30);
  Eigen::VectorXd level(static_cast<Index>(run.sensors.size()));
  // The beginning decides: later, what an earlier blow left counts for more.
  const Index count = std::max<Index>(8, (set.block - set.pre_trigger) / 8);
  for (Index k = 0; k < level.size(); ++k) {
    const auto column =
        static_cast<Index>(run.sensors[static_cast<std::size_t>(k)].channel);
    const Eigen::VectorXd part = recording.samples.col(column).segment(
        hit.trigger, std::min(count, recording.samples.rows() - hit.trigger));
    const double mean = part.mean();
    const double energy = (part.array() - mean).matrix().norm();
    level[k] = std::log(std::max(energy, 1e-30) / impulse);
  }
  return level;
}

double second_share(const Hit& hit) {
  return hit.second ? hit.second->share : 0.0;
}

bool is_outlier(const Eigen::RowVectorXd& level,
                const Eigen::MatrixXd& levels,
                double second) {
  if (levels.rows() < 3) return false;
  constexpr double smallest = 1e-3;  // of what two equal blows may leave
  const double more = std::log1p(second);
  const double less = -std::log(std::max(smallest, 1.0 - second));
  for (Index k = 0; k < levels.cols(); ++k) {
    const double middle = median(levels.col(k));
    const Eigen::VectorXd away = (levels.col(k).array() - middle).abs();
    const double limit =
        std::max(std::log(outlier_factor), 6.0 * 1.4826 * median(away));
    const double beyond = level[k] - middle;
    if (beyond > limit + more || beyond < -limit - less) return true;
  }
  return false;
}

void judge_outliers(const std::vector<ComparedRun>& runs, const HitSet& set) {
  std::vector<Hit*> good;
  std::vector<Eigen::VectorXd> levels_of;
  for (const ComparedRun& one : runs) {
    for (Hit& hit : *one.hits) {
      if (!hit.accepted) continue;
      good.push_back(&hit);
      levels_of.push_back(
          response_per_impulse(one.run, *one.recording, *one.hammer, hit, set));
    }
  }
  if (good.empty()) return;
  const auto count = static_cast<Index>(good.size());
  Eigen::MatrixXd levels(count, levels_of.front().size());
  for (Index i = 0; i < count; ++i) {
    levels.row(i) = levels_of[static_cast<std::size_t>(i)].transpose();
  }
  for (Index i = 0; i < count; ++i) {
    Hit& hit = *good[static_cast<std::size_t>(i)];
    if (!is_outlier(levels.row(i), levels, second_share(hit))) continue;
    reject(hit, HitFault::Outlier);
  }
}

void keep_best_rejected(const Run& run,
                        double noise,
                        std::vector<Hit>& hits,
                        std::vector<std::string>& statements) {
  if (any_accepted(hits)) return;
  Hit* best = nullptr;
  for (Hit& hit : hits) {
    if (!usable(hit, noise)) continue;
    if (best == nullptr || hit.peak_n > best->peak_n) best = &hit;
  }
  const std::string file = run.file.filename().string();
  if (best == nullptr) {
    statements.push_back(
        fmt::format("{}: every hit was rejected; the run is not used", file));
    return;
  }
  best->accepted = true;
  statements.push_back(fmt::format(
      "{}: every hit was rejected; the hit at {:.3f} s ({}) is kept as the "
      "best there is",
      file,
      best->time_s,
      reasons(*best)));
}

}  // namespace tapfit::acquisition
