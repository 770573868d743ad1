#include "updating/reduction/solve_base.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/reduction/base_error.hpp"
#include "updating/reduction/seen_through.hpp"
#include "updating/reduction/subspace.hpp"
#include "updating/structure/assembly/deck_modes.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/factor.hpp"
#include "updating/structure/solve/symmetric_product.hpp"

#include <Eigen/Eigenvalues>

#include <utility>

namespace tapfit::updating {
namespace {

// What FRFs may be off the whole model's, and orders of responses tried for it.
constexpr double exact_enough = 1e-6;
constexpr std::size_t most_orders = 4;

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
                                    options.reach * options.high_hz);
    solved.modes = std::move(found.phi);
    solved.modes_hz = std::move(found.frequency_hz);
  } catch (const structure::SingularMatrix&) {
    structure::name_mechanism(deck);
    throw;
  }
  progress("model: residual flexibility", 0.8);
  const Eigen::MatrixXd u = motions.expand(solved.modes);
  Eigen::MatrixXd& V = solved.V;
  // Two with modes to four times the band leave a smaller basis than three with
  // modes to three times it.
  for (std::size_t orders = 2; orders <= most_orders; ++orders) {
    V = join(
        {u,
         m_orthogonal_complement(
             system.M, u, model.answers->to_points(options.points, orders))});
    if (V.cols() == 0) {
      throw InputError("no mode is in reach of the band, no point moves",
                       deck.path.string(),
                       "check units, supports and the points' directions");
    }
    const Eigen::MatrixXd projected =
        V.transpose() * structure::symmetric_product(system.K, V);
    V = (V * Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(projected)
                 .eigenvectors())
            .eval();
    solved.K = V.transpose() * structure::symmetric_product(system.K, V);
    solved.error = base_error(system,
                              *model.answers,
                              V,
                              solved.K.diagonal(),
                              options.points,
                              options.high_hz);
    if (solved.error <= exact_enough) break;
  }
  for (const UncertainPart& part : *model.plain.parts) {
    solved.K_part.push_back(seen_through(V, part.K));
    solved.M_part.push_back(seen_through(V, part.M));
  }
  return solved;
}

}  // namespace tapfit::updating
