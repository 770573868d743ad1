#include "modal/mode_set/mac.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

namespace tapfit::modal {
namespace {

Eigen::MatrixXcd random_shapes(Eigen::Index n, Eigen::Index m, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXcd::NullaryExpr(n, m, [&] {
    return std::complex<double>(normal(random), normal(random));
  });
}

TEST(Mac, IsOneForTheSameShapeInAnyScaleAndPhase) {
  const Eigen::MatrixXcd U = random_shapes(7, 3, 1);
  const Eigen::MatrixXcd V = std::complex<double>(-0.3, 2.0) * U;
  const Eigen::MatrixXd result = mac(U, V);
  // Rounding of a sum of seven products.
  EXPECT_LT((result.diagonal().array() - 1.0).abs().maxCoeff(), 1e-14);
  EXPECT_GE(result.minCoeff(), 0.0);
  EXPECT_LE(result.maxCoeff(), 1.0);
}

TEST(Mac, MatchesItsDefinition) {
  const Eigen::MatrixXcd U = random_shapes(5, 2, 2);
  const Eigen::MatrixXcd V = random_shapes(5, 4, 3);
  const Eigen::MatrixXd result = mac(U, V);
  ASSERT_EQ(result.rows(), 2);
  ASSERT_EQ(result.cols(), 4);
  for (Eigen::Index i = 0; i < 2; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      std::complex<double> inner = 0.0;
      double uu = 0.0;
      double vv = 0.0;
      for (Eigen::Index k = 0; k < 5; ++k) {
        inner += std::conj(U(k, i)) * V(k, j);
        uu += std::norm(U(k, i));
        vv += std::norm(V(k, j));
      }
      EXPECT_NEAR(result(i, j), std::norm(inner) / uu / vv, 1e-14);
    }
  }
}

TEST(Mac, IsZeroForOrthogonalAndForZeroShapes) {
  Eigen::MatrixXcd U = Eigen::MatrixXcd::Zero(3, 2);
  U(0, 0) = 1.0;
  Eigen::MatrixXcd V = Eigen::MatrixXcd::Zero(3, 1);
  V(1, 0) = 2.0;
  EXPECT_EQ(mac(U, V), Eigen::MatrixXd::Zero(2, 1));
}

TEST(Comac, IsOneWhereShapesAgreeInScaleAndSign) {
  const Eigen::MatrixXcd U = random_shapes(6, 4, 5);
  Eigen::MatrixXcd V = -2.0 * U;
  // A point whose motion is swapped between modes agrees less.
  V.row(2) = U.row(2).reverse();
  const Eigen::VectorXd result = comac(U, V);
  for (const Eigen::Index k : {0, 1, 3, 4, 5}) {
    EXPECT_NEAR(result(k), 1.0, 1e-14);
  }
  EXPECT_LT(result(2), 0.99);
}

// Shapes that a laboratory scales one by one, also by a phase: their MAC is 1.
TEST(Comac, IsOneInTheOthersScale) {
  const Eigen::MatrixXcd V = random_shapes(6, 3, 5);
  Eigen::MatrixXcd U = V;
  U.col(0) *= std::complex<double>(0.0, 30.0);
  U.col(1) *= -0.02;
  EXPECT_LT(comac(U, V).minCoeff(), 0.9);
  const Eigen::MatrixXcd scaled = in_scale_of(U, V);
  EXPECT_LT((scaled - V).norm(), 1e-14 * V.norm());
  EXPECT_NEAR(comac(scaled, V).minCoeff(), 1.0, 1e-14);
  // A shape of nothing stays one.
  U.col(2).setZero();
  EXPECT_EQ(in_scale_of(U, V).col(2).norm(), 0.0);
}

TEST(MassWeightedMac, TellsApartWhatUnevenPointsConfuse) {
  // A free-free bar of five equal masses, orthonormal in the mass matrix; the
  // last point stands for most of the mass.
  Eigen::MatrixXd W = Eigen::VectorXd::Ones(5).asDiagonal();
  W(4, 4) = 20.0;
  Eigen::MatrixXd V = random_shapes(5, 3, 8).real();
  // Gram-Schmidt in W.
  for (Eigen::Index k = 0; k < 3; ++k) {
    for (Eigen::Index j = 0; j < k; ++j) {
      V.col(k) -= V.col(j).dot(W * V.col(k)) * V.col(j);
    }
    V.col(k) /= std::sqrt(V.col(k).dot(W * V.col(k)));
  }
  const Eigen::MatrixXcd shapes = V.cast<std::complex<double>>();
  const Eigen::MatrixXd weighted = mass_weighted_mac(shapes, shapes, W);
  EXPECT_LT((weighted - Eigen::MatrixXd::Identity(3, 3)).norm(), 1e-12);
  EXPECT_GT((auto_mac(shapes) - Eigen::MatrixXd::Identity(3, 3)).norm(), 0.1);
}

/// Chain of masses with springs between them and one to the ground, k in N/m.
struct Chain {
  Eigen::VectorXd m;
  double to_ground = 0.0;

  [[nodiscard]] Eigen::MatrixXd K() const {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(m.size(), m.size());
    for (Eigen::Index k = 0; k + 1 < m.size(); ++k) {
      const double stiffness = 100.0 + 50.0 * static_cast<double>(k);
      result.block<2, 2>(k, k) +=
          stiffness * (Eigen::Matrix2d() << 1.0, -1.0, -1.0, 1.0).finished();
    }
    result(0, 0) += to_ground;
    return result;
  }
};

TEST(CondensedMass, IsTheMassWhereAllOfItIsMeasured) {
  Chain chain{Eigen::VectorXd::LinSpaced(5, 1.0, 9.0), 80.0};
  const Eigen::MatrixXd M = chain.m.asDiagonal();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      chain.K(), M);
  const Eigen::MatrixXd W = condensed_mass(
      modes.eigenvectors(), modes.eigenvalues().cwiseMax(0.0).cwiseSqrt());
  EXPECT_LT((W - M).norm(), 1e-9 * M.norm());
}

// By its definition T' M T with T = [I; -K_oo^-1 K_oa], free and held.
TEST(CondensedMass, IsGuyansOfTheMatrices) {
  for (const double to_ground : {0.0, 80.0}) {
    const Chain chain{Eigen::VectorXd::LinSpaced(6, 1.0, 3.0), to_ground};
    const Eigen::MatrixXd M = chain.m.asDiagonal();
    const Eigen::MatrixXd K = chain.K();
    const std::vector<Eigen::Index> seen{0, 2, 5};
    const std::vector<Eigen::Index> other{1, 3, 4};
    Eigen::MatrixXd T = Eigen::MatrixXd::Zero(6, 3);
    for (Eigen::Index k = 0; k < 3; ++k) {
      T(seen[static_cast<std::size_t>(k)], k) = 1.0;
    }
    T(other, Eigen::all) = -K(other, other).inverse() * K(other, seen);
    const Eigen::MatrixXd guyan = T.transpose() * M * T;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(K, M);
    const Eigen::MatrixXd V = modes.eigenvectors()(seen, Eigen::all);
    const Eigen::MatrixXd W =
        condensed_mass(V, modes.eigenvalues().cwiseMax(0.0).cwiseSqrt());
    // A free body's thousandth enters squared, times the ratio of its whole
    // mass to the parts that bend; held, only rounding is left.
    EXPECT_LT((W - guyan).norm(),
              (to_ground > 0.0 ? 1e-9 : 1e-3) * guyan.norm())
        << to_ground;
  }
}

TEST(Macco, NamesTheTurnedSensorFirst) {
  const Eigen::MatrixXcd U = random_shapes(10, 4, 3);
  Eigen::MatrixXcd V = U + 0.02 * random_shapes(10, 4, 4);
  V.row(6) *= -1.0;
  const std::vector<LeftOut> steps = macco(U, V, 3);
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[0].dof, 6);
  EXPECT_GT(steps[0].mean_mac, 0.99);
  EXPECT_LT(mac(U, V).diagonal().mean(), 0.9);
  // By its definition: MAC of what stays.
  std::vector<Eigen::Index> rest{0, 1, 2, 3, 4, 5, 7, 8, 9};
  EXPECT_NEAR(steps[0].mean_mac,
              mac(U(rest, Eigen::all), V(rest, Eigen::all)).diagonal().mean(),
              1e-12);
  EXPECT_EQ(macco(U, V, 100).size(), 9U);
}

// Coverage of the interval where the shapes differ, where they agree, and with
// errors that differ from point to point.
TEST(MacWithUncertainty, IntervalsHoldTheTruth) {
  for (const double mixed : {0.0, 0.05, 0.5}) {
    const Eigen::VectorXcd shape = random_shapes(12, 1, 21).real();
    const Eigen::VectorXcd other =
        shape + mixed * random_shapes(12, 1, 22).real();
    const double truth = mac(shape, other)(0, 0);
    Eigen::VectorXd sd(12);
    for (Eigen::Index k = 0; k < 12; ++k) sd(k) = 0.02 + 0.01 * double(k % 4);
    std::mt19937_64 random(23);
    std::normal_distribution<double> normal;
    int inside = 0;
    double mean = 0.0;
    constexpr int seeds = 500;
    for (int seed = 0; seed < seeds; ++seed) {
      Eigen::VectorXcd u = shape;
      for (Eigen::Index k = 0; k < 12; ++k) {
        u(k) += sd(k) / std::sqrt(2.0) *
                std::complex<double>(normal(random), normal(random));
      }
      const MacEstimate found = mac_with_uncertainty(u, sd, other);
      mean += found.value / seeds;
      if (found.lo95 <= truth && truth <= found.hi95) ++inside;
    }
    SCOPED_TRACE(mixed);
    EXPECT_GE(inside, 450);  // 90 %
    // At MAC = 1 the truth is the end of what can be: the interval, cut there,
    // holds it more often.
    if (mixed > 0.0) {
      EXPECT_LE(inside, 495);  // 99 %
    }
    // Without the correction it would be sum sd^2 / |u|^2 = 1e-3 too low.
    EXPECT_NEAR(mean, truth, 4e-4);
  }
}

TEST(MacWithUncertainty, IsNothingForShapesOfZeros) {
  const Eigen::VectorXcd zero = Eigen::VectorXcd::Zero(3);
  EXPECT_EQ(mac_with_uncertainty(zero, Eigen::VectorXd::Ones(3), zero).value,
            0.0);
}

}  // namespace
}  // namespace tapfit::modal
