#include "updating/properties/element_parts.hpp"

#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/deck/bar_thickness.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace tapfit::updating {
namespace {

// Entries of matrices, 12 bytes each: 120 MB. Of a fine mesh, or one of
// quadratic solids, other elements are worked out again.
constexpr Eigen::Index most_kept = 10'000'000;

using structure::Deck;
using structure::SparseMatrix;
using Triplets = std::vector<Eigen::Triplet<double>>;

// What element matrices depend on besides the element and its grids.
Deck cards_of(const Deck& deck) {
  Deck cards;
  cards.path = deck.path;
  cards.systems = deck.systems;
  cards.materials = deck.materials;
  cards.shell_properties = deck.shell_properties;
  cards.bar_properties = deck.bar_properties;
  cards.rod_properties = deck.rod_properties;
  cards.solid_properties = deck.solid_properties;
  cards.coupled_mass = deck.coupled_mass;
  cards.weight_to_mass = deck.weight_to_mass;
  return cards;
}

// What goes with the thickness itself: the rest made next to nothing, since
// properties of nothing say nothing of what is uncertain in them.
Deck of_thickness(Deck cards) {
  constexpr double nothing = 1e-9;
  for (auto& [id, p] : cards.shell_properties) {
    p.bending_ratio *= nothing;
    p.coupling = 0;
  }
  for (auto& [id, p] : cards.bar_properties) {
    const auto [first, second] = structure::bends_across(p);
    p.J *= std::max(structure::twist_by_thickness(p), nothing);
    p.I12 = 0.0;
    if (first) p.I1 *= nothing;
    if (second) p.I2 *= nothing;
  }
  for (auto& [id, p] : cards.rod_properties) p.J *= nothing;
  return cards;
}

// Whether an element has a thickness that its stiffness goes with.
bool has_thickness(const Deck& cards, const structure::Shell& e) {
  const structure::ShellProperty& p = cards.shell_properties.at(e.property);
  return p.plies.empty() && !p.panel;
}
bool has_thickness(const Deck&, const structure::Bar&) { return true; }
bool has_thickness(const Deck&, const structure::Rod&) { return true; }
bool has_thickness(const Deck&, const structure::Solid&) { return false; }

std::vector<int> grids_of(const structure::Shell& e) { return e.all_grids(); }
std::vector<int> grids_of(const structure::Solid& e) { return e.all_grids(); }
template <class Bar>
std::vector<int> grids_of(const Bar& e) {
  return {e.grids.begin(), e.grids.end()};
}

Eigen::Index entries(const ElementParts::Sum& sum) {
  Eigen::Index count = sum.K.nonZeros() + sum.M.nonZeros();
  for (const UncertainPart& part : sum.parts) {
    count += part.K.nonZeros() + part.M.nonZeros();
  }
  return count;
}

// Sums of matrices that are given over some of the degrees of freedom.
class Gathered {
 public:
  void add(const SparseMatrix& A, const std::vector<int>& dofs) {
    for (Eigen::Index c = 0; c < A.outerSize(); ++c) {
      const int column = dofs[static_cast<std::size_t>(c)];
      for (SparseMatrix::InnerIterator it(A, c); it; ++it) {
        const int row = dofs[static_cast<std::size_t>(it.row())];
        entries_.emplace_back(row, column, it.value());
      }
    }
  }

  [[nodiscard]] SparseMatrix result(Eigen::Index n) const {
    SparseMatrix A(n, n);
    A.setFromTriplets(entries_.begin(), entries_.end());
    return A;
  }

 private:
  Triplets entries_;
};

}  // namespace

ElementParts::ElementParts(
    const Deck& deck, std::vector<acquisition::UncertainProperty> uncertain)
    : deck_(&deck),
      cards_(cards_of(deck)),
      thickness_cards_(of_thickness(cards_)),
      uncertain_(std::move(uncertain)) {
  const auto take = [this](const auto& elements) {
    for (std::size_t k = 0; k < elements.size(); ++k) at_[elements[k].id] = k;
  };
  take(deck.shells);
  take(deck.bars);
  take(deck.rods);
  take(deck.solids);
}

// As if the element were the whole deck.
ElementParts::Own ElementParts::work_out(const Key& key) const {
  Own own;
  const auto [element, share] = key;
  const auto at = at_.find(element);
  if (at == at_.end()) return own;
  const bool whole = share == Share::Whole;
  Deck alone = whole ? cards_ : thickness_cards_;
  const auto take = [&](const auto& elements, auto& of_one) {
    if (at->second >= elements.size()) return;
    const auto& e = elements[at->second];
    if (e.id != key.first || !(whole || has_thickness(alone, e))) return;
    of_one.push_back(e);
    for (const int grid : grids_of(e)) {
      if (alone.has_grid(grid)) continue;
      alone.grids.push_back(deck_->grid(grid));
    }
  };
  take(deck_->shells, alone.shells);
  take(deck_->bars, alone.bars);
  take(deck_->rods, alone.rods);
  take(deck_->solids, alone.solids);
  if (alone.grids.empty()) return own;
  for (const structure::Grid& grid : alone.grids) {
    const int first = 6 * static_cast<int>(deck_->grid_index(grid.id));
    for (int c = 0; c < 6; ++c) own.dofs.push_back(first + c);
  }
  const auto all = [](int) { return true; };
  own.sum = {structure::assemble_stiffness(alone, all),
             structure::assemble_mass(alone, all),
             uncertain_parts(alone, uncertain_)};
  return own;
}

std::shared_ptr<const ElementParts::Own> ElementParts::own(
    const Key& key) const {
  {
    const std::scoped_lock lock(mutex_);
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;
  }
  auto fresh = std::make_shared<const Own>(work_out(key));
  const std::scoped_lock lock(mutex_);
  // Elements of a mesh are much alike.
  if (std::ssize(known_) * entries(fresh->sum) < most_kept) {
    known_.try_emplace(key, fresh);
  }
  return fresh;
}

ElementParts::Sum ElementParts::sum_of(const std::set<int>& elements,
                                       Share share) const {
  Gathered K;
  Gathered M;
  std::map<std::vector<int>, std::pair<Gathered, Gathered>> parts;
  for (const int id : elements) {
    const std::shared_ptr<const Own> e = own({id, share});
    K.add(e->sum.K, e->dofs);
    M.add(e->sum.M, e->dofs);
    for (const UncertainPart& part : e->sum.parts) {
      auto& [of_K, of_M] = parts[part.power];
      of_K.add(part.K, e->dofs);
      of_M.add(part.M, e->dofs);
    }
  }
  const auto n = static_cast<Eigen::Index>(6 * deck_->grids.size());
  Sum sum{K.result(n), M.result(n), {}};
  for (const auto& [power, of] : parts) {
    sum.parts.push_back({power, of.first.result(n), of.second.result(n)});
  }
  return sum;
}

ElementParts::ByThickness ElementParts::by_thickness(
    const std::set<int>& elements) const {
  Sum whole = sum_of(elements, Share::Whole);
  Sum own = sum_of(elements, Share::Thickness);
  ByThickness result;
  for (UncertainPart& part : whole.parts) {
    const auto at =
        std::ranges::find(own.parts, part.power, &UncertainPart::power);
    SparseMatrix K(part.K.rows(), part.K.cols());
    if (at != own.parts.end()) K = std::move(at->K);
    result.cube.parts.push_back(
        {part.power, part.K - K, SparseMatrix(K.rows(), K.cols())});
    result.thickness.parts.push_back(
        {part.power, std::move(K), std::move(part.M)});
  }
  result.cube.K = whole.K - own.K;
  result.cube.M = SparseMatrix(whole.M.rows(), whole.M.cols());
  result.thickness.K = std::move(own.K);
  result.thickness.M = std::move(whole.M);
  return result;
}

}  // namespace tapfit::updating
