#include "updating/reduction/solve_base.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/reduction/base_error.hpp"
#include "updating/reduction/subspace.hpp"
#include "updating/structure/assembly/deck_modes.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/factor.hpp"
#include "updating/structure/solve/seen_through.hpp"
#include "updating/structure/solve/symmetric_product.hpp"

#include <Eigen/Eigenvalues>

#include <stop_token>
#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

// What FRFs may be off the whole model's, and orders of responses tried for it.
constexpr double exact_enough = 1e-6;
constexpr std::size_t most_orders = 4;

// Of a mode's mass, in what a form adds to its shape: less is rounding, or
// twist that moves nothing else.
constexpr double worth_holding = 1e-8;

// What modes with the mass of all forms have beside those of the deck u: bars
// on lines alone have no modes in which they twist.
Eigen::MatrixXd shapes_of_forms(const AssembledBase& model,
                                const Eigen::MatrixXd& u,
                                const std::stop_token& stop) {
  if (model.forms.empty()) return {};
  structure::SparseMatrix M = model.system.M;
  for (const MassForm& form : model.forms) {
    M += form.M;
  }
  Eigen::MatrixXd beside = model.motions.expand(
      structure::eigenmodes_up_to(model.motions.reduce(model.system.K),
                                  model.motions.reduce(M),
                                  model.options.reach * model.options.high_hz,
                                  stop)
          .phi);
  const Eigen::MatrixXd inside =
      u.transpose() * structure::symmetric_product(model.system.M, beside);
  beside -= u * inside;
  const Eigen::VectorXd mass =
      beside.cwiseProduct(structure::symmetric_product(model.system.M, beside))
          .colwise()
          .sum();
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < mass.size(); ++k) {
    if (mass(k) > worth_holding) kept.push_back(k);
  }
  return beside(Eigen::all, kept);
}

}  // namespace

SolvedBase solve_base(const AssembledBase& model,
                      const structure::Deck& deck,
                      const Progress& progress) {
  const structure::System& system = model.system;
  const structure::FreeMotions& motions = model.motions;
  const BaseOptions& options = model.options;
  progress("model: eigenmodes", 0.2);
  SolvedBase solved;
  try {
    structure::Eigenmodes found =
        structure::eigenmodes_up_to(motions.reduce(system.K),
                                    motions.reduce(system.M),
                                    options.reach * options.high_hz,
                                    progress.stop);
    solved.modes = std::move(found.phi);
    solved.modes_hz = std::move(found.frequency_hz);
  } catch (const structure::SingularMatrix&) {
    structure::name_mechanism(deck);
    throw;
  }
  progress("model: residual flexibility", 0.8);
  const Eigen::MatrixXd u = motions.expand(solved.modes);
  const Eigen::MatrixXd formed = shapes_of_forms(model, u, progress.stop);
  Eigen::MatrixXd& V = solved.V;
  // Two with modes to four times the band leave a smaller basis than three with
  // modes to three times it.
  for (std::size_t orders = 2; orders <= most_orders; ++orders) {
    V = join({u,
              m_orthogonal_complement(
                  system.M,
                  u,
                  join({model.answers->to_points(options.points, orders),
                        formed}))});
    if (V.cols() == 0) {
      throw InputError("no mode is in reach of the band, no point moves",
                       deck.path.string(),
                       "check units, supports and the points' directions");
    }
    V = (V * Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
                 structure::seen_through(V, system.K))
                 .eigenvectors())
            .eval();
    solved.K = structure::seen_through(V, system.K);
    solved.error = base_error(system,
                              *model.answers,
                              V,
                              solved.K.diagonal(),
                              options.points,
                              options.high_hz);
    if (solved.error <= exact_enough) break;
  }
  for (const UncertainPart& part : model.parts) {
    solved.K_part.push_back(structure::seen_through(V, part.K));
    solved.M_part.push_back(structure::seen_through(V, part.M));
  }
  return solved;
}

}  // namespace tapfit::updating
