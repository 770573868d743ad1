#include "modal/checks/run_rate.hpp"

#include "modal/checks/frfs_by_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;

// Where the others are described to the last.
constexpr double share_left = 0.02;

// The lines that are lines of the other runs once they are scaled: beyond them
// there are modes that nobody knows.
signal::FrfSet known_lines(const signal::FrfSet& run, double ratio) {
  const auto w = run.s.imag();
  std::vector<Index> kept;
  for (Index l = 0; l < w.size(); ++l) {
    const bool known = w(l) >= ratio * w(0) && w(l) <= ratio * w(w.size() - 1);
    if (known) kept.push_back(l);
  }
  signal::FrfSet part;
  part.s = run.s(kept);
  for (const signal::Frf& frf : run.frfs) {
    signal::Frf& one = part.frfs.emplace_back();
    one = frf;
    one.H = VectorXcd(frf.H(kept));
    if (frf.variance.size() == frf.H.size()) {
      one.variance = Eigen::VectorXd(frf.variance(kept));
    }
  }
  return part;
}

// Those that lie on the lines.
VectorXcd within(const VectorXcd& s, const VectorXcd& poles) {
  std::vector<std::complex<double>> kept;
  for (const std::complex<double>& pole : poles) {
    const double w = pole.imag();
    if (w >= s(0).imag() && w <= s(s.size() - 1).imag()) kept.push_back(pole);
  }
  return VectorXcd::Map(kept.data(), static_cast<Index>(kept.size()));
}

}  // namespace

std::vector<double> rate_ratios() {
  constexpr std::array rates{44.1, 48.0, 50.0, 51.2, 64.0, 65.536};
  constexpr double most = 2.0;
  constexpr double same = 1e-6;
  std::vector<double> ratios;
  for (const double rate : rates) {
    for (const double other : rates) {
      for (double ratio = rate / other / 4.0; ratio <= most; ratio *= 2.0) {
        if (ratio < 1.0 / most || std::abs(ratio - 1.0) < same) continue;
        ratios.push_back(ratio);
      }
    }
  }
  std::ranges::sort(ratios);
  const auto repeated = std::ranges::unique(
      ratios, [](double a, double b) { return b - a < same * a; });
  ratios.erase(repeated.begin(), repeated.end());
  return ratios;
}

std::optional<double> rate_ratio(const signal::FrfSet& run,
                                 const VectorXcd& poles,
                                 double usual,
                                 const RunRateLimits& limits) {
  if (poles.size() == 0 || run.lines() == 0) return {};
  struct Tried {
    double ratio = 0.0;
    double left = 0.0;
    double as_it_is = 0.0;
  };
  std::vector<Tried> all;
  for (const double ratio : rate_ratios()) {
    const signal::FrfSet lines = known_lines(run, ratio);
    if (static_cast<double>(lines.lines()) <
        limits.share_of_lines * static_cast<double>(run.lines()))
      continue;
    const VectorXcd scaled = within(lines.s, ratio * poles);
    if (scaled.size() < limits.fewest_modes) continue;
    all.push_back({ratio,
                   left_by(scaled, lines),
                   left_by(within(lines.s, poles), lines)});
  }
  if (all.empty()) return {};
  const Tried best = *std::ranges::min_element(all, {}, &Tried::left);
  // Many poles close together explain anything, at any ratio.
  const bool alone = std::ranges::all_of(all, [&](const Tried& other) {
    return std::abs(std::log(other.ratio / best.ratio)) < limits.beside ||
           best.left < limits.alone * other.left;
  });
  if (!alone || best.left > limits.times_usual * usual + share_left ||
      best.left > limits.explained * best.as_it_is) {
    return {};
  }
  return best.ratio;
}

}  // namespace tapfit::modal
