// The Diagnose screen from hand-made results.
#include "tui/views/diagnose_view.hpp"

#include "tests/tui/support/canvases.hpp"
#include "tests/tui/support/fake_workbench.hpp"
#include "tests/tui/support/holds.hpp"
#include "updating/localisation/signature.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(DiagnoseView, ShowsCandidatesSizesAndLookAlikes) {
  const acquisition::TestBundle bundle = testing::fake_bundle();
  const updating::Diagnosis d = testing::fake_diagnosis();
  const Wireframe wire = wireframe(testing::fake_deck());
  std::map<int, std::shared_ptr<const updating::Signature>> signatures;
  signatures[5] =
      std::make_shared<const updating::Signature>(testing::fake_signature(5));
  for (const Canvas& canvas : sizes) {
    Screen s = diagnose_view({bundle, d, signatures, &wire}, {}, canvas);
    EXPECT_TRUE(
        holds(s, "verdict: added-mass   error 38.8 % → 3.8 %, floor 3.1 %"));
    EXPECT_TRUE(holds(s, "98.3 %")) << s.to_text();
    EXPECT_TRUE(holds(s, "mass 0.07850 ± 0.00060 kg (95 %: 0.0773 to 0.0797)"));
    EXPECT_TRUE(holds(s, "grid 5 alone explains 99 % of the misfit"));
    EXPECT_TRUE(holds(s, "a pure mass leaves 6 % of it, a spring 84 %"))
        << s.to_text();
    EXPECT_FALSE(holds(s, "80.1 g")) << "beside 78.5 g that were fitted";
    DiagnoseState second;
    second.list.selected = 1;
    s = diagnose_view({bundle, d, signatures, &wire}, second, canvas);
    EXPECT_TRUE(
        holds(s, "indistinguishable with these points from: added-mass"));
  }
}

TEST(DiagnoseView, DrawsTheLawOfAnAbsorberThatIsSuspected) {
  const acquisition::TestBundle bundle = testing::fake_bundle();
  updating::Diagnosis d = testing::fake_diagnosis();
  updating::Signature z = testing::fake_signature(5);
  z.absorber = {0.0123, 23.456, 0.02, 0.05};
  const std::map<int, std::shared_ptr<const updating::Signature>> signatures{
      {5, std::make_shared<const updating::Signature>(z)}};
  const DiagnoseInput input{bundle, d, signatures, nullptr};
  for (const Canvas& canvas : sizes) {
    d.candidates[0].effect = "added-mass";
    Screen s = diagnose_view(input, {}, canvas);
    EXPECT_TRUE(holds(s, "an absorber leaves 5 %")) << s.to_text();
    EXPECT_FALSE(holds(s, "absorber law")) << s.to_text();
    d.candidates[0].effect = "absorber";
    s = diagnose_view(input, {}, canvas);
    EXPECT_TRUE(holds(s, "absorber law")) << s.to_text();
    EXPECT_FALSE(holds(s, "mass law")) << s.to_text();
  }
}

TEST(DiagnoseView, FindsTheGridsOfChannels) {
  const acquisition::TestBundle bundle = testing::fake_bundle();
  updating::Location where;
  where.channels = {"acc2"};
  EXPECT_EQ(grids_of(bundle, where), std::vector<int>{4});
}

// Sensors and elements are no single grid, and a mistake acts on none: their
// evidence is what they do for the FRFs.
TEST(DiagnoseView, ShowsTheFrfsWithAndWithoutWhatIsAtNoSingleGrid) {
  const acquisition::TestBundle bundle = testing::fake_bundle();
  const structure::Deck deck = testing::fake_deck();
  const Wireframe wire = wireframe(deck);
  const signal::FrfSet frfs = testing::fake_frfs();
  const updating::EffectEvidence evidence = updating::effect_evidence(
      testing::fake_comparison(0.05), testing::fake_comparison(0.0));
  updating::Diagnosis d = testing::fake_diagnosis();
  updating::Candidate& chosen = d.candidates[0];
  const auto drawn = [&](const updating::EffectEvidence* known,
                         const Canvas& canvas,
                         Standing standing = Standing::Final) {
    return diagnose_view(
        {bundle, d, {}, &wire, nullptr, standing, &deck, &frfs, known},
        {},
        canvas);
  };
  for (const Canvas& canvas : sizes) {
    chosen.effect = "stiffness-loss";
    chosen.where = {.elements = {2}};
    EXPECT_EQ(grids_of(bundle, chosen.where, &deck),
              (std::vector<int>{3, 4, 5, 6}));
    const Screen s = drawn(&evidence, canvas);
    EXPECT_TRUE(holds(s, "●")) << s.to_text();
    EXPECT_TRUE(holds(s, "measured  ┈ without  ╌ with")) << s.to_text();
    EXPECT_TRUE(holds(s, "error 38.8 % without it, 0.01 % with it"));
    EXPECT_TRUE(holds(s, "where it shows most: ")) << s.to_text();
    EXPECT_TRUE(holds(drawn(nullptr, canvas), "FRFs with and without it …"));
    EXPECT_TRUE(holds(drawn(nullptr, canvas, Standing::Preliminary),
                      "FRFs with and without it come with the verdict"));
    chosen.effect = "point-mislabelled";
    chosen.where = {.node = 5};
    EXPECT_TRUE(holds(drawn(&evidence, canvas), "without  ╌ with"));
    chosen.effect = updating::nonlinearity;
    EXPECT_TRUE(holds(drawn(nullptr, canvas), "no linear model holds it"));
  }
}

// e shows them of an effect at one grid, too.
TEST(DiagnoseView, ShowsTheFrfsOfAPointEffectOnRequest) {
  const acquisition::TestBundle bundle = testing::fake_bundle();
  const signal::FrfSet frfs = testing::fake_frfs();
  const updating::Diagnosis d = testing::fake_diagnosis();
  const updating::EffectEvidence evidence = updating::effect_evidence(
      testing::fake_comparison(0.05), testing::fake_comparison(0.0));
  const std::map<int, std::shared_ptr<const updating::Signature>> signatures{
      {5,
       std::make_shared<const updating::Signature>(
           testing::fake_signature(5))}};
  DiagnoseInput input{bundle, d, signatures};
  input.frfs = &frfs;
  input.evidence = &evidence;
  DiagnoseState state;
  EXPECT_TRUE(holds(diagnose_view(input, state, sizes[0]), "missing z"));
  state.evidence = true;
  EXPECT_TRUE(holds(diagnose_view(input, state, sizes[0]), "╌ with"));
}

// Where the place explains little, its curve is of something else.
TEST(DiagnoseView, DrawsNoSignatureThatMeansNothing) {
  const acquisition::TestBundle bundle = testing::fake_bundle();
  const signal::FrfSet frfs = testing::fake_frfs();
  const updating::Diagnosis d = testing::fake_diagnosis();
  updating::Signature z = testing::fake_signature(5);
  z.explained = 0.18;
  const std::map<int, std::shared_ptr<const updating::Signature>> signatures{
      {5, std::make_shared<const updating::Signature>(z)}};
  DiagnoseInput input{bundle, d, signatures};
  input.frfs = &frfs;
  const Screen s = diagnose_view(input, {}, sizes[1]);
  EXPECT_TRUE(
      holds(s, "grid 5 alone explains 18.0 % of the misfit: no signature"))
      << s.to_text();
  const signal::FrfSet none;  // of a test of modes
  input.frfs = &none;
  EXPECT_FALSE(holds(diagnose_view(input, {}, sizes[1]), "explains"));
  EXPECT_FALSE(holds(s, "missing z")) << s.to_text();
}

TEST(DiagnoseView, TakesNoCandidates) {
  const acquisition::TestBundle bundle;
  updating::Diagnosis d;
  d.verdict = "none";
  EXPECT_TRUE(holds(diagnose_view({bundle, d, {}, nullptr}, {}, {}),
                    "nothing significant is missing (error within the floor)"));
  d.error_best = 0.0186;
  d.floor = 0.0157;
  EXPECT_TRUE(holds(diagnose_view({bundle, d, {}, nullptr}, {}, {120, 35}),
                    "nothing significant is missing (error 1.2 times the "
                    "floor, as good as the data allow)"));
}

TEST(DiagnoseView, ClaimsNothingThatTheFloorHides) {
  const acquisition::TestBundle bundle;
  updating::Diagnosis d;
  d.verdict = "none";
  d.error_best = 0.726;
  d.floor = 0.464;
  const auto seen = [&] {
    return diagnose_view({bundle, d, {}, nullptr}, {}, {120, 35});
  };
  EXPECT_TRUE(holds(seen(), "a floor of 46.4 % hides what is missing"))
      << seen().to_text();
  EXPECT_FALSE(holds(seen(), "nothing significant"));
  d.floor = 0.2;
  EXPECT_TRUE(holds(seen(),
                    "no effect is supported by the data (error 3.6 times the "
                    "floor)"))
      << seen().to_text();
}

// The rung of what is uncertain in the model is no effect.

}  // namespace
}  // namespace tapfit::tui
