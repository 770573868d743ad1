// A plate under in-plane force, seen through a base, against the whole model.
#include "tests/updating/support/sample_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/effects/preload.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/reduction/reduced_base.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/free_motions.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using structure::SparseMatrix;

class PulledPlate : public ::testing::Test, protected support::BasedPlate {
 protected:
  [[nodiscard]] Location place() const {
    return effects::find("prestress").places(context_).front();
  }
  [[nodiscard]] ReducedBase base(BaseUse use) const {
    StiffnessChange change;
    change.kind = ChangeKind::Preload;
    change.of = {"prestress", place()};
    return builder_.build({}, {change}, use);
  }
};

// Clamped on one side: a wire pulls at the other.
TEST_F(PulledPlate, HasAForceAndASideStiffness) {
  const auto specs = effects::find("prestress").parameters(place(), context_);
  ASSERT_EQ(specs.size(), 2U);
  EXPECT_EQ(specs[0].name, "force_n");
  EXPECT_EQ(specs[1].name, "side_stiffness_n_per_m");
  EXPECT_EQ(base(BaseUse::Fit).terms.size(), 2U);
}

TEST_F(PulledPlate, FrequenciesAreTheWholeModels) {
  const structure::System system = structure::assemble(deck_);
  const effects::Preload unit =
      effects::preload(deck_, system, place().elements, place());
  const structure::FreeMotions motions = structure::free_motions(system);
  for (const BaseUse use : {BaseUse::Fit, BaseUse::Scan}) {
    const ReducedBase small = base(use);
    for (const double share : {0.1, 1.0}) {
      const double T = share * small.terms[0].upper;
      const double k = share * small.terms[1].upper;
      const MatrixXd K = small.K + T * small.terms[0].S + k * small.terms[1].S;
      const Eigen::VectorXd found =
          Eigen::SelfAdjointEigenSolver<MatrixXd>(K, Eigen::EigenvaluesOnly)
              .eigenvalues();
      const SparseMatrix whole = system.K + T * unit.along + k * unit.side;
      const auto exact = structure::eigenmodes(
          motions.reduce(whole), motions.reduce(system.M), 4);
      for (Index r = 0; r < 4; ++r) {
        const double hz = std::sqrt(found(r)) / (2.0 * M_PI);
        // A cantilever beam in the same ranges is good to 3e-8.
        EXPECT_NEAR(hz / exact.frequency_hz(r), 1.0, 1e-4) << share << ' ' << r;
      }
    }
  }
}

// The derivatives of FRFs by the logarithms of force and side stiffness,
// against differences.
TEST_F(PulledPlate, FrfsChangeWithTheForceAsDerived) {
  Eigen::VectorXcd s(3);
  s << std::complex<double>(5.0, 300.0), std::complex<double>(5.0, 700.0),
      std::complex<double>(5.0, 1500.0);
  FitProblem problem;
  problem.context = context_;
  problem.measured = support::plate_pairs(bundle_, s);
  problem.targets = {make_target(problem.measured)};
  problem.uncertain_sd = {0.1};
  const Fitter fitter(builder_, problem);
  EffectInstance effect = placed(effects::find("prestress"), place(), context_);
  const auto model = fitter.model_for({effect});
  for (std::size_t k = 0; k < 2; ++k) {
    effect.p[k] = model->base().terms[k].start;
  }
  const ModelState state = fitter.first_state(*model, {effect});
  const auto derived = model->respond(state, s, true).dH;
  constexpr double step = 1e-4;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto at = [&](double h) {
      ModelState moved = state;
      moved.effects[0].p[k] *= std::exp(h);
      return model->respond(moved, s, false).H;
    };
    const Eigen::MatrixXcd differences = (at(step) - at(-step)) / (2.0 * step);
    const Eigen::MatrixXcd& own = derived[derived.size() - 2 + k];
    EXPECT_LT((own - differences).norm(), 1e-4 * differences.norm()) << k;
  }
}

}  // namespace
}  // namespace tapfit::updating
