#include "acquisition/hits/pulse_top.hpp"

#include "acquisition/samples/sinc_interpolation.hpp"
#include "acquisition/samples/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

constexpr Index few = 20;   // samples between the 50 % points
constexpr Index finer = 4;  // values per sample where there are few

// A pulse and what is beside it, at `per_sample` values a sample.
struct Surroundings {
  Eigen::VectorXd force;
  Index peak = 0;
  double per_sample = 1.0;

  [[nodiscard]] double at(double position) const {
    if (position < 0.0 || position >= static_cast<double>(force.size() - 1)) {
      return 0.0;
    }
    const auto i = static_cast<Index>(position);
    const double part = position - static_cast<double>(i);
    return (1.0 - part) * force[i] + part * force[i + 1];
  }
};

// Samples from the peak on in steps of 1 or -1 that stay above half of it.
Index above_half(const BaselineFree& force, Index peak, Index step) {
  Index i = peak;
  while (i + step >= 0 && i + step < force.size() &&
         force[i + step] > 0.5 * force[peak]) {
    i += step;
  }
  return std::abs(i - peak) + 1;
}

Surroundings surroundings(const BaselineFree& force, Index peak) {
  const Index width = above_half(force, peak, -1) + above_half(force, peak, 1);
  const Index reach = width + width / 2 + 6;
  const Index first = std::max<Index>(0, peak - reach);
  const Index last = std::min(force.size() - 1, peak + reach);
  Surroundings result;
  if (width < few) {
    constexpr Index context = 20;  // beyond what interpolation needs
    const Index begin = std::max<Index>(0, first - context);
    const Index end = std::min(force.size(), last + context + 1);
    result.force = interpolated(
        force.segment(begin, end - begin), first - begin, last - begin, finer);
    result.per_sample = static_cast<double>(finer);
  } else {
    result.force = force.segment(first, last - first + 1);
  }
  result.force.maxCoeff(&result.peak);
  return result;
}

struct Span {
  double from = 0.0;
  double to = 0.0;
  [[nodiscard]] double length() const { return to - from; }
};

// The outermost point on one side where the force crosses a level, within what
// stays above half the peak: ripple and dents are passed over.
double outermost(const Surroundings& of, double level, Index step) {
  const Eigen::VectorXd& x = of.force;
  const double half = 0.5 * x[of.peak];
  auto place = static_cast<double>(of.peak);
  for (Index i = of.peak; i + step >= 0 && i + step < x.size(); i += step) {
    if (x[i] >= level && x[i + step] < level) {
      const double part = (x[i] - level) / (x[i] - x[i + step]);
      place = static_cast<double>(i) + static_cast<double>(step) * part;
    }
    if (x[i + step] <= half) break;
  }
  return place;
}

Span above(const Surroundings& of, double share) {
  const double level = share * of.force[of.peak];
  return {outermost(of, level, -1), outermost(of, level, 1)};
}

// Of all polynomials p of degree 4 with |p| <= d / 2 within a run of length n
// Chebyshev's falls farthest f n beside it: (T4(1 + 2 f) + 1) / 2 times d.
double farthest_fall(double f) {
  const double x = 1.0 + 2.0 * f;
  const double square = x * x;
  return 0.5 * (8.0 * square * square - 8.0 * square + 2.0);
}

double corners(const Surroundings& of, double noise) {
  const double peak = of.force[of.peak];
  double most = 0.0;
  for (double depth = 0.003; depth < 0.06; depth *= 1.4) {
    if (depth * peak < 4.0 * noise) continue;
    const Span run = above(of, 1.0 - depth);
    for (const double beside : {0.1, 0.2, 0.35, 0.5}) {
      const double far = beside * run.length();
      if (far < of.per_sample) continue;
      const double fall =
          peak - std::max(of.at(run.from - far), of.at(run.to + far));
      most = std::max(most, fall / (farthest_fall(beside) * depth * peak));
    }
  }
  return most;
}

}  // namespace

PulseTop measure_top(const BaselineFree& force,
                     const Pulse& pulse,
                     double noise) {
  const Surroundings near = surroundings(force, pulse.peak);
  const Span half = above(near, 0.5);
  const Span high = above(near, 0.9);
  const auto from = static_cast<Index>(std::ceil(high.from));
  const auto to = static_cast<Index>(std::floor(high.to));
  PulseTop top;
  top.level = median(near.force.segment(from, to - from + 1));
  top.width = half.length() / near.per_sample;
  top.flatness = high.length() / std::max(half.length(), 1e-9);
  top.corners = corners(near, noise);
  return top;
}

double lost_force(double flatness) {
  // sin(theta) = c is where it is cut off; from there on it is above a share s
  // of the cut for pi - 2 asin(s c) of its phase.
  const double pi = std::numbers::pi;
  const auto share = [pi](double c) {
    return (pi - 2.0 * std::asin(0.9 * c)) / (pi - 2.0 * std::asin(0.5 * c));
  };
  double flat = 0.0;
  double whole = 1.0;
  constexpr int halvings = 30;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (flat + whole);
    (share(middle) > flatness ? flat : whole) = middle;
  }
  const double theta = std::asin(whole);
  const double left =
      2.0 * (1.0 - std::cos(theta)) + whole * (pi - 2.0 * theta);
  return 2.0 / left - 1.0;
}

}  // namespace tapfit::acquisition
