// *EQUATION and *MPC: MPC and RBE2.
#include "updating/structure/abaqus/inp_deck.hpp"

#include <algorithm>

namespace tapfit::structure {
namespace {

struct Term {
  std::vector<int> nodes;  // one for each equation, or one for all
  int dof = 0;
  double factor = 0.0;
};

int of_row(const std::vector<int>& nodes, std::size_t row) {
  return nodes.size() == 1 ? nodes[0] : nodes[row];
}

// How many rows sets of nodes stand for: a set of more than one is one for
// each of its nodes.
std::size_t row_count(const Place& place,
                      const std::vector<std::size_t>& sizes) {
  std::size_t count = 1;
  for (const std::size_t n : sizes) {
    if (n == 1) continue;
    if (n == 0 || (count > 1 && n != count)) {
      fail_at(place,
              "the node sets have different sizes",
              "Name sets of the same number of nodes, or single nodes.");
    }
    count = n;
  }
  return count;
}

void write_equation(InpDeck& deck,
                    const Place& place,
                    const std::vector<Term>& terms) {
  std::vector<std::size_t> sizes;
  for (const Term& term : terms) sizes.push_back(term.nodes.size());
  const std::size_t count = row_count(place, sizes);
  for (std::size_t row = 0; row < count; ++row) {
    std::vector<RelationTerm> relation;
    for (const Term& term : terms) {
      relation.push_back({of_row(term.nodes, row), term.dof, term.factor});
    }
    write_relation(deck, place, relation);
  }
}

// The number of terms, then node, degree of freedom and factor of each.
void read_equations(InpDeck& deck, const Keyword& keyword) {
  std::size_t k = 0;
  while (k < keyword.lines.size()) {
    const DataLine& head = keyword.lines[k++];
    const int count = integer_in(head, 0, "number of terms");
    if (count < 1) {
      fail_at(head.place,
              "the equation has no term",
              "Give the number of terms, then node, degree of freedom and "
              "factor of each.");
    }
    std::vector<Term> terms;
    while (static_cast<int>(terms.size()) < count) {
      const DataLine& line = keyword.line(k++, "terms of the equation");
      for (std::size_t at = 0;
           at < line.fields.size() && static_cast<int>(terms.size()) < count;
           at += 3) {
        terms.push_back({deck.nodes_of(line.text(at), line.place),
                         dof_in(line, at + 1),
                         number_in(line, at + 2, "factor")});
      }
    }
    write_equation(deck, head.place, terms);
  }
}

// BEAM, PIN, TIE: the first node follows the second one.
void read_mpc(InpDeck& deck, const DataLine& line) {
  const std::string type = line.name(0);
  if (type != "BEAM" && type != "PIN" && type != "TIE") {
    deck.leave_out("MPC " + type,
                   line.place,
                   "a constraint is missing; use BEAM, PIN, TIE or *EQUATION");
    return;
  }
  const std::vector<int> follow = deck.nodes_of(line.text(1), line.place);
  const std::vector<int> lead = deck.nodes_of(line.text(2), line.place);
  if (lead.size() > 1 && follow.size() == 1) {
    fail_at(line.place,
            "one node follows several",
            "Name as many nodes that lead as follow, or one.");
  }
  const std::size_t count = row_count(line.place, {follow.size(), lead.size()});
  for (std::size_t k = 0; k < count; ++k) {
    const int leader = of_row(lead, k);
    const int follower = of_row(follow, k);
    if (type == "BEAM") {
      deck.cards.card(line.place,
                      "RBE2",
                      {deck.next_element++, leader, "123456", follower});
      continue;
    }
    for (int dof = 1; dof <= (type == "PIN" ? 3 : 6); ++dof) {
      write_relation(
          deck, line.place, {{follower, dof, 1.0}, {leader, dof, -1.0}});
    }
  }
}

}  // namespace

void write_relation(InpDeck& deck,
                    const Place& place,
                    const std::vector<RelationTerm>& terms) {
  // Two terms a line: blank, G, C, A, G, C, A, blank.
  CardFields fields{1};
  for (std::size_t k = 0; k < terms.size(); ++k) {
    RelationTerm term = terms[k];
    const auto body = deck.turning_node.find(term.node);
    if (body != deck.turning_node.end() && term.dof <= 3) {
      term.node = body->second;
      term.dof += 3;
    }
    if (k > 0 && k % 2 == 0) fields.resize(fields.size() + 2);
    fields.emplace_back(term.node);
    fields.emplace_back(term.dof);
    fields.emplace_back(term.factor);
  }
  deck.cards.card(place, "MPC", fields);
}

void write_inp_equations(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("EQUATION")) {
    read_equations(deck, *keyword);
  }
  for (const Keyword* keyword : deck.of("MPC")) {
    for (const DataLine& line : keyword->lines) read_mpc(deck, line);
  }
}

}  // namespace tapfit::structure
