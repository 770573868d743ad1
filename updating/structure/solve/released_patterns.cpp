#include "updating/structure/solve/released_patterns.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <utility>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// A motion that strains nothing has this share of the energy at the band's top.
constexpr double least_energy = 1e-2;
// Of the amplitude (root of the energy) of a load's answer.
constexpr double negligible = 1e-4;
// Sizes of a spring over its range, by the logarithm.
constexpr int sizes = 6;
constexpr int shifts = 3;

class Patterns {
 public:
  Patterns(const ReleasedMotions& motions) : motions_(motions) {}

  // What it lacks of the answers with these springs, in their energy.
  void take(const MatrixXd& springs) {
    const MatrixXd K = motions_.K + springs;
    const Eigen::LLT<MatrixXd> energy(K +
                                      least_energy * motions_.top * motions_.M);
    if (energy.info() != Eigen::Success) return;
    const Index loads = motions_.loads.cols();
    MatrixXd q(K.rows(), shifts * loads);
    q.leftCols(loads) = energy.solve(motions_.loads);
    for (Index k = 1; k < shifts; ++k) {
      const double mu = motions_.top * static_cast<double>(k) / (shifts - 1);
      q.middleCols(k * loads, loads) =
          (K - mu * motions_.M).partialPivLu().solve(motions_.loads);
    }
    const auto U = energy.matrixU();
    MatrixXd lacking = U * q;
    if (span_.cols() > 0) {
      const MatrixXd known = U * span_;
      lacking -=
          known *
          (known.transpose() * known).ldlt().solve(known.transpose() * lacking);
    }
    const Eigen::SelfAdjointEigenSolver<MatrixXd> energies(lacking *
                                                           lacking.transpose());
    const Index fresh =
        (energies.eigenvalues().array() > negligible * negligible).count();
    if (fresh == 0) return;
    const Index known = span_.cols();
    span_.conservativeResize(K.rows(), known + fresh);
    span_.rightCols(fresh) =
        U.solve(MatrixXd(energies.eigenvectors().rightCols(fresh)));
  }

  [[nodiscard]] MatrixXd span() && { return std::move(span_); }

 private:
  const ReleasedMotions& motions_;
  MatrixXd span_;
};

}  // namespace

MatrixXd released_patterns(const ReleasedMotions& motions,
                           const std::vector<ReleasedSprings>& springs) {
  const Index n = motions.K.rows();
  Patterns patterns(motions);
  const auto with = [&](const auto& size_of) {
    MatrixXd sum = MatrixXd::Zero(n, n);
    for (std::size_t k = 0; k < springs.size(); ++k) {
      sum += size_of(k) * springs[k].S;
    }
    return sum;
  };
  patterns.take(MatrixXd::Zero(n, n));
  patterns.take(with([&](std::size_t k) { return springs[k].lower; }));
  for (std::size_t own = 0; own < springs.size(); ++own) {
    const double low = std::log(springs[own].lower);
    const double high = std::log(springs[own].upper);
    for (int step = 0; step < sizes; ++step) {
      const double size = std::exp(low + (high - low) * step / (sizes - 1));
      patterns.take(with(
          [&](std::size_t k) { return k == own ? size : springs[k].upper; }));
    }
  }
  return std::move(patterns).span();
}

}  // namespace tapfit::structure
