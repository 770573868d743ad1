#include "signal/spectra/offset.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::signal {

Stretch quiet_stretch(Eigen::Index earlier,
                      Eigen::Index onset,
                      Eigen::Index wanted) {
  const Eigen::Index end = std::max<Eigen::Index>(onset, 0);
  const Eigen::Index begin = std::max({Eigen::Index{0}, earlier, end - wanted});
  return {std::min(begin, end), end};
}

Eigen::VectorXd hann(Eigen::Index n) {
  Eigen::VectorXd w(n);
  // cos((i + 1/2) 2 pi / n) by turning a pointer, begun anew every 256 steps;
  // the second half mirrors the first.
  const double angle = 2.0 * std::numbers::pi / static_cast<double>(n);
  const std::complex<double> turn = std::polar(1.0, angle);
  std::complex<double> pointer;
  for (Eigen::Index i = 0; i < (n + 1) / 2; ++i) {
    pointer = i % 256 == 0
                  ? std::polar(1.0, angle * (static_cast<double>(i) + 0.5))
                  : pointer * turn;
    w(i) = w(n - 1 - i) = 0.5 - 0.5 * pointer.real();
  }
  return w;
}

double hann_mean(const Eigen::Ref<const Eigen::VectorXd>& x) {
  if (x.size() == 0) return 0.0;
  const Eigen::VectorXd w = hann(x.size());
  return w.dot(x) / w.sum();
}

double offset_at_hit(const Eigen::Ref<const Eigen::VectorXd>& channel,
                     const Stretch& before,
                     const Stretch& after,
                     Eigen::Index wanted) {
  const double level_before =
      hann_mean(channel.segment(before.begin, before.length()));
  if (2 * before.length() >= wanted || after.length() == 0) return level_before;
  const double level_after =
      hann_mean(channel.segment(after.begin, after.length()));
  const double a = static_cast<double>(before.length());
  const double b = static_cast<double>(after.length());
  return (a * level_before + b * level_after) / (a + b);
}

}  // namespace tapfit::signal
