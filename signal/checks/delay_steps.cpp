#include "signal/checks/delay_steps.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::signal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What hits [begin, end) are on average, each counted by its deviation.
struct Level {
  double mean = 0.0;
  double variance = 0.0;  // of the mean
  double squares = 0.0;   // weighted, about it
};

class Steps {
 public:
  Steps(const HitDelays& of, double sample_s, const DelayStepLimits& limits)
      : of_(of), sample_s_(sample_s), limits_(limits), sd_(of.sd_s) {
    sd_ = sd_.cwiseMax(scatter());
  }

  /// Delays are what hits differ by, and hits have an FRF in common.
  [[nodiscard]] bool are_delays() const {
    if (of_.sd_s.size() == 0 || common_share() < limits_.alike) return false;
    const double explained = of_.before - of_.after;
    const double most_left =
        std::max(limits_.left * of_.before, limits_.left_times * of_.expected);
    const bool rather =
        explained > limits_.rather_delay * of_.moved ||
        (explained > of_.moved &&
         of_.after * limits_.rather_delay < of_.before - of_.moved);
    return rather && of_.after < most_left;
  }

  void part(Index begin, Index end, std::vector<DelayStep>& steps) const {
    const std::optional<DelayStep> step = best(begin, end);
    if (!step || !counts(*step, weights(*step))) return;
    part(begin, step->first, steps);
    steps.push_back(*step);
    part(step->first, end, steps);
  }

  [[nodiscard]] std::optional<DelayStep> drift(const VectorXd& time_s) const {
    const Index n = of_.delay_s.size();
    if (n < limits_.fewest_for_drift || time_s.size() != n) return {};
    const VectorXd w = of_.sd_s.cwiseAbs2().cwiseInverse();
    const VectorXd t = time_s.array() - time_s.dot(w) / w.sum();
    const double spread = t.cwiseAbs2().dot(w);
    if (!(spread > 0.0)) return {};
    const VectorXd to_slope = t.cwiseProduct(w) / spread;
    const double slope = of_.delay_s.dot(to_slope);
    const Level all = level(0, n, of_.sd_s);
    const VectorXd off = of_.delay_s.array() - all.mean - slope * t.array();
    const double beside = off.cwiseAbs2().dot(w);
    if (beside > limits_.off_line * all.squares) return {};
    const double span = time_s(n - 1) - time_s(0);
    const double inflation = std::max(1.0, beside / static_cast<double>(n - 2));
    const DelayStep found{
        n - 1, 0, n, slope * span, span * std::sqrt(inflation / spread)};
    const VectorXd between = of_.delay_s.tail(n - 1) - of_.delay_s.head(n - 1);
    const double largest = between.cwiseAbs().maxCoeff();
    if (largest > limits_.largest_part * std::abs(found.delay_s)) return {};
    if (!counts(found, span * to_slope)) return {};
    return found;
  }

 private:
  // The least that a hit has in common with the others. Of n hits that have
  // nothing in common each is 1 / n of what they average to.
  [[nodiscard]] double common_share() const {
    const double chance = 1.0 / static_cast<double>(of_.alike.size());
    return (of_.alike.minCoeff() - chance) / (1.0 - chance);
  }

  // Of a hit's delay against its neighbours', of which few are steps: half of
  // all differences are no more than that.
  [[nodiscard]] double scatter() const {
    const Index n = of_.delay_s.size();
    if (n < 3) return 0.0;
    VectorXd between =
        (of_.delay_s.tail(n - 1) - of_.delay_s.head(n - 1)).cwiseAbs();
    std::sort(between.begin(), between.end());
    constexpr double sd_of_median = 1.4826;
    return sd_of_median * between((n - 2) / 2) / std::sqrt(2.0);
  }

  [[nodiscard]] Level level(Index begin, Index end, const VectorXd& sd) const {
    const VectorXd w =
        sd.segment(begin, end - begin).cwiseAbs2().cwiseInverse();
    const VectorXd x = of_.delay_s.segment(begin, end - begin);
    Level result;
    result.mean = x.dot(w) / w.sum();
    result.variance = 1.0 / w.sum();
    result.squares = (x.array() - result.mean).matrix().cwiseAbs2().dot(w);
    return result;
  }

  [[nodiscard]] std::optional<DelayStep> best(Index begin, Index end) const {
    std::optional<DelayStep> found;
    double least = 0.0;
    for (Index first = begin + 1; first < end; ++first) {
      const Level a = level(begin, first, sd_);
      const Level b = level(first, end, sd_);
      if (found && a.squares + b.squares >= least) continue;
      least = a.squares + b.squares;
      found = DelayStep{first,
                        begin,
                        end,
                        b.mean - a.mean,
                        std::sqrt(a.variance + b.variance)};
    }
    return found;
  }

  // The step as a sum over the hits' delays.
  [[nodiscard]] VectorXd weights(const DelayStep& step) const {
    const VectorXd w = sd_.cwiseAbs2().cwiseInverse();
    VectorXd of = VectorXd::Zero(w.size());
    const Index before = step.first - step.begin;
    const Index behind = step.end - step.first;
    of.segment(step.begin, before) =
        -w.segment(step.begin, before) / w.segment(step.begin, before).sum();
    of.segment(step.first, behind) =
        w.segment(step.first, behind) / w.segment(step.first, behind).sum();
    return of;
  }

  [[nodiscard]] bool counts(const DelayStep& step, const VectorXd& of) const {
    const double size = std::abs(step.delay_s);
    if (size < limits_.worth_saying * sample_s_ ||
        size < limits_.significance * step.sd_s) {
      return false;
    }
    // All of the band must want the same: phase grows with omega.
    const VectorXd other = of_.parts_s * of;
    const VectorXd variance = of_.parts_sd_s.cwiseAbs2() * of.cwiseAbs2();
    const double usual = limits_.parts_differ * size;
    return other.squaredNorm() / static_cast<double>(other.size()) <
           usual * usual + 2.0 * variance.mean();
  }

  const HitDelays& of_;
  double sample_s_;
  const DelayStepLimits& limits_;
  VectorXd sd_;
};

}  // namespace

DelayHistory delay_history(const HitDelays& of,
                           const VectorXd& time_s,
                           double sample_s,
                           const DelayStepLimits& limits) {
  DelayHistory history;
  if (of.sd_s.size() < 2) return history;
  const Steps steps(of, sample_s, limits);
  if (!steps.are_delays()) return history;
  history.drift = steps.drift(time_s);
  if (!history.drift) steps.part(0, of.delay_s.size(), history.steps);
  return history;
}

}  // namespace tapfit::signal
