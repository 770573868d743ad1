#include "updating/localisation/location_scan.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/localisation/first_order_sensitivity.hpp"
#include "updating/localisation/location_operators.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

constexpr int grid = 27;

/// The sample plate with a sensor's mass in its model that every second run is
/// measured without, against FRFs that have nothing to do with it.
class Scanned : public testing::Test {
 protected:
  Scanned() {
    for (std::size_t r = 0; r < bundle_.runs.size(); r += 2) {
      bundle_.runs[r].sensors.pop_back();  // so that the mass is not there
    }
    Eigen::VectorXcd s(40);
    for (Index l = 0; l < s.size(); ++l) {
      const double w = 2.0 * M_PI * (20.0 + 9.0 * static_cast<double>(l));
      s(l) = {0.03 * w, w};
    }
    FitProblem problem;
    problem.context = support::plate_context(bundle_, deck_);
    problem.measured = support::plate_pairs(bundle_, s);
    problem.uncertain_sd = {0.1};
    for (std::size_t f = 0; f < problem.measured.frfs.size(); ++f) {
      signal::Frf& frf = problem.measured.frfs[f];
      frf.H = Eigen::VectorXcd::Random(s.size()) * 100.0;
      frf.variance = Eigen::VectorXd::Ones(s.size());
    }
    problem.targets = {make_target(problem.measured)};
    fitter_.emplace(builder_, std::move(problem));
    EffectInstance sensor{&effects::find("sensor-mass"), {}, {0.02}};
    sensor.where.channels = {"acc2"};
    EffectInstance added{&effects::find("ground-spring"), {}, {1.0}};
    added.where.node = grid;
    current_.model = fitter_->model_for({sensor, added});
    current_.effects = {sensor};
    current_.result.state = fitter_->first_state(*current_.model, {sensor});
  }

  [[nodiscard]] const Target& target() const { return fitter_->target(); }

  structure::Deck deck_ = support::plate_deck(true);
  acquisition::TestBundle bundle_ = support::plate_bundle();
  BaseBuilder builder_{deck_,
                       {{"material", 1, "E", 3.0}},
                       support::plate_base(bundle_, deck_),
                       Progress{}};
  std::optional<Fitter> fitter_;
  Fit current_;
};

// The rank-one formula and Woodbury's on all effects at once are the same. (A
// spring would be in the modes, with its say in whose damping ratios they are.)
TEST_F(Scanned, ALawAtAGridLeavesWhatTheModelWithItLeaves) {
  const ProjectedMisfit misfit(current_, target());
  const LocationScan scan(
      current_, target(), misfit, {{current_.model->row(grid, 3)}, {}, {}}, {});
  const Eigen::VectorXcd& s = target().s;
  const MatrixXcd now =
      current_.model->respond(current_.result.state, s, false).H;
  const std::vector<double> sizes = {0.3, 10.0, 300.0};
  MatrixXcd z(s.size(), 3);
  Eigen::MatrixXd changes(2 * now.size(), 3);
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    z.col(static_cast<Index>(k)) = sizes[k] * s;
    ModelState with = current_.result.state;
    with.effects.push_back({&effects::find("dashpot"), {}, {sizes[k]}});
    with.effects.back().where.node = grid;
    changes.col(static_cast<Index>(k)) =
        misfit.change(current_.model->respond(with, s, false).H - now);
  }
  const Eigen::VectorXd expected = misfit.errors(changes);
  const Eigen::VectorXd found = scan.errors(0, z);
  for (Index k = 0; k < 3; ++k) {
    EXPECT_NEAR(found(k), expected(k), 1e-9 * expected(k)) << sizes[k];
  }
  EXPECT_GT((found.array() - found(0)).abs().maxCoeff(), 1e-3);
}

TEST_F(Scanned, PartsAddUpToTheirPatternsSum) {
  const ProjectedMisfit misfit(current_, target());
  LocationOperators rows(*current_.model);
  const std::vector<ElementCell> cells =
      element_cells(*current_.model->context().deck);
  const std::vector<Eigen::MatrixXd> parts = {rows.cell(cells[2]),
                                              rows.cell(cells[3])};
  const LocationScan scan(
      current_, target(), misfit, {{}, parts, {{0, 1}}}, {});
  const FirstOrderSensitivity patterns =
      first_order_sensitivity(current_, target(), parts, {});
  MatrixXcd change = patterns.pattern[0] + patterns.pattern[1];
  for (Index l = 0; l < change.rows(); ++l) {
    change.row(l) *= target().s(l) * target().s(l);
  }
  const ProjectedMisfit::Scaled best = scan.scaled(0);
  ASSERT_GT(best.factor, 0.0);
  const Eigen::VectorXd stacked = misfit.change(best.factor * change);
  EXPECT_NEAR(misfit.errors(stacked)(0), best.error, 1e-9 * best.error);
  for (const double step : {-1e-3, 1e-3}) {
    const double other = best.factor * (1.0 + step);
    EXPECT_GE(misfit.errors(misfit.change(other * change))(0),
              best.error * (1.0 - 1e-12));
  }
}

TEST_F(Scanned, AnyLawIsTheLeastSquaresOfEveryLine) {
  const ProjectedMisfit misfit(current_, target());
  const LocationScan scan(
      current_, target(), misfit, {{current_.model->row(grid, 3)}, {}, {}}, {});
  // Against a direct least squares of the pattern, line by line.
  const FirstOrderSensitivity patterns = first_order_sensitivity(
      current_, target(), {current_.model->row(grid, 3)}, {});
  const MatrixXcd missing =
      current_.model->respond(current_.result.state, target().s, false).H -
      target().H;
  double left = 0.0;
  for (Index l = 0; l < missing.rows(); ++l) {
    const Eigen::VectorXcd p = patterns.pattern[0].row(l).transpose();
    const Eigen::VectorXcd m = missing.row(l).transpose();
    const double rest = m.squaredNorm() - std::norm(p.dot(m)) / p.squaredNorm();
    left += rest / std::pow(target().weight(l), 2);
  }
  const double expected = std::sqrt(left / target().count());
  EXPECT_NEAR(scan.any_law(0), expected, 1e-9 * expected);
}

}  // namespace
}  // namespace tapfit::updating
