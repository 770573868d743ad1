#include "updating/structure/assembly/autospc.hpp"

#include "updating/structure/checks/attached_grids.hpp"
#include "updating/structure/deck/card_places.hpp"
#include "updating/structure/elements/element_matrices.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double rounding_share = 1e-12;

// The diagonal of T' A T.
VectorXd own_diagonal(const SparseMatrix& A, const SparseMatrix& T) {
  if (T.size() == 0) return A.diagonal();
  const SparseMatrix AT = A * T;
  VectorXd own(T.cols());
  for (Index j = 0; j < own.size(); ++j) own(j) = T.col(j).dot(AT.col(j));
  return own;
}

// Of the three components of the same kind, the largest; per entry of q.
VectorXd largest_beside(const VectorXd& diagonal) {
  VectorXd largest(diagonal.size());
  for (Index first = 0; first < diagonal.size(); first += 3) {
    largest.segment<3>(first).setConstant(
        diagonal.segment<3>(first).cwiseAbs().maxCoeff());
  }
  return largest;
}

// What springs alone put on the diagonal, without regard to sign.
class SpringShares {
 public:
  SpringShares(const Deck& deck, const SparseMatrix& T)
      : deck_(&deck),
        rows_(T.transpose()),
        shares_(VectorXd::Zero(6 * static_cast<Index>(deck.grids.size()))) {}

  void add(const std::array<int, 2>& grids,
           const VectorXd& direction,
           double stiffness) {
    if (stiffness == 0.0) return;
    std::map<int, double> along;  // q
    Index at = 0;
    for (const int grid : grids) {
      if (grid == 0) continue;
      const int first = 6 * static_cast<int>(deck_->grid_index(grid));
      for (int c = 0; c < 6; ++c, ++at) follow(first + c, direction(at), along);
    }
    std::array<double, 2> largest{};
    for (const auto& [q, part] : along) {
      double& most = largest[q % 6 < 3 ? 0 : 1];
      most = std::max(most, part * part);
    }
    for (const auto& [q, part] : along) {
      if (part * part <= rounding_share * largest[q % 6 < 3 ? 0 : 1]) continue;
      shares_(q) += std::abs(stiffness) * part * part;
    }
  }

  [[nodiscard]] const VectorXd& get() const { return shares_; }

 private:
  void follow(int dof, double part, std::map<int, double>& along) const {
    if (part == 0.0) return;
    if (rows_.size() == 0) {
      along[dof] += part;
      return;
    }
    for (SparseMatrix::InnerIterator it(rows_, dof); it; ++it) {
      along[static_cast<int>(it.row())] += part * it.value();
    }
  }

  const Deck* deck_;
  SparseMatrix rows_;  // T'
  VectorXd shares_;
};

VectorXd spring_shares(const Deck& deck, const SparseMatrix& T) {
  SpringShares shares(deck, T);
  for (const ScalarElement& e : deck.scalars) {
    shares.add(e.grids, scalar_direction(e), e.stiffness);
  }
  for (const Bush& e : deck.bushes) {
    const Eigen::MatrixXd strains = bush_strains(e);
    for (Index k = 0; k < strains.rows(); ++k) {
      shares.add(e.grids,
                 strains.row(k).transpose(),
                 e.stiffness[static_cast<std::size_t>(k)]);
    }
  }
  return shares.get();
}

struct Lost {
  std::array<std::size_t, 6> grids{};  // per component
  std::size_t count = 0;
  Index first = -1;
};

Lost lost_motions(const Deck& deck, const System& system) {
  const VectorXd mass = own_diagonal(system.M, system.T);
  const VectorXd beside = largest_beside(mass);
  const std::vector<bool> without = without_stiffness(deck, system);
  const std::set<int> attached = attached_grids(deck);
  Lost lost;
  for (Index i = 0; i < mass.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!system.inactive[at] || system.fixed[at] || !without[at]) continue;
    if (!(mass(i) > rounding_share * beside(i))) continue;
    if (!deck.given && !attached.contains(deck.grids[at / 6].id)) continue;
    if (lost.count++ == 0) lost.first = i;
    ++lost.grids[at % 6];
  }
  return lost;
}

void warn_lost(const Deck& deck,
               const System& system,
               std::vector<std::string>& warnings) {
  const Lost lost = lost_motions(deck, system);
  if (lost.count == 0) return;
  std::string parts;
  for (std::size_t c = 0; c < 6; ++c) {
    if (lost.grids[c] == 0) continue;
    parts += fmt::format("{}component {} of {} grid{}",
                         parts.empty() ? "" : ", ",
                         c + 1,
                         lost.grids[c],
                         lost.grids[c] == 1 ? "" : "s");
  }
  const auto at = static_cast<std::size_t>(lost.first);
  warnings.push_back(fmt::format(
      "{} degree{} of freedom with mass but without stiffness {} held ({}; "
      "first {}, component {}): their motions are missing; give the property "
      "the stiffness, or hold them with an SPC1 if that is meant",
      lost.count,
      lost.count == 1 ? "" : "s",
      lost.count == 1 ? "is" : "are",
      parts,
      grid_place(deck, deck.grids[at / 6].id),
      at % 6 + 1));
}

// Entries that have stiffness and are held all the same: null_rotations().
void warn_idle_turns(const Deck& deck,
                     const System& system,
                     std::vector<std::string>& warnings) {
  const std::vector<bool> without = without_stiffness(deck, system);
  std::size_t count = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < without.size(); ++i) {
    if (!system.inactive[i] || system.fixed[i] || without[i]) continue;
    if (count++ == 0) first = i;
  }
  if (count == 0) return;
  warnings.push_back(fmt::format(
      "{} turn{} without inertia that nothing resists {} held (first {}, "
      "component {}), like the twist of a straight line of CBARs; the other "
      "modes do not change. For twisting modes use CBEAM or give CONM2s "
      "inertia, else hold the component with an SPC1",
      count,
      count == 1 ? "" : "s",
      count == 1 ? "is" : "are",
      grid_place(deck, deck.grids[first / 6].id),
      first % 6 + 1));
}

}  // namespace

std::vector<bool> without_stiffness(const Deck& deck, const System& system) {
  const VectorXd own = own_diagonal(system.K, system.T);
  const VectorXd beside = largest_beside(own);
  const VectorXd springs = spring_shares(deck, system.T);
  std::vector<bool> without(static_cast<std::size_t>(own.size()), false);
  for (Index i = 0; i < own.size(); ++i) {
    const double stiffness = std::abs(own(i));
    const bool sprung =
        springs(i) > 0.0 && stiffness > rounding_share * springs(i);
    without[static_cast<std::size_t>(i)] =
        !(stiffness > rounding_share * beside(i)) && !sprung;
  }
  return without;
}

std::vector<std::string> autospc_warnings(const Deck& deck,
                                          const System& system) {
  std::vector<std::string> warnings;
  warn_lost(deck, system, warnings);
  warn_idle_turns(deck, system, warnings);
  return warnings;
}

}  // namespace tapfit::structure
