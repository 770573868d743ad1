#include "updating/frf_model/test_as_done.hpp"

#include "tests/updating/support/plate_model.hpp"

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

class AsDone : public PlateModel {
 protected:
  static EffectInstance moved(const std::string& channel,
                              int written,
                              int real) {
    Location where;
    where.channels = {channel};
    where.nodes = {written};
    where.node = real;
    return {&effects::find("point-mislabelled"), where, {}};
  }

  // FRFs of the model of a sheet.
  [[nodiscard]] MatrixXcd frfs(
      const acquisition::TestBundle& sheet,
      const std::vector<EffectInstance>& effects) const {
    FitProblem fit = fitter_->problem();
    fit.context = support::plate_context(sheet, deck_);
    fit.measured = support::plate_pairs(sheet, s_);
    const BaseBuilder builder(
        deck_, sheet.uncertain, support::plate_base(sheet, deck_), Progress{});
    const Fitter fitter(builder, fit);
    const auto model = fitter.model_for(effects);
    return model->respond(fitter.first_state(*model, effects), s_, false).H;
  }
};

// Static answers bring both bases to about 1e-6 of each other.
constexpr double as_good_as_bases = 1e-4;

TEST_F(AsDone, FrfsAreThoseOfTheSheetPutRight) {
  acquisition::TestBundle right = bundle_;
  right.runs[2].hammer.dof.node = 49;  // 52 on the sheet
  const MatrixXcd wrong = frfs(bundle_, {});
  const MatrixXcd expected = frfs(right, {});
  EXPECT_GT(difference(wrong, expected), 0.1);
  EXPECT_LT(difference(frfs(bundle_, {moved("hammer", 52, 49)}), expected),
            as_good_as_bases);
}

TEST_F(AsDone, MassMovesWithTheSensor) {
  acquisition::TestBundle right = bundle_;
  for (acquisition::Run& run : right.runs) run.sensors[1].dof.node = 33;
  const EffectInstance mass = sensors(0.02, 0.05);
  const MatrixXcd expected = frfs(right, {mass});
  EXPECT_LT(difference(frfs(bundle_, {mass, moved("acc2", 36, 33)}), expected),
            as_good_as_bases);
  EXPECT_LT(difference(frfs(bundle_, {moved("acc2", 36, 33), mass}), expected),
            as_good_as_bases);
}

TEST_F(AsDone, RunsThatAreNotMeantStay) {
  EffectInstance late = moved("acc2", 36, 33);
  late.where.runs = {4, 5, 6};
  const MatrixXcd all = frfs(bundle_, {moved("acc2", 36, 33)});
  const MatrixXcd some = frfs(bundle_, {late});
  const MatrixXcd none = frfs(bundle_, {});
  for (Index f = 0; f < some.cols(); ++f) {
    // Two sensors a run.
    const MatrixXcd& same = f < 6 ? none : all;
    EXPECT_LT(difference(some.col(f), same.col(f)), as_good_as_bases) << f;
  }
}

TEST_F(AsDone, TellsWhatEachFrfWasMeasuredBetween) {
  const auto model = fitter_->model_for({moved("hammer", 52, 49)});
  ModelState state;
  state.effects = {moved("hammer", 52, 49)};
  const std::vector<PairEnds> ends = model->ends(state);
  ASSERT_EQ(ends.size(), 12U);
  EXPECT_EQ(ends[4].reference.node, 49);
  EXPECT_EQ(ends[4].response.node, 11);
  EXPECT_EQ(ends[6].reference.node, 28);
}

TEST_F(AsDone, IsTheSheetWhereNothingIsWrongWithIt) {
  const TestAsDone done = test_as_done(context_, {at_node("added-mass", 3, 1)});
  EXPECT_EQ(done.sheet, nullptr);
  EXPECT_EQ(done.context.bundle, &bundle_);
}

}  // namespace
}  // namespace tapfit::updating
