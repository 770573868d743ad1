#include "signal/frf_checks.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::signal {
namespace {

using Eigen::Index;

// Lines at which |H| is largest of five, twice its geometric mean and more, and
// five standard deviations out of its noise.
std::vector<Index> peaks_of(const Frf& frf) {
  const Eigen::ArrayXd size = frf.H.cwiseAbs().array().max(1e-300);
  const double least = 2.0 * std::exp(size.log().mean());
  std::vector<Index> peaks;
  for (Index i = 2; i + 2 < size.size(); ++i) {
    const bool clear =
        size(i) >= least && size(i) * size(i) >= 25.0 * frf.variance(i);
    if (clear && size(i) >= size.segment(i - 2, 5).maxCoeff()) {
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

// Slope of log|A| over log f in the band's lowest octave: 0 mass, 2 stiffness.
void find_low_line(const FrfSet& set, const Frf& frf, DrivingPoint& point) {
  const Eigen::ArrayXd f = set.frequency_hz().array();
  Index n = 0;
  while (n < f.size() && f(n) <= 2.0 * f(0)) ++n;
  if (n < 4 || !(f(0) > 0.0)) return;
  const Eigen::ArrayXd x = f.head(n).log() - f.head(n).log().mean();
  const Eigen::ArrayXd size = frf.H.head(n).cwiseAbs().array().max(1e-300);
  const double slope = (x * size.log()).sum() / (x * x).sum();
  if (std::abs(slope) < 0.2) {
    point.low = LowLine::Mass;
    point.mass_kg = 1.0 / std::exp(size.log().mean());
  } else if (std::abs(slope - 2.0) < 0.2) {
    const Eigen::ArrayXd s2 = set.s.head(n).cwiseAbs2().array();
    point.low = LowLine::Stiffness;
    point.stiffness_n_per_m = std::exp((s2 / size).log().mean());
  }
}

DrivingPoint driving_point(const FrfSet& set, std::size_t index) {
  const Frf& frf = set.frfs[index];
  const double sign = orientation(frf);
  DrivingPoint point;
  point.frf = index;
  for (const Index i : peaks_of(frf)) {
    ++point.peaks;
    if (sign * frf.H(i).imag() < 0.0) ++point.wrong_peaks;
  }
  Index active = 0;
  for (Index i = 0; i < frf.H.size(); ++i) {
    if (!(std::abs(set.s(i)) > 0.0)) continue;
    const double real = sign * (frf.H(i) / set.s(i)).real();
    const double sd = std::sqrt(0.5 * frf.variance(i)) / std::abs(set.s(i));
    if (real < -3.0 * sd - 1e-9 * std::abs(frf.H(i) / set.s(i))) ++active;
  }
  point.active_share = static_cast<double>(active) /
                       static_cast<double>(std::max<Index>(1, frf.H.size()));
  find_low_line(set, frf, point);
  return point;
}

Reciprocal compared(const FrfSet& set, std::size_t i, std::size_t j) {
  const Frf& a = set.frfs[i];
  const Frf& b = set.frfs[j];
  const Eigen::VectorXcd one = orientation(a) * a.H;
  const Eigen::VectorXcd two = orientation(b) * b.H;
  const double norms = one.norm() * two.norm();
  Reciprocal result;
  result.frf = i;
  result.other = j;
  if (!(norms > 0.0)) return result;
  const Eigen::ArrayXd d2 = (one - two).cwiseAbs2().array();
  result.difference = std::sqrt(d2.sum() / norms);
  result.gain = two.dot(one).real() / two.squaredNorm();
  const Eigen::ArrayXd variance = (a.variance + b.variance).array();
  if (variance.size() > 0 && variance.minCoeff() > 0.0) {
    result.chi2 = (d2 / variance).mean();
  }
  return result;
}

}  // namespace

std::vector<DrivingPoint> driving_points(const FrfSet& set) {
  std::vector<DrivingPoint> result;
  for (std::size_t i = 0; i < set.frfs.size(); ++i) {
    if (same_place(set.frfs[i].response, set.frfs[i].reference)) {
      result.push_back(driving_point(set, i));
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
        result.push_back(compared(set, i, j));
      }
    }
  }
  return result;
}

std::optional<double> spread_at_peaks(const Frf& frf) {
  if (frf.hits < 2) return std::nullopt;
  double largest = 0.0;
  for (const Index i : peaks_of(frf)) {
    if (frf.coherence(i) > 0.0) {
      largest = std::max(largest, 1.0 / frf.coherence(i) - 1.0);
    }
  }
  return largest;
}

}  // namespace tapfit::signal
