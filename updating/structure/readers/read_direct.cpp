// DMIG: entries of stiffness and mass given by degrees of freedom.
#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {
namespace {

constexpr int symmetric_form = 6;

// NAME 0 IFO TIN TOUT POLAR _ NCOL
void read_head(DeckBuilder& builder,
               const CardReader& card,
               const std::string& name) {
  DirectMatrix matrix;
  matrix.where = card.where();
  matrix.form = card.integer(3, "IFO");
  const int kind = card.integer_or(4, 1, "TIN");
  if (kind > 2) {
    card.fail(fmt::format("DMIG {} is complex (TIN = {})", name, kind),
              "Give it as a real matrix; damping is identified, not read.");
  }
  if (!builder.direct_matrices.emplace(name, matrix).second) {
    card.fail(fmt::format("DMIG {} is defined already", name),
              "Keep one of the two.");
  }
}

std::pair<int, int> dof_at(const DeckBuilder& builder,
                           const CardReader& card,
                           std::size_t field) {
  const int grid = existing_grid(builder, card, field);
  const int component = card.integer_or(field + 1, 0, "component");
  const bool scalar = builder.grid(card, grid).scalar;
  if (scalar && component <= 1) return {grid, 1};
  if (scalar || component < 1 || component > 6) {
    card.fail(
        fmt::format("component {} of grid {} is not there", component, grid),
        "Give one of 1 to 6, of a scalar point 0.");
  }
  return {grid, component};
}

// NAME GJ CJ _ G1 C1 A1 B1 / G2 C2 A2 B2 ...
void read_column(DeckBuilder& builder, const CardReader& card) {
  const std::string name = upper(card.text(1));
  if (card.text(2) == "0") {
    read_head(builder, card, name);
    return;
  }
  const auto found = builder.direct_matrices.find(name);
  if (found == builder.direct_matrices.end()) {
    card.fail(fmt::format("DMIG {} has no head", name),
              "Put the entry with a zero in field 3 in front.");
  }
  const auto [grid, component] = dof_at(builder, card, 2);
  for (std::size_t at = 5; at < card.size(); at += 4) {
    if (card.blank(at)) continue;
    const auto [row_grid, row_component] = dof_at(builder, card, at);
    found->second.terms.push_back(
        {{row_grid, grid}, {row_component, component}, card.real(at + 2, "A")});
  }
}

std::vector<MatrixTerm> symmetric_terms(const DirectMatrix& matrix,
                                        const std::string& name) {
  if (matrix.form == symmetric_form) return matrix.terms;
  throw InputError(
      fmt::format("DMIG {} is not symmetric (IFO = {})", name, matrix.form),
      matrix.where,
      "Give stiffness and mass with IFO 6, one triangle of each.");
}

void take(const DeckBuilder& builder,
          const std::vector<std::string>& names,
          std::vector<MatrixTerm>& terms) {
  for (const std::string& name : names) {
    const auto found = builder.direct_matrices.find(name);
    if (found == builder.direct_matrices.end()) continue;
    const std::vector<MatrixTerm> own = symmetric_terms(found->second, name);
    terms.insert(terms.end(), own.begin(), own.end());
  }
}

}  // namespace

CardTable direct_matrix_cards() { return {{"DMIG", read_column}}; }

void apply_direct_matrices(DeckBuilder& builder,
                           const std::vector<std::string>& stiffness,
                           const std::vector<std::string>& mass) {
  if (builder.direct_matrices.empty()) return;
  const bool chosen = !stiffness.empty() || !mass.empty();
  const std::vector<std::string> K =
      chosen ? stiffness : std::vector<std::string>{"K2GG", "KAAX", "KGG"};
  const std::vector<std::string> M =
      chosen ? mass : std::vector<std::string>{"M2GG", "MAAX", "MGG"};
  take(builder, K, builder.deck.stiffness_terms);
  take(builder, M, builder.deck.mass_terms);
  for (const auto& [name, matrix] : builder.direct_matrices) {
    const bool used = std::ranges::count(K, name) + std::ranges::count(M, name);
    if (used) continue;
    builder.deck.warnings.push_back(
        fmt::format("{}: DMIG {} is left out; name it by K2GG or M2GG in the "
                    "case control where it belongs to the model",
                    matrix.where,
                    name));
  }
}

}  // namespace tapfit::structure
