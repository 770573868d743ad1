// DMIG: entries of stiffness and mass given by degrees of freedom.
#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

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

using MatrixDof = std::pair<int, int>;  // grid, component

// One triangle of a square matrix whose numbers are symmetric all the same.
std::optional<std::vector<MatrixTerm>> triangle_of(
    const std::vector<MatrixTerm>& square) {
  std::map<std::pair<MatrixDof, MatrixDof>, double> value;
  const auto row = [](const MatrixTerm& t) {
    return MatrixDof{t.grids[0], t.components[0]};
  };
  const auto column = [](const MatrixTerm& t) {
    return MatrixDof{t.grids[1], t.components[1]};
  };
  for (const MatrixTerm& t : square) value[{row(t), column(t)}] += t.value;
  std::vector<MatrixTerm> triangle;
  for (const auto& [at, own] : value) {
    constexpr double rounding = 1e-6;  // of numbers in fields of eight columns
    const auto other = value.find({at.second, at.first});
    const double mirrored = other == value.end() ? 0.0 : other->second;
    if (std::abs(own - mirrored) > rounding * std::abs(own)) return {};
    if (at.first < at.second) continue;
    triangle.push_back({{at.first.first, at.second.first},
                        {at.first.second, at.second.second},
                        own});
  }
  return triangle;
}

std::vector<MatrixTerm> symmetric_terms(const DirectMatrix& matrix,
                                        const std::string& name) {
  if (matrix.form == symmetric_form) return matrix.terms;
  if (auto triangle = triangle_of(matrix.terms)) return *std::move(triangle);
  throw InputError(
      fmt::format("DMIG {} is not symmetric (IFO = {})", name, matrix.form),
      matrix.where,
      "Give stiffness and mass with IFO 6, one triangle of each.");
}

// NAME, or FACTOR*NAME.
struct TakenMatrix {
  std::string name;
  double factor = 1.0;
};

std::vector<TakenMatrix> taken(const std::vector<std::string>& texts) {
  std::vector<TakenMatrix> result;
  for (const std::string& text : texts) {
    const std::size_t star = text.find('*');
    if (star == std::string::npos) {
      result.push_back({text});
      continue;
    }
    const std::optional<double> factor =
        parse_real(trimmed(text.substr(0, star)));
    if (!factor) {
      throw InputError(
          fmt::format("the case control takes \"{}\" as a matrix", text),
          "K2GG and M2GG",
          "Give a name or a number times a name, such as 2.0*KX.");
    }
    result.push_back({trimmed(text.substr(star + 1)), *factor});
  }
  return result;
}

// @param needed whether the case control names them
void take(const DeckBuilder& builder,
          const std::vector<TakenMatrix>& matrices,
          bool needed,
          std::vector<MatrixTerm>& terms) {
  for (const auto& [name, factor] : matrices) {
    const auto found = builder.direct_matrices.find(name);
    if (found == builder.direct_matrices.end()) {
      if (!needed) continue;
      throw InputError(
          fmt::format("the case control takes the matrix {}, which no DMIG of "
                      "the deck defines",
                      name),
          "K2GG and M2GG",
          "Add its DMIG cards, or take it out there if the model is whole "
          "without.");
    }
    for (MatrixTerm term : symmetric_terms(found->second, name)) {
      term.value *= factor;
      terms.push_back(term);
    }
  }
}

// Those of responses (K2PP) are chosen for them alone.
bool chooses_matrices(const CaseControl& control) {
  if (control.selects) return true;
  const std::vector<const char*> names{"K2GG", "M2GG", "K2PP", "M2PP"};
  return std::ranges::any_of(names, [&control](const char* name) {
    return control.commands.contains(name);
  });
}

}  // namespace

CardTable direct_matrix_cards() { return {{"DMIG", read_column}}; }

void apply_direct_matrices(DeckBuilder& builder, const CaseControl& control) {
  const bool chosen = chooses_matrices(control);
  const std::vector<TakenMatrix> K =
      taken(chosen ? control.stiffness_matrices
                   : std::vector<std::string>{"K2GG", "KAAX", "KGG"});
  const std::vector<TakenMatrix> M =
      taken(chosen ? control.mass_matrices
                   : std::vector<std::string>{"M2GG", "MAAX", "MGG"});
  take(builder, K, chosen, builder.deck.stiffness_terms);
  take(builder, M, chosen, builder.deck.mass_terms);
  for (const auto& [name, matrix] : builder.direct_matrices) {
    const auto is_this = [&](const TakenMatrix& m) { return m.name == name; };
    const bool stiffness = std::ranges::any_of(K, is_this);
    if (stiffness || std::ranges::any_of(M, is_this)) {
      if (chosen) continue;
      builder.deck.warnings.push_back(fmt::format(
          "{}: DMIG {} is taken as {} for its name, since no case control "
          "chooses; choose there ({} = {}) if that is meant",
          matrix.where,
          name,
          stiffness ? "stiffness" : "mass",
          stiffness ? "K2GG" : "M2GG",
          name));
      continue;
    }
    builder.deck.warnings.push_back(
        fmt::format("{}: DMIG {} is left out; name it by K2GG or M2GG in the "
                    "case control where it belongs to the model",
                    matrix.where,
                    name));
  }
}

}  // namespace tapfit::structure
