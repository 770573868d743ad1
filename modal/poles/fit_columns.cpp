#include "modal/poles/fit_columns.hpp"

#include <complex>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
constexpr Complex imaginary{0.0, 1.0};

}  // namespace

Eigen::MatrixXd stack(const Eigen::MatrixXcd& x) {
  Eigen::MatrixXd result(2 * x.rows(), x.cols());
  result.topRows(x.rows()) = x.real();
  result.bottomRows(x.rows()) = x.imag();
  return result;
}

Eigen::MatrixXcd unstack(const Eigen::MatrixXd& x) {
  const Index n = x.rows() / 2;
  Eigen::MatrixXcd result(n, x.cols());
  result.real() = x.topRows(n);
  result.imag() = x.bottomRows(n);
  return result;
}

Eigen::MatrixXcd pole_columns(const Eigen::VectorXcd& s,
                              const Eigen::VectorXcd& poles,
                              int power) {
  const Eigen::ArrayXcd twice = 2.0 * s.array().square();
  Eigen::MatrixXcd columns(s.size(), 2 * poles.size());
  for (Index r = 0; r < poles.size(); ++r) {
    // g and h over their common denominator.
    const Eigen::ArrayXcd t = s.array() - poles(r).real();
    const double w = poles(r).imag();
    const Eigen::ArrayXcd d = (t.square() + w * w).inverse();
    if (power == 1) {
      const Eigen::ArrayXcd c = twice * d;
      columns.col(2 * r) = t * c;
      columns.col(2 * r + 1) = -w * c;
    } else {
      const Eigen::ArrayXcd c = twice * d.square();
      columns.col(2 * r) = (t.square() - w * w) * c;
      columns.col(2 * r + 1) = -2.0 * w * t * c;
    }
  }
  return columns;
}

Eigen::MatrixXcd term_columns(const Eigen::MatrixXcd& basis) {
  Eigen::MatrixXcd columns(basis.rows(), 2 * basis.cols());
  for (Index t = 0; t < basis.cols(); ++t) {
    columns.col(2 * t) = basis.col(t);
    columns.col(2 * t + 1) = imaginary * basis.col(t);
  }
  return columns;
}

Eigen::MatrixXcd residual_basis(const Eigen::VectorXcd& s,
                                const Eigen::VectorXcd& band) {
  const Complex low = band(0);
  const Complex high = band(band.size() - 1);
  const Index count = band.size() < 60 ? 2 : 4;
  Eigen::MatrixXcd basis(s.size(), count);
  for (Index k = 0; k < s.size(); ++k) {
    const Complex x = s(k) * s(k) / std::norm(high);
    basis(k, 0) = 1.0;
    basis(k, 1) = x;
    if (count < 4) continue;
    basis(k, 2) = x * x;
    basis(k, 3) = std::norm(low) / (s(k) * s(k));
  }
  return basis;
}

}  // namespace tapfit::modal
