// FRFs of a plate that has lost stiffness.
#include "tests/updating/support/direct_frfs.hpp"
#include "tests/updating/support/plate_model.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/places/stretched_patches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::MatrixXcd;

using FrfModelTest = PlateModel;

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
  Location where;
  where.elements = {4, 5, 6, 14, 15, 16};
  const effects::Effect& effect = effects::find("stiffness-loss");
  const auto model =
      fitter_->model_for({{&effect, where, {0.5}}}, BaseUse::Scan);
  for (const double factor : {0.8, 0.3, 0.05}) {
    structure::Deck weak = deck_;
    weaken(where.elements, factor, weak);
    const ModelState state =
        undamped_state(*fitter_, *model, {{&effect, where, {factor}}});
    const MatrixXcd H = model->respond(state, s_, false).H;
    // See basis_enrichment.hpp.
    EXPECT_LT(difference(H, direct_frfs(weak, pairs_, {}, s_)), 5e-4)
        << "factor " << factor;
  }
}

// What is lost ends within the elements beside: each layer has a factor of its
// own, between that of the patch and all.
EffectInstance loss_with_edges(const structure::Deck& deck) {
  Location where;
  where.elements = {4, 5, 6, 14, 15, 16};
  where.variant = edges;
  EffectInstance loss{&effects::find("stiffness-loss"), where, {0.2}};
  const std::size_t layers = layers_beside(where.elements, deck).size();
  for (std::size_t k = 0; k < layers; ++k) {
    loss.p.push_back(0.3 + 0.15 * static_cast<double>(k));
  }
  return loss;
}

TEST_F(FrfModelTest, LossWithEdgesAgreesWithDirectSolve) {
  EffectInstance loss = loss_with_edges(deck_);
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
    const ModelState state = undamped_state(*fitter_, *model, {loss});
    const MatrixXcd H = model->respond(state, s_, false).H;
    // As of one loss, see basis_enrichment.hpp, and what its layers, which are
    // answered for together, do apart.
    EXPECT_LT(difference(H, direct_frfs(weak, pairs_, {}, s_)), 1e-3)
        << "times " << left;
  }
}

TEST_F(FrfModelTest, DerivativesOfEdgesAgreeWithDifferences) {
  EffectInstance loss = loss_with_edges(deck_);
  loss.where.variant = pocket_edges;
  const auto model = fitter_->model_for({loss});
  const ModelState state = fitter_->first_state(*model, {loss});
  EXPECT_LT(derivative_error(*model, state, s_), 1e-5);
}

// Thinned to t / t_0 = factor^(1/3). The sensors look across the plate, which
// bends only: that its membrane keeps more than the factor shows nowhere.
TEST_F(FrfModelTest, PocketAgreesWithDirectSolve) {
  Location where;
  where.elements = {4, 5, 6, 14, 15, 16};
  where.variant = pocket;
  const effects::Effect& effect = effects::find("stiffness-loss");
  const auto model =
      fitter_->model_for({{&effect, where, {0.5}}}, BaseUse::Scan);
  for (const double factor : {0.8, 0.3, 0.05}) {
    structure::Deck thin = deck_;
    own_property(where.elements, thin).thickness *= std::cbrt(factor);
    const ModelState state =
        undamped_state(*fitter_, *model, {{&effect, where, {factor}}});
    const MatrixXcd H = model->respond(state, s_, false).H;
    // See basis_enrichment.hpp; and the shear of a thin plate goes with t,
    // which is 1e-3 of its bending here.
    EXPECT_LT(difference(H, direct_frfs(thin, pairs_, {}, s_)), 3e-3)
        << "factor " << factor;
  }
}

TEST_F(FrfModelTest, DerivativesOfAPocketAgreeWithDifferences) {
  Location where;
  where.elements = {4, 5, 6, 14, 15, 16};
  where.variant = pocket;
  const EffectInstance thinned{&effects::find("stiffness-loss"), where, {0.4}};
  const auto model = fitter_->model_for({thinned});
  const ModelState state = fitter_->first_state(*model, {thinned});
  EXPECT_LT(derivative_error(*model, state, s_), 1e-5);
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

}  // namespace
}  // namespace tapfit::updating
