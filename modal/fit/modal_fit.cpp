#include "modal/fit/modal_fit.hpp"

#include "modal/fit/fit_columns.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double kAtRest = 1e-9;     // relative step of the poles
constexpr double kNoGain = 1e-10;    // of the cost, far less than the noise
constexpr double kMostDamped = 1e4;  // in units of the normal matrix's diagonal

/// Separable weights nearest to w_f(k): mean logarithms over lines and FRFs.
void separate_weights(const Curves& curves, ModalFit& fit) {
  const Eigen::MatrixXd logs = curves.weight.array().log();
  const Eigen::VectorXd per_frf = logs.colwise().mean().transpose();
  const double mean = per_frf.mean();
  fit.frf_weight = per_frf.array().exp();
  fit.line_weight = (logs.rowwise().mean().array() - mean).exp();
}

/// Measured FRFs by line weight, 2 n_lines x n_frfs.
Eigen::MatrixXd weighted_frfs(const Curves& curves, const ModalFit& weights) {
  return stack(weights.line_weight.asDiagonal() * curves.H);
}

/// The linear problem for given poles: weighted, columns of unit length.
struct Linear {
  Eigen::MatrixXd Q;             ///< 2 n_lines x n_columns, orthonormal
  Eigen::MatrixXd R;             ///< upper triangular
  Eigen::VectorXd scale;         ///< length of each column before scaling
  Eigen::MatrixXd residual;      ///< weighted by v and u, 2 n_lines x n_frfs
  Eigen::MatrixXd coefficients;  ///< n_columns x n_frfs
  double cost = 0.0;
};

/// Q R = phi, by Cholesky's factor of phi' phi, twice for orthogonality to
/// rounding (Y. Yamamoto, Y. Nakatsukasa, Y. Yanagisawa, T. Fukaya, ETNA 44,
/// 2015, p. 306): products of matrices, where Householder's reflections go over
/// the columns one by one. Columns too alike for it are left to those.
void orthogonalise(Eigen::MatrixXd phi, Linear& linear) {
  constexpr double alike = 1e-12;  // condition 1e6, squared
  const Index n = phi.cols();
  linear.R.setIdentity(n, n);
  for (int pass = 0; pass < 2; ++pass) {
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(n, n);
    gram.selfadjointView<Eigen::Lower>().rankUpdate(phi.transpose());
    const Eigen::LLT<Eigen::MatrixXd> factor(gram);
    if (factor.info() != Eigen::Success || factor.rcond() < alike) {
      const Eigen::HouseholderQR<Eigen::MatrixXd> qr(phi);
      linear.Q = qr.householderQ() * Eigen::MatrixXd::Identity(phi.rows(), n);
      linear.R =
          qr.matrixQR().topRows(n).triangularView<Eigen::Upper>() * linear.R;
      return;
    }
    factor.matrixU().solveInPlace<Eigen::OnTheRight>(phi);
    linear.R = factor.matrixU() * linear.R;
  }
  linear.Q = std::move(phi);
}

Linear solve_linear(const Curves& curves,
                    const Eigen::MatrixXd& y,
                    const Eigen::VectorXcd& poles,
                    const ModalFit& weights,
                    Eigen::MatrixXcd& columns) {
  const Eigen::MatrixXcd terms =
      term_columns(residual_basis(curves.s, curves.s));
  const Eigen::MatrixXcd modes = pole_columns(curves.s, poles, 1);
  columns.resize(curves.lines(), modes.cols() + terms.cols());
  columns << modes, terms;
  Linear linear;
  Eigen::MatrixXd phi = stack(weights.line_weight.asDiagonal() * columns);
  linear.scale = phi.colwise().norm().transpose().cwiseMax(1e-300);
  phi = phi * linear.scale.cwiseInverse().asDiagonal();
  orthogonalise(std::move(phi), linear);
  // A diagonal of zero would be two equal columns.
  for (Index c = 0; c < linear.R.cols(); ++c) {
    if (std::abs(linear.R(c, c)) < 1e-12) linear.R(c, c) = 1e-12;
  }
  const Eigen::MatrixXd Qy = linear.Q.transpose() * y;
  linear.coefficients = linear.scale.cwiseInverse().asDiagonal() *
                        linear.R.triangularView<Eigen::Upper>().solve(Qy);
  linear.residual = (y - linear.Q * Qy) * weights.frf_weight.asDiagonal();
  linear.cost = linear.residual.squaredNorm();
  return linear;
}

/// Derivatives of the fitted functions to each pole's real and imaginary part
/// for unit Re R and Im R, projected off the linear columns.
Eigen::MatrixXd projected_derivatives(const Curves& curves,
                                      const Eigen::VectorXcd& poles,
                                      const ModalFit& weights,
                                      const Linear& linear) {
  const Eigen::MatrixXd E = stack(weights.line_weight.asDiagonal() *
                                  pole_columns(curves.s, poles, 2));
  return E - linear.Q * (linear.Q.transpose() * E);
}

/// sum_f w_f^2 C_f' G C_f, where C_f turns the derivatives E to unit residues
/// into those to (Re, Im lambda): C_f multiplies mode r by its residue c_fr. A
/// 2 x 2 block of G maps z to g z + h conj(z), so that its product maps z to
/// sum conj(c_r) c_q g z + sum conj(c_r c_q) h conj(z).
///
/// @param weight w of each FRF, where it differs also by mode: n_frfs x n_modes
Eigen::MatrixXd with_residues(const Eigen::MatrixXd& G,
                              const Linear& linear,
                              const Eigen::MatrixXd& weight) {
  const Index modes = G.cols() / 2;
  Eigen::MatrixXcd c(weight.rows(), modes);
  for (Index r = 0; r < modes; ++r) {
    c.col(r).real() = linear.coefficients.row(2 * r).transpose();
    c.col(r).imag() = linear.coefficients.row(2 * r + 1).transpose();
  }
  c = c.cwiseProduct(weight);
  const Eigen::MatrixXcd same = c.adjoint() * c;
  const Eigen::MatrixXcd other = c.adjoint() * c.conjugate();
  Eigen::MatrixXd result(G.rows(), G.cols());
  for (Index r = 0; r < modes; ++r) {
    for (Index q = 0; q < modes; ++q) {
      const Eigen::Matrix2d B = G.block<2, 2>(2 * r, 2 * q);
      const Complex g = 0.5 * Complex(B(0, 0) + B(1, 1), B(1, 0) - B(0, 1));
      const Complex h = 0.5 * Complex(B(0, 0) - B(1, 1), B(1, 0) + B(0, 1));
      const Complex u = same(r, q) * g;
      const Complex v = other(r, q) * h;
      result.block<2, 2>(2 * r, 2 * q) << (u + v).real(), (v - u).imag(),
          (u + v).imag(), (u - v).real();
    }
  }
  return result;
}

/// sum_f w_f C_f' x_f for the columns x_f.
Eigen::VectorXd along_residues(const Eigen::MatrixXd& x,
                               const Linear& linear,
                               const Eigen::VectorXd& weight) {
  Eigen::VectorXd result(x.rows());
  for (Index r = 0; r < x.rows() / 2; ++r) {
    const Eigen::RowVectorXd re =
        linear.coefficients.row(2 * r).cwiseProduct(weight.transpose());
    const Eigen::RowVectorXd im =
        linear.coefficients.row(2 * r + 1).cwiseProduct(weight.transpose());
    result(2 * r) = re.dot(x.row(2 * r)) + im.dot(x.row(2 * r + 1));
    result(2 * r + 1) = re.dot(x.row(2 * r + 1)) - im.dot(x.row(2 * r));
  }
  return result;
}

struct Step {
  Eigen::MatrixXd normal;
  Eigen::VectorXd gradient;
};

Step gauss_newton(const Eigen::MatrixXd& E,
                  const Linear& linear,
                  const Eigen::VectorXd& frf_weight) {
  return {with_residues(
              E.transpose() * E, linear, frf_weight.replicate(1, E.cols() / 2)),
          along_residues(E.transpose() * linear.residual, linear, frf_weight)};
}

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

/// Solves (N + mu diag N) x = g in units of the diagonal.
Eigen::VectorXd damped_solve(const Step& step, double mu) {
  const Eigen::VectorXd d = step.normal.diagonal().cwiseMax(1e-300).cwiseSqrt();
  Eigen::MatrixXd N = d.cwiseInverse().asDiagonal() * step.normal *
                      d.cwiseInverse().asDiagonal();
  N.diagonal().array() += mu + 1e-14;
  const Eigen::VectorXd g = step.gradient.cwiseQuotient(d);
  return N.ldlt().solve(g).cwiseQuotient(d);
}

double mean_square_near(const Eigen::MatrixXd& residual,
                        Index lines,
                        Index begin,
                        Index end) {
  const Index n = end - begin;
  return (residual.middleRows(begin, n).squaredNorm() +
          residual.middleRows(lines + begin, n).squaredNorm()) /
         static_cast<double>(2 * n * residual.cols());
}

/// Lines within a few half bandwidths of a pole: begin, end.
std::pair<Index, Index> around(const Curves& curves, const Complex& pole) {
  const double half =
      std::max(3.0 * (curves.sigma - pole.real()), 6.0 * curves.spacing);
  const double first = curves.s(0).imag();
  const auto index = [&](double omega) {
    const double k = std::round((omega - first) / curves.spacing);
    return static_cast<Index>(
        std::clamp(k, 0.0, static_cast<double>(curves.lines() - 1)));
  };
  const Index last = curves.lines() - 1;
  Index begin = index(pole.imag() - half);
  Index end = index(pole.imag() + half);
  begin = std::min(begin, std::max<Index>(0, last - 6));
  end = std::max(end, std::min<Index>(last, 6));
  return {begin, end + 1};
}

/// Fills what is said about each mode from the solved linear problem.
void judge_modes(const Curves& curves, const Linear& linear, ModalFit& fit) {
  const Index modes = fit.poles.size();
  const Index n = linear.R.cols();
  const Eigen::MatrixXd Rinv = linear.R.triangularView<Eigen::Upper>().solve(
      Eigen::MatrixXd::Identity(n, n));
  fit.significance.resize(modes);
  fit.contribution.resize(modes);
  // An exponential window spreads noise over about sigma T lines, in the very
  // form of a resonance.
  const double shared =
      std::max(1.0, 2.0 * std::numbers::pi * curves.sigma / curves.spacing);
  for (Index r = 0; r < modes; ++r) {
    const Eigen::MatrixXd rows = Rinv.middleRows(2 * r, 2);
    const Eigen::Matrix2d inverse = (rows * rows.transpose()).inverse();
    double drop = 0.0;
    for (Index f = 0; f < curves.count(); ++f) {
      const Eigen::Vector2d c =
          fit.frf_weight(f) * linear.scale.segment<2>(2 * r).cwiseProduct(
                                  linear.coefficients.block<2, 1>(2 * r, f));
      drop += c.dot(inverse * c);
    }
    const auto [begin, end] = around(curves, fit.poles(r));
    const double noise =
        mean_square_near(linear.residual, curves.lines(), begin, end);
    fit.significance(r) = drop / static_cast<double>(2 * curves.count()) /
                          std::max(shared * noise, 1e-300);
    const Complex s(curves.sigma, fit.poles(r).imag());
    const Eigen::VectorXd peak = fit.residues.col(r).cwiseAbs() *
                                 (std::norm(s) / std::abs(s - fit.poles(r)));
    const Index line = std::clamp((begin + end - 1) / 2, begin, end - 1);
    const Eigen::VectorXd level = curves.H.row(line).cwiseAbs().transpose();
    fit.contribution(r) =
        peak.cwiseProduct(fit.frf_weight).norm() /
        std::max(level.cwiseProduct(fit.frf_weight).norm(), 1e-300);
  }
}

ModalFit finish(const Curves& curves,
                const Eigen::MatrixXd& y,
                const Eigen::VectorXcd& poles,
                ModalFit fit) {
  Eigen::MatrixXcd columns;
  const Linear linear = solve_linear(curves, y, poles, fit, columns);
  const Index modes = poles.size();
  const Index terms = columns.cols() / 2 - modes;
  fit.poles = poles;
  fit.residues.resize(curves.count(), modes);
  fit.terms.resize(curves.count(), terms);
  for (Index c = 0; c < modes + terms; ++c) {
    Eigen::VectorXcd value(curves.count());
    value.real() = linear.coefficients.row(2 * c).transpose();
    value.imag() = linear.coefficients.row(2 * c + 1).transpose();
    if (c < modes) {
      fit.residues.col(c) = value;
    } else {
      fit.terms.col(c - modes) = value;
    }
  }
  fit.H = columns * linear.coefficients.cast<Complex>();
  fit.leverage = 0.5 * unstack(linear.Q).rowwise().squaredNorm();
  judge_modes(curves, linear, fit);
  return fit;
}

}  // namespace

ModalFit fit_residues(const Curves& curves, const Eigen::VectorXcd& poles) {
  ModalFit fit;
  separate_weights(curves, fit);
  return finish(curves, weighted_frfs(curves, fit), poles, fit);
}

ModalFit refine_poles(const Curves& curves,
                      const Eigen::VectorXcd& start,
                      int iterations) {
  ModalFit fit;
  separate_weights(curves, fit);
  const Eigen::MatrixXd y = weighted_frfs(curves, fit);
  Eigen::VectorXcd poles = start;
  Eigen::MatrixXcd columns;
  Linear linear = solve_linear(curves, y, poles, fit, columns);
  double mu = 1e-3;
  for (int i = 0; i < iterations && poles.size() > 0; ++i) {
    const Eigen::MatrixXd E = projected_derivatives(curves, poles, fit, linear);
    const Step step = gauss_newton(E, linear, fit.frf_weight);
    bool moved_on = false;
    double relative = 1.0;
    for (double factor = 10.0;
         mu < kMostDamped && relative > kAtRest && !moved_on;
         mu *= factor, factor *= 10.0) {
      const Eigen::VectorXd x = damped_solve(step, mu);
      if (step.gradient.dot(x) < kNoGain * linear.cost) break;
      const Eigen::VectorXcd next = moved(poles, x, curves.sigma);
      if (!next.allFinite()) continue;
      relative =
          ((next - poles).array().abs() / poles.array().abs()).maxCoeff();
      Linear trial = solve_linear(curves, y, next, fit, columns);
      if (trial.cost >= linear.cost) continue;
      poles = next;
      linear = std::move(trial);
      moved_on = true;
      mu = std::max(0.1 * mu / factor, 1e-9);
    }
    if (!moved_on || relative < kAtRest) break;
  }
  return finish(curves, y, poles, fit);
}

double relative_misfit(const Curves& curves, const Eigen::MatrixXcd& H) {
  ModalFit fit;
  separate_weights(curves, fit);
  const auto size = [&fit](const Eigen::MatrixXcd& X) {
    return (fit.line_weight.asDiagonal() * X * fit.frf_weight.asDiagonal())
        .norm();
  };
  return size(curves.H - H) / size(curves.H);
}

Eigen::MatrixXd pole_covariance(const Curves& curves,
                                const ModalFit& fit,
                                NoiseFrom from) {
  const Index modes = fit.poles.size();
  if (modes == 0) return {};
  Eigen::MatrixXcd columns;
  const Linear linear =
      solve_linear(curves, weighted_frfs(curves, fit), fit.poles, fit, columns);
  const Eigen::MatrixXd E =
      projected_derivatives(curves, fit.poles, fit, linear);
  const Step step = gauss_newton(E, linear, fit.frf_weight);
  const Noise noise = weighted_noise(curves, fit, from);
  const Eigen::MatrixXcd X = noise.per_line.asDiagonal() * unstack(E);
  const double ratio = curves.sigma / curves.spacing;
  const Eigen::MatrixXd V = 0.5 * (X.adjoint() * correlate(X, ratio)).real();
  const Eigen::MatrixXd middle = with_residues(
      V, linear, fit.frf_weight.asDiagonal() * noise_at_modes(noise, X));
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
