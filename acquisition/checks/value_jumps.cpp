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

constexpr Index reach = 64;        // samples that say what is usual
constexpr Index most_rows = 4096;  // enough for the coefficients

// Of samples `order`, `order` + 1, ... how far they are from what those before
// them say.
VectorXd prediction_errors(const Samples& x, Index order) {
  const Index rows = x.size() - order;
  const Index stride = (rows + most_rows - 1) / most_rows;
  const Index used = rows / stride;
  MatrixXd before(used, order + 1);
  VectorXd now(used);
  for (Index i = 0; i < used; ++i) {
    const Index n = order + i * stride;
    before.row(i).head(order) = x.segment(n - order, order).transpose();
    before(i, order) = 1.0;
    now(i) = x(n);
  }
  const VectorXd a = before.householderQr().solve(now);
  VectorXd errors(rows);
  for (Index i = 0; i < rows; ++i) {
    errors(i) =
        x(order + i) - a(order) - a.head(order).dot(x.segment(i, order));
  }
  return errors;
}

// |e| over its rms beside, on the side where that is larger. What a jump leaves
// behind itself lasts for `order` samples, which say nothing.
VectorXd standing_out(const VectorXd& errors, double least, Index order) {
  VectorXd squares(errors.size() + 1);
  squares(0) = 0.0;
  for (Index i = 0; i < errors.size(); ++i) {
    squares(i + 1) = squares(i) + errors(i) * errors(i);
  }
  const auto rms = [&](Index from, Index to) {
    return std::sqrt(std::max(0.0, squares(to) - squares(from)) /
                     static_cast<double>(to - from));
  };
  VectorXd times = VectorXd::Zero(errors.size());
  for (Index i = reach; i + order + reach < errors.size(); ++i) {
    const double usual = std::max(
        {rms(i - reach, i), rms(i + order + 1, i + order + 1 + reach), least});
    if (usual > 0.0) times(i) = std::abs(errors(i)) / usual;
  }
  return times;
}

struct Stretch {
  Index begin = 0;
  Index end = 0;
};

// From behind each hit's blows to before the next one's.
std::vector<Stretch> between_blows(const std::vector<Hit>& hits,
                                   double rate,
                                   Index samples) {
  std::vector<Stretch> stretches;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    const auto width =
        4 + static_cast<Index>(std::ceil(2.0 * hits[k].pulse_s * rate));
    const Index begin = hits[k].trigger + std::max(hits[k].blows_after, width);
    const Index end =
        k + 1 < hits.size()
            ? hits[k + 1].trigger - std::max(hits[k + 1].blows_before, width)
            : samples;
    if (begin < end) stretches.push_back({begin, end});
  }
  return stretches;
}

// In all sensors at once: the least of what they show within a few samples.
VectorXd shown_by_all(const Run& run,
                      const Recording& recording,
                      const Stretch& at,
                      Index order) {
  VectorXd all;
  for (const Placement& sensor : run.sensors) {
    const auto x = recording.samples.col(static_cast<Index>(sensor.channel))
                       .segment(at.begin, at.end - at.begin);
    // Rounding of what is read; smaller is nothing that was measured.
    const double least = 1e-7 * x.cwiseAbs().maxCoeff();
    const VectorXd times =
        standing_out(prediction_errors(x, order), least, order);
    if (all.size() == 0) {
      all = times;
      continue;
    }
    constexpr Index near = 2;
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
  std::vector<Index> jumps;
  for (const Stretch& at : between_blows(
           hits, recording.sample_rate_hz, recording.samples.rows())) {
    if (at.end - at.begin < 8 * limits.order + 2 * reach) continue;
    const VectorXd times = shown_by_all(run, recording, at, limits.order);
    for (Index i = 0; i < times.size(); ++i) {
      if (times(i) < least) continue;
      const Index sample = at.begin + limits.order + i;
      const bool same =
          !jumps.empty() && sample - jumps.back() <= 2 * limits.order;
      if (!same) jumps.push_back(sample);
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
