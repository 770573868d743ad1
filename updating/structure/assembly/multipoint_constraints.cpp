#include "updating/structure/assembly/multipoint_constraints.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <map>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace tapfit::structure {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Row = std::map<int, double>;  // index in q -> coefficient

// Translations and rotations turned alike.
Matrix6 twice(const Eigen::Matrix3d& axes) {
  Matrix6 both = Matrix6::Zero();
  both.topLeftCorner<3, 3>() = axes;
  both.bottomRightCorner<3, 3>() = axes;
  return both;
}

// Motion of a point at r from the one that leads.
Matrix6 arm(const Eigen::Vector3d& r) {
  Matrix6 X = Matrix6::Identity();
  X.topRightCorner<3, 3>() << 0.0, r.z(), -r.y(), -r.z(), 0.0, r.x(), r.y(),
      -r.x(), 0.0;
  return X;
}

// What a component follows: a rigid element, or a relation.
struct Leader {
  const RigidElement* rigid = nullptr;
  const Relation* relation = nullptr;

  [[nodiscard]] const std::string& where() const {
    return rigid != nullptr ? rigid->where : relation->where;
  }
  [[nodiscard]] std::string name() const {
    return rigid != nullptr ? fmt::format("rigid element {}", rigid->id)
                            : std::string("MPC");
  }
};

// Follows every component back to those that may be chosen.
class Followed {
 public:
  Followed(const Deck& deck, const ConstraintAxes& axes)
      : deck_(&deck), axes_(&axes) {
    for (const RigidElement& e : deck.rigids) {
      // What follows a held grid is held.
      if (axes.held_wholly(e.independent)) continue;
      for (const Dependent& d : e.dependents) lead(e, d);
    }
    for (const Relation& e : deck.relations) lead(e);
  }

  [[nodiscard]] bool none() const { return follows_.empty(); }

  [[nodiscard]] bool plain(const Grid& grid, std::size_t index) const {
    return !axes_->turned.contains(grid.id) && !follows_.contains(index);
  }

  // Columns of the grid's q in basic axes.
  [[nodiscard]] Matrix6 axes(const Grid& grid) const {
    if (!axes_->turned.contains(grid.id)) return Matrix6::Identity();
    return twice(grid.axes);
  }

  const Row& row(int dof) {
    const auto [place, fresh] = rows_.try_emplace(dof);
    const auto leader = leader_.find(dof);
    if (!fresh) {
      // A row is empty while it is worked out, or where it follows nothing.
      if (place->second.empty() && leader != leader_.end() &&
          !done_.contains(dof)) {
        fail_round(leader->second, dof);
      }
      return place->second;
    }
    Row& row = place->second;
    if (leader == leader_.end()) {
      row[dof] = 1.0;
      return row;
    }
    Row sum = leader->second.rigid != nullptr
                  ? led(*leader->second.rigid, dof)
                  : summed(*leader->second.relation);
    // A place in an unordered_map stays where it is while others are added.
    row = std::move(sum);
    done_.insert(dof);
    return row;
  }

 private:
  [[nodiscard]] Row led(const RigidElement& e, int dof) {
    const Grid& own = deck_->grids[static_cast<std::size_t>(dof / 6)];
    const std::size_t first = deck_->grid_index(e.independent);
    const Grid& hub = deck_->grids[first];
    const Matrix6 from_hub =
        axes(own).transpose() * arm(own.position - hub.position) * axes(hub);
    Row sum;
    for (int j = 0; j < 6; ++j) {
      const double part = from_hub(dof % 6, j);
      if (part == 0.0) continue;
      for (const auto& [q, a] : row(6 * static_cast<int>(first) + j)) {
        sum[q] += part * a;
      }
    }
    return sum;
  }

  // Terms count along their grids' own axes, whether solved in them or not.
  [[nodiscard]] Row summed(const Relation& e) {
    Row sum;
    for (const RelationTerm& term : e.terms) {
      const std::size_t index = deck_->grid_index(term.grid);
      const Grid& grid = deck_->grids[index];
      const int kind = term.component > 3 ? 3 : 0;
      const int axis = (term.component - 1) % 3;
      const int first = 6 * static_cast<int>(index) + kind;
      for (int j = 0; j < 3; ++j) {
        const double along = axes_->turned.contains(term.grid)
                                 ? (j == axis ? 1.0 : 0.0)
                                 : grid.axes(j, axis);
        if (along == 0.0) continue;
        for (const auto& [q, a] : row(first + j)) {
          sum[q] += term.factor * along * a;
        }
      }
    }
    return sum;
  }

  void lead(const Relation& e) {
    const std::size_t index = deck_->grid_index(e.grid);
    follows_.insert(index);
    take(6 * static_cast<int>(index) + e.component - 1,
         Leader{nullptr, &e},
         e.grid,
         static_cast<char>('0' + e.component));
  }

  // Makes a component follow.
  void take(int dof, const Leader& leader, int grid, char digit) {
    refuse_held(leader, grid, digit);
    const auto [place, fresh] = leader_.try_emplace(dof, leader);
    if (fresh) return;
    fail(leader,
         fmt::format("component {} of grid {} follows {} already",
                     digit,
                     grid,
                     card_place(*deck_, place->second.where(), "another")),
         "Leave it to one of the two.");
  }

  void lead(const RigidElement& e, const Dependent& d) {
    const std::size_t index = deck_->grid_index(d.grid);
    follows_.insert(index);
    std::string components = d.components;
    if (!axes_->turned.contains(d.grid)) {
      components = *along_basic(components, deck_->grids[index].axes);
    }
    for (const char digit : components) {
      take(6 * static_cast<int>(index) + digit - '1',
           Leader{&e, nullptr},
           d.grid,
           digit);
    }
  }

  void refuse_held(const Leader& e, int grid, char digit) const {
    const auto held = axes_->held.find(grid);
    if (held == axes_->held.end() ||
        held->second.find(digit) == std::string::npos) {
      return;
    }
    if (e.rigid == nullptr) {
      fail(e,
           fmt::format("component {} of grid {} depends on others and is held "
                       "by an SPC (or GRID field 8) besides",
                       digit,
                       grid),
           "Take it out of the one or the other.");
    }
    fail(e,
         fmt::format("component {} of grid {} follows grid {} and is held by "
                     "an SPC (or GRID field 8) besides",
                     digit,
                     grid,
                     e.rigid->independent),
         fmt::format("Take it out of the one or the other, or hold grid {}.",
                     e.rigid->independent));
  }

  [[noreturn]] void fail_round(const Leader& e, int dof) const {
    fail(e,
         fmt::format("grid {} follows itself round a ring of rigid elements",
                     deck_->grids[static_cast<std::size_t>(dof / 6)].id),
         "Let one grid lead all others of the ring.");
  }

  [[noreturn]] void fail(const Leader& e,
                         const std::string& what,
                         const std::string& remedy) const {
    throw InputError(what, card_place(*deck_, e.where(), e.name()), remedy);
  }

  const Deck* deck_;
  const ConstraintAxes* axes_;
  std::unordered_set<std::size_t> follows_;  // grid index
  std::unordered_map<int, Leader> leader_;   // index in q
  std::unordered_set<int> done_;             // of those that follow
  std::unordered_map<int, Row> rows_;
};

using Triplets = std::vector<Eigen::Triplet<double>>;

// One column of a grid's axes, times what that component of q follows.
void add_component(const Eigen::Matrix<double, 6, 1>& direction,
                   const Row& row,
                   int first,
                   Triplets& entries) {
  for (const auto& [q, a] : row) {
    for (int i = 0; i < 6; ++i) {
      const double part = direction(i) * a;
      if (part != 0.0) entries.emplace_back(first + i, q, part);
    }
  }
}

}  // namespace

Eigen::SparseMatrix<double> multipoint_constraints(const Deck& deck,
                                                   const ConstraintAxes& axes) {
  Followed followed(deck, axes);
  if (followed.none() && axes.turned.empty()) return {};
  Triplets entries;
  for (std::size_t g = 0; g < deck.grids.size(); ++g) {
    const Grid& grid = deck.grids[g];
    const int first = 6 * static_cast<int>(g);
    if (followed.plain(grid, g)) {
      for (int c = 0; c < 6; ++c) entries.emplace_back(first + c, first + c, 1);
      continue;
    }
    const Matrix6 R = followed.axes(grid);
    for (int c = 0; c < 6; ++c) {
      add_component(R.col(c), followed.row(first + c), first, entries);
    }
  }
  const Eigen::Index n = 6 * static_cast<Eigen::Index>(deck.grids.size());
  Eigen::SparseMatrix<double> T(n, n);
  T.setFromTriplets(entries.begin(), entries.end());
  return T;
}

}  // namespace tapfit::structure
