#include "updating/structure/assembly/deck_modes.hpp"

#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/assembly/autospc.hpp"
#include "updating/structure/cards/error_notes.hpp"
#include "updating/structure/checks/unit_checks.hpp"
#include "updating/structure/deck/constraint_axes.hpp"
#include "updating/structure/solve/factor.hpp"
#include "updating/structure/solve/free_motions.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const char* const join =
    "Join the parts (equal grids, bars, springs) or hold them with an SPC1.";

std::string place_of(const Deck& deck, Index dof) {
  return fmt::format("GRID {}, component {}",
                     deck.grids[static_cast<std::size_t>(dof / 6)].id,
                     dof % 6 + 1);
}

// Six motions of the whole, 6 n_grids x 6, about the middle and with rotations
// scaled to move the outermost grid by one; in q, along turned grids' own axes.
MatrixXd rigid_motions(const Deck& deck, const std::set<int>& turned) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Grid& grid : deck.grids) middle += grid.position;
  middle /= static_cast<double>(deck.grids.size());
  double size = 0.0;
  for (const Grid& grid : deck.grids) {
    size = std::max(size, (grid.position - middle).norm());
  }
  if (size == 0.0) size = 1.0;
  MatrixXd R(6 * static_cast<Index>(deck.grids.size()), 6);
  for (std::size_t i = 0; i < deck.grids.size(); ++i) {
    const Eigen::Vector3d p = (deck.grids[i].position - middle) / size;
    auto part = R.middleRows<6>(6 * static_cast<Index>(i));
    if (deck.grids[i].scalar) {
      part.setZero();
      continue;
    }
    part.setIdentity();
    part.bottomRightCorner<3, 3>() /= size;
    part.topRightCorner<3, 3>() << 0.0, p.z(), -p.y(), -p.z(), 0.0, p.x(),
        p.y(), -p.x(), 0.0;
    if (!turned.contains(deck.grids[i].id)) continue;
    const Eigen::Matrix3d own = deck.grids[i].axes.transpose();
    part.topRows<3>() = (own * part.topRows<3>()).eval();
    part.bottomRows<3>() = (own * part.bottomRows<3>()).eval();
  }
  return R;
}

// Energies below this share of their parts are rounding.
constexpr double rounding = 1e-12;

// Held entries of grids that nothing is joined to.
std::vector<int> held_alone(const System& system) {
  const VectorXd stiffness = system.K.diagonal();
  std::vector<int> held;
  for (std::size_t i = 0; i < system.fixed.size(); ++i) {
    const auto first = static_cast<Index>(i / 6 * 6);
    const bool joined = (stiffness.segment<6>(first).array() != 0.0).any();
    if (system.fixed[i] && !joined) held.push_back(static_cast<int>(i));
  }
  return held;
}

// Those of the columns that leave these rows at rest.
MatrixXd at_rest(const MatrixXd& R, const std::vector<int>& rows) {
  if (rows.empty()) return R;
  Eigen::FullPivLU<MatrixXd> lu(R(rows, Eigen::all));
  lu.setThreshold(1e-9);
  if (lu.dimensionOfKernel() == 0) return R.leftCols(0);
  return R * lu.kernel();
}

// Those that stretch nothing while all that is held stays where it is, on the
// free entries: what is held but not tied to what moves does not stop it,
// unless nothing at all is joined there. Such a support was meant to hold.
MatrixXd allowed_motions(const Deck& deck,
                         const System& system,
                         const FreeMotions& motions,
                         const SparseMatrix& K) {
  MatrixXd R = at_rest(rigid_motions(deck, constraint_axes(deck).turned),
                       held_alone(system))(motions.free, Eigen::all);
  const VectorXd stiffness = K.diagonal();
  for (Index c = 0; c < R.cols(); ++c) {
    const double parts = R.col(c).cwiseAbs2().dot(stiffness);
    R.col(c) /= parts > 0.0 ? std::sqrt(parts) : 1.0;
  }
  if (R.cols() == 0) return R;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(R.transpose() *
                                                       MatrixXd(K * R));
  const Index count = (solver.eigenvalues().array() <= rounding).count();
  return R * solver.eigenvectors().leftCols(count);
}

// A mode's: rounding leaves 1e-16 of its parts, give or take a few. A line of n
// bars that is held at one end has a mode of 12.4 / 24 n^4 of them.
constexpr double rounding_of_mode = 1e-14;

// Lines of more elements than this have modes below that share.
constexpr std::size_t long_line = 2600;

// Modes whose energy is rounding of what its parts cancel from.
MatrixXd motions_without_stiffness(const SparseMatrix& K, const MatrixXd& phi) {
  std::vector<Index> loose;
  for (Index i = 0; i < phi.cols(); ++i) {
    const VectorXd u = phi.col(i);
    const double parts = u.cwiseAbs2().dot(K.diagonal());
    if (u.dot(K * u) <= rounding_of_mode * parts) loose.push_back(i);
  }
  return phi(Eigen::all, loose);
}

// The degree of freedom of `free` that a mechanism moves most, translations
// before rotations; how many independent ones there are.
std::vector<std::string> describe(const Deck& deck,
                                  const SparseMatrix& M,
                                  const MatrixXd& loose,
                                  const MatrixXd& rigid,
                                  const std::vector<int>& free) {
  MatrixXd rest = loose;
  if (rigid.cols() > 0) {
    const MatrixXd gram = rigid.transpose() * (M * rigid);
    const MatrixXd onto = rigid.transpose() * (M * loose);
    rest -= rigid * gram.completeOrthogonalDecomposition().solve(onto);
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(rest.transpose() *
                                                       (M * rest));
  // Unit modes keep all of their length, or none.
  const Index count = (solver.eigenvalues().array() > 0.5).count();
  if (count == 0) return {};
  // How far each degree of freedom goes in any of them.
  const VectorXd shape =
      (rest * solver.eigenvectors().rightCols(count)).rowwise().norm();
  Index largest = -1;
  for (const bool translation : {true, false}) {
    for (Index i = 0; i < shape.size(); ++i) {
      if ((free[static_cast<std::size_t>(i)] % 6 < 3) != translation) continue;
      if (shape(i) <= 1e-6 * shape.maxCoeff()) continue;
      // Of equal ones the first of the deck, whatever rounding says.
      if (largest < 0 || shape(i) > (1.0 + 1e-6) * shape(largest)) {
        largest = i;
      }
    }
    if (largest >= 0) break;
  }
  return {fmt::format(
      "{} motion{} without stiffness beyond those of a rigid body, the largest "
      "at {}: a mechanism{}. {}",
      count,
      count == 1 ? "" : "s",
      place_of(deck, free[static_cast<std::size_t>(largest)]),
      deck.grids.size() > long_line
          ? ", or a line of so many elements that rounding hides what bends it "
            "(its frequencies are not to be trusted then; use longer elements)"
          : "",
      join)};
}

// @param M over the free degrees of freedom
void refuse_without_modes(const Deck& deck, const SparseMatrix& M) {
  if (M.rows() > 0 && M.norm() > 0.0) return;
  try {
    if (M.rows() > 0) {
      throw no_density(
          deck, "nothing that can move has mass: the model has no modes");
    }
    throw InputError(
        "nothing can move: every component is held, or without stiffness",
        deck.path.filename().string(),
        "Check the SPCs, and that elements join the grids.");
  } catch (const InputError& error) {
    throw with_notes(error, deck.warnings);
  }
}

}  // namespace

DeckModes deck_modes(const Deck& deck,
                     const System& system,
                     Index count,
                     const std::stop_token& stop) {
  const FreeMotions motions = free_motions(system);
  const std::vector<int>& free = motions.free;
  const SparseMatrix M = motions.reduce(system.M);
  refuse_without_modes(deck, M);
  DeckModes result;
  try {
    result.modes = eigenmodes(motions.reduce(system.K), M, count, stop);
  } catch (const SingularMatrix& singular) {
    const int dof = free[static_cast<std::size_t>(singular.row())];
    throw with_notes(
        InputError(
            fmt::format("{} moves without stiffness or mass: a mechanism",
                        place_of(deck, dof)),
            deck.path.filename().string(),
            join),
        deck.warnings);
  }
  result.warnings = mechanism_warnings(deck, system, result.modes.phi);
  return result;
}

std::vector<std::string> mechanism_warnings(const Deck& deck,
                                            const System& system,
                                            const MatrixXd& phi) {
  std::vector<std::string> warnings = autospc_warnings(deck, system);
  const FreeMotions motions = free_motions(system);
  const SparseMatrix K = motions.reduce(system.K);
  const MatrixXd loose = motions_without_stiffness(K, phi);
  if (loose.cols() == 0) return warnings;
  for (std::string& text : describe(deck,
                                    motions.reduce(system.M),
                                    loose,
                                    allowed_motions(deck, system, motions, K),
                                    motions.free)) {
    warnings.push_back(std::move(text));
  }
  return warnings;
}

void name_mechanism(const Deck& deck) {
  static_cast<void>(deck_modes(deck, assemble(deck), 1));
}

}  // namespace tapfit::structure
