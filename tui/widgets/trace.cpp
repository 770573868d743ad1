#include "tui/widgets/trace.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::tui {

Trace trace(const acquisition::Recording& recording, Eigen::Index most) {
  Trace t;
  t.sample_rate_hz = recording.sample_rate_hz;
  t.samples = recording.samples.rows();
  t.stretch = std::max<Eigen::Index>(1, (t.samples + most - 1) / most);
  const Eigen::Index rows = (t.samples + t.stretch - 1) / t.stretch;
  const Eigen::Index channels = recording.samples.cols();
  t.low.resize(rows, channels);
  t.high.resize(rows, channels);
  for (Eigen::Index c = 0; c < channels; ++c) {
    for (Eigen::Index r = 0; r < rows; ++r) {
      const Eigen::Index from = r * t.stretch;
      const Eigen::Index count = std::min(t.stretch, t.samples - from);
      const auto part = recording.samples.col(c).segment(from, count);
      t.low(r, c) = static_cast<float>(part.minCoeff());
      t.high(r, c) = static_cast<float>(part.maxCoeff());
    }
  }
  return t;
}

Envelope envelope(const Trace& trace,
                  Eigen::Index channel,
                  double from_s,
                  double to_s,
                  Eigen::Index columns) {
  Envelope e;
  const Eigen::Index rows = trace.low.rows();
  if (rows == 0 || channel >= trace.low.cols() || columns < 1) return e;
  const double row_s =
      static_cast<double>(trace.stretch) / trace.sample_rate_hz;
  const auto row_of = [&](double s) {
    return std::clamp<Eigen::Index>(
        static_cast<Eigen::Index>(std::floor(s / row_s)), 0, rows - 1);
  };
  const Eigen::Index first = row_of(from_s);
  const Eigen::Index count = row_of(to_s) - first + 1;
  const Eigen::Index n = std::min(count, columns);
  e.time_s.resize(n);
  e.low.resize(n);
  e.high.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index begin = first + i * count / n;
    const Eigen::Index end = first + (i + 1) * count / n;
    // One row into the next stretch, so that steep flanks stay connected.
    const Eigen::Index length = std::min(end - begin + 1, rows - begin);
    e.time_s[i] = static_cast<double>(begin) * row_s;
    e.low[i] = trace.low.col(channel).segment(begin, length).minCoeff();
    e.high[i] = trace.high.col(channel).segment(begin, length).maxCoeff();
  }
  return e;
}

}  // namespace tapfit::tui
