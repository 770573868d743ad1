// The numbers of the paper's section 4.2, on a wing of like size.
#include "updating/studies/wing_study.hpp"

#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/system.hpp"
#include "updating/studies/truss_study.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

TEST(WingStudyTest, IdentifiesFourPropertiesUnderNoise) {
  const WingStudy wing(TAPFIT_SOURCE_DIR "/recordings/paper-solar-wing");
  const structure::Deck& deck = wing.study().deck();
  EXPECT_EQ(deck.grids.size(), 47u);
  EXPECT_EQ(deck.element_count(), 34u);
  EXPECT_EQ(structure::assemble(deck).free_dofs().size(), 264u);

  const WingResult result = wing.identify(1);
  EXPECT_TRUE(result.last.converged) << result.last.message;
  // The paper's largest error.
  EXPECT_LT(largest_error(result.factor, WingStudy::truth()), 0.0042);
  // Density and area of the beams are hard to tell apart, but they can be.
  EXPECT_LT(result.last.identifiability.correlation(2, 3), -0.9);
  EXPECT_TRUE(result.last.identifiability.confounded.empty());
}

TEST(WingStudyTest, ModelAtTheTruthIsExactThere) {
  const WingStudy wing(TAPFIT_SOURCE_DIR "/recordings/paper-solar-wing");
  const PropertyStudy& study = wing.study();
  const Eigen::VectorXcd s = lines_at(even_lines(12.0, 0.5));
  const signal::FrfSet exact = study.exact(WingStudy::truth(), s);
  const FrfModel model = study.model_at(WingStudy::truth());
  const Eigen::MatrixXcd H =
      model.respond(study.state(model, study.nominal()), s, false).H;
  for (std::size_t k = 0; k < exact.frfs.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    // Modes to five times the band, residual flexibility undamped beyond.
    EXPECT_LT((H.col(column) - exact.frfs[k].H).norm(),
              1e-3 * exact.frfs[k].H.norm());
  }
}

}  // namespace
}  // namespace tapfit::updating
