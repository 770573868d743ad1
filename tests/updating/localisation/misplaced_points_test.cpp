#include "updating/localisation/misplaced_points.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/properties/uncertain_property.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// Hammer test of the sample plate, its FRFs straight from the model with a
/// little scatter, and the fit of that model to them.
class Points : public testing::Test {
 protected:
  // The FRFs are made with the bundle as it was done; `bundle_` is then what
  // was written down.
  void measure(const acquisition::TestBundle& done) {
    const Eigen::VectorXcd s = lines();
    const effects::Setting setting = support::plate_setting(done, deck_);
    builder_.emplace(deck_,
                     std::vector<acquisition::UncertainProperty>{},
                     support::plate_base(done, deck_),
                     Progress{});
    const signal::FrfSet pairs = support::plate_pairs(done, s);
    const FrfModel truth(builder_->build({}, {}), setting, pairs);
    ModelState state;
    state.zeta = Eigen::VectorXd::Constant(4, 0.01);
    const Eigen::MatrixXcd H = truth.respond(state, s, false).H;
    FitSetting fit;
    fit.setting = support::plate_setting(bundle_, deck_);
    fit.measured = support::plate_pairs(bundle_, s);
    for (Index f = 0; f < H.cols(); ++f) {
      signal::Frf& frf = fit.measured.frfs[static_cast<std::size_t>(f)];
      frf.H = H.col(f);
      // A ripple of 1 %, another one in every FRF.
      for (Index l = 0; l < s.size(); ++l) {
        frf.H(l) *=
            1.0 + 0.01 * std::cos(1.7 * static_cast<double>(l * (f + 1)));
      }
      frf.variance = (0.007 * frf.H.cwiseAbs()).cwiseAbs2();
    }
    fit.targets = {make_target(fit.measured)};
    fitter_.emplace(*builder_, std::move(fit));
  }

  [[nodiscard]] std::vector<MisplacedPoint> found(
      Looked looked = Looked::Roved) const {
    const Fit fit = fitter_->fit({}, fitter_->model_for({}));
    return misplaced_points(fit, *fitter_, floor, looked, {});
  }

  static Eigen::VectorXcd lines() {
    Eigen::VectorXcd s(60);
    for (Index l = 0; l < s.size(); ++l) {
      const double w = 2.0 * M_PI * (20.0 + 6.0 * static_cast<double>(l));
      s(l) = Complex(0.03 * w, w);
    }
    return s;
  }

  static constexpr double floor = 0.01;
  structure::Deck deck_ = support::plate_deck(true);
  acquisition::TestBundle bundle_ = support::plate_bundle();
  std::optional<BaseBuilder> builder_;
  std::optional<Fitter> fitter_;
};

TEST_F(Points, WhereTheyWereWrittenDownAreLeftAlone) {
  measure(bundle_);
  EXPECT_TRUE(found().empty());
}

TEST_F(Points, HitElsewhereIsFoundThere) {
  acquisition::TestBundle done = bundle_;
  const Dof written = bundle_.runs[2].hammer.dof;
  Dof& real = done.runs[2].hammer.dof;
  real.node = written.node - 3;  // three elements nearer the clamp
  measure(done);
  const std::vector<MisplacedPoint> points = found();
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].point.written, written);
  EXPECT_EQ(points[0].point.likely, real);
  EXPECT_TRUE(points[0].point.channel.empty());
  EXPECT_EQ(points[0].frfs.size(), 2U) << "one run, two sensors";
  // The ripple: 1 % at the crest.
  EXPECT_LT(points[0].point.error_there, 0.012);
}

TEST_F(Points, HitFromTheOtherSideIsFound) {
  acquisition::TestBundle done = bundle_;
  done.runs[4].hammer.dof.sign = -done.runs[4].hammer.dof.sign;
  measure(done);
  const std::vector<MisplacedPoint> points = found();
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].point.likely, done.runs[4].hammer.dof);
  EXPECT_NE(describe(points[0].point).find("hits at "), std::string::npos);
}

TEST_F(Points, SensorThatStaysIsLookedAtLast) {
  acquisition::TestBundle done = bundle_;
  for (acquisition::Run& run : done.runs) run.sensors[1].dof.node = 33;
  measure(done);
  EXPECT_TRUE(found(Looked::Roved).empty())
      << "its channel may be swapped or turned";
  const std::vector<MisplacedPoint> points = found(Looked::All);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].point.channel, "acc2");
  EXPECT_EQ(points[0].point.likely.node, 33);
}

TEST_F(Points, WhatTheStructureLacksIsNoWrongPoint) {
  // A mass of a tenth of the plate that the model does not have: every FRF is
  // off, whatever the grid.
  deck_.masses.push_back({900, bundle_.runs[2].hammer.dof.node, 0.03});
  measure(bundle_);
  const Fit wrong = [&] {
    deck_.masses.clear();
    builder_.emplace(deck_,
                     std::vector<acquisition::UncertainProperty>{},
                     support::plate_base(bundle_, deck_),
                     Progress{});
    FitSetting setting = fitter_->setting();
    fitter_.emplace(*builder_, std::move(setting));
    return fitter_->fit({}, fitter_->model_for({}));
  }();
  EXPECT_GT(wrong.result.error, 0.2) << "the mass is felt";
  EXPECT_TRUE(
      misplaced_points(wrong, *fitter_, floor, Looked::All, {}).empty());
}

TEST_F(Points, FitterWithoutAnFrfHasTheOthers) {
  measure(bundle_);
  const Fitter rest = fitter_->without({0, 3});
  const Target& whole = fitter_->target();
  const Target& part = rest.target();
  ASSERT_EQ(part.H.cols(), whole.H.cols() - 2);
  EXPECT_EQ(part.H.col(0), whole.H.col(1));
  EXPECT_EQ(part.H.col(2), whole.H.col(4));
  EXPECT_EQ(part.run[2], whole.run[4]);
  EXPECT_EQ(part.weight, whole.weight);
  EXPECT_EQ(rest.setting().measured.frfs.size(), whole.run.size() - 2);
}

}  // namespace
}  // namespace tapfit::updating
