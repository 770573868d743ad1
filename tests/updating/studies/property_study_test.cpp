#include "updating/studies/property_study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;

const PropertyStudy& truss() {
  static const PropertyStudy study(TAPFIT_SOURCE_DIR "/recordings/paper-truss",
                                   {{4, 2, 1}, {10, 2, -1}},
                                   1e4);
  return study;
}

TEST(PropertyStudyTest, ModelAndDirectSolutionAgree) {
  const std::vector<double> factor = {1.3, 0.8, 1.1, 1.0, 0.9};
  const Eigen::VectorXcd s =
      lines_at(Eigen::VectorXd::LinSpaced(20, 13.0, 477.0), 0.02);
  const signal::FrfSet exact = truss().exact(factor, s);
  const FrfModel model = truss().model_at(truss().nominal());
  const ModelResponse response =
      model.respond(truss().state(model, factor), s, false);
  for (std::size_t k = 0; k < exact.frfs.size(); ++k) {
    // Every mode is in the base, so that it holds any factor: rounding.
    EXPECT_LT((response.H.col(static_cast<Index>(k)) - exact.frfs[k].H).norm(),
              1e-9 * exact.frfs[k].H.norm());
  }
}

TEST(PropertyStudyTest, LinesLieWhereTheyAreAsked) {
  const Eigen::VectorXcd s = lines_at(Eigen::VectorXd::Constant(1, 10.0), 0.1);
  EXPECT_NEAR(s(0).imag(), 20.0 * M_PI, 1e-12);
  EXPECT_NEAR(s(0).real(), 2.0 * M_PI, 1e-12);
}

TEST(PropertyStudyTest, NoiseIsInProportionAndItsVarianceKnown) {
  signal::FrfSet set = truss().exact(
      truss().nominal(), lines_at(Eigen::VectorXd::LinSpaced(400, 1.0, 70.0)));
  const signal::FrfSet clean = set;
  acquisition::SeededRandom random(3, "noise");
  add_noise(set, 0.05, random);
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t k = 0; k < set.frfs.size(); ++k) {
    for (Index l = 0; l < set.lines(); ++l) {
      const double off = std::abs(set.frfs[k].H(l) - clean.frfs[k].H(l));
      EXPECT_LE(off, 0.05 * std::abs(clean.frfs[k].H(l)) * (1.0 + 1e-12));
      sum += off * off / set.frfs[k].variance(l);
      count += 1.0;
    }
  }
  // 800 values of relative scatter 0.9 each: 0.03 is one standard deviation.
  EXPECT_NEAR(sum / count, 1.0, 0.1);
}

}  // namespace
}  // namespace tapfit::updating
