#include "signal/estimate/frf_variance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapfit::signal {
namespace {

using Eigen::Index;

// The noise before one hit is known from a spectrum of so many degrees of
// freedom: a triangle over +-24 bins of a Hann window.
constexpr double of_one_hit = 38.0;
// Lines that are averaged over, in bandwidths to either side, times m - 1; and
// how many degrees of freedom come together that way.
constexpr double reach_of_hits = 12.0;
constexpr double of_hits = 24.0;

// How often P's shape is mended: each time it follows R more closely, and the
// third moves it little.
constexpr int shape_passes = 3;

// Scatter over hits per line, R. The difference of the sums is known to their
// rounding, 1e-16 of |Y|^2.
Eigen::VectorXd scatter(const CrossPowers& powers, const Eigen::VectorXcd& H) {
  const double free = static_cast<double>(powers.hits - 1);
  const Eigen::ArrayXd cross =
      (H.conjugate().array() * powers.Gyf.array()).real();
  return ((powers.Gyy.array() - 2.0 * cross +
           H.array().abs2() * powers.Gff.array())
              .max(0.0) /
          free)
      .matrix();
}

// Share b of the response that does not repeat, by least squares of
// R = N + b q over the lines, weighted with the inverse square of what R is
// expected to be.
double repeatability(const Eigen::VectorXd& R,
                     const Eigen::VectorXd& N,
                     const Eigen::VectorXd& q) {
  double b = 0.0;
  for (int pass = 0; pass < 4; ++pass) {
    double top = 0.0;
    double bottom = 0.0;
    for (Index i = 0; i < R.size(); ++i) {
      const double expected = N(i) + std::max(b, 1e-12) * q(i);
      if (!(expected > 0.0) || !(q(i) > 0.0)) continue;
      const double share = q(i) / expected;
      top += (R(i) - N(i)) / expected * share;
      bottom += share * share;
    }
    b = bottom > 0.0 ? std::max(0.0, top / bottom) : 0.0;
  }
  return b;
}

// Averaged with triangular weights over the lines within reach; at the band's
// ends, where one side is missing, the other one reaches further.
Eigen::VectorXd local_average(const Eigen::VectorXd& omega,
                              const Eigen::VectorXd& value,
                              const Eigen::VectorXd& reach) {
  Eigen::VectorXd result(value.size());
  const double low = omega.minCoeff();
  const double high = omega.maxCoeff();
  for (Index i = 0; i < value.size(); ++i) {
    const double edge = std::min(omega(i) - low, high - omega(i));
    const double width = reach(i) + std::max(0.0, reach(i) - edge);
    double sum = value(i);
    double weights = 1.0;
    const auto add = [&](Index j) {
      const double w = 1.0 - std::abs(omega(j) - omega(i)) / width;
      if (w <= 0.0) return false;
      sum += w * value(j);
      weights += w;
      return true;
    };
    for (Index j = i + 1; j < value.size() && add(j); ++j) {
    }
    for (Index j = i - 1; j >= 0 && add(j); --j) {
    }
    result(i) = sum / weights;
  }
  return result;
}

}  // namespace

Eigen::VectorXd frf_variance(const Eigen::VectorXcd& s,
                             const CrossPowers& powers,
                             const Eigen::VectorXcd& H,
                             const LineNoise& noise) {
  const double hits = static_cast<double>(powers.hits);
  const Eigen::VectorXd& Gff = powers.Gff;
  const Eigen::VectorXd q =
      H.cwiseAbs2().cwiseProduct(Gff) / hits;  // |Y|^2 per hit
  Eigen::VectorXd P = noise.response + H.cwiseAbs2().cwiseProduct(noise.force);
  // Data without any noise still carries rounding.
  P.array() += 1e-24 * (q.array() + q.mean());
  Eigen::VectorXd R = P;
  if (powers.hits > 1) {
    const Eigen::VectorXd measured = scatter(powers, H);
    P += repeatability(measured, P, q) * q;
    P.array() += std::numeric_limits<double>::min();
    const Eigen::VectorXd reach =
        (reach_of_hits / (hits - 1.0) * noise.bandwidth)
            .cwiseMax(noise.bandwidth);
    const auto averaged = [&](const Eigen::VectorXd& value) {
      return local_average(s.imag(), value, reach);
    };
    constexpr double least = 1e-12;
    for (int pass = 0; pass < shape_passes; ++pass) {
      const Eigen::VectorXd logs =
          measured.cwiseQuotient(P).cwiseMax(least).array().log();
      P = P.cwiseProduct(averaged(logs).array().exp().matrix());
    }
    R = P.cwiseProduct(averaged(measured.cwiseQuotient(P)));
  }
  Eigen::VectorXd variance(H.size());
  for (Index i = 0; i < H.size(); ++i)
    variance(i) = Gff(i) > 0.0 ? R(i) / Gff(i) : 0.0;
  const double floor = 1e-24 * H.cwiseAbs2().maxCoeff();
  return variance.cwiseMax(floor + std::numeric_limits<double>::min());
}

double variance_freedom(int hits) {
  if (hits < 2) return of_one_hit;
  return of_hits * std::max(1.0, (hits - 1) / reach_of_hits);
}

}  // namespace tapfit::signal
