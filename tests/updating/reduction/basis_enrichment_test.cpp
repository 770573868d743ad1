// Bases for changes of the stiffness against direct solves of the whole
// changed model, over all that the change may be.
#include "updating/reduction/basis_enrichment.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/measurement/damped_line.hpp"
#include "updating/reduction/reduced_base.hpp"
#include "updating/reduction/released_system.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"
#include "updating/structure/solve/eigenmodes.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseLU>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <complex>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using std::complex;

class ChangedMotions : public ::testing::Test {
 protected:
  // Largest relative error of the FRFs between all points, over the range of
  // the change's parameter.
  double worst_error(const StiffnessChange& change, bool split) {
    BaseOptions options = support::plate_base(bundle_, deck_);
    options.split = split;
    const ReducedBase base =
        BaseBuilder(deck_, {}, options, Progress{}).build({}, {change});
    const structure::RefinedDeck mesh =
        split ? structure::refine_mesh(deck_)
              : structure::RefinedDeck{deck_, {}, {}};
    const structure::System system = structure::assemble(mesh.deck);
    const ReleasedSystem whole = release(mesh,
                                         system,
                                         nothing_released(system, {}),
                                         ElementParts(mesh.deck, {}),
                                         {change});
    const StiffnessTerm& term = base.terms.front();
    double worst = 0.0;
    for (const double p :
         {term.lower,
          std::pow(term.lower, 0.75) * std::pow(term.upper, 0.25),
          std::sqrt(term.lower * term.upper),
          term.start,
          term.upper}) {
      // A second parameter is elsewhere in its range.
      std::vector<double> sizes = {p};
      if (base.terms.size() > 1) sizes.push_back(base.terms[1].start);
      worst = std::max(worst, error_at(base, whole, sizes));
    }
    return worst;
  }

  double error_at(const ReducedBase& base,
                  const ReleasedSystem& whole,
                  const std::vector<double>& sizes) const {
    structure::SparseMatrix changed = whole.K.whole();
    MatrixXd Kr = base.K;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      const StiffnessTerm& term = base.terms[k];
      changed += (sizes[k] - term.included) * whole.scaled[k].S;
      Kr += (sizes[k] - term.included) * term.S;
    }
    const structure::SparseMatrix K = extract(whole, changed);
    const structure::SparseMatrix M = extract(whole, whole.M.whole());
    const std::vector<int> points = points_;
    double error = 0.0;
    for (const double hz : {20.0, 110.0, 233.0, 390.0}) {
      const complex<double> s = 2.0 * M_PI * hz * complex<double>(0.03, 1.0);
      Eigen::SparseMatrix<complex<double>> Z =
          K.cast<complex<double>>() + s * s * M.cast<complex<double>>();
      const Eigen::SparseLU<Eigen::SparseMatrix<complex<double>>> lu(Z);
      MatrixXcd f = MatrixXcd::Zero(Z.rows(), Index(points.size()));
      for (std::size_t k = 0; k < points.size(); ++k) {
        f(place(whole, points[k]), Index(k)) = 1.0;
      }
      const MatrixXcd H = f.transpose() * lu.solve(f);
      MatrixXd rows(Index(points.size()), base.size());
      for (std::size_t k = 0; k < points.size(); ++k) {
        rows.row(Index(k)) = base.rows.row(points[k]);
      }
      const MatrixXcd Zr =
          Kr.cast<complex<double>>() +
          s * s * MatrixXcd::Identity(base.size(), base.size());
      const MatrixXcd Hr =
          rows * Zr.partialPivLu().solve(
                     MatrixXcd(rows.transpose().cast<complex<double>>()));
      error = std::max(error, (Hr - H).norm() / H.norm());
    }
    return error;
  }

  static Index place(const ReleasedSystem& whole, int dof) {
    return std::lower_bound(whole.active.begin(), whole.active.end(), dof) -
           whole.active.begin();
  }
  static structure::SparseMatrix extract(const ReleasedSystem& whole,
                                         const structure::SparseMatrix& A) {
    return structure::extract(A, whole.active);
  }

  structure::Deck deck_ = support::plate_deck(true);
  acquisition::TestBundle bundle_ = support::plate_bundle();
  std::vector<int> points_ = measured_points(deck_, bundle_).all;
};

// The bound of a base with nothing changed.
constexpr double exact = 1e-6;

TEST_F(ChangedMotions, SupportTurns) {
  StiffnessChange change;
  change.kind = ChangeKind::Support;
  change.of.where.nodes = {1, 12, 23, 34, 45};
  change.of.where.variant = "rotation";
  EXPECT_LT(worst_error(change, false), exact);
  EXPECT_LT(worst_error(change, true), exact);
}

// A base that holds all that has mass leaves the released rotations none.
TEST_F(ChangedMotions, SupportTurnsWhereFewGridsHaveMass) {
  deck_.materials[1].rho = 0.0;
  for (const int grid : {11, 36, 42}) {
    structure::PointMass mass;
    mass.id = 100 + grid;
    mass.grid = grid;
    mass.mass = 0.1;
    deck_.masses.push_back(mass);
  }
  StiffnessChange change;
  change.kind = ChangeKind::Support;
  change.of.where.nodes = {1, 12, 23, 34, 45};
  change.of.where.variant = "rotation";
  EXPECT_LT(worst_error(change, false), exact);
}

// A clamp that holds no moment is a hinge: the range reaches far enough down
// for a cantilever to swing about it.
TEST_F(ChangedMotions, TheSoftestSupportIsNearlyAHinge) {
  StiffnessChange change;
  change.kind = ChangeKind::Support;
  change.of.where.nodes = {1, 12, 23, 34, 45};
  change.of.where.variant = "rotation";
  const ReducedBase base =
      BaseBuilder(deck_, {}, support::plate_base(bundle_, deck_), Progress{})
          .build({}, {change});
  const StiffnessTerm& term = base.terms.front();
  const auto first_at = [&](double k) {
    const MatrixXd K = base.K + (k - term.included) * term.S;
    return std::sqrt(
        Eigen::SelfAdjointEigenSolver<MatrixXd>(K, Eigen::EigenvaluesOnly)
            .eigenvalues()(0));
  };
  // A rigid plate on springs that lower omega^2 a hundredfold.
  EXPECT_LT(first_at(term.lower), 0.11 * first_at(term.upper));
  EXPECT_GT(first_at(term.lower), 0.08 * first_at(term.upper));
}

TEST_F(ChangedMotions, SupportMoves) {
  StiffnessChange change;
  change.kind = ChangeKind::Support;
  change.of.where.nodes = {1, 12, 23, 34, 45};
  change.of.where.variant = "translation";
  EXPECT_LT(worst_error(change, false), exact);
  EXPECT_LT(worst_error(change, true), exact);
}

TEST_F(ChangedMotions, SupportTurnsAndMovesOrVaries) {
  StiffnessChange change;
  change.kind = ChangeKind::Support;
  change.of.where.nodes = {1, 12, 23, 34, 45};
  for (const char* form : {"both", "rotation-varying", "translation-varying"}) {
    change.of.where.variant = form;
    EXPECT_LT(worst_error(change, false), exact) << form;
    EXPECT_LT(worst_error(change, true), exact) << form;
  }
}

TEST_F(ChangedMotions, JointTurns) {
  StiffnessChange change;
  change.kind = ChangeKind::Joint;
  change.of.where.nodes = {5, 16, 27, 38, 49};
  EXPECT_LT(worst_error(change, false), exact);
  EXPECT_LT(worst_error(change, true), exact);
}

// Patterns of force of less than 3 % are left out, and what inertia does to
// the rest (2e-4): the base would be half as large again.
TEST_F(ChangedMotions, ElementsSoften) {
  StiffnessChange change;
  change.of.where.elements = {4, 5, 6, 14, 15, 16};
  EXPECT_LT(worst_error(change, false), 5e-4);
  EXPECT_LT(worst_error(change, true), 5e-4);
}

}  // namespace
}  // namespace tapfit::updating
