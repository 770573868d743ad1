#include "modal/fit/frf_peaks.hpp"

#include "signal/checks/confidence_band.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Complex = std::complex<double>;

/// The lowest value on the way from the peak to something higher, or the end.
double lowest_downhill(const Eigen::VectorXd& size,
                       const Eigen::VectorXd& value,
                       Index peak,
                       Index step) {
  double lowest = value[peak];
  for (Index i = peak + step; i >= 0 && i < size.size(); i += step) {
    if (size[i] > size[peak]) break;
    lowest = std::min(lowest, value[i]);
  }
  return lowest;
}

/// Where the peak's upper part ends on that side: at the latest in the valley
/// before something higher.
Index end_of_upper_part(const Eigen::VectorXcd& H, Index peak, Index step) {
  const double size = std::abs(H[peak]);
  Index end = peak;
  Index valley = peak;
  for (Index i = peak + step; i >= 0 && i < H.size(); i += step) {
    const double here = std::abs(H[i]);
    if (here > size) return valley;
    if (here <= 0.4 * size) break;
    end = i;
    if (here < std::abs(H[valley])) valley = i;
  }
  return end;
}

/// First and last line of the peak's upper part.
std::pair<Index, Index> upper_part(const Eigen::VectorXcd& H, Index peak) {
  Index first = end_of_upper_part(H, peak, -1);
  Index last = end_of_upper_part(H, peak, 1);
  first = std::min(first, std::max<Index>(peak - 3, 0));
  last = std::max(last, std::min<Index>(peak + 3, H.size() - 1));
  return {first, last};
}

}  // namespace

std::vector<Index> peak_lines(const Eigen::VectorXd& magnitude,
                              double prominence) {
  std::vector<Index> found;
  for (Index i = 1; i + 1 < magnitude.size(); ++i) {
    if (!(magnitude[i] > magnitude[i - 1] && magnitude[i] >= magnitude[i + 1]))
      continue;
    const double valley = std::max(lowest_downhill(magnitude, magnitude, i, -1),
                                   lowest_downhill(magnitude, magnitude, i, 1));
    if (magnitude[i] >= prominence * valley) found.push_back(i);
  }
  return found;
}

std::vector<Index> peak_lines(const signal::Frf& frf) {
  const Eigen::VectorXd size = frf.H.cwiseAbs();
  std::vector<Index> found = peak_lines(size);
  if (frf.variance.size() != size.size()) return found;  // not known
  // One of n lines outside its circle is as likely as the sum of n.
  const auto lines = static_cast<double>(size.size());
  const Eigen::VectorXd radius = signal::confidence_radius(frf, 0.05 / lines);
  const Eigen::VectorXd highest = size + radius;
  std::erase_if(found, [&](Index i) {
    const double valley = std::max(lowest_downhill(size, highest, i, -1),
                                   lowest_downhill(size, highest, i, 1));
    return size[i] - radius[i] <= valley;
  });
  return found;
}

double PeakFit::frequency_hz() const {
  return std::abs(pole) / (2.0 * std::numbers::pi);
}

double PeakFit::damping_ratio() const { return -pole.real() / std::abs(pole); }

std::optional<PeakFit> fit_peak(const Eigen::VectorXcd& s,
                                const Eigen::VectorXcd& H,
                                Index peak) {
  if (peak < 0 || peak >= H.size() || s.size() != H.size()) return {};
  PeakFit fit;
  std::tie(fit.first, fit.last) = upper_part(H, peak);
  const Index n = fit.last - fit.first + 1;
  if (n < 5) return std::nullopt;
  const Complex s_0 = s[peak];
  const double span = std::abs(s[fit.last] - s[fit.first]);
  const double size = std::abs(H[peak]);
  if (!(span > 0.0) || !(size > 0.0)) return std::nullopt;
  // In units of the stretch and the peak, so that the columns are alike.
  const Eigen::VectorXcd x =
      (s.segment(fit.first, n).array() - s_0).matrix() / span;
  const Eigen::VectorXcd y = H.segment(fit.first, n) / size;
  Eigen::MatrixXcd A(n, 3);
  A.col(0) = y;
  A.col(1) = x;
  A.col(2).setOnes();
  const Eigen::VectorXcd b = x.cwiseProduct(y);
  const Eigen::Vector3cd found = A.colPivHouseholderQr().solve(b);
  fit.pole = s_0 + span * found[0];
  fit.rest = size * found[1];
  fit.residue = size * span * (found[1] * found[0] + found[2]);
  const double a = s_0.real() - fit.pole.real();
  if (!found.allFinite() || !(a > 0.0) || !(fit.pole.real() < 0.0)) return {};
  // A pole beside its lines is another peak's, of whose flank they are.
  const double w = fit.pole.imag();
  if (w < s[fit.first].imag() || w > s[fit.last].imag()) return std::nullopt;
  fit.centre = fit.rest + fit.residue / (2.0 * a);
  fit.radius = std::abs(fit.residue) / (2.0 * a);
  if (!(fit.radius > 0.0)) return std::nullopt;
  const Eigen::ArrayXcd left =
      H.segment(fit.first, n).array() - fit.rest -
      fit.residue / (s.segment(fit.first, n).array() - fit.pole);
  fit.deviation = std::sqrt(left.abs2().mean()) / fit.radius;
  return fit;
}

}  // namespace tapfit::modal
