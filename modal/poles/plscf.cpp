#include "modal/poles/plscf.hpp"

#include "modal/poles/band_circle.hpp"
#include "modal/poles/matrix_roots.hpp"
#include "modal/poles/reduced_normal.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// M = L L'. More order than the data carry makes M singular; a little on its
/// diagonal takes the smallest solution, which pushes the surplus poles to
/// negative damping.
Eigen::MatrixXd factor(Eigen::MatrixXd M) {
  const double mean = M.trace() / static_cast<double>(M.rows());
  for (double share = 1e-13; share < 1e-2; share *= 10.0) {
    Eigen::MatrixXd raised = M;
    raised.diagonal().array() += share * mean;
    const Eigen::LLT<Eigen::MatrixXd> llt(raised);
    if (llt.info() == Eigen::Success) return llt.matrixL();
  }
  return {};
}

/// Transposed coefficients A_0 .. A_{degree-1} side by side, the highest being
/// the identity: one back-substitution in the factor of all degrees.
Eigen::MatrixXd coefficients(const Eigen::MatrixXd& L,
                             Index degree,
                             Index refs) {
  const Index size = degree * refs;
  const Eigen::MatrixXd right = -L.block(size, 0, refs, size).transpose();
  return L.topLeftCorner(size, size)
      .triangularView<Eigen::Lower>()
      .transpose()
      .solve(right)
      .transpose();
}

/// The damped poles in the upper half plane.
OrderPoles poles_of(const Eigen::MatrixXd& A,
                    const Eigen::VectorXcd& roots,
                    const BandCircle& circle,
                    double sigma) {
  std::vector<Complex> poles;
  std::vector<Complex> places;
  for (const Complex& z : roots) {
    if (!(std::abs(z) > 1e-12)) continue;
    const Complex pole =
        -std::log(z) / circle.dt + Complex(sigma, circle.omega_0);
    if (pole.imag() <= circle.omega_0 || pole.real() >= 0.0) continue;
    poles.push_back(pole);
    places.push_back(z);
  }
  OrderPoles result;
  const auto count = static_cast<Index>(poles.size());
  result.poles = Eigen::Map<Eigen::VectorXcd>(poles.data(), count);
  result.participation.resize(A.rows(), count);
  for (Index p = 0; p < count; ++p) {
    result.participation.col(p) =
        left_null_vector(A, places[static_cast<std::size_t>(p)]);
  }
  return result;
}

}  // namespace

std::vector<OrderPoles> plscf_poles(const WeightedFrfs& curves,
                                    const FrfMatrix& matrix,
                                    int max_order,
                                    const Progress& progress) {
  const Index refs = matrix.references;
  const Index wanted = std::max<Index>(2, 2 * max_order / refs);
  const Index largest =
      std::max<Index>(2, std::min(wanted, curves.lines() / 3));
  const Index step = refs == 1 ? 2 : 1;
  const BandCircle circle = lay_on_circle(curves, largest);
  const Eigen::MatrixXd L =
      factor(reduced_normal(curves, matrix, circle, largest));
  std::vector<OrderPoles> orders;
  if (L.size() == 0 || !L.allFinite()) return orders;
  Eigen::VectorXcd roots;
  for (Index degree = 2; degree <= largest; degree += step) {
    progress("poles",
             static_cast<double>(degree) / static_cast<double>(largest));
    const Eigen::MatrixXd A = coefficients(L, degree, refs);
    roots = matrix_roots(A, roots);
    OrderPoles found = poles_of(A, roots, circle, curves.sigma);
    found.order = static_cast<int>(degree * refs / 2);
    if (found.poles.size() > 0) orders.push_back(std::move(found));
  }
  return orders;
}

}  // namespace tapfit::modal
