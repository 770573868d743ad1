#include "updating/reduction/lean_span.hpp"

#include "updating/reduction/base_matrices.hpp"
#include "updating/reduction/subspace.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Modes are kept to this many times the top of the band, and what properties
// make of those up to a little above it is looked at.
constexpr double kept_reach = 2.5;
constexpr double looked_at_reach = 1.3;

// Of the amplitude (root of the energy) of a mode, or of all that a point
// answers: what is left is its square, in frequency and in flexibility.
constexpr double negligible = 1e-6;

// The same where a base was released, whose own coordinates are looked at once
// more.
constexpr double negligible_of_released = 1e-4;

// A mode that strains nothing has this share of the energy at the band's top.
constexpr double least_energy = 1e-2;

// A parameter's range is halved at most so often.
constexpr int halvings = 3;

// The coordinates beyond the modes that are kept.
struct Beyond {
  Index first = 0;
  VectorXd lambda;
};

// What driven points answer through the modes beyond, at rest and at the top
// of the band, per root of all that they answer.
MatrixXd answers(const ReducedBase& base,
                 const Beyond& beyond,
                 const MatrixXd& driven,
                 double top) {
  const VectorXd all = base.K.diagonal().cwiseMax(1e-3 * top);
  constexpr Index shifts = 3;
  MatrixXd result(beyond.lambda.size(), shifts * driven.cols());
  for (Index p = 0; p < driven.cols(); ++p) {
    const double flexibility =
        driven.col(p).cwiseAbs2().cwiseQuotient(all).sum();
    const VectorXd felt = driven.col(p).tail(beyond.lambda.size()) /
                          std::sqrt(std::max(flexibility, 1e-300));
    for (Index k = 0; k < shifts; ++k) {
      const double sigma = top * static_cast<double>(k) / (shifts - 1);
      result.col(shifts * p + k) =
          felt.array() / (beyond.lambda.array() - sigma);
    }
  }
  return result;
}

// What the modes of other properties need beyond those kept, per root of their
// own stiffness.
MatrixXd changed_modes(const ReducedBase& base,
                       const Beyond& beyond,
                       const std::vector<double>& factor,
                       double top) {
  const auto [K, M] = base.at(factor, {});
  const Index m = beyond.first;
  const Index h = beyond.lambda.size();
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> kept(
      MatrixXd(K.topLeftCorner(m, m)), MatrixXd(M.topLeftCorner(m, m)));
  const VectorXd lambda = kept.eigenvalues().cwiseMax(0.0);
  const Index count =
      (lambda.array() < looked_at_reach * looked_at_reach * top).count();
  const MatrixXd phi = kept.eigenvectors().leftCols(count);
  MatrixXd load = K.bottomLeftCorner(h, m) * phi;
  load -= M.bottomLeftCorner(h, m) * phi * lambda.head(count).asDiagonal();
  for (Index k = 0; k < count; ++k) {
    load.col(k) /= std::sqrt(std::max(lambda(k), 1e-2 * top));
  }
  return -K.bottomRightCorner(h, h).ldlt().solve(load);
}

// Values of the terms' parameters and of the properties.
struct Setting {
  std::vector<double> p;
  std::vector<double> factor;
};

MatrixXd orthonormal_columns(const MatrixXd& A) {
  return Eigen::HouseholderQR<MatrixXd>(A).householderQ() *
         MatrixXd::Identity(A.rows(), A.cols());
}

// The span that takes what it lacks at one setting after another.
class GrowingSpan {
 public:
  GrowingSpan(const ReducedBase& base, const MatrixXd& driven, double top)
      : base_(base), driven_(driven), top_(top), span_(base.size(), 0) {}

  /// @return whether it lacked anything
  bool take(const Setting& at);
  /// Between two settings that it has, as finely as it takes.
  void take_between(const Setting& a, const Setting& b, int deepest);

  [[nodiscard]] MatrixXd orthonormal() const {
    return orthonormal_columns(span_);
  }

 private:
  // Modes at one setting.
  struct Modes {
    VectorXd lambda;
    MatrixXd phi;
    VectorXd root;  // of the energy of each
  };

  // The modes of the band and the answers through the others, in coordinates
  // of modes in which the energy is the square.
  [[nodiscard]] MatrixXd wanted(const Modes& modes) const;

  const ReducedBase& base_;
  const MatrixXd& driven_;
  double top_;
  MatrixXd span_;
};

MatrixXd GrowingSpan::wanted(const Modes& modes) const {
  const VectorXd& lambda = modes.lambda;
  const double reach = looked_at_reach * looked_at_reach * top_;
  const Index low = (lambda.array() < reach).count();
  const Index high = lambda.size() - low;
  constexpr Index shifts = 3;
  MatrixXd result =
      MatrixXd::Zero(lambda.size(), low + shifts * driven_.cols());
  result.topLeftCorner(low, low).setIdentity();
  const MatrixXd felt = modes.phi.transpose() * driven_;
  for (Index p = 0; p < driven_.cols(); ++p) {
    const double all = felt.col(p).cwiseQuotient(modes.root).norm();
    const VectorXd share =
        felt.col(p).cwiseProduct(modes.root).tail(high) / std::max(all, 1e-300);
    for (Index k = 0; k < shifts; ++k) {
      const double sigma = top_ * static_cast<double>(k) / (shifts - 1);
      result.col(low + shifts * p + k).tail(high) =
          share.array() / (lambda.tail(high).array() - sigma);
    }
  }
  return result;
}

bool GrowingSpan::take(const Setting& at) {
  const auto [K, M] = base_.at(at.factor, at.p);
  Modes modes;
  const auto keep = [&modes](const auto& solver) {
    modes.lambda = solver.eigenvalues().cwiseMax(0.0);
    modes.phi = solver.eigenvectors();
  };
  const bool unit_mass = M.isIdentity(1e-14);
  if (unit_mass) {
    keep(Eigen::SelfAdjointEigenSolver<MatrixXd>(K));
  } else {
    keep(Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(K, M));
  }
  modes.root = (modes.lambda.array() + least_energy * top_).sqrt();
  MatrixXd lacking = wanted(modes);
  if (span_.cols() > 0) {
    const MatrixXd moved = unit_mass ? span_ : MatrixXd(M * span_);
    const MatrixXd Q = orthonormal_columns(modes.root.asDiagonal() *
                                           (modes.phi.transpose() * moved));
    lacking -= Q * (Q.transpose() * lacking).eval();
  }
  // Its leading directions, of unit energy.
  const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(lacking.transpose() *
                                                     lacking);
  const VectorXd& energy = gram.eigenvalues();
  const Index fresh =
      (energy.array() > negligible_of_released * negligible_of_released)
          .count();
  if (fresh == 0) return false;
  const MatrixXd directions =
      lacking * gram.eigenvectors().rightCols(fresh) *
      energy.tail(fresh).cwiseSqrt().cwiseInverse().asDiagonal();
  MatrixXd wider(span_.rows(), span_.cols() + fresh);
  wider << span_,
      modes.phi * (modes.root.cwiseInverse().asDiagonal() * directions);
  span_ = std::move(wider);
  return true;
}

// Parameters run by their logarithm, as the stiffness of springs does.
void GrowingSpan::take_between(const Setting& a,
                               const Setting& b,
                               int deepest) {
  Setting middle = a;
  for (std::size_t k = 0; k < a.p.size(); ++k) {
    if (a.p[k] != b.p[k]) middle.p[k] = std::sqrt(a.p[k] * b.p[k]);
  }
  if (!take(middle) || deepest == 1) return;
  take_between(a, middle, deepest - 1);
  take_between(middle, b, deepest - 1);
}

Setting setting_of(const ReducedBase& base,
                   double ChangeRange::*value,
                   std::size_t properties) {
  Setting setting{{}, std::vector<double>(properties, 1.0)};
  for (const StiffnessTerm& term : base.terms) {
    setting.p.push_back(term.*value);
  }
  return setting;
}

// Each parameter over its range, the others as they are at `from`.
void take_ranges(const ReducedBase& base,
                 const Setting& from,
                 GrowingSpan& span) {
  for (std::size_t k = 0; k < base.terms.size(); ++k) {
    Setting low = from;
    Setting high = from;
    low.p[k] = base.terms[k].lower;
    high.p[k] = base.terms[k].upper;
    span.take(low);
    span.take(high);
    span.take_between(low, high, halvings);
  }
}

}  // namespace

MatrixXd lean_span(const ReducedBase& base,
                   const MatrixXd& driven,
                   const LeanOptions& options) {
  const double top = std::pow(2.0 * std::numbers::pi * options.high_hz, 2);
  const VectorXd lambda = base.K.diagonal();
  Beyond beyond;
  beyond.first = std::min<Index>(
      std::max<Index>((lambda.array() < kept_reach * kept_reach * top).count(),
                      1),
      base.size());
  beyond.lambda = lambda.tail(base.size() - beyond.first);
  const Index h = beyond.lambda.size();
  if (h == 0) return MatrixXd::Identity(base.size(), base.size());
  std::vector<MatrixXd> all = {answers(base, beyond, driven, top)};
  const std::vector<double> nominal(options.spread.size(), 1.0);
  for (std::size_t j = 0; j < options.spread.size(); ++j) {
    for (const double sign : {-1.0, 1.0}) {
      std::vector<double> factor = nominal;
      factor[j] = std::exp(sign * options.spread[j]);
      all.push_back(changed_modes(base, beyond, factor, top));
    }
  }
  // In the coordinates in which stiffness is the unit.
  const VectorXd root = beyond.lambda.cwiseSqrt();
  const MatrixXd S = root.asDiagonal() * join(all);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(S * S.transpose());
  const Index kept =
      (gram.eigenvalues().array() > negligible * negligible).count();
  MatrixXd span = MatrixXd::Zero(base.size(), beyond.first + kept);
  span.topLeftCorner(beyond.first, beyond.first).setIdentity();
  // Frequencies alone are measured at no point.
  if (kept == 0) return span;
  const MatrixXd directions =
      root.cwiseInverse().asDiagonal() * gram.eigenvectors().rightCols(kept);
  span.bottomRightCorner(h, kept) =
      Eigen::HouseholderQR<MatrixXd>(directions).householderQ() *
      MatrixXd::Identity(h, kept);
  return span;
}

MatrixXd released_span(const ReducedBase& base,
                       const MatrixXd& driven,
                       const LeanOptions& options) {
  const double top = std::pow(2.0 * std::numbers::pi * options.high_hz, 2);
  GrowingSpan span(base, driven, top);
  const std::size_t properties = options.spread.size();
  const Setting absent = setting_of(base, &ChangeRange::absent, properties);
  const Setting start = setting_of(base, &ChangeRange::start, properties);
  span.take(absent);
  // A support that is not there at all.
  span.take(setting_of(base, &ChangeRange::included, properties));
  take_ranges(base, absent, span);
  if (base.terms.size() > 1) {
    take_ranges(base, start, span);
    span.take(setting_of(base, &ChangeRange::lower, properties));
  }
  for (std::size_t j = 0; j < properties; ++j) {
    for (const double sign : {-1.0, 1.0}) {
      Setting other = start;
      other.factor[j] = std::exp(sign * options.spread[j]);
      span.take(other);
    }
  }
  return span.orthonormal();
}

}  // namespace tapfit::updating
