#include "acquisition/checks/value_jumps.hpp"

#include "acquisition/foundation/parallel.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Samples = Eigen::Ref<const VectorXd>;

constexpr Index reach = 64;        // samples before that say what is usual
constexpr Index near = 2;          // over which a jump may spread
constexpr Index next_to = 16;      // and behind
constexpr Index ringing = 16;      // of filters, behind a blow
constexpr Index most_rows = 2048;  // enough for the coefficients

struct Stretch {
  Index begin = 0;
  Index end = 0;
  [[nodiscard]] Index size() const { return end - begin; }
};

// The coefficients a and, last, c that fit some stretches best, each where it
// is loud: a jump that the noise hides is none that matters.
VectorXd prediction(const Samples& x,
                    const std::vector<Stretch>& stretches,
                    Index order) {
  const Index each = most_rows / static_cast<Index>(stretches.size()) + 1;
  MatrixXd behind(each * static_cast<Index>(stretches.size()), order + 1);
  VectorXd now(behind.rows());
  Index used = 0;
  for (const Stretch& at : stretches) {
    const Index end = at.begin + std::min(each, at.size() - order);
    for (Index n = at.begin; n < end; ++n, ++used) {
      behind.row(used).head(order) = x.segment(n + 1, order).transpose();
      behind(used, order) = 1.0;
      now(used) = x(n);
    }
  }
  return behind.topRows(used).householderQr().solve(now.head(used));
}

// Of each sample of a stretch, but for the last ones, how far it is from what
// those behind it say.
VectorXd prediction_errors(const Samples& x,
                           const Stretch& at,
                           const VectorXd& a) {
  const Index order = a.size() - 1;
  VectorXd errors(at.size() - order);
  for (Index i = 0; i < errors.size(); ++i) {
    const Index n = at.begin + i;
    errors(i) = x(n) - a(order) - a.head(order).dot(x.segment(n + 1, order));
  }
  return errors;
}

// |e| over its rms behind it, and before it where the stretch goes back so far:
// the `order` samples before a jump say nothing.
VectorXd standing_out(const VectorXd& errors, double least, Index order) {
  VectorXd squares(errors.size() + 1);
  squares(0) = 0.0;
  for (Index i = 0; i < errors.size(); ++i) {
    squares(i + 1) = squares(i) + errors(i) * errors(i);
  }
  const auto rms = [&](Index from, Index count) {
    return from < 0 ? 0.0
                    : std::sqrt(
                          std::max(0.0, squares(from + count) - squares(from)) /
                          static_cast<double>(count));
  };
  VectorXd times = VectorXd::Zero(errors.size());
  for (Index i = ringing; i + near + next_to < errors.size(); ++i) {
    const Index behind = i + near + 1;
    const double usual =
        std::max({rms(behind, next_to), rms(i - order - reach, reach), least});
    if (usual > 0.0) times(i) = std::abs(errors(i)) / usual;
  }
  return times;
}

// From behind each hit's blows to before the next one's, where that is long
// enough to tell what is usual.
std::vector<Stretch> between_blows(const std::vector<Hit>& hits,
                                   double rate,
                                   Index samples,
                                   Index order) {
  std::vector<Stretch> stretches;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    const auto width =
        4 + static_cast<Index>(std::ceil(2.0 * hits[k].pulse_s * rate));
    const Index begin = hits[k].trigger + std::max(hits[k].blows_after, width);
    const Index end =
        k + 1 < hits.size()
            ? hits[k + 1].trigger - std::max(hits[k + 1].blows_before, width)
            : samples;
    const Stretch stretch{begin, end};
    if (stretch.size() >= 4 * order + 2 * reach) stretches.push_back(stretch);
  }
  return stretches;
}

// What one sensor shows in a stretch, by a prediction that the others gave: a
// jump would bend its own towards itself. A stretch alone has no others.
VectorXd shown_by(const Samples& x,
                  const std::vector<Stretch>& stretches,
                  std::size_t which,
                  Index order) {
  std::vector<Stretch> others = stretches;
  if (others.size() > 1) {
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(which));
  }
  const Stretch& at = stretches[which];
  // Rounding of what is read; smaller is nothing that was measured.
  const double least =
      1e-7 * x.segment(at.begin, at.size()).cwiseAbs().maxCoeff();
  return standing_out(
      prediction_errors(x, at, prediction(x, others, order)), least, order);
}

// In all sensors at once: the least of what they show within a few samples.
VectorXd shown_by_all(const Run& run,
                      const Recording& recording,
                      const std::vector<Stretch>& stretches,
                      std::size_t which,
                      Index order) {
  VectorXd all;
  for (const Placement& sensor : run.sensors) {
    const VectorXd times =
        shown_by(recording.samples.col(static_cast<Index>(sensor.channel)),
                 stretches,
                 which,
                 order);
    if (all.size() == 0) {
      all = times;
      continue;
    }
    for (Index i = 0; i < all.size(); ++i) {
      const Index from = std::max<Index>(0, i - near);
      const Index count = std::min(all.size(), i + near + 1) - from;
      all(i) = std::min(all(i), times.segment(from, count).maxCoeff());
    }
  }
  return all;
}

}  // namespace

std::vector<Index> value_jumps(const Run& run,
                               const Recording& recording,
                               const std::vector<Hit>& hits,
                               const JumpLimits& limits) {
  const double least =
      run.sensors.size() > 1 ? limits.least_together : limits.least_alone;
  const std::vector<Stretch> stretches = between_blows(
      hits, recording.sample_rate_hz, recording.samples.rows(), limits.order);
  std::vector<Index> jumps;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const VectorXd times =
        shown_by_all(run, recording, stretches, k, limits.order);
    // Of those that stand out together the last is next to the jump.
    for (Index i = 0, last = -limits.order; i < times.size(); ++i) {
      if (times(i) < least) continue;
      const Index sample = stretches[k].begin + i + 1;
      if (i - last < limits.order) {
        jumps.back() = sample;
      } else {
        jumps.push_back(sample);
      }
      last = i;
    }
  }
  return jumps;
}

std::vector<Finding> jump_findings(const TestBundle& bundle,
                                   const std::vector<Recording>& recordings,
                                   const HitSet& hits) {
  std::vector<std::vector<Index>> of(recordings.size());
  for_each_parallel(recordings.size(), [&](std::size_t r) {
    if (recordings[r].samples.rows() == 0) return;
    of[r] = value_jumps(bundle.runs[r], recordings[r], hits.runs[r]);
  });
  std::vector<std::size_t> runs;
  std::size_t count = 0;
  for (std::size_t r = 0; r < of.size(); ++r) {
    if (of[r].empty()) continue;
    runs.push_back(r);
    count += of[r].size();
  }
  if (runs.empty()) return {};
  const std::size_t first = runs.front();
  return {
      {Severity::Warning,
       {runs, {}, {}, {}},
       fmt::format("all responses jump {} time{} while the hammer rests, "
                   "first at {:.3f} s of run {}",
                   count,
                   count == 1 ? "" : "s",
                   static_cast<double>(of[first].front()) /
                       recordings[first].sample_rate_hz,
                   first + 1),
       "samples were lost there, or something else struck the structure",
       "reject the hits before it (Space on the Recording screen), or leave "
       "these runs out of `runs`"}};
}

}  // namespace tapfit::acquisition
