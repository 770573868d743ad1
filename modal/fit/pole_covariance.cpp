#include "modal/fit/pole_covariance.hpp"

#include "modal/fit/linear_fit.hpp"
#include "modal/fit/pole_step.hpp"
#include "modal/poles/fit_columns.hpp"

#include <Eigen/Dense>

namespace tapfit::modal {
Eigen::MatrixXd pole_covariance(const WeightedFrfs& curves,
                                const ModalFit& fit,
                                NoiseFrom from) {
  if (fit.poles.size() == 0) return {};
  return pole_covariance(curves, fit, weighted_noise(curves, fit, from));
}

Eigen::MatrixXd pole_covariance(const WeightedFrfs& curves,
                                const ModalFit& fit,
                                const Noise& noise) {
  const Eigen::Index modes = fit.poles.size();
  if (modes == 0) return {};
  const LinearFit linear = fit_linear(curves, fit.poles);
  const PoleStep step = pole_step(curves, fit.poles, linear);
  const Eigen::MatrixXcd X =
      noise.per_line.asDiagonal() *
      unstack(projected_derivatives(curves, fit.poles, linear));
  const Eigen::MatrixXd V = correlated_gram(X, curves.sigma / curves.spacing);
  const Eigen::MatrixXd middle =
      with_residues(V, linear, noise_at_modes(noise, X));
  const Eigen::VectorXd d =
      step.normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  Eigen::MatrixXd N = d.asDiagonal() * step.normal * d.asDiagonal();
  N.diagonal().array() += 1e-14;
  const Eigen::MatrixXd inverse =
      d.asDiagonal() *
      N.ldlt().solve(Eigen::MatrixXd::Identity(2 * modes, 2 * modes)) *
      d.asDiagonal();
  return inverse * middle * inverse.transpose();
}

}  // namespace tapfit::modal
