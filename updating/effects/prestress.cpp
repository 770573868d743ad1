#include "updating/effects/prestress.hpp"

#include "updating/effects/effects.hpp"
#include "updating/effects/preload.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/edit/direct_matrix.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace tapfit::effects {
namespace {

class Prestress final : public Effect {
 public:
  // Besides none of the variants: a tension along the member.
  Prestress()
      : Effect({.name = "prestress",
                .words = "axial force in a member",
                .sits = Sits::OnElements,
                .changes_stiffness = updating::ChangeKind::Preload,
                .variants = {"compression", "across", "across-compression"}}) {}

  // Each whole member, pulled, and where both its ends are held, pushed; a
  // sheet held at both ends across as well.
  std::vector<Location> places(const TestContext& context) const override {
    std::vector<Location> result;
    if (context.deck == nullptr) return result;
    for (const std::vector<int>& elements :
         updating::whole_members(*context.deck)) {
      for (const bool across : {false, true}) {
        const auto member =
            updating::axial_member(*context.deck, elements, across);
        if (!member || !member->can_be_pulled()) continue;
        const bool by_wire = member->pulled() != nullptr;
        // A plate that hangs on one side only is pulled the long way.
        if (by_wire && across) continue;
        result.emplace_back().elements = elements;
        if (across) result.back().variant = "across";
        if (by_wire) continue;
        result.emplace_back().elements = elements;
        result.back().variant = across ? "across-compression" : "compression";
      }
    }
    return result;
  }

  std::vector<ParameterSpec> parameters(
      const Location& where, const TestContext& context) const override {
    // The scale at which the force is as stiff as the structure's inertia is
    // heavy at the band's ends; the base narrows it to what shows.
    const auto member = member_at(*context.deck, where.elements, where);
    const double length = member ? member->length : 1.0;
    const double m = context.mass_kg;
    const double lower = 1e-4 * m * context.low() * context.low();
    const double upper = 10.0 * m * context.high() * context.high();
    std::vector<ParameterSpec> specs = {
        spread("force_n", lower * length, upper * length)};
    if (is_compression(where)) specs.front().sign = -1.0;
    if (member && member->pulled() != nullptr) {
      specs.push_back(spread("side_stiffness_n_per_m", lower, upper));
    }
    return specs;
  }

  // DMIG K2GG: exact on the deck's own mesh.
  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext& context,
      const std::vector<double>& p) const override {
    const structure::Deck& deck = *context.deck;
    // Compressions are told below zero; the matrix has their sign.
    const double force = std::abs(p.at(0));
    std::vector<std::string> cards = {
        fmt::format("$ {} of {:.4g} N in elements {}, as the stiffness that it "
                    "gives at rest (K2GG)",
                    is_compression(where) ? "Compression" : "Tension",
                    force,
                    fmt::join(where.elements, ", "))};
    if (!deck.stiffness_terms.empty()) {
      cards.emplace_back(
          "$ not written: the deck has a DMIG for K2GG already; add this one "
          "by a DMIG of its own");
      return cards;
    }
    const Preload unit =
        preload(deck, structure::assemble(deck), where.elements, where);
    structure::SparseMatrix K = force * unit.along;
    if (unit.side.size() > 0 && p.size() > 1) K += p[1] * unit.side;
    const std::vector<std::string> matrix =
        structure::direct_stiffness_cards(deck, "K2GG", K);
    if (matrix.empty()) {
      cards.emplace_back(
          "$ not written: grids there have displacement axes (CD) of their "
          "own");
    }
    cards.insert(cards.end(), matrix.begin(), matrix.end());
    return cards;
  }
};

}  // namespace

bool can_carry(const structure::Deck& deck, const Location& where) {
  const auto member = member_at(deck, where.elements, where);
  if (!member || !member->can_be_pulled()) return false;
  // A wire does not push.
  return !is_compression(where) || member->pulled() == nullptr;
}

const Effect& prestress() {
  static const Prestress effect;
  return effect;
}

}  // namespace tapfit::effects
