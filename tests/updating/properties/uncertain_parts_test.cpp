#include "updating/properties/uncertain_parts.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/measurement/damped_line.hpp"
#include "updating/properties/element_parts.hpp"
#include "updating/properties/uncertain_property.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/deck/bar_thickness.hpp"
#include "updating/structure/deck/bar_thickness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace tapfit::updating {
namespace {

using acquisition::UncertainProperty;
using structure::Deck;
using structure::SparseMatrix;

// The sample plate with a stiffener of bars along one edge and a rod across,
// each with a property card and a material of its own.
Deck stiffened_plate() {
  Deck deck = support::plate_deck(true);
  structure::Material steel;
  steel.id = 2;
  steel.E = 210e9;
  steel.nu = 0.3;
  steel.G = 210e9 / 2.6;
  steel.rho = 7850.0;
  deck.materials[2] = steel;
  deck.bar_properties[2] = {2, 2, 4e-4, 1.3e-8, 2.1e-8, 0.0, 2.2e-8};
  deck.rod_properties[3] = {3, 2, 2e-4, 1e-9};
  for (int i = 0; i < 10; ++i) {
    structure::Bar bar;
    bar.id = 101 + i;
    bar.property = 2;
    bar.grids = {1 + i, 2 + i};
    bar.orientation = Eigen::Vector3d::UnitZ();
    bar.rotary_inertia = true;
    deck.bars.push_back(bar);
  }
  deck.rods.push_back({201, 3, {11, 55}});
  deck.shell_properties[1].shear = 0;
  return deck;
}

// The matrices that the parts stand for against the scaled deck's own.
void expect_reassembled(const Deck& deck,
                        const std::vector<UncertainProperty>& uncertain,
                        const std::vector<double>& factor,
                        double tolerance) {
  Deck scaled = deck;
  for (std::size_t j = 0; j < uncertain.size(); ++j) {
    scale_property(scaled, uncertain[j], factor[j]);
  }
  const structure::System whole = structure::assemble(scaled);
  structure::System system = structure::assemble(deck);
  for (const UncertainPart& part : uncertain_parts(deck, uncertain)) {
    system.K += part_coefficient(part.power, factor) * part.K;
    system.M += part_coefficient(part.power, factor) * part.M;
  }
  const double dK = SparseMatrix(system.K - whole.K).norm() / whole.K.norm();
  const double dM = SparseMatrix(system.M - whole.M).norm() / whole.M.norm();
  EXPECT_LT(dK, tolerance);
  EXPECT_LT(dM, tolerance);
}

TEST(UncertainPartsTest, PolynomialsAreExact) {
  const Deck deck = stiffened_plate();
  const std::vector<UncertainProperty> uncertain = {
      {"material", 1, "E"},
      {"material", 1, "rho"},
      {"property", 1, "t"},
      {"material", 2, "E"},
      {"material", 2, "rho"},
      {"property", 2, "A"},
      {"property", 2, "I1"},
      {"property", 2, "I2"},
      {"property", 2, "J"},
      {"property", 3, "A"},
      {"property", 3, "J"},
  };
  const std::vector<double> factor = {
      1.2, 0.8, 1.3, 0.7, 1.15, 1.2, 0.9, 1.4, 0.6, 1.5, 0.5};
  // Rounding only; powers of f - 1 cancel two or three digits.
  expect_reassembled(deck, uncertain, factor, 1e-12);
}

// Twice: worked out, and as it was kept.
TEST(ElementPartsTest, OfSomeElementsAreTheseElementsAlone) {
  const Deck deck = stiffened_plate();
  const std::vector<UncertainProperty> uncertain = {
      {"material", 1, "E"}, {"property", 1, "t"}, {"material", 2, "E"}};
  const std::vector<double> factor = {1.2, 0.9, 1.4};
  Deck scaled = deck;
  for (std::size_t j = 0; j < uncertain.size(); ++j) {
    scale_property(scaled, uncertain[j], factor[j]);
  }
  const ElementParts parts(deck, uncertain);
  for (const std::set<int>& elements :
       {std::set{3, 4}, std::set{4, 103}, std::set{3, 4}, std::set{201}}) {
    const auto wanted = [&](int id) { return elements.contains(id); };
    const ElementParts::Sum sum = parts.of(elements);
    SparseMatrix K = sum.K;
    SparseMatrix M = sum.M;
    for (const UncertainPart& part : sum.parts) {
      K += part_coefficient(part.power, factor) * part.K;
      M += part_coefficient(part.power, factor) * part.M;
      // No shell is of the second material.
      EXPECT_TRUE(part.power[2] == 0 || wanted(103) || wanted(201));
    }
    const auto expect_same = [](const SparseMatrix& found,
                                const SparseMatrix& direct) {
      const SparseMatrix left = found - direct;
      EXPECT_LT(left.norm(), 1e-12 * direct.norm());
    };
    expect_same(sum.K, structure::assemble_stiffness(deck, wanted));
    expect_same(sum.M, structure::assemble_mass(deck, wanted));
    expect_same(K, structure::assemble_stiffness(scaled, wanted));
    expect_same(M, structure::assemble_mass(scaled, wanted));
  }
}

// Shells, a flat bar and a rod at 0.6 of their thickness, with what is
// uncertain in them: K = c^3 (K - K_t) + c K_t, M = c M.
TEST(ElementPartsTest, ThinnedElementsAreThoseOfAThinnerDeck) {
  Deck deck = stiffened_plate();
  for (structure::Bar& bar : deck.bars) bar.rotary_inertia = false;
  const double c = 0.6;
  Deck thin = deck;
  thin.shell_properties[1].thickness *= c;
  structure::BarProperty& bar = thin.bar_properties[2];
  bar.area *= c;
  const double twist = structure::twist_by_thickness(bar);
  bar.I1 *= c * c * c;
  bar.I2 *= c;
  bar.J *= c * c * c + twist * (c - c * c * c);
  thin.rod_properties[3].area *= c;
  thin.rod_properties[3].J *= c * c * c;
  const std::vector<UncertainProperty> uncertain = {
      {"material", 1, "E"}, {"property", 1, "t"}, {"property", 2, "I1"}};
  const std::vector<double> factor = {1.2, 0.9, 1.4};
  for (std::size_t j = 0; j < uncertain.size(); ++j) {
    scale_property(thin, uncertain[j], factor[j]);
  }
  const ElementParts parts(deck, uncertain);
  for (const std::set<int>& elements :
       {std::set{3, 4}, std::set{102, 103}, std::set{201}, std::set{4, 103}}) {
    const auto wanted = [&](int id) { return elements.contains(id); };
    const auto [cube, thickness] = parts.by_thickness(elements);
    SparseMatrix K = c * c * c * cube.K + c * thickness.K;
    SparseMatrix M = c * thickness.M;
    ASSERT_EQ(cube.parts.size(), thickness.parts.size());
    for (std::size_t k = 0; k < cube.parts.size(); ++k) {
      ASSERT_EQ(cube.parts[k].power, thickness.parts[k].power);
      const double f = part_coefficient(cube.parts[k].power, factor);
      K += f * (c * c * c * cube.parts[k].K + c * thickness.parts[k].K);
      M += f * c * thickness.parts[k].M;
      EXPECT_EQ(cube.parts[k].M.nonZeros(), 0);
    }
    const SparseMatrix own_K = structure::assemble_stiffness(thin, wanted);
    const SparseMatrix own_M = structure::assemble_mass(thin, wanted);
    // What is made next to nothing is 1e-9 of it.
    EXPECT_LT(SparseMatrix(K - own_K).norm(), 1e-8 * own_K.norm());
    // A plate's rotary inertia goes with the cube.
    EXPECT_LT(SparseMatrix(M - own_M).norm(), 1e-3 * own_M.norm());
  }
}

TEST(UncertainPartsTest, RationalPropertiesAreCloseInTheirRange) {
  Deck deck = stiffened_plate();
  deck.shell_properties[1].shear = 1;
  deck.bar_properties[2].K1 = 0.83;
  deck.bar_properties[2].K2 = 0.83;
  // The interpolation's error of fourth degree over 0.5 .. 2: parts in ten
  // thousand of the few percent that are not polynomial.
  expect_reassembled(
      deck,
      {{"property", 1, "t"}, {"property", 2, "I1"}, {"material", 1, "nu"}},
      {1.3, 0.8, 1.1},
      1e-4);
}

// A block of one hexahedron on the plate, which is a laminate of two materials.
Deck laid_plate_with_block() {
  Deck deck = stiffened_plate();
  structure::ShellProperty& p = deck.shell_properties[1];
  p.plies = {{1, 0.4 * p.thickness, 30.0}, {2, 0.6 * p.thickness, 0.0}};
  p.bottom = -0.5 * p.thickness;
  p.membrane = p.bending = p.shear = 0;
  deck.solid_properties[4] = {4, 2, ""};
  structure::Solid block{301, 4, {}};
  for (int k = 0; k < 8; ++k) {
    const int id = 9001 + k;
    const double x = k % 4 == 1 || k % 4 == 2 ? 0.1 : 0.0;
    deck.grids.push_back({id, {x, k % 4 < 2 ? 0.0 : 0.1, k < 4 ? 0.5 : 0.6}});
    block.grids.push_back(id);
  }
  deck.solids.push_back(block);
  return deck;
}

TEST(UncertainPartsTest, LaminatesAndSolids) {
  const Deck deck = laid_plate_with_block();
  const std::vector<UncertainProperty> uncertain = {
      {"material", 2, "E"}, {"material", 2, "rho"}, {"property", 1, "t"}};
  // E of one of two plies is rational; the polynomial through five values is
  // this close in a tenth about them.
  expect_reassembled(deck, uncertain, {1.1, 0.8, 0.95}, 1e-5);
  // The block alone is linear in E.
  const PropertyLaw law = property_law(deck, uncertain[0], "test.json");
  EXPECT_TRUE(law.elements.contains(301));
}

TEST(UncertainPartsTest, OrthotropicModuli) {
  Deck deck = support::plate_deck(true);
  structure::Material& wood = deck.materials[1];
  wood = {1, true, 12e9, 0.35, 0.7e9, 450.0, 0.9e9, 0.7e9, 0.1e9};
  const std::vector<UncertainProperty> uncertain = {{"material", 1, "E1"},
                                                    {"material", 1, "E2"},
                                                    {"material", 1, "G12"},
                                                    {"material", 1, "rho"}};
  // As above.
  expect_reassembled(deck, uncertain, {1.1, 0.85, 1.2, 0.9}, 1e-4);
}

TEST(UncertainPartsTest, DerivativesAgreeWithDifferences) {
  const Deck deck = stiffened_plate();
  acquisition::TestBundle bundle = support::plate_bundle();
  bundle.uncertain = {{"property", 1, "t"},
                      {"material", 1, "E"},
                      {"material", 2, "E"},
                      {"property", 2, "A"},
                      {"material", 2, "rho"}};
  const effects::TestContext context = support::plate_context(bundle, deck);
  const Eigen::VectorXcd s = damped_line({10.0, 400.0}, 2.0, {0.05, 40});
  BaseOptions options;
  options.high_hz = 400.0;
  options.split = false;
  options.points = measured_points(deck, bundle).all;
  const BaseBuilder builder(deck, bundle.uncertain, options, Progress{});
  const FrfModel model(
      builder.build({}, {}), context, support::plate_pairs(bundle, s));
  ModelState state;
  state.factor = {1.1, 0.95, 1.2, 0.9, 1.15};
  // Unequal, so that damping that turns with the modes would show.
  state.zeta.setLinSpaced(6, 0.004, 0.05);
  state.zeta_other = 0.02;
  const ModelResponse response = model.respond(state, s, true);
  const Eigen::VectorXd theta = pack(state);
  const auto properties = static_cast<Eigen::Index>(state.factor.size());
  for (Eigen::Index k = 0; k < properties; ++k) {
    constexpr double h = 1e-5;
    Eigen::VectorXd up = theta;
    Eigen::VectorXd down = theta;
    up(k) += h;
    down(k) -= h;
    const Eigen::MatrixXcd numeric =
        (model.respond(unpack(state, up), s, false).H -
         model.respond(unpack(state, down), s, false).H) /
        (2.0 * h);
    const Eigen::MatrixXcd& exact = response.dH[static_cast<std::size_t>(k)];
    // Central differences of step 1e-5 are good to about 1e-8 here.
    EXPECT_LT((exact - numeric).norm(), 1e-6 * numeric.norm()) << k;
  }
}

TEST(UncertainPartsTest, ReducedModelFollowsTheScaledDeck) {
  Deck deck = support::plate_deck(true);
  acquisition::TestBundle bundle = support::plate_bundle();
  bundle.uncertain = {{"property", 1, "t"}};
  const Eigen::VectorXcd s = damped_line({10.0, 400.0}, 2.0, {0.05, 40});
  const auto respond = [&](const Deck& of, double factor) {
    const effects::TestContext context = support::plate_context(bundle, of);
    BaseOptions options;
    options.high_hz = 400.0;
    options.split = false;
    options.points = measured_points(of, bundle).all;
    const BaseBuilder builder(of, bundle.uncertain, options, Progress{});
    const FrfModel model(
        builder.build({}, {}), context, support::plate_pairs(bundle, s));
    ModelState state;
    state.factor = {factor};
    return model.respond(state, s, false).H;
  };
  const Eigen::MatrixXcd reduced = respond(deck, 1.1);
  scale_property(deck, bundle.uncertain[0], 1.1);
  const Eigen::MatrixXcd solved = respond(deck, 1.0);
  // Bending modes of a plate do not change shape with its thickness; what is
  // left are modes above four times the band.
  EXPECT_LT((reduced - solved).norm(), 1e-4 * solved.norm());
}

TEST(UncertainPartsTest, RefusesWhatTheDeckHasNot) {
  const Deck deck = stiffened_plate();
  const auto refuses = [&](const std::vector<UncertainProperty>& uncertain) {
    EXPECT_THROW(static_cast<void>(uncertain_parts(deck, uncertain)),
                 InputError);
  };
  refuses({{"material", 9, "E"}});
  refuses({{"property", 9, "t"}});
  refuses({{"property", 1, "A"}});
  refuses({{"property", 3, "I1"}});
  refuses({{"material", 1, "E1"}});  // a MAT1
  refuses({{"material", 1, "E"}, {"material", 1, "E"}});
}

}  // namespace
}  // namespace tapfit::updating
