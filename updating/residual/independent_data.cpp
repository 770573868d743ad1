#include "updating/residual/independent_data.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace tapfit::updating {

using Eigen::Index;

double effective_data(const Target& target) {
  if (target.is_modal()) {
    const Index values = std::max<Index>(target.H.cols() - 1, 1);
    return static_cast<double>(target.s.size() * values) + known_scatter;
  }
  // The transform on a damped line is smoothed by a Lorentzian of half width
  // sigma, whose equivalent width is pi sigma.
  double lines = 0.0;
  for (Index l = 0; l < target.s.size(); ++l) {
    const Index a = std::max<Index>(l - 1, 0);
    const Index b = std::min<Index>(l + 1, target.s.size() - 1);
    const double spacing = (target.s(b).imag() - target.s(a).imag()) /
                           static_cast<double>(std::max<Index>(b - a, 1));
    const double width = std::numbers::pi * target.s(l).real();
    lines += width > 0.0 ? std::min(1.0, spacing / width) : 1.0;
  }
  return 2.0 * lines *
         std::accumulate(target.use.begin(), target.use.end(), 0.0);
}

double residual_data(const Target& target, const Eigen::VectorXd& residual) {
  const double most = effective_data(target);
  const Index lines = target.s.size();
  if (residual.size() != 2 * lines * target.H.cols()) return most;
  // Column after column: real parts of an FRF, then its imaginary parts.
  const Eigen::Map<const Eigen::MatrixXd> r(
      residual.data(), 2 * lines, target.H.cols());
  Eigen::MatrixXcd R(lines, target.H.cols());
  R.real() = r.topRows(lines);
  R.imag() = r.bottomRows(lines);
  const Eigen::MatrixXcd gram = R.adjoint() * R;
  const double trace = gram.trace().real();
  if (trace <= 0.0) return most;
  const double frfs =
      std::accumulate(target.use.begin(), target.use.end(), 0.0);
  const double concentration = gram.squaredNorm() / (trace * trace) -
                               1.0 / static_cast<double>(lines) -
                               1.0 / std::max(frfs, 1.0);
  if (concentration <= 0.0) return most;
  return std::min(2.0 / (concentration * concentration), most);
}

double most_data(const Target& target) {
  const int modes = target.modes_in_band;
  const double all = effective_data(target);
  if (target.is_modal() || modes <= 0) return all;
  const double frfs =
      std::accumulate(target.use.begin(), target.use.end(), 0.0);
  return std::min(all, modes * (2.0 * frfs + 1.0));
}

double independent_data(const Target& target, const Eigen::VectorXd& residual) {
  const int modes = target.modes_in_band;
  const double most = most_data(target);
  if (target.is_modal()) return most;
  const double found = residual_data(target, residual);
  if (modes <= 0) return found;
  return std::clamp(found, std::min(4.0 * modes, most), most);
}

}  // namespace tapfit::updating
