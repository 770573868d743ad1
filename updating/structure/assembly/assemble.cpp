#include "updating/structure/assembly/assemble.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "updating/structure/assembly/autospc.hpp"
#include "updating/structure/assembly/multipoint_constraints.hpp"
#include "updating/structure/assembly/negative_cards.hpp"
#include "updating/structure/assembly/null_rotations.hpp"
#include "updating/structure/deck/constraint_axes.hpp"
#include "updating/structure/elements/element_matrices.hpp"
#include "updating/structure/readers/matrix_market.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::structure {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;
using Wanted = std::function<bool(int)>;

void add(const Deck& deck,
         const std::vector<int>& grids,
         const Eigen::MatrixXd& part,
         Triplets& triplets) {
  // What turning the element's axes leaves of a zero is no entry.
  constexpr double relative_rounding = 1e-15;
  const Eigen::VectorXd scale = part.diagonal().cwiseAbs().cwiseSqrt();
  std::vector<int> index;
  for (const int grid : grids) {
    const int first = 6 * static_cast<int>(deck.grid_index(grid));
    for (int c = 0; c < 6; ++c) index.push_back(first + c);
  }
  for (Eigen::Index j = 0; j < part.cols(); ++j) {
    for (Eigen::Index i = 0; i < part.rows(); ++i) {
      const double limit = relative_rounding * scale(i) * scale(j);
      if (!(std::abs(part(i, j)) > limit)) continue;
      triplets.emplace_back(index[static_cast<std::size_t>(i)],
                            index[static_cast<std::size_t>(j)],
                            part(i, j));
    }
  }
}

struct Entries {
  Triplets K;
  Triplets M;
};

void take(const Deck& deck, const ElementMatrices& e, Entries& entries) {
  add(deck, e.grids, e.K, entries.K);
  add(deck, e.grids, e.M, entries.M);
}

template <typename Element>
void take(const Deck& deck,
          const Element& element,
          const ElementMatrices& matrices,
          Entries& entries) {
  if (!matrices.K.allFinite() || !matrices.M.allFinite()) {
    throw InputError(
        "the element's stiffness or mass is not a finite number",
        card_place(deck, element.where, fmt::format("element {}", element.id)),
        "Look for far too large or small values in its grids, "
        "property and material.");
  }
  take(deck, matrices, entries);
}

// The k-th of the shells, bars, rods and solids, in this order.
void take_structural(const Deck& deck,
                     std::size_t k,
                     const Wanted& wanted,
                     Entries& entries) {
  const std::size_t bars = deck.shells.size();
  const std::size_t rods = bars + deck.bars.size();
  const std::size_t solids = rods + deck.rods.size();
  if (k < bars) {
    const Shell& e = deck.shells[k];
    if (wanted(e.id)) take(deck, e, shell_matrices(deck, e), entries);
  } else if (k < rods) {
    const Bar& e = deck.bars[k - bars];
    if (wanted(e.id)) take(deck, e, bar_matrices(deck, e), entries);
  } else if (k < solids) {
    const Rod& e = deck.rods[k - rods];
    if (wanted(e.id)) take(deck, e, rod_matrices(deck, e), entries);
  } else {
    const Solid& e = deck.solids[k - solids];
    if (wanted(e.id)) take(deck, e, solid_matrices(deck, e), entries);
  }
}

void append(Triplets& part, Triplets& whole) {
  whole.insert(whole.end(), part.begin(), part.end());
  part = {};
}

// Pieces on all cores, put together in the deck's order: sums do not depend on
// the number of cores.
Entries structural(const Deck& deck, const Wanted& wanted) {
  constexpr std::size_t piece_columns = 512;
  const std::size_t count = deck.shells.size() + deck.bars.size() +
                            deck.rods.size() + deck.solids.size();
  std::vector<Entries> pieces((count + piece_columns - 1) / piece_columns);
  for_each_parallel(pieces.size(), [&](std::size_t piece) {
    const std::size_t end = std::min(count, (piece + 1) * piece_columns);
    for (std::size_t k = piece * piece_columns; k < end; ++k) {
      take_structural(deck, k, wanted, pieces[piece]);
    }
  });
  Entries whole;
  for (Entries& piece : pieces) {
    append(piece.K, whole.K);
    append(piece.M, whole.M);
  }
  return whole;
}

SparseMatrix gather(const Deck& deck, const Triplets& triplets) {
  const Eigen::Index n = 6 * static_cast<Eigen::Index>(deck.grids.size());
  SparseMatrix A(n, n);
  A.setFromTriplets(triplets.begin(), triplets.end());
  // Rounding of the element products must not make the matrix unsymmetric.
  const SparseMatrix At = A.transpose();
  A = 0.5 * (A + At);
  A.makeCompressed();
  return A;
}

// Entries that the deck gives directly, along the grids' own axes.
void take(const Deck& deck,
          const std::vector<MatrixTerm>& terms,
          Triplets& triplets) {
  const auto along = [&](const MatrixTerm& term, std::size_t end) {
    const std::size_t index = deck.grid_index(term.grids[end]);
    const int component = term.components[end] - 1;
    const Eigen::Vector3d a = deck.grids[index].axes.col(component % 3);
    std::array<std::pair<int, double>, 3> parts;
    for (int j = 0; j < 3; ++j) {
      parts[static_cast<std::size_t>(j)] = {
          6 * static_cast<int>(index) + component / 3 * 3 + j, a(j)};
    }
    return parts;
  };
  for (const MatrixTerm& term : terms) {
    const bool diagonal = term.grids[0] == term.grids[1] &&
                          term.components[0] == term.components[1];
    for (const auto& [i, a] : along(term, 0)) {
      for (const auto& [j, b] : along(term, 1)) {
        const double value = term.value * a * b;
        if (value == 0.0) continue;
        triplets.emplace_back(i, j, value);
        if (!diagonal) triplets.emplace_back(j, i, value);
      }
    }
  }
}

std::vector<bool> fixed_dofs(const Deck& deck, const ConstraintAxes& axes) {
  std::vector<bool> fixed(6 * deck.grids.size(), false);
  for (const auto& [grid, components] : axes.held) {
    const std::size_t first = 6 * deck.grid_index(grid);
    for (const char digit : components) {
      fixed[first + static_cast<std::size_t>(digit - '1')] = true;
    }
  }
  return fixed;
}

}  // namespace

System assemble(const Deck& deck) {
  check_references(deck);
  Entries entries = structural(deck, [](int) { return true; });
  for (const PointMass& e : deck.masses) {
    take(deck, mass_matrices(e), entries);
  }
  for (const ScalarElement& e : deck.scalars) {
    take(deck, scalar_matrices(e), entries);
  }
  for (const Bush& e : deck.bushes) take(deck, bush_matrices(e), entries);
  take(deck, deck.stiffness_terms, entries.K);
  take(deck, deck.mass_terms, entries.M);
  System system;
  system.K = gather(deck, entries.K);
  system.M = gather(deck, entries.M) * deck.weight_to_mass;
  if (deck.given) {
    system.K += deck.given->K;
    system.M += deck.given->M;
  }
  const ConstraintAxes axes = constraint_axes(deck);
  system.T = multipoint_constraints(deck, axes);
  system.fixed = fixed_dofs(deck, axes);
  system.inactive = without_stiffness(deck, system);
  refuse_negative_cards(deck, system);
  for (const int dof : null_rotations(deck, system)) {
    system.inactive[static_cast<std::size_t>(dof)] = true;
  }
  return system;
}

SparseMatrix assemble_stiffness(const Deck& deck, const Wanted& wanted) {
  return gather(deck, structural(deck, wanted).K);
}

SparseMatrix assemble_mass(const Deck& deck, const Wanted& wanted) {
  return gather(deck, structural(deck, wanted).M) * deck.weight_to_mass;
}

std::vector<int> elements_of_material(const Deck& deck, int id) {
  std::vector<int> elements;
  for (const Shell& e : deck.shells) {
    const ShellProperty& p = deck.shell_properties.at(e.property);
    const bool laid = std::ranges::any_of(
        p.plies, [id](const Ply& ply) { return ply.material == id; });
    if (p.membrane == id || p.bending == id || p.coupling == id || laid) {
      elements.push_back(e.id);
    }
  }
  for (const Bar& e : deck.bars) {
    if (deck.bar_properties.at(e.property).material == id) {
      elements.push_back(e.id);
    }
  }
  for (const Rod& e : deck.rods) {
    if (deck.rod_properties.at(e.property).material == id) {
      elements.push_back(e.id);
    }
  }
  for (const Solid& e : deck.solids) {
    if (deck.solid_properties.at(e.property).material == id) {
      elements.push_back(e.id);
    }
  }
  return elements;
}

double total_mass(const Deck& deck, const System& system) {
  return total_mass(deck, system.M);
}

double total_mass(const Deck& deck, const SparseMatrix& M) {
  const Eigen::Index n = M.rows();
  if (n != 6 * static_cast<Eigen::Index>(deck.grids.size())) {
    throw InputError("the matrices do not belong to the model",
                     deck.path.filename().string(),
                     "Assemble this model again.");
  }
  // A CMASS2 may act along one axis only, so the largest of the three counts.
  double largest = 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Eigen::VectorXd rigid = Eigen::VectorXd::Zero(n);
    for (Eigen::Index i = axis; i < n; i += 6) {
      if (!deck.grids[static_cast<std::size_t>(i / 6)].scalar) rigid(i) = 1.0;
    }
    largest = std::max(largest, rigid.dot(M * rigid));
  }
  return largest;
}

}  // namespace tapfit::structure
