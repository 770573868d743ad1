#include "modal/poles/matrix_roots.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::ArrayXd;
using Eigen::Index;

constexpr int most_sweeps = 60;
constexpr double settled = 1e-9;  // the next step is of its third power

/// Roots in two arrays: real and imaginary parts go through the processor's
/// vector units better apart.
struct Points {
  ArrayXd re;
  ArrayXd im;
};

/// One entry of the polynomial and its derivative at every point (Horner).
struct Values {
  Points value;
  Points slope;
};

void multiply_add(const Points& z, const Points& add, Points& p, ArrayXd& t) {
  t = p.re * z.re - p.im * z.im + add.re;
  p.im = p.re * z.im + p.im * z.re + add.im;
  p.re.swap(t);
}

/// @param entry coefficients in falling powers
Values horner(const std::vector<double>& entry, const Points& z) {
  const Index n = z.re.size();
  const Points zero{ArrayXd::Zero(n), ArrayXd::Zero(n)};
  Values v{zero, zero};
  ArrayXd t(n);
  for (const double a : entry) {
    multiply_add(z, v.value, v.slope, t);
    t = v.value.re * z.re - v.value.im * z.im + a;
    v.value.im = v.value.re * z.im + v.value.im * z.re;
    v.value.re.swap(t);
  }
  return v;
}

/// tr(A^-1 A') at each point for the coefficients given; also whether A is
/// singular there to working precision.
class LogDerivative {
 public:
  explicit LogDerivative(const Eigen::MatrixXd& A)
      : k_(A.rows()), degree_(A.cols() / A.rows()) {
    falling_.resize(static_cast<std::size_t>(k_ * k_));
    rising_.resize(falling_.size());
    for (Index e = 0; e < k_ * k_; ++e) {
      const Index row = e % k_;
      const Index column = e / k_;
      std::vector<double>& rising = rising_[static_cast<std::size_t>(e)];
      for (Index r = 0; r < degree_; ++r) {
        rising.push_back(A(row, r * k_ + column));
      }
      rising.push_back(row == column ? 1.0 : 0.0);
      falling_[static_cast<std::size_t>(e)].assign(rising.rbegin(),
                                                   rising.rend());
    }
  }

  /// @param z all inside or on the unit circle, or all outside
  [[nodiscard]] Eigen::ArrayXcd at(const Eigen::ArrayXcd& z,
                                   bool outside) const {
    const Eigen::ArrayXcd w = outside ? Eigen::ArrayXcd(z.inverse()) : z;
    const Points points{w.real(), w.imag()};
    std::vector<Values> entries;
    for (const std::vector<double>& entry : outside ? rising_ : falling_) {
      entries.push_back(horner(entry, points));
    }
    Eigen::ArrayXcd result(z.size());
    for (Index i = 0; i < z.size(); ++i) result(i) = trace(entries, i);
    if (outside) {
      // A(z) = z^n B(1/z)
      result = w * (static_cast<double>(degree_ * k_) - w * result);
    }
    return result;
  }

 private:
  [[nodiscard]] Complex trace(const std::vector<Values>& entries,
                              Index i) const {
    const auto value = [&](std::size_t e) {
      return Complex(entries[e].value.re(i), entries[e].value.im(i));
    };
    const auto slope = [&](std::size_t e) {
      return Complex(entries[e].slope.re(i), entries[e].slope.im(i));
    };
    if (k_ == 1) return slope(0) / value(0);
    if (k_ == 2) {
      const Complex det = value(0) * value(3) - value(1) * value(2);
      return (slope(0) * value(3) + value(0) * slope(3) - slope(1) * value(2) -
              value(1) * slope(2)) /
             det;
    }
    Eigen::MatrixXcd V(k_, k_);
    Eigen::MatrixXcd D(k_, k_);
    for (Index e = 0; e < k_ * k_; ++e) {
      V(e % k_, e / k_) = value(static_cast<std::size_t>(e));
      D(e % k_, e / k_) = slope(static_cast<std::size_t>(e));
    }
    return V.partialPivLu().solve(D).trace();
  }

  Index k_;
  Index degree_;
  std::vector<std::vector<double>>
      falling_;  ///< of the entry at row + k column
  std::vector<std::vector<double>> rising_;
};

Eigen::VectorXcd companion_roots(const Eigen::MatrixXd& A) {
  const Index k = A.rows();
  const Index size = A.cols();
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(size, size);
  C.topRightCorner(size - k, size - k).setIdentity();
  C.bottomRows(k) = -A;
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(C, false);
  if (solver.info() != Eigen::Success) return {};
  return solver.eigenvalues();
}

/// The guesses given, and for the others places on a circle inside, which no
/// symmetry of the roots shares.
Eigen::ArrayXcd first_guess(const Eigen::VectorXcd& start, Index count) {
  constexpr double golden_angle = 2.399963;  // golden angle [rad]
  const Index given = std::min(start.size(), count);
  Eigen::ArrayXcd z(count);
  z.head(given) = start.head(given);
  for (Index i = given; i < count; ++i) {
    z(i) = std::polar(0.9, 0.7 + golden_angle * static_cast<double>(i));
  }
  return z;
}

/// sum_{j != i} 1 / (z_i - z_j)
Complex repulsion(const Points& z, Index i) {
  const ArrayXd x = z.re(i) - z.re;
  const ArrayXd y = z.im(i) - z.im;
  ArrayXd d = x.square() + y.square();
  d(i) = 1.0;  // there x = y = 0
  d = d.max(1e-280).inverse();
  return {(x * d).sum(), -(y * d).sum()};
}

/// Steps of the roots given by index, all on one side of the unit circle.
void move(const LogDerivative& polynomial,
          const std::vector<Index>& which,
          bool outside,
          Points& z,
          std::vector<Index>& unsettled) {
  if (which.empty()) return;
  Eigen::ArrayXcd at(static_cast<Index>(which.size()));
  for (std::size_t n = 0; n < which.size(); ++n) {
    at(static_cast<Index>(n)) = {z.re(which[n]), z.im(which[n])};
  }
  const Eigen::ArrayXcd newton = polynomial.at(at, outside);
  for (std::size_t n = 0; n < which.size(); ++n) {
    const Index i = which[n];
    const Complex pull = newton(static_cast<Index>(n));
    // Exactly on a root the derivative of the logarithm is infinite.
    if (!std::isfinite(std::abs(pull))) continue;
    Complex step = 1.0 / (pull - repulsion(z, i));
    const double size = std::hypot(z.re(i), z.im(i));
    if (!std::isfinite(std::abs(step))) step = 1e-3 * size;
    z.re(i) -= step.real();
    z.im(i) -= step.imag();
    if (std::abs(step) > settled * size) unsettled.push_back(i);
  }
}

}  // namespace

Eigen::VectorXcd matrix_roots(const Eigen::MatrixXd& A,
                              const Eigen::VectorXcd& start) {
  const Index count = A.cols();
  const LogDerivative polynomial(A);
  const Eigen::ArrayXcd guess = first_guess(start, count);
  Points z{guess.real(), guess.imag()};
  std::vector<Index> active(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i) active[static_cast<std::size_t>(i)] = i;
  for (int sweep = 0; sweep < most_sweeps && !active.empty(); ++sweep) {
    std::vector<Index> inside;
    std::vector<Index> outside;
    for (const Index i : active) {
      (std::hypot(z.re(i), z.im(i)) > 1.0 ? outside : inside).push_back(i);
    }
    active.clear();
    move(polynomial, inside, false, z, active);
    move(polynomial, outside, true, z, active);
  }
  // The roots add up to minus the trace of the next to highest coefficient.
  const Index k = A.rows();
  const double sum = -A.rightCols(k).trace();
  const double off = std::hypot(z.re.sum() - sum, z.im.sum());
  const double size = (z.re.square() + z.im.square()).sqrt().sum();
  if (!active.empty() || !(off < 1e-7 * size)) return companion_roots(A);
  Eigen::VectorXcd roots(count);
  roots.real() = z.re.matrix();
  roots.imag() = z.im.matrix();
  return roots;
}

Eigen::VectorXcd left_null_vector(const Eigen::MatrixXd& A, Complex z) {
  const Index k = A.rows();
  if (k == 1) return Eigen::VectorXcd::Ones(1);
  Eigen::MatrixXcd V = Eigen::MatrixXcd::Identity(k, k);
  const bool outside = std::abs(z) > 1.0;
  const Index degree = A.cols() / k;
  if (outside) {
    const Complex w = 1.0 / z;
    V = A.leftCols(k).cast<Complex>();
    for (Index r = 1; r < degree; ++r) V = w * V + A.middleCols(r * k, k);
    V = w * V + Eigen::MatrixXcd::Identity(k, k);
  } else {
    for (Index r = degree - 1; r >= 0; --r) V = z * V + A.middleCols(r * k, k);
  }
  const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(V.transpose(),
                                               Eigen::ComputeFullV);
  return svd.matrixV().col(k - 1);
}

}  // namespace tapfit::modal
