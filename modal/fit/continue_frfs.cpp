#include "modal/fit/continue_frfs.hpp"

#include "modal/fit/fit_residual.hpp"
#include "modal/fit/modal_fit.hpp"
#include "modal/poles/fit_columns.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// Weights of a piecewise linear function's values in Poisson's integral.
class PoissonWeights {
 public:
  explicit PoissonWeights(const VectorXd& omega) : omega_(omega) {}

  // @param sigma distance from the measured line, above 0
  [[nodiscard]] VectorXd at(double sigma, double omega) const {
    VectorXd weight = VectorXd::Zero(omega_.size());
    for (Index k = 0; k + 1 < omega_.size(); ++k) {
      const double from = omega_(k) - omega;
      const double to = omega_(k + 1) - omega;
      const double h = to - from;
      const double area =
          (std::atan(to / sigma) - std::atan(from / sigma)) / std::numbers::pi;
      const double moment =
          sigma / (2.0 * std::numbers::pi) *
          std::log((sigma * sigma + to * to) / (sigma * sigma + from * from));
      weight(k) += (to * area - moment) / h;
      weight(k + 1) += (moment - from * area) / h;
    }
    return weight;
  }

  // On the measured line itself: linear interpolation.
  [[nodiscard]] VectorXd between(double omega) const {
    VectorXd weight = VectorXd::Zero(omega_.size());
    const Index last = omega_.size() - 1;
    const auto* above =
        std::lower_bound(omega_.data(), omega_.data() + last, omega);
    const Index k = std::max<Index>(above - omega_.data(), 1);
    const double part = std::clamp(
        (omega - omega_(k - 1)) / (omega_(k) - omega_(k - 1)), 0.0, 1.0);
    weight(k - 1) = 1.0 - part;
    weight(k) = part;
    return weight;
  }

 private:
  VectorXd omega_;
};

// Residues of the poles and residual terms, as functions of s.
MatrixXcd model_at(const ModalFit& fit,
                   const VectorXcd& s,
                   const VectorXcd& band) {
  const MatrixXcd poles = pole_columns(s, fit.poles, 1);
  MatrixXcd H = residual_basis(s, band) * fit.terms.transpose();
  for (Index r = 0; r < fit.poles.size(); ++r) {
    H += poles.col(2 * r) * fit.residues.col(r).real().transpose() +
         poles.col(2 * r + 1) * fit.residues.col(r).imag().transpose();
  }
  return H;
}

// Each pole once, however many modes share it.
VectorXcd poles_of(const ModeSet& modes) {
  std::vector<std::complex<double>> poles;
  for (const Mode& mode : modes.modes) {
    const bool repeated = std::ranges::find(poles, mode.pole) != poles.end();
    if (!repeated) poles.push_back(mode.pole);
  }
  return Eigen::Map<VectorXcd>(poles.data(), static_cast<Index>(poles.size()));
}

}  // namespace

signal::FrfSet continue_frfs(const signal::FrfSet& frfs,
                             const ModeSet& modes,
                             const VectorXcd& s) {
  signal::FrfSet result;
  result.s = s;
  result.statements = frfs.statements;
  const WeightedFrfs curves = prepare_frfs(frfs, result.statements);
  const ModalFit fit = fit_residues(curves, poles_of(modes));
  const MatrixXcd left = curves.H - fitted_accelerance(curves, fit);
  const MatrixXd variance = curves.variance.cwiseMax(left.cwiseAbs2());
  const PoissonWeights poisson(curves.s.imag());
  MatrixXcd H = model_at(fit, s, curves.s);
  MatrixXd H_variance(H.rows(), H.cols());
  for (Index l = 0; l < s.size(); ++l) {
    const double sigma = s(l).real() - curves.sigma;
    const bool inside = sigma > 1e-9 * std::abs(s(l));
    const VectorXd own =
        inside ? poisson.at(sigma, s(l).imag()) : poisson.between(s(l).imag());
    const VectorXd mirrored =
        inside ? poisson.at(sigma, -s(l).imag()) : VectorXd::Zero(own.size());
    H.row(l) +=
        own.transpose() * left + mirrored.transpose() * left.conjugate();
    H_variance.row(l) = own.cwiseAbs2().transpose() * variance;
  }
  for (Index c = 0; c < curves.count(); ++c) {
    const std::size_t source = curves.source[static_cast<std::size_t>(c)];
    signal::Frf frf = frfs.frfs[source];
    const double sign = frf.response.sign * frf.reference.sign;
    VectorXd coherence(s.size());
    for (Index l = 0; l < s.size(); ++l) {
      Index nearest = 0;
      (frfs.s.imag().array() - s(l).imag()).abs().minCoeff(&nearest);
      coherence(l) = frf.coherence(nearest);
    }
    frf.H = sign * H.col(c);
    frf.variance = H_variance.col(c);
    frf.coherence = coherence;
    result.frfs.push_back(std::move(frf));
  }
  return result;
}

}  // namespace tapfit::modal
