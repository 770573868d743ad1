#include "updating/frf_model/frf_model.hpp"

#include "tests/updating/support/plate_model.hpp"
#include "updating/places/stretched_patches.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/system.hpp"

#include <Eigen/SparseLU>
#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <map>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using std::complex;

// The definition: Z(s) = K + s^2 M + B D B', solved whole.
MatrixXcd direct(const structure::Deck& deck,
                 const signal::FrfSet& pairs,
                 const std::vector<std::tuple<int, int, complex<double>>>&
                     point_stiffness_by_line,
                 const VectorXcd& s,
                 const std::vector<int>& also_free = {},
                 double k_free = 0.0) {
  const structure::System system = structure::assemble(deck);
  std::vector<int> free = system.free_dofs();
  free.insert(free.end(), also_free.begin(), also_free.end());
  std::vector<int> position(static_cast<std::size_t>(system.dofs()), -1);
  for (std::size_t k = 0; k < free.size(); ++k) {
    position[static_cast<std::size_t>(free[k])] = static_cast<int>(k);
  }
  const auto n = static_cast<Index>(free.size());
  MatrixXcd H(s.size(), static_cast<Index>(pairs.frfs.size()));
  for (Index l = 0; l < s.size(); ++l) {
    std::vector<Eigen::Triplet<complex<double>>> entries;
    const auto put = [&](const structure::SparseMatrix& A, complex<double> f) {
      for (Index c = 0; c < A.outerSize(); ++c) {
        for (structure::SparseMatrix::InnerIterator it(A, c); it; ++it) {
          const int a = position[static_cast<std::size_t>(it.row())];
          const int b = position[static_cast<std::size_t>(it.col())];
          if (a >= 0 && b >= 0) entries.emplace_back(a, b, f * it.value());
        }
      }
    };
    put(system.K, 1.0);
    put(system.M, s(l) * s(l));
    for (const auto& [node, power, size] : point_stiffness_by_line) {
      const int dofs = power == 2 ? 3 : 1;  // a mass moves in all directions
      for (int d = 0; d < dofs; ++d) {
        const int at = position[6 * deck.grid_index(node) +
                                static_cast<std::size_t>(2 - d)];
        entries.emplace_back(at, at, size * std::pow(s(l), power));
      }
    }
    for (const int dof : also_free) {
      const int at = position[static_cast<std::size_t>(dof)];
      // End grids carry half a gap of 30 mm.
      const int row = dof / 66;
      const double length = row == 0 || row == 4 ? 0.015 : 0.03;
      entries.emplace_back(at, at, k_free * length);
    }
    Eigen::SparseMatrix<complex<double>> Z(n, n);
    Z.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<complex<double>>> lu(Z);
    for (std::size_t f = 0; f < pairs.frfs.size(); ++f) {
      const signal::Frf& frf = pairs.frfs[f];
      VectorXcd force = VectorXcd::Zero(n);
      force(position[6 * deck.grid_index(frf.reference.node) + 2]) =
          frf.reference.sign;
      const VectorXcd x = lu.solve(force);
      H(l, static_cast<Index>(f)) =
          s(l) * s(l) * static_cast<double>(frf.response.sign) *
          x(position[6 * deck.grid_index(frf.response.node) + 2]);
    }
  }
  return H;
}

ModelState undamped(const Fitter& fitter,
                    const FrfModel& model,
                    const std::vector<PlacedEffect>& effects) {
  ModelState state = fitter.first_state(model, effects);
  state.zeta.setConstant(1e-12);
  state.zeta_other = 1e-12;
  return state;
}

// Largest relative difference between analytic and central differences.
double derivative_error(const FrfModel& model,
                        const ModelState& state,
                        const VectorXcd& s) {
  const Eigen::VectorXd theta = pack(state);
  const ModelResponse response = model.respond(state, s, true);
  double worst = 0.0;
  for (Index k = 0; k < theta.size(); ++k) {
    // Of fourth order: what truncation leaves is far below rounding, which is
    // that of small differences where a parameter moves little.
    constexpr double h = 1e-3;
    const auto across = [&](double step) {
      Eigen::VectorXd up = theta;
      Eigen::VectorXd down = theta;
      up(k) += step;
      down(k) -= step;
      return MatrixXcd(model.respond(unpack(state, up), s, false).H -
                       model.respond(unpack(state, down), s, false).H);
    };
    const MatrixXcd numeric = (8.0 * across(h) - across(2.0 * h)) / (12.0 * h);
    worst = std::max(
        worst, difference(response.dH[static_cast<std::size_t>(k)], numeric));
  }
  return worst;
}

using FrfModelTest = PlateModel;

TEST_F(FrfModelTest, BaseAgreesWithDirectSolve) {
  const auto model = fitter_->model_for({}, BaseUse::Scan);
  const MatrixXcd H =
      model->respond(undamped(*fitter_, *model, {}), s_, false).H;
  // What the basis is made for, see response_orders.
  EXPECT_LT(difference(H, direct(deck_, pairs_, {}, s_)), 1e-6);
}

TEST_F(FrfModelTest, LowRankEffectsAgreeWithDirectSolve) {
  const std::vector<PlacedEffect> effects = {at_node("added-mass", 30, 0.05),
                                             at_node("ground-spring", 50, 3e4),
                                             at_node("dashpot", 20, 7.0),
                                             sensors(0.01, 0.02)};
  const auto model = fitter_->model_for(effects, BaseUse::Scan);
  const MatrixXcd H =
      model->respond(undamped(*fitter_, *model, effects), s_, false).H;
  const MatrixXcd exact = direct(
      deck_,
      pairs_,
      {{30, 2, 0.05}, {50, 0, 3e4}, {20, 1, 7.0}, {11, 2, 0.01}, {36, 2, 0.02}},
      s_);
  EXPECT_LT(difference(H, exact), 1e-6);
}

TEST_F(FrfModelTest, SoftSupportAgreesWithDirectSolveFromStiffToSoft) {
  const auto model = fitter_->model_for({clamp(1.0)}, BaseUse::Scan);
  const StiffnessTerm& term = model->base().terms.front();
  std::vector<int> rotations;
  for (int j = 0; j < 5; ++j) rotations.push_back(6 * 11 * j + 4);
  for (const double k : {term.lower, 3.0 * term.start, 0.1 * term.upper}) {
    const ModelState state = undamped(*fitter_, *model, {clamp(k)});
    const MatrixXcd H = model->respond(state, s_, false).H;
    const MatrixXcd exact = direct(deck_, pairs_, {}, s_, rotations, k);
    // What the basis is made for, see changed_motions.hpp.
    EXPECT_LT(difference(H, exact), 1e-6) << "k = " << k;
  }
}

// Puts shells on a property of their own, 2, as 1 is.
structure::ShellProperty& own_property(const std::vector<int>& elements,
                                       structure::Deck& deck) {
  structure::ShellProperty& own = deck.shell_properties[2];
  own = deck.shell_properties[1];
  own.id = 2;
  for (structure::Shell& shell : deck.shells) {
    if (std::ranges::count(elements, shell.id) > 0) shell.property = 2;
  }
  return own;
}

// Elements on a material of their own with part of the stiffness.
void weaken(const std::vector<int>& elements,
            double factor,
            structure::Deck& deck) {
  const int id = 1 + static_cast<int>(deck.materials.size());
  structure::Material material = deck.materials.begin()->second;
  material.id = id;
  material.E *= factor;
  material.G *= factor;
  deck.materials[id] = material;
  structure::ShellProperty own = deck.shell_properties[1];
  own.id = id;
  own.membrane = own.bending = own.shear = id;
  deck.shell_properties[id] = own;
  for (structure::Shell& shell : deck.shells) {
    if (std::ranges::count(elements, shell.id) > 0) shell.property = id;
  }
}

TEST_F(FrfModelTest, StiffnessLossAgreesWithDirectSolve) {
  Where where;
  where.elements = {4, 5, 6, 14, 15, 16};
  const effects::Effect& effect = effects::find("stiffness-loss");
  const auto model =
      fitter_->model_for({{&effect, where, {0.5}}}, BaseUse::Scan);
  for (const double factor : {0.8, 0.3, 0.05}) {
    structure::Deck weak = deck_;
    weaken(where.elements, factor, weak);
    const ModelState state =
        undamped(*fitter_, *model, {{&effect, where, {factor}}});
    const MatrixXcd H = model->respond(state, s_, false).H;
    // See changed_motions.hpp.
    EXPECT_LT(difference(H, direct(weak, pairs_, {}, s_)), 5e-4)
        << "factor " << factor;
  }
}

// What is lost ends within the elements beside: each layer has a factor of its
// own, between that of the patch and all.
PlacedEffect loss_with_edges(const structure::Deck& deck) {
  Where where;
  where.elements = {4, 5, 6, 14, 15, 16};
  where.variant = edges;
  PlacedEffect loss{&effects::find("stiffness-loss"), where, {0.2}};
  const std::size_t layers = layers_beside(where.elements, deck).size();
  for (std::size_t k = 0; k < layers; ++k) {
    loss.p.push_back(0.3 + 0.15 * static_cast<double>(k));
  }
  return loss;
}

TEST_F(FrfModelTest, LossWithEdgesAgreesWithDirectSolve) {
  PlacedEffect loss = loss_with_edges(deck_);
  const auto layers = layers_beside(loss.where.elements, deck_);
  ASSERT_GE(layers.size(), 2U);
  const auto model = fitter_->model_for({loss}, BaseUse::Scan);
  for (const double left : {1.0, 0.25}) {
    for (double& p : loss.p) p *= left;
    structure::Deck weak = deck_;
    weaken(loss.where.elements, loss.p[0], weak);
    for (std::size_t k = 0; k < layers.size(); ++k) {
      weaken(layers[k], loss.p[k + 1], weak);
    }
    const ModelState state = undamped(*fitter_, *model, {loss});
    const MatrixXcd H = model->respond(state, s_, false).H;
    // As of one loss, see changed_motions.hpp, and what its layers, which are
    // answered for together, do apart.
    EXPECT_LT(difference(H, direct(weak, pairs_, {}, s_)), 1e-3)
        << "times " << left;
  }
}

TEST_F(FrfModelTest, DerivativesOfEdgesAgreeWithDifferences) {
  PlacedEffect loss = loss_with_edges(deck_);
  loss.where.variant = pocket_edges;
  const auto model = fitter_->model_for({loss});
  const ModelState state = fitter_->first_state(*model, {loss});
  EXPECT_LT(derivative_error(*model, state, s_), 1e-5);
}

// Thinned to t / t_0 = factor^(1/3). The sensors look across the plate, which
// bends only: that its membrane keeps more than the factor shows nowhere.
TEST_F(FrfModelTest, PocketAgreesWithDirectSolve) {
  Where where;
  where.elements = {4, 5, 6, 14, 15, 16};
  where.variant = pocket;
  const effects::Effect& effect = effects::find("stiffness-loss");
  const auto model =
      fitter_->model_for({{&effect, where, {0.5}}}, BaseUse::Scan);
  for (const double factor : {0.8, 0.3, 0.05}) {
    structure::Deck thin = deck_;
    own_property(where.elements, thin).thickness *= std::cbrt(factor);
    const ModelState state =
        undamped(*fitter_, *model, {{&effect, where, {factor}}});
    const MatrixXcd H = model->respond(state, s_, false).H;
    // See changed_motions.hpp; and the shear of a thin plate goes with t, which
    // is 1e-3 of its bending here.
    EXPECT_LT(difference(H, direct(thin, pairs_, {}, s_)), 3e-3)
        << "factor " << factor;
  }
}

TEST_F(FrfModelTest, DerivativesOfAPocketAgreeWithDifferences) {
  Where where;
  where.elements = {4, 5, 6, 14, 15, 16};
  where.variant = pocket;
  const PlacedEffect thinned{&effects::find("stiffness-loss"), where, {0.4}};
  const auto model = fitter_->model_for({thinned});
  const ModelState state = fitter_->first_state(*model, {thinned});
  EXPECT_LT(derivative_error(*model, state, s_), 1e-5);
}

// A spring between grids is a spring at a grid where the place is the grid's;
// what moves elsewhere is tested in between_grids_test.
TEST_F(FrfModelTest, SpringBetweenGridsAgreesWithAGridThere) {
  PlacedEffect spring = at_node("ground-spring", 50, 3e4);
  const auto at_grid = fitter_->model_for({spring}, BaseUse::Scan);
  const MatrixXcd H =
      at_grid->respond(undamped(*fitter_, *at_grid, {spring}), s_, false).H;
  const Eigen::Vector3d x = position_of(spring.where, deck_);
  spring.where.at = {x.x(), x.y(), x.z()};
  const auto between = fitter_->model_for({spring}, BaseUse::Scan);
  const MatrixXcd same =
      between->respond(undamped(*fitter_, *between, {spring}), s_, false).H;
  EXPECT_LT(difference(H, same), 1e-9);
}

// Elements between held grids alone: no mode strains them.
TEST_F(FrfModelTest, LossThatNothingFeelsLeavesTheFrfsAlone) {
  structure::Deck pad = deck_;
  for (const int id : {2, 13}) pad.constraints.push_back({id, "123456"});
  const BaseBuilder builder(
      pad, {}, support::plate_base(bundle_, pad), Progress{});
  StiffnessChange change;
  change.of = {"stiffness-loss", {}};
  change.of.where.elements = {1};
  const ReducedBase base = builder.build({}, {change});
  ASSERT_EQ(base.terms.size(), 1U);
  EXPECT_TRUE(base.K.allFinite());
  EXPECT_LT(base.terms[0].S.norm(), 1e-9 * base.K.norm());
}

// The plate cut along x = 0.15 m, its halves held together by springs: stiff
// ones, but for the rotation about the cut.
structure::Deck jointed_plate(const structure::Deck& plate, double k_per_m) {
  structure::Deck deck = plate;
  std::map<int, int> twin;
  int spring = 1000;
  for (int j = 0; j < 5; ++j) {
    const int id = 6 + 11 * j;
    twin[id] = 100 + id;
    deck.grids.push_back({100 + id, deck.grids[deck.grid_index(id)].position});
    const double length = j == 0 || j == 4 ? 0.015 : 0.03;
    for (int c = 1; c <= 6; ++c) {
      structure::ScalarElement e;
      e.id = spring++;
      e.grids = {id, 100 + id};
      e.components = {c, c};
      e.stiffness = c == 5 ? k_per_m * length : c > 3 ? 1e7 : 1e11;
      deck.scalars.push_back(e);
    }
  }
  for (structure::Shell& shell : deck.shells) {
    const bool right = (shell.id - 1) % 10 >= 5;
    for (int& grid : shell.grids) {
      if (right && twin.contains(grid)) grid = twin[grid];
    }
  }
  return deck;
}

TEST_F(FrfModelTest, JointAgreesWithDirectSolveFromStiffToSoft) {
  const effects::Effect& effect = effects::find("joint");
  Where where;
  for (const Where& place : effect.places(setting_)) {
    const auto& n = place.nodes;
    if (n.size() == 5 && std::find(n.begin(), n.end(), 6) != n.end()) {
      where = place;
    }
  }
  ASSERT_EQ(where.nodes.size(), 5U);
  const auto model = fitter_->model_for({{&effect, where, {1.0}}});
  const StiffnessTerm& term = model->base().terms.front();
  for (const double k : {term.lower, term.start, 0.1 * term.upper}) {
    const ModelState state =
        undamped(*fitter_, *model, {{&effect, where, {k}}});
    const MatrixXcd H = model->respond(state, s_, false).H;
    const MatrixXcd exact = direct(jointed_plate(deck_, k), pairs_, {}, s_);
    EXPECT_LT(difference(H, exact), 1e-4) << "k = " << k;
  }
}

// The plate on which nothing is held, or only the rotations are let go.
TEST_F(FrfModelTest, SupportThatWasNotThereHoldsNothing) {
  const effects::Effect& effect = effects::find("support-mismatch");
  for (const std::string variant : {"free", "free-rotations"}) {
    const std::vector<Where> places = effect.places(setting_);
    const auto where = std::ranges::find(places, variant, &Where::variant);
    ASSERT_NE(where, places.end()) << variant;
    const PlacedEffect freed{&effect, *where, {}};
    const auto model = fitter_->model_for({freed});
    const ModelState state = undamped(*fitter_, *model, {freed});
    structure::Deck deck = support::plate_deck(false);
    for (int j = 0; variant != "free" && j < 5; ++j) {
      deck.constraints.push_back({1 + 11 * j, "123"});
    }
    // Rotations are lent a mass, which is felt at 1e-5.
    EXPECT_LT(difference(model->respond(state, s_, false).H,
                         direct(deck, pairs_, {}, s_)),
              1e-4)
        << variant;
  }
}

TEST_F(FrfModelTest, SwappedChannelsRecordEachOther) {
  Where both;
  both.channels = {"acc1", "acc2"};
  const auto model = fitter_->model_for({});
  ModelState state = undamped(*fitter_, *model, {});
  const MatrixXcd H = model->respond(state, s_, false).H;
  state.effects = {{&effects::find("channel-swap"), both, {}}};
  const MatrixXcd swapped = model->respond(state, s_, false).H;
  // The bundle has acc1 and acc2 in turn, run after run.
  for (Eigen::Index f = 0; f < H.cols(); f += 2) {
    EXPECT_EQ(swapped.col(f), H.col(f + 1));
    EXPECT_EQ(swapped.col(f + 1), H.col(f));
  }
}

TEST_F(FrfModelTest, DerivativesAgreeWithDifferences) {
  const std::vector<PlacedEffect> effects = {at_node("added-mass", 30, 0.05),
                                             at_node("ground-spring", 50, 3e4),
                                             at_node("dashpot", 20, 7.0),
                                             sensors(0.01, 0.02)};
  const auto model = fitter_->model_for(effects);
  ModelState state = fitter_->first_state(*model, effects);
  state.factor = {1.02};
  state.zeta.setLinSpaced(0.004, 0.02);
  // Central differences of step 1e-5 are good to about 1e-8 here.
  EXPECT_LT(derivative_error(*model, state, s_), 1e-6);
}

// The first modes and those beside them, with springs and a faulty channel in
// the model: central differences in the base's own stiffness.
TEST_F(FrfModelTest, FormPatternsAgreeWithDifferences) {
  Where channel;
  channel.channels = {"acc1"};
  const std::vector<PlacedEffect> effects = {
      at_node("dashpot", 50, 3.0),
      {&effects::find("channel-gain"), channel, {1.3}}};
  const auto model = fitter_->model_for(effects);
  const ModelState state = undamped(*fitter_, *model, effects);
  const std::vector<MatrixXcd> patterns = model->form_patterns(state, s_);
  const BaseModes modes = model->base_modes(state);
  // Entries in order: 11, 12, 13, 22, ...
  const std::vector<std::pair<Index, Index>> entries = {{0, 0}, {0, 1}, {0, 2}};
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const auto [i, j] = entries[k];
    const Eigen::VectorXd a = modes.omega(i) * modes.phi.col(i);
    const Eigen::VectorXd b = modes.omega(j) * modes.phi.col(j);
    const Eigen::MatrixXd one =
        i == j ? Eigen::MatrixXd(a * a.transpose())
               : Eigen::MatrixXd((a * b.transpose() + b * a.transpose()) /
                                 std::sqrt(2.0));
    // Smaller ones beside the diagonal count as rounding, see solve_modes().
    const double h = 1e-3;
    const auto changed = [&](double by) {
      ReducedBase base = model->base();
      base.K += by * one;
      return FrfModel(base, setting_, pairs_).respond(state, s_, false).H;
    };
    const MatrixXcd numeric = (changed(h) - changed(-h)) / (2.0 * h);
    // Central differences are off by h^2 over the square of the damping.
    EXPECT_LT(difference(patterns[k], numeric), 1e-3) << i << ' ' << j;
  }
}

// A law's damping turns with the modes as matrices do: no part is left out.
TEST_F(FrfModelTest, DerivativesOfADampingLawAgreeWithDifferences) {
  const std::vector<PlacedEffect> effects = {
      at_node("added-mass", 30, 0.05),
      {&effects::find("damping-law"), {}, {4.0, 2e-6, 0.01}}};
  const auto model = fitter_->model_for(effects);
  ModelState state = fitter_->first_state(*model, effects);
  EXPECT_EQ(state.zeta.size(), 0);
  state.factor = {1.02};
  EXPECT_LT(derivative_error(*model, state, s_), 1e-6);
}

// The highest mode too, for which other fits have one ratio in common.
TEST_F(FrfModelTest, ALawGivesTheModesItsRatios) {
  const PlacedEffect law{&effects::find("damping-law"), {}, {4.0, 2e-6, 0.01}};
  const auto model = fitter_->model_for({law});
  const ModelState state = fitter_->first_state(*model, {law});
  ModelState mode_by_mode = state;
  mode_by_mode.effects.clear();
  const Eigen::VectorXd omega = model->base_modes(state).omega;
  mode_by_mode.zeta =
      omega.unaryExpr([&](double each) { return state.zeta_at(each); });
  const MatrixXcd expected = model->respond(mode_by_mode, s_, false).H;
  EXPECT_LT(difference(model->respond(state, s_, false).H, expected), 1e-12);
}

TEST_F(FrfModelTest, DerivativesAgreeWithDifferencesOnASoftSupport) {
  auto effects = std::vector<PlacedEffect>{clamp(1.0)};
  const auto model = fitter_->model_for(effects);
  effects.back().p[0] = model->base().terms.front().start;
  const ModelState state = fitter_->first_state(*model, effects);
  // FRFs change little with a support this stiff, and differences of them lose
  // digits: 2e-5 at a tenth of the step.
  EXPECT_LT(derivative_error(*model, state, s_), 1e-5);
}

TEST_F(FrfModelTest, DerivativesAgreeWithDifferencesOnFormsOfASupport) {
  for (const char* form : {"both", "rotation-varying", "translation-varying"}) {
    auto effects = std::vector<PlacedEffect>{clamp(1.0)};
    effects.back().where.variant = form;
    effects.back().p = {1.0, 1.0};
    const auto model = fitter_->model_for(effects);
    const std::vector<StiffnessTerm>& terms = model->base().terms;
    ASSERT_EQ(terms.size(), 2U) << form;
    effects.back().p = {terms[0].start, 0.3 * terms[1].start};
    const ModelState state = fitter_->first_state(*model, effects);
    // Rounding: it grows as the step shrinks, 1e-4 at a tenth of it and 6e-7
    // at ten times, where other parameters' differences are 4e-5 off.
    EXPECT_LT(derivative_error(*model, state, s_), 3e-5) << form;
  }
}

// The same springs told in two ways.
TEST_F(FrfModelTest, AClampThatVariesByNothingIsTheEvenOne) {
  const auto even = fitter_->model_for({clamp(1.0)});
  const double k = even->base().terms.front().start;
  const MatrixXcd H =
      even->respond(undamped(*fitter_, *even, {clamp(k)}), s_, false).H;
  PlacedEffect varying = clamp(k);
  varying.where.variant = "rotation-varying";
  varying.p = {k, k};
  const auto model = fitter_->model_for({varying});
  const ModelState state = undamped(*fitter_, *model, {varying});
  EXPECT_LT(difference(model->respond(state, s_, false).H, H), 1e-9);
  // A rigid translation beside the turn leaves the turn alone.
  PlacedEffect both = clamp(k);
  both.where.variant = "both";
  both.p = {k, 1.0};
  const auto of_both = fitter_->model_for({both});
  both.p[1] = 1e3 * of_both->base().terms[1].upper;
  const ModelState stiff = undamped(*fitter_, *of_both, {both});
  EXPECT_LT(difference(of_both->respond(stiff, s_, false).H, H), 1e-5);
}

}  // namespace
}  // namespace tapfit::updating
