// The sample plate's FRFs with an effect in it, and a fitter that has the plate
// without.
#pragma once

#include "tests/updating/support/sample_plate.hpp"
#include "updating/fit/fitter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace tapfit::support {

class HiddenInPlate : public ::testing::Test {
 protected:
  void hide(const std::vector<updating::EffectInstance>& effects) {
    using namespace updating;
    Eigen::VectorXcd s(60);
    for (Eigen::Index l = 0; l < s.size(); ++l) {
      const double w = 2.0 * M_PI * (20.0 + 6.0 * static_cast<double>(l));
      s(l) = {0.03 * w, w};
    }
    FitProblem problem;
    problem.context = plate_context(bundle_, deck_);
    problem.measured = plate_pairs(bundle_, s);
    problem.targets = {make_target(problem.measured)};
    const Fitter blank(builder_, problem);
    const auto truth = blank.model_for(effects);
    const ModelState state = blank.first_state(*truth, effects);
    const Eigen::MatrixXcd H = truth->respond(state, s, false).H;
    for (Eigen::Index f = 0; f < H.cols(); ++f) {
      signal::Frf& frf = problem.measured.frfs[static_cast<std::size_t>(f)];
      frf.H = H.col(f);
      frf.variance = (0.01 * H.col(f).cwiseAbs()).cwiseAbs2();
    }
    problem.targets = {make_target(problem.measured)};
    // Clamped, the plate has five modes to 380 Hz.
    problem.targets.back().modes_in_band = 5;
    fitter_.emplace(builder_, std::move(problem));
  }

  structure::Deck deck_ = plate_deck(true);
  acquisition::TestBundle bundle_ = plate_bundle();
  updating::BaseBuilder builder_{
      deck_, {}, plate_base(bundle_, deck_), Progress{}};
  std::optional<updating::Fitter> fitter_;
};

}  // namespace tapfit::support
