#include "signal/frf_set/kept_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace tapfit::signal {
namespace {

using Eigen::Index;

// q^2 of every line.
Eigen::ArrayXd noise_of(const FrfSet& set) {
  Eigen::ArrayXd noise = Eigen::ArrayXd::Zero(set.lines());
  Eigen::ArrayXd all = Eigen::ArrayXd::Zero(set.lines());
  for (const Frf& frf : set.frfs) {
    noise += frf.variance.array();
    all += frf.H.array().abs2();
  }
  return noise / all.max(1e-300);
}

}  // namespace

void keep_lines(const std::vector<Index>& keep, FrfSet& set) {
  set.s = set.s(keep).eval();
  for (Frf& frf : set.frfs) {
    frf.H = frf.H(keep).eval();
    frf.coherence = frf.coherence(keep).eval();
    frf.variance = frf.variance(keep).eval();
    if (frf.change_with_level.size() > 0) {
      frf.change_with_level = frf.change_with_level(keep).eval();
    }
  }
}

std::string leave_out_noisy_lines(FrfSet& set) {
  constexpr double of_models = 0.01;
  const Eigen::ArrayXd noise = noise_of(set);
  std::vector<Index> order(static_cast<std::size_t>(set.lines()));
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, {}, [&](Index l) { return noise(l); });
  double sum = 0.0;
  std::size_t kept = 0;
  for (; kept < order.size(); ++kept) {
    const double own = noise(order[kept]) + of_models;
    if (own * static_cast<double>(kept) > 2.0 * sum) break;
    sum += own;
  }
  if (kept == order.size() || 2 * kept < order.size()) return {};
  const auto noisy = order.begin() + static_cast<std::ptrdiff_t>(kept);
  std::sort(order.begin(), noisy);
  std::sort(noisy, order.end());
  const Eigen::VectorXd hz = set.frequency_hz();
  const std::size_t left = order.size() - kept;
  const std::string where =
      left == 1
          ? fmt::format("{:.4g} Hz", hz(*noisy))
          : fmt::format("{:.4g} to {:.4g} Hz", hz(*noisy), hz(order.back()));
  std::string said = fmt::format(
      "{} of {} lines ({}) {} left out of fits: the noise there is more than a "
      "tenth of what is measured",
      left,
      order.size(),
      where,
      left == 1 ? "is" : "are");
  order.resize(kept);
  keep_lines(order, set);
  return said;
}

}  // namespace tapfit::signal
