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

constexpr Index kBlock = 32;  // lines of the smallest blocks
constexpr Index kTerms = 14;  // of the expansion
// |w| of a pole in the next block but one is 0.172; its 14th power is 2e-11.
constexpr double kFar = 0.175;

/// T_j(u) of each u: kTerms x u.size().
Eigen::MatrixXd chebyshev(const Eigen::RowVectorXd& u) {
  Eigen::MatrixXd T(kTerms, u.size());
  T.row(0).setOnes();
  T.row(1) = u;
  for (Index j = 2; j < kTerms; ++j) {
    T.row(j) = 2.0 * u.cwiseProduct(T.row(j - 1)) - T.row(j - 2);
  }
  return T;
}

/// T_j over a block as a sum of T_i over one half of it, at the polynomials'
/// own points u_l = cos((l + 1/2) pi / n): kTerms x kTerms, i by j.
///
/// @param side -1 for the first half, +1 for the second
Eigen::MatrixXd of_half(double side) {
  Eigen::RowVectorXd u(kTerms);
  for (Index l = 0; l < kTerms; ++l) {
    u(l) = std::cos((static_cast<double>(l) + 0.5) * std::numbers::pi /
                    static_cast<double>(kTerms));
  }
  Eigen::MatrixXd to_terms =
      2.0 / static_cast<double>(kTerms) * chebyshev(u);  // by l
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
  const Index count = halves.cols() / kTerms;
  Eigen::MatrixXcd result(halves.rows(), (count + 1) / 2 * kTerms);
  const auto from = as_real(halves);
  auto to = as_real(result);
  for (Index b = 0; b < result.cols() / kTerms; ++b) {
    auto block = to.middleCols(b * kTerms, kTerms);
    block.noalias() = from.middleCols(2 * b * kTerms, kTerms) * first;
    if (2 * b + 1 == count) continue;
    block.noalias() += from.middleCols((2 * b + 1) * kTerms, kTerms) * second;
  }
  return result;
}

/// Factors of some rows in S1 and S2, real and imaginary: n x 4.
Eigen::MatrixX4d as_factors(const Eigen::VectorXcd& first,
                            const Eigen::VectorXcd& second) {
  Eigen::MatrixX4d result(first.size(), 4);
  result << first.real(), first.imag(), second.real(), second.imag();
  return result;
}

/// sum += x c for some rows from one on, four columns of c, reading x once.
template <int rows>
void add_rows(const Eigen::Ref<const Eigen::MatrixXd>& x,
              const Eigen::MatrixX4d& c,
              Index from,
              Eigen::MatrixX4d& sum) {
  using Rows = Eigen::Array<double, rows, 1>;
  Rows total[4];
  for (Index i = 0; i < 4; ++i) total[i] = sum.col(i).segment<rows>(from);
  for (Index k = 0; k < x.cols(); ++k) {
    const Rows value = x.col(k).template segment<rows>(from);
    for (Index i = 0; i < 4; ++i) total[i] += c(k, i) * value;
  }
  for (Index i = 0; i < 4; ++i) sum.col(i).segment<rows>(from) = total[i];
}

/// The same for all rows, of which there are an even number.
void add_product(const Eigen::Ref<const Eigen::MatrixXd>& x,
                 const Eigen::MatrixX4d& c,
                 Eigen::MatrixX4d& sum) {
  Index from = 0;
  for (; from + 8 <= x.rows(); from += 8) add_rows<8>(x, c, from, sum);
  for (; from < x.rows(); from += 2) add_rows<2>(x, c, from, sum);
}

}  // namespace

CauchySums::CauchySums(Eigen::MatrixXcd x) : x_(std::move(x)) {
  const Index blocks = (x_.cols() + kBlock - 1) / kBlock;
  Eigen::RowVectorXd u(kBlock);
  for (Index k = 0; k < kBlock; ++k) {
    u(k) = 2.0 * static_cast<double>(k) / static_cast<double>(kBlock) - 1.0;
  }
  const Eigen::MatrixXd T = chebyshev(u).transpose();
  Eigen::MatrixXcd moments(x_.rows(), blocks * kTerms);
  const auto operations = 50.0 * static_cast<double>(x_.size());
  const auto pieces = static_cast<std::size_t>(blocks);
  for_each_parallel(pieces, operations, [&](std::size_t k) {
    const auto b = static_cast<Index>(k);
    const Index lines = std::min(kBlock, x_.cols() - b * kBlock);
    as_real(moments).middleCols(b * kTerms, kTerms).noalias() =
        as_real(std::as_const(x_)).middleCols(b * kBlock, lines) *
        T.topRows(lines);
  });
  moments_.push_back(std::move(moments));
  while (moments_.back().cols() > kTerms) {
    moments_.push_back(joined(moments_.back()));
  }
}

void CauchySums::add_lines(Index block,
                           const Complex& a,
                           Eigen::MatrixX4d& sum) const {
  const Index begin = block * kBlock;
  const Index lines = std::min(kBlock, x_.cols() - begin);
  Eigen::VectorXcd once(lines);
  for (Index k = 0; k < lines; ++k) {
    once(k) = 1.0 / (static_cast<double>(begin + k) - a);
  }
  add_product(as_real(x_).middleCols(begin, lines),
              as_factors(once, once.cwiseProduct(once)),
              sum);
}

void CauchySums::add(const Block& block,
                     const Complex& a,
                     Eigen::MatrixX4d& sum) const {
  const auto [level, b] = block;
  const double half = 0.5 * static_cast<double>(kBlock << level);
  // p and w; of the two roots the one with |w| < 1.
  const Complex p = a / half - static_cast<double>(2 * b + 1);
  Complex q = std::sqrt(p * p - 1.0);
  if (std::norm(p - q) > std::norm(p + q)) q = -q;
  const Complex w = 1.0 / (p + q);
  if (std::norm(w) > kFar * kFar) {
    if (level == 0) {
      add_lines(b, a, sum);
      return;
    }
    add({level - 1, 2 * b}, a, sum);
    if ((2 * b + 1) * kTerms < moments_[level - 1].cols()) {
      add({level - 1, 2 * b + 1}, a, sum);
    }
    return;
  }
  // The derivative to p of -2 w^j / q is 2 w^j (j + p / q) / q^2.
  Eigen::VectorXcd first(kTerms);
  Eigen::VectorXcd second(kTerms);
  Complex power = -1.0 / (half * q);
  for (Index j = 0; j < kTerms; ++j) {
    first(j) = (j == 0 ? 1.0 : 2.0) * power;
    second(j) = -first(j) * (static_cast<double>(j) + p / q) / (half * q);
    power *= w;
  }
  add_product(as_real(moments_[level]).middleCols(b * kTerms, kTerms),
              as_factors(first, second),
              sum);
}

CauchySums::Pair CauchySums::at(const Complex& a) const {
  Eigen::MatrixX4d sum = Eigen::MatrixX4d::Zero(2 * x_.rows(), 4);
  add({moments_.size() - 1, 0}, a, sum);
  const Complex j(0.0, 1.0);
  const auto column = [&](Index c) {
    return Eigen::Map<const Eigen::VectorXcd>(
        reinterpret_cast<const Complex*>(sum.col(c).data()), x_.rows());
  };
  return {column(0) + j * column(1), column(2) + j * column(3)};
}

}  // namespace tapfit::modal
