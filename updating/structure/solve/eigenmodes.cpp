#include "updating/structure/solve/eigenmodes.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/solve/definiteness.hpp"
#include "updating/structure/solve/factor.hpp"
#include "updating/structure/solve/shift_invert.hpp"
#include "updating/structure/solve/sturm_count.hpp"
#include "updating/structure/solve/symmetric_product.hpp"

#include <Eigen/Dense>
#include <Spectra/SymGEigsShiftSolver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <stop_token>

namespace tapfit::structure {
namespace {

constexpr Eigen::Index dense_limit =
    200;  // below this a dense solver is quicker

// Degrees of freedom that have mass, of which a dense solver still takes no
// more than a minute; there may be fewer modes than these.
constexpr Eigen::Index most_masses = 4000;

// Below this share of the largest mu = 1 / (lambda - sigma) there is no mass.
constexpr double least_mu = 1e-14;

struct Pairs {
  Eigen::VectorXd lambda;  // ascending
  Eigen::MatrixXd phi;
};

// A little below zero, small against the elastic modes and large against the
// rounding of K: 1e-8 of the lower quartile of K_ii / M_ii. The quartile
// belongs to bending where there is any; a seismic mass or a mass that is
// rounding does not move it.
double shift_below_zero(const SparseMatrix& K, const SparseMatrix& M) {
  const Eigen::VectorXd k = K.diagonal();
  const Eigen::VectorXd m = M.diagonal();
  std::vector<double> ratios;
  for (Eigen::Index i = 0; i < k.size(); ++i) {
    if (m(i) > 0.0 && k(i) > 0.0) ratios.push_back(k(i) / m(i));
  }
  if (ratios.empty()) return -1.0;
  const auto quartile =
      ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 4);
  std::nth_element(ratios.begin(), quartile, ratios.end());
  return -1e-8 * *quartile;
}

// Where many more modes than are asked for lie nearer to zero than the shift,
// it does not tell them apart: a line of n elements has its lowest at some
// 1 / n^4 of K_ii / M_ii. The shift is then lowered step by step, as far as
// the rounding of K allows: 1e-13 of the lower quartile.
double closer_shift(const SparseMatrix& K,
                    const SparseMatrix& M,
                    double sigma,
                    Eigen::Index asked) {
  constexpr double step = 0.1;
  constexpr int most_steps = 5;
  for (int i = 0; i < most_steps; ++i) {
    const std::optional<Eigen::Index> nearer = count_below(K, M, -sigma);
    if (!nearer || *nearer <= asked) break;
    sigma *= step;
  }
  return sigma;
}

// M x = mu (K - sigma M) x, lambda = sigma + 1/mu; M may be singular.
Pairs solve_dense(const SparseMatrix& A,
                  const SparseMatrix& M,
                  double sigma,
                  Eigen::Index count) {
  const Eigen::MatrixXd mass = M;
  const Eigen::MatrixXd shifted = A;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      mass, shifted);
  if (solver.info() != Eigen::Success) {
    throw InputError("the modes cannot be solved for",
                     "stiffness matrix",
                     "Look for parts that are not held or not joined.");
  }
  const Eigen::VectorXd& mu = solver.eigenvalues();
  const Eigen::Index finite =
      (mu.array() > least_mu * mu.cwiseAbs().maxCoeff()).count();
  const Eigen::Index n = std::min(count, finite);
  Pairs pairs{Eigen::VectorXd(n), Eigen::MatrixXd(A.rows(), n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index from = mu.size() - 1 - i;
    pairs.lambda(i) = sigma + 1.0 / mu(from);
    pairs.phi.col(i) = solver.eigenvectors().col(from) / std::sqrt(mu(from));
  }
  return pairs;
}

std::vector<Eigen::Index> massive(const SparseMatrix& M) {
  const Eigen::VectorXd m = M.diagonal();
  std::vector<Eigen::Index> dofs;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    if (m(i) != 0.0) dofs.push_back(i);
  }
  return dofs;
}

// Where few degrees of freedom have mass there are no more modes than these:
// with M = F F',
//
//   F' A^-1 F u = mu u,   x = A^-1 F u / mu
Pairs solve_by_masses(const Factor& factor,
                      const SparseMatrix& M,
                      const std::vector<Eigen::Index>& dofs,
                      double sigma,
                      Eigen::Index count) {
  const auto m = static_cast<Eigen::Index>(dofs.size());
  Eigen::MatrixXd own(m, m);
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index j = 0; j < m; ++j) {
      own(i, j) = M.coeff(dofs[static_cast<std::size_t>(i)],
                          dofs[static_cast<std::size_t>(j)]);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> root(own);
  const Eigen::MatrixXd f =
      root.eigenvectors() *
      root.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(M.rows(), m);
  for (Eigen::Index i = 0; i < m; ++i) {
    F.row(dofs[static_cast<std::size_t>(i)]) = f.row(i);
  }
  const Eigen::MatrixXd answers = factor.solve(F);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(F.transpose() *
                                                              answers);
  const Eigen::VectorXd& mu = solver.eigenvalues();
  const Eigen::Index finite = (mu.array() > least_mu * mu.maxCoeff()).count();
  const Eigen::Index n = std::min(count, finite);
  Pairs pairs{Eigen::VectorXd(n), Eigen::MatrixXd(M.rows(), n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    pairs.lambda(i) = sigma + 1.0 / mu(m - 1 - i);
    pairs.phi.col(i) =
        answers * solver.eigenvectors().col(m - 1 - i) / mu(m - 1 - i);
  }
  return pairs;
}

// Well separated by the shift, modes take some ten restarts; more than few say
// that the shift may be too far.
constexpr Eigen::Index few_restarts = 15;
constexpr Eigen::Index most_restarts = 40;

std::optional<Pairs> solve_lanczos(const Factor& factor,
                                   const SparseMatrix& M,
                                   double sigma,
                                   Eigen::Index count,
                                   Eigen::Index basis,
                                   Eigen::Index restarts,
                                   const std::stop_token& stop) {
  ShiftInvert op(factor, M.rows(), stop);
  MassProduct mass(M);
  Spectra::SymGEigsShiftSolver<ShiftInvert,
                               MassProduct,
                               Spectra::GEigsMode::ShiftInvert>
      solver(op, mass, count, basis, sigma);
  solver.init();
  Eigen::Index found = 0;
  try {
    found = solver.compute(Spectra::SortRule::LargestMagn,
                           restarts,
                           1e-11,
                           Spectra::SortRule::SmallestAlge);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error&) {
    // Rounding has eaten the smaller stiffnesses up; a larger basis may do.
    return std::nullopt;
  }
  if (solver.info() != Spectra::CompInfo::Successful || found < count) {
    return std::nullopt;
  }
  return Pairs{solver.eigenvalues(), solver.eigenvectors()};
}

/// K - sigma M, factored.
struct Shifted {
  double sigma = 0.0;
  Factor factor;
};

// The same, from nearer to zero where that is what it takes.
std::optional<Pairs> solve_closer(Shifted& shifted,
                                  const SparseMatrix& K,
                                  const SparseMatrix& M,
                                  Eigen::Index count,
                                  Eigen::Index basis,
                                  const std::stop_token& stop) {
  auto raw = solve_lanczos(
      shifted.factor, M, shifted.sigma, count, basis, few_restarts, stop);
  if (raw) return raw;
  const double closer = closer_shift(K, M, shifted.sigma, count);
  if (closer != shifted.sigma) {
    try {
      shifted = {closer, Factor(K - closer * M, shifted.factor)};
    } catch (const SingularMatrix&) {
      // Nearer than the rounding of K: the shift stays as it is.
    }
  }
  return solve_lanczos(
      shifted.factor, M, shifted.sigma, count, basis, most_restarts, stop);
}

// Rayleigh-Ritz within the span found: exact orthonormality, also inside
// clusters, and ascending order.
Pairs polish(const SparseMatrix& K,
             const SparseMatrix& M,
             const Eigen::MatrixXd& phi) {
  const Eigen::MatrixXd k = phi.transpose() * symmetric_product(K, phi);
  const Eigen::MatrixXd m = phi.transpose() * symmetric_product(M, phi);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz(
      0.5 * (k + k.transpose()), 0.5 * (m + m.transpose()));
  return {ritz.eigenvalues(), phi * ritz.eigenvectors()};
}

// Whether the modes found are all there are up to the `count`-th: the Sturm
// count in a gap above it must be the number found below the gap. Empty when
// no gap allows a certain count.
std::optional<bool> is_complete(const SparseMatrix& K,
                                const SparseMatrix& M,
                                const Eigen::VectorXd& lambda,
                                Eigen::Index count) {
  for (Eigen::Index inside = lambda.size() - 1; inside >= count; --inside) {
    const double below = lambda(inside - 1);
    const double above = lambda(inside);
    if (!(above > 0.0) || above - below < 1e-6 * above) continue;
    const std::optional<Eigen::Index> counted =
        count_below(K, M, 0.5 * (below + above));
    if (counted) return *counted == inside;
  }
  return std::nullopt;
}

bool is_finite(const SparseMatrix& A) {
  for (Eigen::Index column = 0; column < A.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator at(A, column); at; ++at) {
      if (!std::isfinite(at.value())) return false;
    }
  }
  return true;
}

Eigenmodes to_modes(const Pairs& pairs, Eigen::Index count) {
  const Eigen::Index n = std::min(count, pairs.lambda.size());
  return {pairs.lambda.head(n).cwiseMax(0.0).cwiseSqrt() / two_pi,
          pairs.phi.leftCols(n)};
}

// Each of some restarts makes a basis of twice the modes orthogonal, which
// takes n basis^2 products: these are a night of a core, and more memory than
// most have (1000 modes of a million degrees of freedom).
constexpr double most_products = 4e12;

void refuse_too_many(Eigen::Index n, Eigen::Index count, double max_hz) {
  const auto basis = 2.0 * static_cast<double>(count);
  if (static_cast<double>(n) * basis * basis <= most_products) return;
  throw InputError(
      fmt::format("the model has {} modes below {:.4g} Hz on {} degrees of "
                  "freedom, too many to be solved for",
                  count - 1,
                  max_hz,
                  n),
      "stiffness and mass matrix",
      "Lower the high end of band_hz, which modes are needed to some times of, "
      "or use fewer and longer elements: a tenth of a wavelength is enough.");
}

}  // namespace

Eigenmodes eigenmodes(const SparseMatrix& K,
                      const SparseMatrix& M,
                      Eigen::Index count,
                      const std::stop_token& stop) {
  const Eigen::Index n = K.rows();
  if (n == 0 || count <= 0) return {{}, Eigen::MatrixXd(n, 0)};
  if (!is_finite(K) || !is_finite(M)) throw out_of_scale();
  const double sigma = shift_below_zero(K, M);
  const SparseMatrix A = K - sigma * M;
  Shifted shifted{sigma, Factor(A)};  // throws for a mechanism without mass
  const bool dense = n <= dense_limit || 2 * (count + 2) + 20 > n;
  // A negative mass hides in A behind the stiffness.
  if (dense || shifted.factor.pivots().minCoeff() < 0.0)
    refuse_indefinite(K, M);
  Eigen::Index asked = count + 2;
  if (dense) {
    return to_modes(solve_dense(A, M, sigma, count), count);
  }
  const std::vector<Eigen::Index> dofs = massive(M);
  if (std::ssize(dofs) <= dense_limit) {
    return to_modes(
        solve_by_masses(shifted.factor, M, dofs, shifted.sigma, count), count);
  }
  Eigen::Index basis = std::min(n, 2 * asked + 10);
  for (int attempt = 0; attempt < 4; ++attempt) {
    std::optional<Pairs> raw;
    try {
      raw = attempt == 0 ? solve_closer(shifted, K, M, asked, basis, stop)
                         : solve_lanczos(shifted.factor,
                                         M,
                                         shifted.sigma,
                                         asked,
                                         basis,
                                         most_restarts,
                                         stop);
    } catch (const NothingLeft&) {
      if (std::ssize(dofs) > most_masses) break;
      return to_modes(
          solve_by_masses(shifted.factor, M, dofs, shifted.sigma, count),
          count);
    }
    if (raw) {
      const Pairs pairs = polish(K, M, raw->phi);
      const std::optional<bool> complete =
          is_complete(K, M, pairs.lambda, count);
      if (complete.value_or(false)) return to_modes(pairs, count);
      // Without a gap, or with one that is rounding, as among modes of a rigid
      // body: one may follow further up.
      asked = std::min(n - 1, asked + count / 4 + 4);
    }
    basis = std::min(n, std::max(basis + basis / 2, 2 * asked) + 10);
  }
  refuse_indefinite(K, M);
  throw InputError(
      fmt::format("the {} lowest modes did not converge", count),
      "stiffness and mass matrix",
      "Ask for fewer modes, or look for parts that are not held or joined and "
      "for values far larger or smaller than the others.");
}

Eigenmodes eigenmodes_up_to(const SparseMatrix& K,
                            const SparseMatrix& M,
                            double max_hz,
                            const std::stop_token& stop) {
  const std::optional<Eigen::Index> counted =
      count_below(K, M, std::pow(two_pi * max_hz, 2));
  Eigen::Index count = counted ? *counted + 1 : Eigen::Index{20};
  while (true) {
    refuse_too_many(K.rows(), count, max_hz);
    Eigenmodes modes = eigenmodes(K, M, count, stop);
    const Eigen::Index found = modes.frequency_hz.size();
    const Eigen::Index inside = (modes.frequency_hz.array() <= max_hz).count();
    if (inside < found || found < count) {
      return {modes.frequency_hz.head(inside), modes.phi.leftCols(inside)};
    }
    count += count / 2 + 5;
  }
}

}  // namespace tapfit::structure
