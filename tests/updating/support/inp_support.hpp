// Abaqus and CalculiX decks from text for the tests of
// updating/structure/abaqus.
#pragma once

#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/deck_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tapfit::structure {

inline Deck deck_of_inp(const std::string& text,
                        const std::vector<std::string>& ignored = {}) {
  return read_deck(write_text("plate.inp", text), ignored);
}

/// Frequencies of the deck as it is held [Hz].
inline Eigen::VectorXd hz_of(const Deck& deck, Eigen::Index count) {
  return deck_modes(deck, assemble(deck), count).modes.frequency_hz;
}

/// Whether one of the deck's warnings holds the text.
inline bool warns(const Deck& deck, const std::string& text) {
  return std::ranges::any_of(deck.warnings, [&](const std::string& warning) {
    return warning.find(text) != std::string::npos;
  });
}

/// Steel in SI.
inline const std::string steel_inp =
    "*MATERIAL, NAME=STEEL\n*ELASTIC\n2.1e11, .3\n*DENSITY\n7800.\n";

/// Nodes 1 to n + 1 along x, `length` apart at the ends.
inline std::string line_of_nodes(int n, double length) {
  std::string text = "*NODE, NSET=ALL\n";
  for (int k = 0; k <= n; ++k) {
    text += fmt::format("{}, {}, 0., 0.\n", k + 1, length * k / n);
  }
  return text;
}

/// A square of 1 m by one shell of four nodes, element 1 of set P.
inline std::string one_shell(const std::string& type = "S4") {
  return "*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n"
         "4, 0., 1., 0.\n*ELEMENT, TYPE=" +
         type + ", ELSET=P\n1, 1, 2, 3, 4\n";
}

/// A cube of 1 m, element 1 of set V.
inline std::string one_brick() {
  return "*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n"
         "4, 0., 1., 0.\n5, 0., 0., 1.\n6, 1., 0., 1.\n7, 1., 1., 1.\n"
         "8, 0., 1., 1.\n*ELEMENT, TYPE=C3D8, ELSET=V\n"
         "1, 1, 2, 3, 4, 5, 6, 7, 8\n";
}

inline const std::string brick_section =
    "*SOLID SECTION, ELSET=V, MATERIAL=STEEL\n" + steel_inp;

}  // namespace tapfit::structure
