#include "modal/fit/column_products.hpp"

#include "acquisition/foundation/parallel.hpp"

#include <complex>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
constexpr Complex j{0.0, 1.0};

/// sum v^2 conj(g_p) x for p = 1, 2.
void sums_of(const WeightedFrfs& curves,
             const Complex& pole,
             Eigen::Ref<Eigen::VectorXcd> first,
             Eigen::Ref<Eigen::VectorXcd> second) {
  const Complex mu = 2.0 * curves.sigma - std::conj(pole);
  const Complex step = j * curves.spacing;
  const CauchySums::Pair sums = curves.sums.lines.at((mu - curves.s(0)) / step);
  first = -sums.first / step;
  second = sums.second / (step * step);
}

/// <column, x> of each pole's two columns and the complex columns x, which
/// are rows begin .. begin + count of the sums: 2 n_modes x count.
Eigen::MatrixXd with_columns(const PoleSums& sums,
                             Index power,
                             Index begin,
                             Index count) {
  const auto own = sums.own[power].middleRows(begin, count);
  const auto other = sums.conjugate[power].middleRows(begin, count);
  Eigen::MatrixXd result(2 * own.cols(), count);
  for (Index r = 0; r < own.cols(); ++r) {
    result.row(2 * r) = (own.col(r) + other.col(r)).real().transpose();
    result.row(2 * r + 1) = (own.col(r) - other.col(r)).imag().transpose();
  }
  return result;
}

/// The same with columns t and j t of each residual term: 2 n_modes x
/// 2 n_terms.
Eigen::MatrixXd with_terms(const PoleSums& sums,
                           Index power,
                           Index begin,
                           Index count) {
  const auto own = sums.own[power].middleRows(begin, count);
  const auto other = sums.conjugate[power].middleRows(begin, count);
  Eigen::MatrixXd result(2 * own.cols(), 2 * count);
  for (Index r = 0; r < own.cols(); ++r) {
    for (Index t = 0; t < count; ++t) {
      const Complex g = own(t, r) + other(t, r);
      const Complex h = own(t, r) - other(t, r);
      result.block<2, 2>(2 * r, 2 * t) << g.real(), -g.imag(), h.imag(),
          h.real();
    }
  }
  return result;
}

/// A pole or its conjugate, with D_1 and D_2 there.
struct Root {
  Complex at;
  Complex D1;
  Complex D2;
};

/// P of the functions 1 / (s - a)^p and 1 / (s - b)^q: derivatives to conj(a)
/// and b of that of p = q = 1.
Complex product(double sigma, const Root& a, const Root& b, int p, int q) {
  const Complex d = 1.0 / (2.0 * sigma - std::conj(a.at) - b.at);
  const Complex N = std::conj(a.D1) + b.D1;
  if (p == 1 && q == 1) return N * d;
  if (p == 1) return (b.D2 + N * d) * d;
  return (b.D2 + std::conj(a.D2) + 2.0 * N * d) * d * d;
}

std::vector<Root> roots(const Eigen::VectorXcd& poles,
                        const Eigen::MatrixXcd (&sums)[2],
                        bool conjugate) {
  std::vector<Root> result;
  const Index last = sums[0].rows() - 1;
  for (Index r = 0; r < poles.size(); ++r) {
    result.push_back({conjugate ? std::conj(poles(r)) : poles(r),
                      std::conj(sums[0](last, r)),
                      std::conj(sums[1](last, r))});
  }
  return result;
}

/// Products of the poles' columns of power p with those of power q.
Eigen::MatrixXd of_poles(const WeightedFrfs& curves,
                         const Eigen::VectorXcd& poles,
                         const PoleSums& sums,
                         int p,
                         int q) {
  const std::vector<Root> own = roots(poles, sums.own, false);
  const std::vector<Root> other = roots(poles, sums.conjugate, true);
  const Index n = poles.size();
  Eigen::MatrixXd result(2 * n, 2 * n);
  for (Index r = 0; r < n; ++r) {
    for (Index c = p == q ? r : 0; c < n; ++c) {
      const auto a = static_cast<std::size_t>(r);
      const auto b = static_cast<std::size_t>(c);
      const double sigma = curves.sigma;
      const Complex gg = product(sigma, own[a], own[b], p, q);
      const Complex gh = product(sigma, own[a], other[b], p, q);
      const Complex hg = product(sigma, other[a], own[b], p, q);
      const Complex hh = product(sigma, other[a], other[b], p, q);
      Eigen::Matrix2d block;
      block << (gg + gh + hg + hh).real(), -(gg - gh + hg - hh).imag(),
          (gg + gh - hg - hh).imag(), (gg - gh - hg + hh).real();
      result.block<2, 2>(2 * r, 2 * c) = block;
      // Among themselves they are symmetric.
      if (p == q) result.block<2, 2>(2 * c, 2 * r) = block.transpose();
    }
  }
  return result;
}

Index terms_of(const WeightedFrfs& curves) {
  return curves.sums.term_term.cols() / 2;
}

}  // namespace

PoleSums pole_sums(const WeightedFrfs& curves, const Eigen::VectorXcd& poles) {
  const Index rows = curves.count() + terms_of(curves) + 1;
  PoleSums sums;
  for (int p = 0; p < 2; ++p) {
    sums.own[p].resize(rows, poles.size());
    sums.conjugate[p].resize(rows, poles.size());
  }
  const auto sum_up = [&](Index r) {
    sums_of(curves, poles(r), sums.own[0].col(r), sums.own[1].col(r));
    sums_of(curves,
            std::conj(poles(r)),
            sums.conjugate[0].col(r),
            sums.conjugate[1].col(r));
  };
  constexpr double of_a_sum = 3000.0;  // rows of moments and what they take
  for_each_parallel(static_cast<std::size_t>(poles.size()),
                    of_a_sum * static_cast<double>(rows * poles.size()),
                    [&](std::size_t r) { sum_up(static_cast<Index>(r)); });
  return sums;
}

ColumnProducts column_products(const WeightedFrfs& curves,
                               const Eigen::VectorXcd& poles,
                               const PoleSums& sums) {
  const Index modes = 2 * poles.size();
  const Index terms = 2 * terms_of(curves);
  const Eigen::MatrixXd between =
      with_terms(sums, 0, curves.count(), terms_of(curves));
  ColumnProducts result;
  result.gram.resize(modes + terms, modes + terms);
  result.gram << of_poles(curves, poles, sums, 1, 1), between,
      between.transpose(), curves.sums.term_term;
  result.frfs.resize(modes + terms, curves.count());
  result.frfs << with_columns(sums, 0, 0, curves.count()), curves.sums.term_frf;
  return result;
}

DerivativeProducts derivative_products(const WeightedFrfs& curves,
                                       const Eigen::VectorXcd& poles,
                                       const PoleSums& sums) {
  const Index modes = 2 * poles.size();
  DerivativeProducts result;
  result.columns.resize(modes + 2 * terms_of(curves), modes);
  result.columns << of_poles(curves, poles, sums, 1, 2),
      with_terms(sums, 1, curves.count(), terms_of(curves)).transpose();
  result.gram = of_poles(curves, poles, sums, 2, 2);
  result.frfs = with_columns(sums, 1, 0, curves.count());
  return result;
}

}  // namespace tapfit::modal
