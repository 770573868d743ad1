// Operators for Spectra: x -> (K - sigma M)^-1 x through CHOLMOD, and x -> M x.
#pragma once

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/progress.hpp"
#include "updating/structure/solve/factor.hpp"

#include <stop_token>
#include <utility>

namespace tapfit::structure {

/// What is to be said of matrices that the arithmetic cannot hold.
inline InputError out_of_scale() {
  return {"numbers are too large or too far apart to be solved with",
          "stiffness and mass matrix",
          "Look for far too large or small values in grids, properties and "
          "materials."};
}

/// Thrown where Lanczos has gone through all that has mass, and goes on with
/// what is nothing over nothing.
struct NothingLeft {};

class ShiftInvert {
 public:
  using Scalar = double;

  /// @param factor of K - sigma M; must outlive this
  ShiftInvert(const Factor& factor, Eigen::Index size, std::stop_token stop)
      : factor_(factor), size_(size), stop_(std::move(stop)) {}

  [[nodiscard]] Eigen::Index rows() const { return size_; }
  [[nodiscard]] Eigen::Index cols() const { return size_; }

  /// Spectra's hook; the factor is made for the shift beforehand.
  void set_shift(double) {}

  /// @throws Stopped, NothingLeft
  void perform_op(const double* x, double* y) const {
    if (stop_.stop_requested()) throw Stopped{};
    const Eigen::Map<const Eigen::VectorXd> in(x, size_);
    if (!in.allFinite()) throw NothingLeft{};
    Eigen::Map<Eigen::VectorXd> out(y, size_);
    out = factor_.solve(in);
    // Spectra sorts what it is given, and knows no NaN.
    if (!out.allFinite()) throw out_of_scale();
  }

 private:
  const Factor& factor_;
  Eigen::Index size_;
  std::stop_token stop_;
};

class MassProduct {
 public:
  using Scalar = double;

  /// @param M must outlive this
  explicit MassProduct(const SparseMatrix& M) : M_(M) {}

  [[nodiscard]] Eigen::Index rows() const { return M_.rows(); }
  [[nodiscard]] Eigen::Index cols() const { return M_.cols(); }

  void perform_op(const double* x, double* y) const {
    const Eigen::Map<const Eigen::VectorXd> in(x, M_.rows());
    if (!in.allFinite()) throw NothingLeft{};
    Eigen::Map<Eigen::VectorXd> out(y, M_.rows());
    out = M_ * in;
    if (!out.allFinite()) throw out_of_scale();
  }

 private:
  const SparseMatrix& M_;
};

}  // namespace tapfit::structure
