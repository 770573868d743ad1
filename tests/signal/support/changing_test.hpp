// Tests of which something changes between hits: a channel's delay, or the
// structure itself.
#pragma once

#include "tests/signal/support/generated_structure.hpp"

#include <cmath>
#include <functional>
#include <numbers>

namespace tapfit::signal {

/// x later by so many samples, by band-limited interpolation under a Hann
/// window of 129 samples: exact to 1e-3 and better up to 0.4 of the rate.
inline Eigen::VectorXd later(const Eigen::VectorXd& x, double samples) {
  constexpr Eigen::Index reach = 64;
  Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double at = static_cast<double>(i) - samples;
    const auto middle = static_cast<Eigen::Index>(std::round(at));
    for (Eigen::Index j = middle - reach; j <= middle + reach; ++j) {
      if (j < 0 || j >= x.size()) continue;
      const double t = std::numbers::pi * (at - static_cast<double>(j));
      const double window = 0.5 + 0.5 * std::cos(t / (reach + 1.0));
      y(i) += x(j) * window * (std::abs(t) < 1e-12 ? 1.0 : std::sin(t) / t);
    }
  }
  return y;
}

/// First sample that belongs to a hit (from 0), half a lead before its pulse.
inline Eigen::Index begin_of(const GeneratedOptions& o, Eigen::Index hit) {
  return o.lead + hit * o.gap - o.lead / 2;
}

/// A channel of a run later by so many samples from a hit on.
inline void delay_from(GeneratedTest& test,
                       const GeneratedOptions& o,
                       std::size_t run,
                       Eigen::Index channel,
                       Eigen::Index hit,
                       double samples) {
  auto x = test.recordings[run].samples.col(channel);
  const Eigen::Index rest = x.size() - begin_of(o, hit);
  x.tail(rest) = later(x, samples).tail(rest).eval();
}

/// Every hit on the structure as it then is, each at rest when it is hit.
inline GeneratedTest changing_structure(
    const std::function<HungStructure(int hit)>& structure,
    const GeneratedOptions& o) {
  GeneratedTest test = generate_structure(structure(0), o);
  for (int k = 1; k < o.hits; ++k) {
    const GeneratedTest then = generate_structure(structure(k), o);
    for (std::size_t r = 0; r < test.recordings.size(); ++r) {
      auto& x = test.recordings[r].samples;
      const Eigen::Index rest = x.rows() - begin_of(o, k);
      x.bottomRows(rest) = then.recordings[r].samples.bottomRows(rest);
    }
  }
  return test;
}

}  // namespace tapfit::signal
