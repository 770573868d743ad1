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
// |w| < 1). Blocks double in size with their distance, so that a pole costs
// O(log n) rows instead of n.
//
// Source: A. Dutt, M. Gu, V. Rokhlin, "Fast algorithms for polynomial
// interpolation, integration, and differentiation", SIAM J. Numer. Anal. 33(5),
// 1996, p. 1689-1711; the expansion: J. C. Mason, D. C. Handscomb, "Chebyshev
// Polynomials", 2003, sec. 5.2.
#pragma once

#include <Eigen/Core>

#include <complex>
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

  // To S1 and S2, real and imaginary parts of the factors apart: 2 m x 4.
  void add(const Block& block,
           const std::complex<double>& a,
           Eigen::MatrixX4d& sum) const;
  void add_lines(Eigen::Index block,
                 const std::complex<double>& a,
                 Eigen::MatrixX4d& sum) const;

  Eigen::MatrixXcd x_;
  /// By level, the moments sum_k T_j(u_k) x_k of its blocks side by side:
  /// m x (terms n_blocks).
  std::vector<Eigen::MatrixXcd> moments_;
};

}  // namespace tapfit::modal
