#include "modal/fit/modal_fit.hpp"

#include "modal/fit/linear_fit.hpp"
#include "modal/fit/mode_significance.hpp"
#include "modal/fit/pole_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::modal {
namespace {

using Eigen::Index;

constexpr double at_rest = 1e-9;     // relative step of the poles
constexpr double no_gain = 1e-10;    // of the cost, far less than the noise
constexpr double most_damped = 1e4;  // in units of the normal matrix's diagonal

/// Poles moved by a step, each of them at most half of its way to where it
/// would have no damping or no frequency: one that heads there must not hold up
/// the others.
Eigen::VectorXcd moved(const Eigen::VectorXcd& poles,
                       const Eigen::VectorXd& step,
                       double sigma) {
  Eigen::VectorXcd result(poles.size());
  for (Index r = 0; r < poles.size(); ++r) {
    const double re = poles(r).real();
    const double im = poles(r).imag();
    result(r) = {std::min(re + step(2 * r), 0.5 * (re + sigma)),
                 std::max(im + step(2 * r + 1), 0.5 * im)};
  }
  return result;
}

ModalFit finish(const WeightedFrfs& curves,
                const Eigen::VectorXcd& poles,
                const LinearFit& linear) {
  const Index modes = poles.size();
  const Index terms = linear.scale.size() / 2 - modes;
  ModalFit fit;
  fit.poles = poles;
  fit.misfit = linear.misfit;
  fit.frf_weight = curves.weights.frf;
  fit.residues.resize(curves.count(), modes);
  fit.terms.resize(curves.count(), terms);
  for (Index c = 0; c < modes + terms; ++c) {
    Eigen::VectorXcd value(curves.count());
    value.real() = linear.coefficients.row(2 * c).transpose();
    value.imag() = linear.coefficients.row(2 * c + 1).transpose();
    value = value.cwiseQuotient(fit.frf_weight.cast<std::complex<double>>());
    if (c < modes) {
      fit.residues.col(c) = value;
    } else {
      fit.terms.col(c - modes) = value;
    }
  }
  judge_modes(curves, linear, fit);
  return fit;
}

}  // namespace

ModalFit fit_residues(const WeightedFrfs& curves,
                      const Eigen::VectorXcd& poles) {
  return finish(curves, poles, fit_linear(curves, poles));
}

ModalFit refine_poles(const WeightedFrfs& curves,
                      const Eigen::VectorXcd& start,
                      int iterations) {
  Eigen::VectorXcd poles = start;
  LinearFit linear = fit_linear(curves, poles);
  double mu = 1e-3;
  for (int i = 0; i < iterations && poles.size() > 0; ++i) {
    const PoleStep step = pole_step(curves, poles, linear);
    bool moved_on = false;
    double relative = 1.0;
    for (double factor = 10.0;
         mu < most_damped && relative > at_rest && !moved_on;
         mu *= factor, factor *= 10.0) {
      const Eigen::VectorXd x = damped_solve(step, mu);
      if (step.gradient.dot(x) < no_gain * linear.misfit) break;
      const Eigen::VectorXcd next = moved(poles, x, curves.sigma);
      if (!next.allFinite()) continue;
      relative =
          ((next - poles).array().abs() / poles.array().abs()).maxCoeff();
      LinearFit trial = fit_linear(curves, next);
      if (trial.misfit >= linear.misfit) continue;
      poles = next;
      linear = std::move(trial);
      moved_on = true;
      mu = std::max(0.1 * mu / factor, 1e-9);
    }
    if (!moved_on || relative < at_rest) break;
  }
  return finish(curves, poles, linear);
}

double relative_misfit(const WeightedFrfs& curves, const Eigen::MatrixXcd& H) {
  const auto& [v, u] = curves.weights;
  double left = 0.0;
  double all = 0.0;
  for (Index f = 0; f < curves.count(); ++f) {
    const auto measured = curves.H.col(f);
    left += u(f) * u(f) * v.cwiseProduct(measured - H.col(f)).squaredNorm();
    all += u(f) * u(f) * v.cwiseProduct(measured).squaredNorm();
  }
  return std::sqrt(left / all);
}

}  // namespace tapfit::modal
