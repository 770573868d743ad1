#include "modal/plscf.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// How the band lies on the unit circle.
struct Basis {
  double omega_0 = 0.0;     ///< [rad/s], angle 0
  double dt = 0.0;          ///< [s]
  Eigen::MatrixXcd powers;  ///< n_lines x (largest + 1), Omega_k^l
};

Basis make_basis(const Curves& curves, Index largest) {
  const double low = curves.s(0).imag();
  const double high = curves.s(curves.lines() - 1).imag();
  const double margin = 0.05 * (high - low);
  Basis basis;
  // A band that reaches down to zero has its true conjugate symmetry there.
  basis.omega_0 = low < 0.15 * high ? 0.0 : low - margin;
  basis.dt = std::numbers::pi / (high + margin - basis.omega_0);
  basis.powers.resize(curves.lines(), largest + 1);
  for (Index k = 0; k < curves.lines(); ++k) {
    const double angle = (curves.s(k).imag() - basis.omega_0) * basis.dt;
    for (Index l = 0; l <= largest; ++l) {
      basis.powers(k, l) = std::polar(1.0, -angle * static_cast<double>(l));
    }
  }
  return basis;
}

/// Toeplitz sums over the lines, lags -largest .. largest in rows.
struct Sums {
  Index largest = 0;
  Index references = 0;
  Eigen::MatrixXd R;               ///< per output: sum w^2 Omega^l, l >= 0
  std::vector<Eigen::MatrixXd> S;  ///< per output: lags x references
  Eigen::MatrixXd T;               ///< lags x references^2 (i + j references)
};

/// Re sum_k x(k) Omega_k^l for l = -largest .. largest, per column of x.
Eigen::MatrixXd lag_sums(const Basis& basis, const Eigen::MatrixXcd& x) {
  const Index largest = basis.powers.cols() - 1;
  const Eigen::MatrixXd up = (basis.powers.transpose() * x).real();
  const Eigen::MatrixXd down = (basis.powers.adjoint() * x).real();
  Eigen::MatrixXd result(2 * largest + 1, x.cols());
  result.bottomRows(largest + 1) = up;
  result.topRows(largest) = down.bottomRows(largest).colwise().reverse();
  return result;
}

/// Weight of a row of FRFs: by the mean variance over its references.
Eigen::VectorXd row_power(const Curves& curves, const std::vector<Index>& row) {
  Eigen::VectorXd inverse = Eigen::VectorXd::Zero(curves.lines());
  for (const Index f : row) {
    inverse += curves.weight.col(f).array().square().inverse().matrix();
  }
  return (static_cast<double>(row.size()) * inverse.array().inverse()).matrix();
}

Sums make_sums(const Curves& curves,
               const FrfMatrix& matrix,
               const Basis& basis) {
  const auto outputs = static_cast<Index>(matrix.rows.size());
  const Index refs = matrix.references;
  Sums sums;
  sums.largest = basis.powers.cols() - 1;
  sums.references = refs;
  sums.R.resize(sums.largest + 1, outputs);
  Eigen::MatrixXcd G = Eigen::MatrixXcd::Zero(curves.lines(), refs * refs);
  for (Index o = 0; o < outputs; ++o) {
    const std::vector<Index>& row = matrix.rows[static_cast<std::size_t>(o)];
    const Eigen::VectorXd power = row_power(curves, row);
    sums.R.col(o) = (basis.powers.transpose() * power).real();
    const Eigen::MatrixXcd H = curves.H(Eigen::all, row);
    const Eigen::MatrixXcd weighted = power.asDiagonal() * H;
    sums.S.emplace_back(-lag_sums(basis, weighted));
    for (Index j = 0; j < refs; ++j) {
      for (Index i = 0; i < refs; ++i) {
        G.col(i + j * refs).array() +=
            H.col(i).array().conjugate() * weighted.col(j).array();
      }
    }
  }
  sums.T = lag_sums(basis, G);
  return sums;
}

/// M of one polynomial degree, (degree + 1) references square.
Eigen::MatrixXd normal_matrix(const Sums& sums, Index degree) {
  const Index refs = sums.references;
  const Index size = (degree + 1) * refs;
  Eigen::MatrixXd M(size, size);
  for (Index r = 0; r <= degree; ++r) {
    for (Index s = 0; s <= degree; ++s) {
      const Eigen::RowVectorXd block = sums.T.row(sums.largest + s - r);
      M.block(r * refs, s * refs, refs, refs) =
          Eigen::Map<const Eigen::MatrixXd>(block.data(), refs, refs);
    }
  }
  Eigen::MatrixXd R(degree + 1, degree + 1);
  Eigen::MatrixXd S(degree + 1, size);
  for (std::size_t o = 0; o < sums.S.size(); ++o) {
    for (Index r = 0; r <= degree; ++r) {
      for (Index s = 0; s <= degree; ++s) {
        R(r, s) = sums.R(std::abs(s - r), static_cast<Index>(o));
        S.block(r, s * refs, 1, refs) = sums.S[o].row(sums.largest + s - r);
      }
    }
    const Eigen::MatrixXd solved = R.ldlt().solve(S);
    M.noalias() -= S.transpose() * solved;
  }
  return 0.5 * (M + M.transpose());
}

/// Companion matrix of the transposed polynomial, whose eigenvectors hold the
/// participation factors (left null vectors of A).
Eigen::MatrixXd companion(const Eigen::MatrixXd& M, Index degree, Index refs) {
  const Index size = degree * refs;
  Eigen::MatrixXd head = M.topLeftCorner(size, size);
  // More order than the data carry makes M singular; the smallest solution is
  // the one that pushes the surplus poles to negative damping.
  head.diagonal().array() += 1e-13 * head.trace() / static_cast<double>(size);
  const Eigen::MatrixXd alpha =
      head.ldlt().solve(-M.topRightCorner(size, refs));
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(size, size);
  C.topRightCorner(size - refs, size - refs).setIdentity();
  for (Index r = 0; r < degree; ++r) {
    C.block(size - refs, r * refs, refs, refs) =
        -alpha.middleRows(r * refs, refs).transpose();
  }
  return C;
}

OrderPoles poles_of(const Eigen::MatrixXd& C,
                    const Basis& basis,
                    double sigma,
                    Index refs) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(C);
  OrderPoles result;
  if (solver.info() != Eigen::Success) return result;
  std::vector<Complex> poles;
  std::vector<Index> columns;
  for (Index p = 0; p < C.rows(); ++p) {
    const Complex z = solver.eigenvalues()(p);
    if (std::abs(z) < 1e-12) continue;
    const Complex shifted = -std::log(z) / basis.dt;
    if (shifted.imag() <= 0.0) continue;
    poles.push_back(shifted + Complex(sigma, basis.omega_0));
    columns.push_back(p);
  }
  const Eigen::MatrixXcd vectors = solver.eigenvectors();
  result.poles = Eigen::Map<Eigen::VectorXcd>(poles.data(),
                                              static_cast<Index>(poles.size()));
  result.participation = vectors.bottomRows(refs)(Eigen::all, columns);
  result.participation.colwise().normalize();
  return result;
}

}  // namespace

std::vector<OrderPoles> plscf_poles(const Curves& curves,
                                    const FrfMatrix& matrix,
                                    int max_order,
                                    const Progress& progress) {
  const Index refs = matrix.references;
  const Index wanted = std::max<Index>(2, 2 * max_order / refs);
  const Index largest =
      std::max<Index>(2, std::min(wanted, curves.lines() / 3));
  const Index step = refs == 1 ? 2 : 1;
  const Basis basis = make_basis(curves, largest);
  const Sums sums = make_sums(curves, matrix, basis);
  std::vector<OrderPoles> orders;
  for (Index degree = 2; degree <= largest; degree += step) {
    progress("poles",
             static_cast<double>(degree) / static_cast<double>(largest));
    const Eigen::MatrixXd M = normal_matrix(sums, degree);
    const Eigen::MatrixXd C = companion(M, degree, refs);
    if (!C.allFinite()) continue;
    OrderPoles found = poles_of(C, basis, curves.sigma, refs);
    found.order = static_cast<int>(degree * refs / 2);
    if (found.poles.size() > 0) orders.push_back(std::move(found));
  }
  return orders;
}

}  // namespace tapfit::modal
