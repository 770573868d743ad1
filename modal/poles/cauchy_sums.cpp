#include "modal/poles/cauchy_sums.hpp"

#include "acquisition/foundation/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr Index smallest_block = 64;  // lines of the smallest blocks
constexpr Index terms = 16;           // of a block's moments
// |w| of a pole in the next block but one is 0.172; its 16th power is 6e-13.
constexpr double far = 0.175;
// Powers around a place. The lines are ten times as far as it reaches: what is
// left out is 1e-12, of the derivative 1e-10.
constexpr Index order = 12;
constexpr double turn = 2.0 * std::numbers::pi / order;

/// T_j(u) of each u: terms x u.size().
Eigen::MatrixXd chebyshev(const Eigen::RowVectorXd& u) {
  Eigen::MatrixXd T(terms, u.size());
  T.row(0).setOnes();
  T.row(1) = u;
  for (Index j = 2; j < terms; ++j) {
    T.row(j) = 2.0 * u.cwiseProduct(T.row(j - 1)) - T.row(j - 2);
  }
  return T;
}

/// T_j over a block as a sum of T_i over one half of it, at the polynomials'
/// own points u_l = cos((l + 1/2) pi / n): terms x terms, i by j.
///
/// @param side -1 for the first half, +1 for the second
Eigen::MatrixXd of_half(double side) {
  Eigen::RowVectorXd u(terms);
  for (Index l = 0; l < terms; ++l) {
    u(l) = std::cos((static_cast<double>(l) + 0.5) * std::numbers::pi /
                    static_cast<double>(terms));
  }
  Eigen::MatrixXd to_terms =
      2.0 / static_cast<double>(terms) * chebyshev(u);  // by l
  to_terms.row(0) *= 0.5;
  return to_terms * chebyshev((0.5 * (u.array() + side)).matrix()).transpose();
}

/// Real over imaginary part of each entry, without a copy: 2 m x n.
Eigen::Map<const Eigen::MatrixXd> as_real(const Eigen::MatrixXcd& x) {
  return {reinterpret_cast<const double*>(x.data()), 2 * x.rows(), x.cols()};
}

Eigen::Map<Eigen::MatrixXd> as_real(Eigen::MatrixXcd& x) {
  return {reinterpret_cast<double*>(x.data()), 2 * x.rows(), x.cols()};
}

/// Blocks of one level from the halves that the level below has.
Eigen::MatrixXcd joined(const Eigen::MatrixXcd& halves) {
  const Eigen::MatrixXd first = of_half(-1.0);
  const Eigen::MatrixXd second = of_half(1.0);
  const Index count = halves.cols() / terms;
  Eigen::MatrixXcd result(halves.rows(), (count + 1) / 2 * terms);
  const auto from = as_real(halves);
  auto to = as_real(result);
  for (Index b = 0; b < result.cols() / terms; ++b) {
    auto block = to.middleCols(b * terms, terms);
    block.noalias() = from.middleCols(2 * b * terms, terms) * first;
    if (2 * b + 1 == count) continue;
    block.noalias() += from.middleCols((2 * b + 1) * terms, terms) * second;
  }
  return result;
}

/// Places on a circle around c: order of them.
Eigen::RowVectorXcd around(const Complex& c, double radius) {
  Eigen::RowVectorXcd places(order);
  for (Index i = 0; i < order; ++i) {
    places(i) = c + std::polar(radius, turn * static_cast<double>(i));
  }
  return places;
}

/// Coefficients of the powers of z from values at its order roots of unity.
Eigen::MatrixXcd to_powers() {
  Eigen::MatrixXcd result(order, order);
  for (Index i = 0; i < order; ++i) {
    for (Index l = 0; l < order; ++l) {
      const auto turns = static_cast<double>(i * l % order);
      result(i, l) =
          std::polar(1.0 / static_cast<double>(order), -turn * turns);
    }
  }
  return result;
}

/// sum += x c, real and imaginary parts of c side by side in sum.
void add_product(const Eigen::Ref<const Eigen::MatrixXd>& x,
                 const Eigen::MatrixXcd& c,
                 Eigen::MatrixXd& sum) {
  Eigen::MatrixXd parts(c.rows(), 2 * c.cols());
  parts << c.real(), c.imag();
  sum.noalias() += x * parts;
}

}  // namespace

CauchySums::CauchySums(Eigen::MatrixXcd x)
    : x_(std::move(x)), cells_(std::make_shared<CauchyCells>()) {
  const Index blocks = (x_.cols() + smallest_block - 1) / smallest_block;
  Eigen::RowVectorXd u(smallest_block);
  for (Index k = 0; k < smallest_block; ++k) {
    u(k) = 2.0 * static_cast<double>(k) / static_cast<double>(smallest_block) -
           1.0;
  }
  const Eigen::MatrixXd T = chebyshev(u).transpose();
  Eigen::MatrixXcd moments(x_.rows(), blocks * terms);
  const auto operations = 50.0 * static_cast<double>(x_.size());
  const auto pieces = static_cast<std::size_t>(blocks);
  for_each_parallel(pieces, operations, [&](std::size_t k) {
    const auto b = static_cast<Index>(k);
    const Index lines =
        std::min(smallest_block, x_.cols() - b * smallest_block);
    as_real(moments).middleCols(b * terms, terms).noalias() =
        as_real(std::as_const(x_)).middleCols(b * smallest_block, lines) *
        T.topRows(lines);
  });
  moments_.push_back(std::move(moments));
  while (moments_.back().cols() > terms) {
    moments_.push_back(joined(moments_.back()));
  }
}

void CauchySums::add_lines(Index block,
                           const Eigen::RowVectorXcd& a,
                           Eigen::MatrixXd& sum) const {
  const Index begin = block * smallest_block;
  const Index lines = std::min(smallest_block, x_.cols() - begin);
  Eigen::MatrixXcd factors(lines, a.size());
  for (Index k = 0; k < lines; ++k) {
    factors.row(k) = (static_cast<double>(begin + k) - a.array()).inverse();
  }
  add_product(as_real(x_).middleCols(begin, lines), factors, sum);
}

void CauchySums::add(const Block& block,
                     const Eigen::RowVectorXcd& a,
                     Eigen::MatrixXd& sum) const {
  const auto [level, b] = block;
  const double half = 0.5 * static_cast<double>(smallest_block << level);
  // q and w; of the two roots the one with |w| < 1.
  Eigen::RowVectorXcd q(a.size());
  Eigen::RowVectorXcd w(a.size());
  for (Index i = 0; i < a.size(); ++i) {
    const Complex p = a(i) / half - static_cast<double>(2 * b + 1);
    q(i) = std::sqrt(p * p - 1.0);
    if (std::norm(p - q(i)) > std::norm(p + q(i))) q(i) = -q(i);
    w(i) = 1.0 / (p + q(i));
  }
  if (w.cwiseAbs2().maxCoeff() > far * far) {
    if (level == 0) {
      add_lines(b, a, sum);
      return;
    }
    add({level - 1, 2 * b}, a, sum);
    if ((2 * b + 1) * terms < moments_[level - 1].cols()) {
      add({level - 1, 2 * b + 1}, a, sum);
    }
    return;
  }
  Eigen::MatrixXcd factors(terms, a.size());
  factors.row(0) = -(half * q).cwiseInverse();
  factors.row(1) = 2.0 * factors.row(0).cwiseProduct(w);
  for (Index j = 2; j < terms; ++j) {
    factors.row(j) = factors.row(j - 1).cwiseProduct(w);
  }
  add_product(
      as_real(moments_[level]).middleCols(b * terms, terms), factors, sum);
}

Eigen::MatrixXcd CauchySums::expanded(const CauchyCell& cell) const {
  static const Eigen::MatrixXcd to_terms = to_powers();
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(2 * x_.rows(), 2 * order);
  add({moments_.size() - 1, 0}, around(cell.centre(), cell.radius()), sum);
  const Eigen::Map<const Eigen::MatrixXcd> parts(
      reinterpret_cast<const Complex*>(sum.data()), x_.rows(), 2 * order);
  return (parts.leftCols(order) + Complex(0.0, 1.0) * parts.rightCols(order)) *
         to_terms;
}

CauchySums::Pair CauchySums::at(const Complex& a) const {
  const CauchyCell cell = CauchyCell::of(a, static_cast<double>(x_.cols() - 1));
  const CauchyCells::Powers powers =
      cells_->find(cell, [&] { return expanded(cell); });
  const Complex z = (a - cell.centre()) / cell.radius();
  Eigen::VectorXcd first(order);
  Eigen::VectorXcd second(order);
  first(0) = 1.0;
  second(0) = 0.0;
  for (Index i = 1; i < order; ++i) {
    first(i) = first(i - 1) * z;
    second(i) = first(i - 1) * (static_cast<double>(i) / cell.radius());
  }
  return {*powers * first, *powers * second};
}

}  // namespace tapfit::modal
