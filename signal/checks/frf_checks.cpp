#include "signal/checks/frf_checks.hpp"

#include "acquisition/samples/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::signal {
namespace {

using Eigen::Index;

// Power of the noise per line, of how rough the lines are: a single hit in a
// restless laboratory has more of it than its pre-trigger shows. Second
// differences of white noise have six times its power; those of a resonance are
// small but at its peak, which a median passes over. Four lines apart, because
// under an exponential window those next to each other are alike.
//
// @param share of the mean that the median of |noise|^2 is
template <class Vector>
Eigen::ArrayXd roughness(const Vector& x, double share) {
  constexpr Index stride = 4;
  const Index n = x.size();
  Eigen::ArrayXd noise = Eigen::ArrayXd::Zero(n);
  const Index count = n - 2 * stride;
  if (count < 1) return noise;
  const Eigen::VectorXd rough =
      (x.head(count) - 2.0 * x.segment(stride, count) + x.tail(count))
          .cwiseAbs2();
  const Index reach = std::max<Index>(24, n / 20);
  for (Index from = 0; from < n; from += reach) {
    const Index first = std::clamp<Index>(from - reach, 0, count - 1);
    const Index last = std::clamp<Index>(from + 2 * reach, first + 1, count);
    noise.segment(from, std::min(reach, n - from)) =
        acquisition::median(rough.segment(first, last - first)) / (6.0 * share);
  }
  return noise;
}

// E|dH|^2: as stated, or as the lines are rough, what is more. |noise|^2 of
// complex lines is exponential, its median ln 2 of the mean.
Eigen::ArrayXd noise_of(const Frf& frf) {
  return frf.variance.array().max(roughness(frf.H, std::log(2.0)));
}

// Lines at which |H| is largest of five, twice its geometric mean and more, and
// well out of its noise. The flanks of a resonance that moved while it rang are
// jagged: it has to be largest within a hundredth of the band as well.
//
// @param noise from noise_of()
// @param clear_of_noise |H|^2 over the noise's power, at least. Of pure noise
//   one line in exp(that) is.
std::vector<Index> peaks_of(const Frf& frf,
                            const Eigen::ArrayXd& noise,
                            double clear_of_noise) {
  const Eigen::ArrayXd size = frf.H.cwiseAbs().array().max(1e-300);
  const double least = 2.0 * std::exp(size.log().mean());
  const Index reach = std::max<Index>(2, size.size() / 100);
  std::vector<Index> peaks;
  for (Index i = 2; i + 2 < size.size(); ++i) {
    const bool clear =
        size(i) >= least && size(i) * size(i) >= clear_of_noise * noise(i);
    if (!clear) continue;
    const Index first = std::max<Index>(0, i - reach);
    const Index last = std::min(size.size() - 1, i + reach);
    if (size(i) >= size.segment(first, last - first + 1).maxCoeff()) {
      peaks.push_back(i);
    }
  }
  return peaks;
}

int orientation(const Frf& frf) {
  return frf.response.sign * frf.reference.sign;
}

bool same_place(const Dof& a, const Dof& b) {
  return a.node == b.node && a.component == b.component;
}

// Another response to the same blows that passes, taken as the driving point;
// the one with the most peaks.
std::optional<std::size_t> rather(const FrfSet& set, std::size_t index) {
  std::optional<std::size_t> best;
  int peaks = 1;
  for (std::size_t i = 0; i < set.frfs.size(); ++i) {
    if (i == index || set.frfs[i].run != set.frfs[index].run) continue;
    const DrivingPoint other =
        driving_point(set, i, orientation(set.frfs[index]));
    if (other.peaks > peaks && other.fair()) {
      best = i;
      peaks = other.peaks;
    }
  }
  return best;
}

}  // namespace

DrivingPoint driving_point(const FrfSet& set, std::size_t index, double sign) {
  const Frf& frf = set.frfs[index];
  DrivingPoint point;
  point.frf = index;
  constexpr double clear = 25.0;
  const Eigen::ArrayXd noise = noise_of(frf);
  for (const Index i : peaks_of(frf, noise, clear)) {
    const double up = sign * frf.H(i).imag();
    // What rises to neighbouring modes is real: its imaginary part is noise.
    if (up * up < 0.5 * clear * noise(i)) continue;
    ++point.peaks;
    if (up < 0.0) ++point.wrong_peaks;
  }
  const Eigen::ArrayXd size = set.s.cwiseAbs().array().max(1e-300);
  const Eigen::VectorXd real =
      sign * (frf.H.array() / set.s.array()).real().matrix();
  // Of real noise the median is 0.455 of the mean (chi^2 of one freedom).
  const Eigen::ArrayXd sd = (0.5 * frf.variance.array() / size.square())
                                .max(roughness(real, 0.455))
                                .sqrt();
  const auto active =
      (real.array() < -3.0 * sd - 1e-9 * frf.H.cwiseAbs().array() / size)
          .count();
  point.active_share = static_cast<double>(active) /
                       static_cast<double>(std::max<Index>(1, frf.H.size()));
  const LowLines low = low_lines(set.s, frf);
  point.low = low.kind;
  (low.kind == LowLine::Stiffness ? point.stiffness_n_per_m : point.mass_kg) =
      std::abs(low.value);
  return point;
}

Reciprocal compared(const FrfSet& set,
                    std::size_t i,
                    std::size_t j,
                    double sign) {
  const Frf& a = set.frfs[i];
  const Frf& b = set.frfs[j];
  const Eigen::VectorXcd one = sign * a.H;
  const Eigen::VectorXcd two = b.H;
  const double norms = one.norm() * two.norm();
  Reciprocal result;
  result.frf = i;
  result.other = j;
  if (!(norms > 0.0)) return result;
  const Eigen::VectorXcd d = one - two;
  const Eigen::ArrayXd d2 = d.cwiseAbs2().array();
  result.difference = std::sqrt(d2.sum() / norms);
  result.gain = two.dot(one).real() / two.squaredNorm();
  result.shape_difference = (one - result.gain * two).norm() / one.norm();
  result.constant = d.real().mean();
  const double beside = (d.array() - result.constant).matrix().norm();
  if (d.norm() > 0.0) result.beside_constant = beside / d.norm();
  const Eigen::ArrayXd variance = (a.variance + b.variance).array();
  if (variance.size() > 0 && variance.minCoeff() > 0.0) {
    result.chi2 = (d2 / variance).mean();
  }
  return result;
}

std::vector<DrivingPoint> driving_points(const FrfSet& set) {
  std::vector<DrivingPoint> result;
  for (std::size_t i = 0; i < set.frfs.size(); ++i) {
    if (same_place(set.frfs[i].response, set.frfs[i].reference)) {
      DrivingPoint point = driving_point(set, i, orientation(set.frfs[i]));
      // Where every peak is turned it is the polarity, where none is a delay.
      if (point.mixed()) point.rather = rather(set, i);
      result.push_back(point);
    }
  }
  return result;
}

std::vector<Reciprocal> reciprocals(const FrfSet& set) {
  std::vector<Reciprocal> result;
  for (std::size_t i = 0; i < set.frfs.size(); ++i) {
    if (same_place(set.frfs[i].response, set.frfs[i].reference)) continue;
    for (std::size_t j = i + 1; j < set.frfs.size(); ++j) {
      if (same_place(set.frfs[i].response, set.frfs[j].reference) &&
          same_place(set.frfs[i].reference, set.frfs[j].response)) {
        result.push_back(compared(
            set, i, j, orientation(set.frfs[i]) * orientation(set.frfs[j])));
      }
    }
  }
  return result;
}

std::optional<double> spread_at_peaks(const Frf& frf) {
  if (frf.hits < 2) return std::nullopt;
  double largest = 0.0;
  for (const Index i : peaks_of(frf, noise_of(frf), 10.0)) {
    if (frf.coherence(i) > 0.0) {
      largest = std::max(largest, 1.0 / frf.coherence(i) - 1.0);
    }
  }
  return largest;
}

FrfChecks check_frfs(const FrfSet& frfs) {
  return {driving_points(frfs), reciprocals(frfs)};
}

}  // namespace tapfit::signal
