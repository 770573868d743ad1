// Solids: rigid motions strain nothing, constant strains are exact on distorted
// meshes (patch test), mass, and closed forms of beams.
#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/elements/element_matrices.hpp"
#include "updating/structure/elements/solid_shapes.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <random>

namespace tapfit::structure {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double aluminium_modulus = 70e9;
constexpr double nu = 0.3;
constexpr double rho = 2700.0;

std::vector<Vector3d> corners_of(std::size_t corners) {
  switch (corners) {
    case 8:
      return {{0, 0, 0},
              {1, 0, 0},
              {1, 1, 0},
              {0, 1, 0},
              {0, 0, 1},
              {1, 0, 1},
              {1, 1, 1},
              {0, 1, 1}};
    case 6:
      return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    case 5:
      return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {.5, .5, 1}};
    default:
      return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  }
}

// One element, its corners moved at random, its middles on straight edges.
Deck single(std::size_t corners, bool quadratic, double distortion) {
  Deck deck;
  deck.coupled_mass = true;
  deck.materials[1] = {1,
                       false,
                       aluminium_modulus,
                       nu,
                       aluminium_modulus / (2 + 2 * nu),
                       rho,
                       0,
                       0,
                       0};
  deck.solid_properties[1] = {1, 1, ""};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-distortion, distortion);
  Solid solid{1, 1, {}};
  std::vector<Vector3d> places = corners_of(corners);
  for (Vector3d& x : places) {
    for (Eigen::Index k = 0; k < 3; ++k) x(k) += shift(random);
  }
  if (quadratic) {
    for (const auto& [a, b] : solid_edges(corners)) {
      places.push_back(0.5 * (places[static_cast<std::size_t>(a)] +
                              places[static_cast<std::size_t>(b)]));
    }
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    const int id = static_cast<int>(k) + 1;
    deck.grids.push_back({id, places[k]});
    (k < corners ? solid.grids : solid.mids).push_back(id);
  }
  deck.solids.push_back(solid);
  return deck;
}

struct Kind {
  std::size_t corners;
  bool quadratic;
};

class Solids : public ::testing::TestWithParam<Kind> {};

// Displacements of a linear field u = A x + b at the grids.
VectorXd linear_field(const Deck& deck,
                      const Eigen::Matrix3d& A,
                      const Vector3d& b) {
  VectorXd u = VectorXd::Zero(6 * static_cast<Eigen::Index>(deck.grids.size()));
  for (std::size_t k = 0; k < deck.grids.size(); ++k) {
    u.segment<3>(6 * static_cast<Eigen::Index>(k)) =
        A * deck.grids[k].position + b;
  }
  return u;
}

TEST_P(Solids, RigidMotionsAndNothingElseHaveNoEnergy) {
  const Deck deck = single(GetParam().corners, GetParam().quadratic, 0.15);
  const ElementMatrices e = solid_matrices(deck, deck.solids[0]);
  const auto n = static_cast<Eigen::Index>(e.grids.size());
  std::vector<Eigen::Index> moves;
  for (Eigen::Index i = 0; i < 6 * n; ++i) {
    if (i % 6 < 3) moves.push_back(i);
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
      MatrixXd(e.K(moves, moves)));
  const double most = solver.eigenvalues().maxCoeff();
  // Rounding of entries of the size of `most`.
  EXPECT_LT(solver.eigenvalues().head(6).cwiseAbs().maxCoeff(), 1e-11 * most);
  EXPECT_GT(solver.eigenvalues()(6), 1e-4 * most);
  Eigen::Matrix3d spin;
  spin << 0, -3, 2, 3, 0, -1, -2, 1, 0;
  const VectorXd u = linear_field(deck, spin, {1, 2, 3});
  EXPECT_LT((e.K * u).norm(), 1e-11 * most * u.norm());
}

TEST_P(Solids, ConstantStrainIsExactOnAnyShape) {
  // Energy of a linear field: 1/2 e' C e times the volume, from the mass.
  const Deck deck = single(GetParam().corners, GetParam().quadratic, 0.15);
  const ElementMatrices e = solid_matrices(deck, deck.solids[0]);
  Eigen::Matrix3d A;
  A << 1.0, 0.4, -0.2, 0.3, -0.5, 0.6, 0.1, 0.2, 0.7;
  const VectorXd u = linear_field(deck, A, {0, 0, 0});
  const VectorXd ones =
      linear_field(deck, Eigen::Matrix3d::Zero(), Vector3d::UnitX());
  const double volume = ones.dot(e.M * ones) / rho;
  const Eigen::Matrix3d strain = 0.5 * (A + A.transpose());
  const double G = aluminium_modulus / (2 + 2 * nu);
  const double lame = aluminium_modulus * nu / ((1 + nu) * (1 - 2 * nu));
  const double trace = strain.trace();
  const double expected =
      volume * (lame * trace * trace + 2.0 * G * strain.squaredNorm());
  EXPECT_NEAR(u.dot(e.K * u), expected, 1e-9 * expected);
}

TEST_P(Solids, LumpedMassIsWholeAndPositive) {
  Deck deck = single(GetParam().corners, GetParam().quadratic, 0.0);
  const MatrixXd consistent = solid_matrices(deck, deck.solids[0]).M;
  deck.coupled_mass = false;
  const MatrixXd lumped = solid_matrices(deck, deck.solids[0]).M;
  EXPECT_NEAR(lumped.trace(), consistent.sum(), 1e-12 * lumped.trace());
  for (Eigen::Index i = 0; i < lumped.rows(); ++i) {
    if (i % 6 < 3) {
      EXPECT_GT(lumped(i, i), 0.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All,
                         Solids,
                         ::testing::Values(Kind{8, false},
                                           Kind{8, true},
                                           Kind{6, false},
                                           Kind{6, true},
                                           Kind{5, false},
                                           Kind{5, true},
                                           Kind{4, false},
                                           Kind{4, true}),
                         [](const auto& kind) {
                           return std::to_string(kind.param.corners) +
                                  (kind.param.quadratic ? "quadratic"
                                                        : "linear");
                         });

// A cantilever along x of nx by ny by nz hexahedra (or two wedges each).
Deck cantilever(int nx, int ny, int nz, bool wedges) {
  constexpr double beam_length = 1.0;
  constexpr double width = 0.1;
  constexpr double beam_height = 0.05;
  Deck deck;
  deck.coupled_mass = true;
  deck.materials[1] = {
      1, false, aluminium_modulus, 0.0, aluminium_modulus / 2, rho, 0, 0, 0};
  deck.solid_properties[1] = {1, 1, ""};
  const auto id = [&](int i, int j, int k) {
    return 1 + (i * (ny + 1) + j) * (nz + 1) + k;
  };
  for (int i = 0; i <= nx; ++i) {
    for (int j = 0; j <= ny; ++j) {
      for (int k = 0; k <= nz; ++k) {
        deck.grids.push_back(
            {id(i, j, k),
             {beam_length * i / nx, width * j / ny, beam_height * k / nz}});
        if (i == 0) deck.constraints.push_back({id(i, j, k), "123"});
      }
    }
  }
  int next = 1;
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      for (int k = 0; k < nz; ++k) {
        const std::array<int, 8> g{id(i, j, k),
                                   id(i + 1, j, k),
                                   id(i + 1, j + 1, k),
                                   id(i, j + 1, k),
                                   id(i, j, k + 1),
                                   id(i + 1, j, k + 1),
                                   id(i + 1, j + 1, k + 1),
                                   id(i, j + 1, k + 1)};
        if (!wedges) {
          deck.solids.push_back({next++, 1, {g.begin(), g.end()}});
          continue;
        }
        deck.solids.push_back(
            {next++, 1, {g[0], g[1], g[2], g[4], g[5], g[6]}});
        deck.solids.push_back(
            {next++, 1, {g[0], g[2], g[3], g[4], g[6], g[7]}});
      }
    }
  }
  return deck;
}

// Euler-Bernoulli, less shear and rotary inertia of a beam twenty times as long
// as high (0.3 %).
double first_bending(double height) {
  const double x = 1.8751041;
  return x * x / (2.0 * M_PI) * height / std::sqrt(12.0) *
         std::sqrt(aluminium_modulus / rho);
}

TEST(SolidBeam, OneHexahedronAcrossBendsLikeABeam) {
  const Deck deck = cantilever(20, 1, 1, false);
  const Eigenmodes modes = modes_of(deck, 2);
  EXPECT_NEAR(
      modes.frequency_hz(0), first_bending(0.05), 0.006 * first_bending(0.05));
  EXPECT_NEAR(
      modes.frequency_hz(1), first_bending(0.1), 0.02 * first_bending(0.1));
}

TEST(SolidBeam, WedgesBendAcrossTheirTriangles) {
  const Deck deck = cantilever(20, 2, 1, true);
  const Eigenmodes modes = modes_of(deck, 1);
  // Curvature is constant over a triangle: of first order in the mesh.
  EXPECT_NEAR(
      modes.frequency_hz(0), first_bending(0.05), 0.06 * first_bending(0.05));
}

TEST(SolidElement, InsideOutIsRefused) {
  Deck deck = single(4, false, 0.0);
  std::swap(deck.solids[0].grids[0], deck.solids[0].grids[1]);
  deck.solids[0].where = "model.bdf:7 CTETRA 1";
  EXPECT_THAT(
      [&] { static_cast<void>(solid_matrices(deck, deck.solids[0])); },
      Throws<InputError>(
          AllOf(Property(&InputError::what, HasSubstr("model.bdf:7 CTETRA 1")),
                Property(&InputError::what, HasSubstr("inside out")))));
}

TEST(SolidElement, AnisotropicMaterialTurnsWithItsAxes) {
  // An isotropic MAT9 is a MAT1 along any axes; of an orthotropic one a bar
  // along its third axis has E3.
  Deck deck = single(8, false, 0.1);
  const MatrixXd K = solid_matrices(deck, deck.solids[0]).K;
  const double G = aluminium_modulus / (2 + 2 * nu);
  const double lame = aluminium_modulus * nu / ((1 + nu) * (1 - 2 * nu));
  MatrixXd C = MatrixXd::Zero(6, 6);
  C.topLeftCorner(3, 3).setConstant(lame);
  C.diagonal() << lame + 2 * G, lame + 2 * G, lame + 2 * G, G, G, G;
  deck.materials[1].solid = C;
  deck.solid_properties[1].axes =
      Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const MatrixXd turned = solid_matrices(deck, deck.solids[0]).K;
  EXPECT_LT((K - turned).norm(), 1e-10 * K.norm());
}

}  // namespace
}  // namespace tapfit::structure
