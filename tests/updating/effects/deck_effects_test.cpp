// Effects against decks that say the same in cards: at grids that follow a
// rigid element, in turned axes, and with dashpots of the deck's own.
#include "tests/updating/support/deck_support.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/effects/joint_cards.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/measurement/damped_line.hpp"
#include "updating/reduction/released_system.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/edit/move_elements.hpp"
#include "updating/structure/edit/release_constraints.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

// The sample plate as cards. Grid 60 is on an arm of grid 50; the z axis is -x
// of grid 20 and askew to all axes of grid 31.
std::string plate_cards(const std::string& root) {
  std::string text =
      "PARAM,COUPMASS,1\nMAT1,1,7.+10,,.33,2700.\nPSHELL,1,1,.003,1,,1\n"
      "CORD2R,1,,0.,0.,0.,1.,0.,0.\n,0.,0.,-1.\n"
      "CORD2R,2,,0.,0.,0.,1.,2.,2.\n,2.,1.,-2.\n"
      "GRID,60,,.21,.12,.04\nRBE2,900,50,123456,60\n" +
      root;
  for (const structure::Grid& grid : support::plate_deck(false).grids) {
    text += fmt::format("GRID,{},,{:.2f},{:.2f},0.,{}\n",
                        grid.id,
                        grid.position.x(),
                        grid.position.y(),
                        grid.id == 20   ? "1"
                        : grid.id == 31 ? "2"
                                        : "");
  }
  for (const structure::Shell& shell : support::plate_deck(false).shells) {
    text +=
        fmt::format("CQUAD4,{},1,{}\n", shell.id, fmt::join(shell.grids, ","));
  }
  return text;
}

const std::string clamp = "SPC1,1,123456,1,12,23,34,45\n";

class DeckEffects : public ::testing::Test {
 protected:
  // A deck with its base, ready to respond.
  struct Model {
    structure::Deck deck;
    effects::TestContext context;
    std::unique_ptr<BaseBuilder> builder;
    std::unique_ptr<Fitter> fitter;
  };

  std::unique_ptr<Model> model_of(const structure::Deck& deck,
                                  bool split = false) const {
    auto m = std::make_unique<Model>();
    m->deck = deck;
    m->context = support::plate_context(bundle_, m->deck);
    BaseOptions options = support::plate_base(bundle_, m->deck);
    options.split = split;
    m->builder = std::make_unique<BaseBuilder>(
        m->deck,
        std::vector<acquisition::UncertainProperty>{},
        options,
        Progress{});
    FitProblem fit;
    fit.context = m->context;
    fit.measured = pairs_;
    fit.targets = {make_target(pairs_)};
    m->fitter = std::make_unique<Fitter>(*m->builder, fit);
    return m;
  }

  // FRFs with next to no damping but what the effects and the deck have.
  MatrixXcd frfs(const Model& m,
                 const std::vector<EffectInstance>& effects) const {
    const auto model = m.fitter->model_for(effects, BaseUse::Scan);
    ModelState state = m.fitter->first_state(*model, effects);
    state.zeta.setConstant(1e-12);
    state.zeta_other = 1e-12;
    return model->respond(state, s_, false).H;
  }

  // The deck as `tapfit export` writes it.
  structure::Deck with_cards(const Model& m, const EffectInstance& e) const {
    const auto path = m.deck.path.parent_path() / "updated.bdf";
    structure::write_deck(
        m.deck, e.effect->bulk_data(e.where, m.context, e.p), path, {{}, true});
    return structure::read_deck(path);
  }

  // The same with constraints that give way.
  structure::Deck with_support(const Model& m,
                               const EffectInstance& soft) const {
    std::string written;
    for (const std::string& line : structure::edit_cards(
             m.deck.path,
             {structure::release_constraints(
                 m.deck, soft.effect->released(soft.where, m.context))})) {
      written += line + "\n";
    }
    for (const std::string& card :
         soft.effect->bulk_data(soft.where, m.context, soft.p)) {
      written += card + "\n";
    }
    return structure::read_deck(
        structure::write_text("sprung.bdf", written + "ENDDATA\n"));
  }

  acquisition::TestBundle bundle_ = support::plate_bundle();
  VectorXcd s_ = damped_line({10.0, 400.0}, 2.0, {0.05, 40});
  signal::FrfSet pairs_ = support::plate_pairs(bundle_, s_);
};

EffectInstance at_node(const std::string& name,
                       int node,
                       const std::vector<double>& p) {
  return {&effects::find(name), {.node = node}, p};
}

double difference(const MatrixXcd& a, const MatrixXcd& b) {
  return (a - b).norm() / b.norm();
}

TEST_F(DeckEffects, CardsSayWhatTheEffectDoes) {
  const auto base = model_of(structure::deck_of(plate_cards(clamp)));
  const MatrixXcd before = frfs(*base, {});
  for (const int node : {30, 60, 20, 31}) {
    for (const EffectInstance& e :
         {at_node("added-mass", node, {0.05}),
          at_node("ground-spring", node, {3e4}),
          at_node("dashpot", node, {7.0}),
          at_node("absorber", node, {0.02, 60.0, 0.05})}) {
      const MatrixXcd H = frfs(*base, {e});
      EXPECT_GT(difference(H, before), 1e-2) << e.effect->name() << node;
      const auto read_back = model_of(with_cards(*base, e));
      EXPECT_TRUE(read_back->deck.warnings.empty());
      // What the two bases are made for, see response_orders.
      EXPECT_LT(difference(H, frfs(*read_back, {})), 2e-6)
          << e.effect->name() << " at " << node;
    }
  }
}

TEST_F(DeckEffects, DashpotOfTheDeckIsThatOfTheEffect) {
  const auto base = model_of(structure::deck_of(plate_cards(clamp)));
  const EffectInstance dashpot = at_node("dashpot", 30, {7.0});
  // One CDAMP2 of 7 or two that make 7, and the same as CDAMP1 and CBUSH.
  for (const char* cards :
       {"CDAMP2,901,7.,30,3\n",
        "CDAMP2,901,4.,30,3\nPDAMP,9,1.,8,3.\nCDAMP1,902,8,30,3\n",
        "PBUSH,9,B,,,7.\nCBUSH,901,9,30,,,,,0\n"}) {
    const auto damped =
        model_of(structure::deck_of(plate_cards(clamp) + cards));
    // The same bases: rounding.
    EXPECT_LT(difference(frfs(*damped, {}), frfs(*base, {dashpot})), 1e-9)
        << cards;
  }
}

TEST_F(DeckEffects, DerivativesKnowTheDecksDashpots) {
  const auto m = model_of(structure::deck_of(
      plate_cards(clamp) + "CDAMP2,901,7.,30,3\nCDAMP2,902,3.,11,3,60,1\n"));
  const std::vector<EffectInstance> effects = {
      at_node("dashpot", 20, {2.0}), at_node("added-mass", 60, {0.03})};
  const auto model = m->fitter->model_for(effects, BaseUse::Scan);
  const ModelState state = m->fitter->first_state(*model, effects);
  const ModelResponse whole = model->respond(state, s_, true);
  const Eigen::VectorXd theta = pack(state);
  const double h = 1e-5;
  for (Index k = 0; k < theta.size(); ++k) {
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(theta.size(), k);
    const MatrixXcd slope =
        (model->respond(unpack(state, theta + step), s_, false).H -
         model->respond(unpack(state, theta - step), s_, false).H) /
        (2.0 * h);
    // Central differences: h^2 and rounding over h.
    EXPECT_LT((whole.dH[static_cast<std::size_t>(k)] - slope).norm(),
              1e-7 * whole.H.norm() + 1e-6 * slope.norm())
        << k;
  }
}

TEST_F(DeckEffects, SoftSupportOfAHubMovesAllThatFollowsIt) {
  // The clamped edge follows grid 70, which is held.
  const std::string root =
      "GRID,70,,-.02,.06,.01\nRBE2,901,70,123456,1,12,23,34\n,45\n";
  const auto held =
      model_of(structure::deck_of(plate_cards(root + "SPC1,1,123456,70\n")));
  EffectInstance soft{&effects::find("soft-support"), {}, {}};
  for (const Location& where : soft.effect->places(held->context)) {
    const bool hub = where.nodes == std::vector<int>{70};
    if (hub && where.variant == "rotation") soft.where = where;
  }
  ASSERT_EQ(soft.where.nodes, std::vector<int>{70});
  soft.p = {1.0};
  const StiffnessTerm term =
      held->fitter->model_for({soft}, BaseUse::Scan)->base().terms.front();
  for (const double k : {term.lower, term.start, 0.1 * term.upper}) {
    soft.p = {k};
    std::string springs = "SPC1,1,123,70\n";
    for (const int c : {4, 5, 6}) {
      springs += fmt::format("CELAS2,{},{:#.12g},70,{}\n", 910 + c, k, c);
    }
    const auto sprung =
        model_of(structure::deck_of(plate_cards(root + springs)));
    // Also at the softest, where the plate swings on the springs as a whole.
    EXPECT_LT(difference(frfs(*held, {soft}), frfs(*sprung, {})), 2e-6)
        << "k = " << k;
  }
}

// Constraints of every kind hold the clamped edge; what is written lets go of
// what the form names alone.
TEST_F(DeckEffects, SoftSupportReadBackGivesTheSameFrfs) {
  std::string text = plate_cards(
      "SPC,1,12,123456,,23,123456\nSPC1,1,123456,34\nSPC1,1,12346,45\n"
      "SPC1,1,5,45\n");
  const std::string first = "GRID,1,,0.00,0.00,0.,";
  text.replace(text.find(first), first.size(), first + ",123456");
  const auto held = model_of(structure::deck_of(text));
  EffectInstance soft{&effects::find("soft-support"), {}, {}};
  for (const Location& where : soft.effect->places(held->context)) {
    if (where.variant == "rotation") soft.where = where;
  }
  ASSERT_EQ(soft.where.nodes.size(), 5U);
  for (const char* form : {"rotation",
                           "translation",
                           "both",
                           "face",
                           "rotation-varying",
                           "translation-varying"}) {
    soft.where.variant = form;
    soft.p = {1.0};
    if (soft.effect->parameters(soft.where, held->context).size() == 2) {
      soft.p.push_back(1.0);
    }
    const auto base = held->fitter->model_for({soft}, BaseUse::Scan);
    for (const StiffnessTerm& term : base->base().terms) {
      // The second end a third as stiff as the first.
      soft.p[term.parameter] = term.start / (term.parameter == 0 ? 1.0 : 3.0);
    }
    const auto sprung = model_of(with_support(*held, soft));
    // Seven digits of the springs.
    EXPECT_LT(difference(frfs(*held, {soft}), frfs(*sprung, {})), 2e-6) << form;
    EXPECT_GT(difference(frfs(*held, {}), frfs(*sprung, {})), 0.1) << form;
    if (soft.where.variant != "rotation") continue;
    // Halved, the edge is held as closely.
    EXPECT_LT(difference(frfs(*model_of(held->deck, true), {soft}),
                         frfs(*model_of(sprung->deck, true), {})),
              1e-5);
  }
}

// A rib on the plate, as beams 6 mm above its grids: its section couples what
// turns and what moves.
TEST_F(DeckEffects, SoftFaceWithARibReadBackGivesTheSameFrfs) {
  const auto held = model_of(structure::deck_of(plate_cards(
      "SPC1,1,123456,1,12,23,34,45\nPBAR,7,1,4.-5,2.-10,3.-10,4.-10\n"
      "CBAR,801,7,23,24,0.,0.,1.\n,,,0.,0.,.006,0.,0.,.006\n"
      "CBAR,802,7,24,25,0.,0.,1.\n,,,0.,0.,.006,0.,0.,.006\n")));
  EffectInstance soft{&effects::find("soft-support"), {}, {1.0}};
  for (const Location& where : soft.effect->places(held->context)) {
    if (where.variant == "rotation") soft.where = where;
  }
  ASSERT_TRUE(soft.effect->takes("face", soft.where, held->context));
  soft.where.variant = "face";
  const auto base = held->fitter->model_for({soft}, BaseUse::Scan);
  ASSERT_EQ(base->base().terms.size(), 1U);
  for (const double k :
       {base->base().terms[0].start, 10.0 * base->base().terms[0].start}) {
    soft.p = {k};
    const auto sprung = model_of(with_support(*held, soft));
    // Seven digits of springs, some of which are below zero.
    EXPECT_LT(difference(frfs(*held, {soft}), frfs(*sprung, {})), 5e-6) << k;
  }
}

// The deck as `tapfit export` writes it: the elements on one side on doubled
// grids.
structure::Deck with_joint(const structure::Deck& deck,
                           const effects::JointCards& cards,
                           const JointLine& line) {
  structure::GridMoves moves;
  for (const int id : line.side) moves[id] = cards.doubles;
  const structure::WeakenCards none(deck, {});
  std::string text;
  for (const std::string& l : structure::edit_cards(
           deck.path, {structure::move_elements(moves, none)})) {
    text += l + "\n";
  }
  text += fmt::format("{}\nENDDATA\n", fmt::join(cards.added, "\n"));
  return structure::read_deck(structure::write_text("jointed.bdf", text));
}

// A line along a basic axis, and the whole plate turned so that it is along
// none: on the mesh as it is, as another program would run it, and split, where
// the seam's halves must be tied at the middles too.
TEST_F(DeckEffects, JointReadBackGivesTheSameFrfs) {
  for (const bool turned : {false, true}) {
    std::string text = plate_cards(clamp);
    if (turned) {
      text += "CORD2R,9,,0.,0.,0.,0.,0.,1.\n,.8,.6,0.\n";
      const auto cards = text.find("GRID,1,");
      for (std::size_t at = cards; at != std::string::npos;
           at = text.find("GRID,", at + 6)) {
        // CP, behind the id
        text.insert(text.find(',', at + 5) + 1, "9");
      }
    }
    const auto whole = model_of(structure::deck_of(text));
    EffectInstance joint{&effects::find("joint"), {}, {1.0}};
    joint.where.nodes = {5, 16, 27, 38, 49};
    const StiffnessTerm term =
        whole->fitter->model_for({joint}, BaseUse::Scan)->base().terms.front();
    for (const double k : {term.lower, term.start}) {
      joint.p = {k};
      const JointLine line = effects::joint_at(joint.where, whole->context);
      const effects::JointCards cards =
          effects::joint_cards(whole->deck, line, k);
      EXPECT_EQ(cards.added,
                joint.effect->bulk_data(joint.where, whole->context, joint.p));
      const structure::Deck written = with_joint(whole->deck, cards, line);
      const auto jointed = model_of(written);
      EXPECT_TRUE(jointed->deck.warnings.empty())
          << fmt::format("{}", fmt::join(jointed->deck.warnings, "\n"));
      EXPECT_LT(difference(frfs(*model_of(written, true), {}),
                           frfs(*model_of(whole->deck, true), {joint})),
                1e-5)
          << turned << ", k = " << k;
      const MatrixXcd H = frfs(*whole, {joint});
      EXPECT_GT(difference(frfs(*whole, {}), H), 0.05);
      // Seven digits of k and what the two bases are made for.
      EXPECT_LT(difference(frfs(*jointed, {}), H), 1e-5)
          << turned << ", k = " << k;
    }
  }
}

// A bar that turns at its end, across x.
TEST_F(DeckEffects, JointOfABarReadBackGivesTheSameFrfs) {
  std::string text = plate_cards(clamp);
  text +=
      "PBAR,8,1,1.-4,1.-9,1.-9,1.-9\n"
      "GRID,201,,.30,.06,.10\nGRID,202,,.30,.12,.10\n"
      "CBAR,801,8,33,201,1.,0.,0.\nCBAR,802,8,201,202,1.,0.,0.\n"
      "CBAR,803,8,202,55,1.,0.,0.\n";
  const auto whole = model_of(structure::deck_of(text));
  EffectInstance joint{&effects::find("joint"), {}, {2.0}};
  joint.where.nodes = {201};
  effects::TestContext along_x = whole->context;
  along_x.component = 1;
  const JointLine line = effects::joint_at(joint.where, along_x);
  ASSERT_EQ(line.side.size(), 1U);
  const structure::Deck jointed = with_joint(
      whole->deck, effects::joint_cards(whole->deck, line, 2.0), line);
  StiffnessChange change;
  change.kind = ChangeKind::Joint;
  change.component = 1;
  change.of.where = joint.where;
  const structure::System system = structure::assemble(whole->deck);
  const ReleasedSystem released = release({whole->deck, {}, {}},
                                          system,
                                          nothing_released(system, {}),
                                          ElementParts(whole->deck, {}),
                                          {change});
  const structure::SparseMatrix K =
      released.K.whole() + joint.p[0] * released.scaled.front().S;
  const Eigen::VectorXd direct =
      structure::eigenmodes(
          structure::extract(K, released.active),
          structure::extract(released.M.whole(), released.active),
          8)
          .frequency_hz;
  const Eigen::VectorXd read = structure::modes_of(jointed, 8).frequency_hz;
  // Seven digits of the cards.
  EXPECT_LT((read - direct).cwiseQuotient(direct).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_GT(structure::modes_of(whole->deck, 8).frequency_hz(7) - read(7),
            1e-2 * read(7));
}

}  // namespace
}  // namespace tapfit::updating
