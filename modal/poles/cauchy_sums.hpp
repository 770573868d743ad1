// Sums over evenly spaced lines that a pole enters, for many columns at once:
//
//   S1(a) = sum_k x_k / (k - a),  S2(a) = sum_k x_k / (k - a)^2,  k = 0 .. n -
//   1
//
// Lines near the pole are summed one by one. What is far away enters through
// moments of its block of lines, which are worked out once:
//
//   1 / (u - p) = -1/q sum_j' 2 w^j T_j(u),  q = sqrt(p^2 - 1),  w = p - q
//
// with u in [-1, 1] over the block and p the pole there (the first term halved,
// |w| < 1). Blocks double in size with their distance, so that a place costs
// O(log n) rows instead of n. Around a place S1 is a power series, of which S2
// is the derivative; its coefficients come from S1 on a circle and are kept, so
// that poles that hardly move cost a few rows (cauchy_cells.hpp).
//
// Source: A. Dutt, M. Gu, V. Rokhlin, "Fast algorithms for polynomial
// interpolation, integration, and differentiation", SIAM J. Numer. Anal. 33(5),
// 1996, p. 1689-1711; the expansion: J. C. Mason, D. C. Handscomb, "Chebyshev
// Polynomials", 2003, sec. 5.2.
#pragma once

#include "modal/poles/cauchy_cells.hpp"

#include <Eigen/Core>

#include <complex>
#include <memory>
#include <vector>

namespace tapfit::modal {

class CauchySums {
 public:
  struct Pair {
    Eigen::VectorXcd first;   ///< S1 of each column
    Eigen::VectorXcd second;  ///< S2
  };

  CauchySums() = default;

  /// @param x one column per line: m x n_lines
  explicit CauchySums(Eigen::MatrixXcd x);

  /// @param a the pole in units of lines, on none of them
  /// @return accurate to 1e-10 of the sums of sizes
  [[nodiscard]] Pair at(const std::complex<double>& a) const;

 private:
  /// Lines b 2^l .. (b + 1) 2^l of the smallest blocks.
  struct Block {
    std::size_t level = 0;
    Eigen::Index index = 0;
  };

  // To S1 at several places near each other: 2 m x 2 n_places, real and
  // imaginary parts of the factors apart.
  void add(const Block& block,
           const Eigen::RowVectorXcd& a,
           Eigen::MatrixXd& sum) const;
  void add_lines(Eigen::Index block,
                 const Eigen::RowVectorXcd& a,
                 Eigen::MatrixXd& sum) const;

  /// Coefficients of S1 around a square's middle, in units of its radius:
  /// m x order.
  [[nodiscard]] Eigen::MatrixXcd expanded(const CauchyCell& cell) const;

  Eigen::MatrixXcd x_;
  /// By level, the moments sum_k T_j(u_k) x_k of its blocks side by side:
  /// m x (terms n_blocks).
  std::vector<Eigen::MatrixXcd> moments_;
  std::shared_ptr<CauchyCells> cells_;
};

}  // namespace tapfit::modal
