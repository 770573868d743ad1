#include "signal/spectra/noise_spectrum.hpp"

#include "acquisition/hits/choose_block.hpp"
#include "signal/spectra/fft.hpp"
#include "signal/spectra/offset.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::signal {
namespace {

constexpr Eigen::Index shortest = 16;
constexpr Eigen::Index longest = 4096;
constexpr Eigen::Index fewest = 4;
// Triangular smoothing over +-24 bins leaves each value with about 44 degrees
// of freedom per stretch.
constexpr Eigen::Index smoothing = 24;

Eigen::VectorXd smooth(const Eigen::VectorXd& x) {
  const Eigen::ArrayXd away =
      Eigen::ArrayXd::LinSpaced(2 * smoothing + 1, -smoothing, smoothing);
  const Eigen::VectorXd triangle = smoothing + 1.0 - away.abs();
  Eigen::VectorXd result = x;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    // The first two bins are what the offset's removal has eaten.
    const Eigen::Index first = std::max<Eigen::Index>(2, i - smoothing);
    const Eigen::Index count = std::min(x.size(), i + smoothing + 1) - first;
    if (count <= 0) continue;
    const Eigen::Ref<const Eigen::VectorXd> weights =
        triangle.segment(first - i + smoothing, count);
    result(i) = weights.dot(x.segment(first, count)) / weights.sum();
  }
  return result;
}

// Too few samples for a spectrum: white noise, offset and all.
Eigen::VectorXd white(const std::vector<Eigen::VectorXd>& stretches) {
  double square = 0.0;
  double freedom = 0.0;
  for (const Eigen::VectorXd& x : stretches) {
    if (x.size() < fewest) continue;
    square += (x.array() - x.mean()).square().sum();
    freedom += static_cast<double>(x.size()) - 1.0;
  }
  if (freedom == 0.0) return {};
  return Eigen::VectorXd::Constant(1, square / freedom);
}

}  // namespace

double NoiseSpectrum::at(double omega) const {
  if (S.size() == 0) return 0.0;
  if (S.size() == 1 || !(step > 0.0)) return S(0);
  const double x =
      std::clamp(omega / step, 0.0, static_cast<double>(S.size() - 1));
  const Eigen::Index i = std::min(static_cast<Eigen::Index>(x), S.size() - 2);
  const double f = x - static_cast<double>(i);
  return (1.0 - f) * S(i) + f * S(i + 1);
}

NoiseSpectrum noise_spectrum(const std::vector<Eigen::VectorXd>& stretches,
                             double dt) {
  Eigen::Index n = 0;
  for (const Eigen::VectorXd& x : stretches) n = std::max(n, x.size());
  NoiseSpectrum result;
  if (n < shortest) {
    result.S = white(stretches);
    return result;
  }
  // A few samples less, and none of the slow transforms of odd lengths.
  n = acquisition::smooth_length(std::min(n, longest));
  RealFft fft(n);
  result.step = 2.0 * std::numbers::pi / (static_cast<double>(n) * dt);
  result.S = Eigen::VectorXd::Zero(n / 2 + 1);
  double total = 0.0;
  Eigen::VectorXd h;
  for (const Eigen::VectorXd& x : stretches) {
    if (x.size() < shortest) continue;
    // The last samples are those nearest to the hit.
    const Eigen::Index length = std::min(n, x.size());
    if (h.size() != length) h = hann(length);
    const Eigen::VectorXd tapered = h.cwiseProduct(x.tail(length));
    const double weight = static_cast<double>(length);
    result.S += weight / h.squaredNorm() * fft.transform(tapered).cwiseAbs2();
    total += weight;
  }
  result.S = smooth(result.S / total);
  return result;
}

}  // namespace tapfit::signal
