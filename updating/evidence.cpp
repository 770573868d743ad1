#include "updating/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

namespace tapfit::updating {

double evidence_data(const Target& target,
                     const Eigen::VectorXd& residual,
                     int modes_in_band) {
  const double frfs =
      std::accumulate(target.use.begin(), target.use.end(), 0.0);
  const double modes = std::max(1, modes_in_band);
  const double most = std::min(effective_data(target), 2.0 * frfs * modes);
  const Eigen::Index lines = target.s.size();
  if (residual.size() != 2 * lines * target.H.cols()) return most;
  // Column after column: real parts of an FRF, then its imaginary parts.
  const Eigen::Map<const Eigen::MatrixXd> r(
      residual.data(), 2 * lines, target.H.cols());
  const Eigen::MatrixXcd R =
      r.topRows(lines) +
      std::complex<double>(0.0, 1.0) *
          r.bottomRows(lines).cast<std::complex<double>>();
  const Eigen::MatrixXcd gram = R.adjoint() * R;
  const double trace = gram.trace().real();
  if (trace <= 0.0) return most;
  const double concentration =
      gram.squaredNorm() / (trace * trace) -
      1.0 / static_cast<double>(lines) - 1.0 / std::max(frfs, 1.0);
  if (concentration <= 0.0) return most;
  return std::clamp(2.0 / (concentration * concentration),
                    std::min(4.0 * modes, most),
                    most);
}

double log_evidence(double error,
                    double parameters,
                    double places,
                    double data) {
  const double misfit = std::max(error * error, 1e-30);
  return -0.5 * data * std::log(misfit) - 0.5 * parameters * std::log(data) -
         std::log(std::max(places, 1.0));
}

std::vector<double> probabilities(const std::vector<double>& log_evidences) {
  if (log_evidences.empty()) return {};
  const double top =
      *std::max_element(log_evidences.begin(), log_evidences.end());
  std::vector<double> p;
  double sum = 0.0;
  for (const double e : log_evidences) {
    p.push_back(std::exp(e - top));
    sum += p.back();
  }
  for (double& x : p) x /= sum;
  return p;
}

}  // namespace tapfit::updating
