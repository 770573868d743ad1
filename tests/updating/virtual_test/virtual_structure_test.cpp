#include "updating/virtual_test/virtual_structure.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "tests/updating/support/virtual_strip.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/factor.hpp"
#include "updating/virtual_test/virtual_panel.hpp"
#include "updating/virtual_test/virtual_points.hpp"

#include <Eigen/LU>
#include <Eigen/SparseLU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::updating {
namespace {

using support::grid_at;
using support::Strip;

using Complex = std::complex<double>;

Complex receptance(const ReducedTruth& truth, Eigen::Index hammer, double hz) {
  const Complex s(0.0, two_pi * hz);
  const Eigen::MatrixXcd Z = truth.system.M.cast<Complex>() * s * s +
                             truth.system.C.cast<Complex>() * s +
                             truth.system.K.cast<Complex>();
  const Eigen::VectorXcd b = truth.hammers.col(hammer).cast<Complex>();
  return (truth.system.output.cast<Complex>() * Z.partialPivLu().solve(b))(0);
}

TEST(VirtualPanel, FrameHasItsMassAndFinerMeshesKeepItsGrids) {
  const Panel panel = frame_panel();
  const PanelMesh model = mesh_panel(panel, 1);
  const PanelMesh fine = mesh_panel(panel, 2);
  const double area = 2 * 0.90 * 0.06 + 3 * 0.43 * 0.06;
  const structure::System system = structure::assemble(model.deck);
  EXPECT_NEAR(structure::total_mass(model.deck, system),
              area * panel.thickness * panel.rho,
              1e-9);
  EXPECT_EQ(fine.deck.shells.size(), 4 * model.deck.shells.size());
  for (const structure::Grid& grid : model.deck.grids) {
    const structure::Grid& same =
        fine.deck.grids[fine.deck.grid_index(grid.id)];
    EXPECT_LT((same.position - grid.position).norm(), 1e-12) << grid.id;
  }
  EXPECT_EQ(fine.children.size(), model.deck.shells.size());
  for (const auto& [id, parts] : fine.children) EXPECT_EQ(parts.size(), 4U);
}

TEST(VirtualPanel, FrameSoundsAsInThePaper) {
  // Table 7 before updating: 2.34 7.92 13.87 29.10 Hz. The paper does not give
  // its frame's dimensions; ours is near, the fourth mode least.
  const structure::Deck deck = mesh_panel(frame_panel(), 1).deck;
  const Eigen::VectorXd hz = model_shapes(deck, 3, 30.0).frequency_hz;
  ASSERT_GE(hz.size(), 4);
  EXPECT_NEAR(hz(0), 2.34, 0.04 * 2.34);
  EXPECT_NEAR(hz(1), 7.92, 0.02 * 7.92);
  EXPECT_NEAR(hz(2), 13.87, 0.01 * 13.87);
  EXPECT_NEAR(hz(3), 29.10, 0.15 * 29.10);
}

TEST(VirtualStructure, ReducedAnswerIsThatOfTheWholeMatrices) {
  const Strip strip;
  const std::vector<VirtualEffect> effects{
      parse_virtual_effect("ground-spring@" + std::to_string(strip.other.node) +
                           "=400"),
      parse_virtual_effect("sensor-mass=0.004")};
  const VirtualStructure whole =
      build_virtual_structure(strip.model, effects, 0.97, 3);
  VirtualDamping none;
  none.mean = 1e-9;
  const ReducedTruth truth = reduce_truth(
      whole, strip.sensors, {strip.other, strip.corner}, 600.0, none);

  structure::SparseMatrix M = whole.M;
  const int sensor = whole.dof_index(strip.corner);
  for (int c = -2; c <= 0; ++c) M.coeffRef(sensor + c, sensor + c) += 0.004;
  const std::vector<int>& free = whole.motions.free;
  const auto free_row = [&](const Dof& dof) {
    const auto at = std::find(free.begin(), free.end(), whole.dof_index(dof));
    return at - free.begin();
  };
  for (const double hz : {5.0, 33.0, 90.0, 150.0}) {
    const structure::SparseMatrix Z =
        structure::extract(whole.K, free) -
        std::pow(two_pi * hz, 2) * structure::extract(M, free);
    const structure::Factor factor(Z);
    const Dof hammers[] = {strip.other, strip.corner};
    for (int h = 0; h < 2; ++h) {
      Eigen::MatrixXd b = Eigen::MatrixXd::Zero(Z.rows(), 1);
      b(free_row(hammers[h]), 0) = 1.0;
      const double exact = factor.solve(b)(free_row(strip.corner), 0);
      // Modes to four times the last line; what stands for the others
      // answers with 5 % damping of its own, a small part of the whole.
      EXPECT_LT(std::abs(receptance(truth, h, hz) - exact),
                1e-3 * std::abs(exact))
          << hz << " Hz, hammer " << h;
    }
  }
}

TEST(VirtualStructure, HoldsArmsAndDashpotsOfTheDeck) {
  // An arm up from the sensor's corner, with a dashpot along x at its end.
  Strip strip;
  structure::ScalarElement damper;
  damper.id = 8001;
  damper.grids = {9000, 0};
  damper.components = {1, 0};
  damper.damping = 3.0;
  for (structure::Deck* deck : {&strip.model.model, &strip.model.fine}) {
    deck->grids.push_back({9000, {0.30, 0.0, 0.05}});
    deck->rigids.push_back({8000, strip.corner.node, {{9000, "123456"}}, {}});
    deck->scalars.push_back(damper);
  }
  const VirtualStructure whole = build_virtual_structure(
      strip.model, {parse_virtual_effect("absorber@9000=0.01,60,0.1")}, 1.0, 3);
  VirtualDamping none;
  none.mean = 1e-9;
  const ReducedTruth truth = reduce_truth(
      whole, strip.sensors, {strip.other, {9000, 1, -1}}, 2400.0, none);

  const structure::SparseMatrix K = whole.motions.reduce(whole.K);
  const structure::SparseMatrix M = whole.motions.reduce(whole.M);
  const auto unit = [&whole](const std::vector<std::pair<int, double>>& dofs) {
    Eigen::MatrixXd u = Eigen::MatrixXd::Zero(whole.K.rows(), 1);
    for (const auto& [dof, part] : dofs) u(dof, 0) = part;
    return Eigen::VectorXcd(whole.motions.project(u).cast<Complex>());
  };
  const int x = whole.dof_index({9000, 1, 1});
  const int own = static_cast<int>(whole.K.rows()) - 1;
  const Eigen::VectorXcd seen = unit({{whole.dof_index(strip.corner), 1.0}});
  const Eigen::VectorXcd hits[] = {unit({{whole.dof_index(strip.other), 1.0}}),
                                   unit({{x, -1.0}})};
  const std::pair<Eigen::VectorXcd, double> dashpots[] = {
      {unit({{x, 1.0}}), 3.0},
      {unit({{x + 2, 1.0}, {own, -1.0}}), 2.0 * 0.1 * two_pi * 60.0 * 0.01}};
  for (const double hz : {9.0, 33.0, 60.0, 150.0}) {
    const double w = two_pi * hz;
    Eigen::SparseMatrix<Complex> Z =
        structure::SparseMatrix(K - w * w * M).cast<Complex>();
    for (const auto& [b, c] : dashpots) {
      const Eigen::SparseMatrix<Complex> B = b.sparseView();
      Z += Complex(0.0, w * c) * B * B.transpose();
    }
    const Eigen::SparseLU<Eigen::SparseMatrix<Complex>> lu(Z);
    for (int h = 0; h < 2; ++h) {
      const Complex exact =
          (seen.transpose() * Eigen::VectorXcd(lu.solve(hits[h])))(0);
      // As above; across the strip the higher modes take part, hence 2400 Hz.
      EXPECT_LT(std::abs(receptance(truth, h, hz) - exact),
                1e-3 * std::abs(exact))
          << hz << " Hz, hammer " << h;
    }
  }
}

TEST(VirtualStructure, ModulusScalesEveryFrequency) {
  const Strip strip;
  const auto first = [&](double factor) {
    return reduce_truth(build_virtual_structure(strip.model, {}, factor, 3),
                        strip.sensors,
                        {strip.other},
                        400.0,
                        {})
        .frequency_hz(0);
  };
  // f goes with the root of E, exactly.
  EXPECT_NEAR(first(1.05) / first(1.0), std::sqrt(1.05), 1e-8);
}

TEST(VirtualStructure, CableDashpotAddsItsDamping) {
  const Strip strip;
  const ReducedTruth plain = strip.reduced({});
  const double c = 0.01;
  const ReducedTruth cable = strip.reduced({"sensor-cable=0,0.01"});
  // First order: c phi^2 = 2 zeta w, for a dashpot this small.
  const double phi = plain.system.output(0, 0);
  const double w = std::sqrt(plain.system.K(0, 0));
  const double added = c * phi * phi / (2.0 * w);
  EXPECT_NEAR(
      cable.damping_ratio(0) - plain.damping_ratio(0), added, 0.01 * added);
}

TEST(VirtualStructure, SensorMassMovesWithItsSensor) {
  Strip strip;
  const double at_tip = strip.reduced({"sensor-mass=0.01"}).frequency_hz(0);
  strip.sensors[0].dof.node = grid_at(strip.model.model, 0.03, 0.0);
  const double at_root = strip.reduced({"sensor-mass=0.01"}).frequency_hz(0);
  const double none = strip.reduced({}).frequency_hz(0);
  EXPECT_LT(at_tip, 0.9 * none);
  EXPECT_NEAR(at_root, none, 2e-3 * none);
  EXPECT_LT(at_root, none);
}

TEST(VirtualStructure, EverySensorMayHaveItsOwnMass) {
  Strip strip;
  strip.sensors.push_back({"acc2", strip.other});
  const auto first = [&strip](const std::vector<std::string>& texts) {
    return strip.reduced(texts).frequency_hz;
  };
  // The same mass matrix, so the same frequencies to the bit.
  const Eigen::VectorXd each = first({"sensor-mass=0.004,0.01"});
  EXPECT_EQ(each, first({"sensor-mass@acc1=0.004", "sensor-mass@acc2=0.01"}));
  EXPECT_EQ(each, first({"sensor-mass@acc2:acc1=0.01,0.004"}));
  EXPECT_EQ(first({"sensor-mass=0.01,0.01"}), first({"sensor-mass=0.01"}));
  EXPECT_NE(each(0), first({"sensor-mass=0.01"})(0));
}

TEST(VirtualStructure, AbsorberAddsAMode) {
  const Strip strip;
  const std::string node = std::to_string(strip.other.node);
  const ReducedTruth plain = strip.reduced({}, 0.005, 100.0);
  const ReducedTruth with =
      strip.reduced({"absorber@" + node + "=0.001,40,0.02"}, 0.005, 100.0);
  EXPECT_EQ(with.frequency_hz.size(), plain.frequency_hz.size() + 1);
}

TEST(VirtualStructure, LostStiffnessOfAllIsALowerModulus) {
  const Strip strip;
  std::string all = "stiffness-loss@1";
  for (std::size_t k = 2; k <= strip.model.model.shells.size(); ++k) {
    all += ":" + std::to_string(k);
  }
  EXPECT_NEAR(strip.reduced({all + "=0.81"}).frequency_hz(0),
              0.9 * strip.reduced({}).frequency_hz(0),
              1e-6);
}

TEST(VirtualStructure, DampingScattersAboutItsMean) {
  const Strip strip;
  const Eigen::VectorXd zeta = strip.reduced({}, 0.006).damping_ratio;
  EXPECT_GT(zeta.maxCoeff() - zeta.minCoeff(), 5e-4);
  // Within exp(2.5 sd) of the mean by construction.
  EXPECT_LT(zeta.maxCoeff(), 0.006 * 1.9);
  EXPECT_GT(zeta.minCoeff(), 0.006 / 1.9);
}

TEST(VirtualStructure, RefusesPlacesThatAreNotThere) {
  const Strip strip;
  EXPECT_THROW((void)strip.reduced({"added-mass@99999=0.1"}), InputError);
  EXPECT_THROW((void)strip.reduced({"stiffness-loss@99999=0.5"}), InputError);
}

TEST(VirtualStructure, RefusesAJointWhereNothingTurns) {
  const Strip strip;
  const structure::Deck& deck = strip.model.model;
  const int middle = grid_at(deck, 0.15, 0.02);
  const int corner = grid_at(deck, 0.30, 0.0);
  EXPECT_THROW((void)strip.reduced({fmt::format("joint@{}=100", middle)}),
               InputError);
  EXPECT_THROW(
      (void)strip.reduced({fmt::format("joint@{}:{}=100", middle, corner)}),
      InputError);
  EXPECT_LT(strip
                .reduced({fmt::format("joint@{}:{}=100",
                                      grid_at(deck, 0.15, 0.0),
                                      grid_at(deck, 0.15, 0.04))})
                .frequency_hz(0),
            strip.reduced({}).frequency_hz(0));
}

// Beyond the modes of masses on springs, static answers are rounding.
TEST(VirtualStructure, HasNoMoreModesThanItsDegreesOfFreedom) {
  for (const int masses : {1, 3}) {
    std::string text;
    for (int k = 1; k <= masses; ++k) {
      text += fmt::format("GRID,{},,{}.,0.,0.,,12456\n", k, k);
      text += fmt::format("CELAS2,{},1.+4,{},3,{},3\n", k, k, k - 1);
      text += fmt::format("CONM2,{},{},,1.\n", 20 + k, k);
    }
    VirtualModel model;
    model.model = model.fine = structure::deck_of(text);
    const Dof last{masses, 3, 1};
    const ReducedTruth truth =
        reduce_truth(build_virtual_structure(model, {}, 1.0, 3),
                     {{"acc1", last}},
                     {last, {1, 3, 1}},
                     1000.0,
                     {});
    ASSERT_EQ(truth.system.K.rows(), masses);
    // 2 sqrt(k / m) sin((2 r - 1) pi / (4 n + 2)).
    for (int r = 1; r <= masses; ++r) {
      const double w =
          200.0 * std::sin((2 * r - 1) * M_PI / (4.0 * masses + 2.0));
      EXPECT_NEAR(truth.frequency_hz(r - 1), w / two_pi, 1e-6 * w);
    }
  }
}

TEST(VirtualPoints, SensorsAreAmongWellSpreadPoints) {
  const structure::Deck deck = mesh_panel(frame_panel(), 1).deck;
  const ModelShapes shapes = model_shapes(deck, 3, 55.0);
  const TestPoints points = choose_points(deck, shapes.shapes, 2, 24);
  ASSERT_EQ(points.sensors.size(), 2U);
  ASSERT_EQ(points.others.size(), 24U);
  for (std::size_t a = 0; a < 24; ++a) {
    const Eigen::Vector3d here =
        deck.grids[deck.grid_index(points.others[a].node)].position;
    EXPECT_GT(here.x(), 0.0) << "on the clamp";
    for (std::size_t b = 0; b < a; ++b) {
      const Eigen::Vector3d there =
          deck.grids[deck.grid_index(points.others[b].node)].position;
      // 4.5 m of outline and inner edges for 24 points.
      EXPECT_GT((here - there).norm(), 0.05);
    }
  }
  EXPECT_EQ(points.others[0], points.sensors[0]);
}

}  // namespace
}  // namespace tapfit::updating
