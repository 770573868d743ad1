// What a careful engineer's deck is wrong by in form, before anything is
// missing from it: no shear in the section, a corner that is a line, a clamp
// that is a row of grids. To first order the residual is
//
//   r = F e + n,   e_k ~ N(0, tau^2 + mu_k^2),   n ~ N(0, sigma^2 / N)
//
// with the patterns F of FrfModel::form_patterns(), so that it has the
// covariance 1 / g (I + g F S^2 F'), S^2 = diag(tau^2 + mu_k^2),
// g = N / sigma^2. mu is what the mesh still leaves, known from splitting it;
// sigma is what else is left, as a relative error; it and tau are estimated
// from the data, tau under a prior. Whether anything is missing at all is asked
// of forms no smaller than usual: mistakes of form are not independent from
// mode to mode, as the patterns are, and a corner that gives looks like a
// spring; what lies within a usual form is no evidence of anything else. Fits
// go to the least residual all the same: weighed by this covariance, properties
// that do to all modes what the form may do would be told by the curvature
// alone, and four times as many steps be needed. The covariance says how likely
// what they leave is, and how far it may have driven them. Sources: M. C.
// Kennedy, A. O'Hagan, "Bayesian calibration of computer models", J. Royal
// Statistical Society B 63, 2001; E. Simoen, G. De Roeck, G. Lombaert, "Dealing
// with uncertainty in model updating for damage assessment", MSSP 56-57, 2015.
#pragma once

#include <Eigen/Core>

namespace tapfit::updating {

/// A careful deck's modal stiffness is off by 0.6 % in the middle (frequencies
/// by 0.3 %), and in two cases of three by 0.2 to 1.8 %.
inline constexpr double middle_tau = 6e-3;

/// Patterns of stack() that the form may add.
struct FormError {
  Eigen::MatrixXd F;        ///< rows of stack() x k
  Eigen::VectorXd mesh_sd;  ///< k: mu, see FormPatterns
};

/// How a fit's parameters may still move the residual, to first order: a fit to
/// the least residual is not where the likelihood is largest.
struct Readjustment {
  Eigen::MatrixXd J;  ///< d r / d theta; zero where theta may not move
  Eigen::MatrixXd information;  ///< of the prior, half its cost's curvature
  Eigen::VectorXd pull;         ///< half its slope; zero as well
};

/// A residual seen in the patterns: all that its likelihood needs.
struct FormView {
  Eigen::MatrixXd patterns;  ///< F' F
  Eigen::VectorXd mesh_sd;
  Eigen::VectorXd along;  ///< F' r
  double whole = 0.0;     ///< r' r
  Eigen::MatrixXd moved;  ///< F' J
  Eigen::MatrixXd gram;   ///< J' J
  Eigen::VectorXd slope;  ///< J' r
  Eigen::MatrixXd information = {};
  Eigen::VectorXd pull = {};
  double allowance = 1.0;  ///< times what a careful deck is wrong by in form

  [[nodiscard]] bool has_patterns() const { return along.size() > 0; }
};

[[nodiscard]] FormView view(const FormError& form,
                            const Eigen::VectorXd& r,
                            const Readjustment& fit);

/// What the data say of tau and sigma.
struct FormEstimate {
  /// Log of the probability of the residual, tau summed over, sigma at its
  /// likeliest for each tau.
  double log_likelihood = 0.0;
  /// The same of tau no less than middle_tau times the allowance.
  double log_likelihood_if_usual = 0.0;
  double tau = 0.0;  ///< relative, of a modal stiffness: twice a frequency's
  /// Root of the mean of tau^2: more where the data leave it open.
  double mean_tau = 0.0;
  double sigma = 0.0;  ///< relative FRF error beside the form's
  /// d theta, from the least residual to the largest likelihood.
  Eigen::VectorXd step = {};
  double left = 0.0;  ///< relative error without what the form explains
};

/// @param data N, independent data in the residual
/// @param noise relative error from the hits' scatter: sigma is no less
[[nodiscard]] FormEstimate estimate_form(const FormView& view,
                                         double data,
                                         double noise);

}  // namespace tapfit::updating
