#include "updating/structure/edit/direct_matrix.hpp"

#include "updating/structure/edit/deck_cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace tapfit::structure {
namespace {

using Entries = Eigen::SparseMatrix<double>;

// Of the largest on the diagonal: what is left of a zero.
constexpr double rounding = 1e-12;

std::string without_blanks(const std::string& line) {
  std::string text;
  for (const char c : line) {
    if (std::isspace(static_cast<unsigned char>(c)) != 0) continue;
    text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return text;
}

// A force by length is mass by time squared, each rotation one length more.
double in_file_units(const Deck& deck, double si, int rotations) {
  return si / (deck.file_mass_kg * std::pow(deck.file_length_m, rotations));
}

struct NamedDof {
  int grid = 0;
  int component = 0;  // 1..6
};

NamedDof named_dof(const Deck& deck, Eigen::Index index) {
  return {deck.grids[static_cast<std::size_t>(index / 6)].id,
          static_cast<int>(index % 6) + 1};
}

bool has_turned_grid(const Deck& deck, const Entries& K) {
  for (Eigen::Index c = 0; c < K.outerSize(); ++c) {
    const bool acts = static_cast<bool>(Entries::InnerIterator(K, c));
    const Grid& grid = deck.grids[static_cast<std::size_t>(c / 6)];
    if (acts && !grid.axes.isIdentity(1e-12)) return true;
  }
  return false;
}

// The rows from the diagonal on; empty where there are none.
std::string column_card(const Deck& deck,
                        const std::string& name,
                        const Entries& K,
                        Eigen::Index column,
                        double least) {
  const NamedDof own = named_dof(deck, column);
  std::string card;
  int terms = 0;
  for (Entries::InnerIterator it(K, column); it; ++it) {
    if (it.row() < column || !(std::abs(it.value()) > least)) continue;
    const NamedDof row = named_dof(deck, it.row());
    const int rotations = (own.component > 3) + (row.component > 3);
    const std::string term =
        fmt::format("{},{},{}",
                    row.grid,
                    row.component,
                    card_real(in_file_units(deck, it.value(), rotations)));
    if (terms == 0) {
      card =
          fmt::format("DMIG,{},{},{},,{}", name, own.grid, own.component, term);
    } else {
      // One in the first line, then two in each.
      card += terms % 2 == 1 ? ",,+\n+," : ",,";
      card += term;
    }
    ++terms;
  }
  return card;
}

}  // namespace

std::vector<std::string> direct_stiffness_cards(const Deck& deck,
                                                const std::string& name,
                                                const Entries& K) {
  if (has_turned_grid(deck, K)) return {};
  const int symmetric = 6;
  const int real_double = 2;
  std::vector<std::string> cards = {
      fmt::format("DMIG,{},0,{},{},0", name, symmetric, real_double)};
  const Eigen::VectorXd stiff = K.diagonal();
  const double least = rounding * stiff.cwiseAbs().maxCoeff();
  for (Eigen::Index c = 0; c < K.outerSize(); ++c) {
    std::string card = column_card(deck, name, K, c, least);
    if (!card.empty()) cards.push_back(std::move(card));
  }
  return cards;
}

void name_direct_stiffness(const std::string& name, EditedDeck& deck) {
  const std::vector<std::string>& lines = deck.lines;
  const auto bulk = std::ranges::find_if(lines, [](const std::string& line) {
    return without_blanks(line).starts_with("BEGINBULK");
  });
  if (bulk == lines.end()) return;
  const auto named = std::find_if(lines.begin(), bulk, [](const auto& line) {
    return without_blanks(line).starts_with("K2GG=");
  });
  const auto at = static_cast<std::size_t>(named - lines.begin());
  if (named == bulk) {
    deck.replaced[at] = {"K2GG = " + name, *bulk};
    return;
  }
  const std::string taken = without_blanks(*named).substr(5) + ",";
  if (("," + taken).find("," + name + ",") == std::string::npos) {
    deck.replaced[at] = {*named + "," + name};
  }
}

}  // namespace tapfit::structure
