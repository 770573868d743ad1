// *EQUATION and *MPC: MPC and RBE2.
#include "acquisition/foundation/trimmed_text.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <fmt/format.h>

namespace tapfit::structure {
namespace {

struct Term {
  std::vector<int> nodes;  // one for each equation, or one for all
  int dof = 0;
  double factor = 0.0;
};

// Two terms a line: blank, G, C, A, G, C, A, blank.
void write_mpc(InpDeck& deck,
               const Place& place,
               const std::vector<Term>& terms,
               std::size_t which) {
  std::vector<std::string> fields{"1"};
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const Term& term = terms[k];
    int node = term.nodes.size() == 1 ? term.nodes[0] : term.nodes[which];
    int dof = term.dof;
    const auto body = deck.turning_node.find(node);
    if (body != deck.turning_node.end() && dof <= 3) {
      node = body->second;
      dof += 3;
    }
    if (k > 0 && k % 2 == 0) {
      fields.emplace_back();
      fields.emplace_back();
    }
    fields.push_back(fmt::format("{}", node));
    fields.push_back(fmt::format("{}", dof));
    fields.push_back(real_field(term.factor));
  }
  deck.cards.card(place, "MPC", fields);
}

Term term_in(const InpDeck& deck, const DataLine& line, std::size_t at) {
  Term term;
  term.nodes = deck.nodes_of(line.text(at), line.place);
  term.dof = integer_in(line, at + 1, "degree of freedom");
  term.factor = number_in(line, at + 2, "factor");
  if (term.dof < 1 || term.dof > 6) {
    fail_at(line.place,
            fmt::format("{} is no degree of freedom", term.dof),
            "Give one of 1 to 6.");
  }
  return term;
}

// A set stands for an equation for each of its nodes.
void write_equation(InpDeck& deck,
                    const Place& place,
                    const std::vector<Term>& terms) {
  std::size_t count = 1;
  for (const Term& term : terms) {
    const std::size_t n = term.nodes.size();
    if (n == 1) continue;
    if (n == 0 || (count > 1 && n != count)) {
      fail_at(place,
              "the node sets of the equation have different sizes",
              "Name sets of the same number of nodes, or single nodes.");
    }
    count = n;
  }
  for (std::size_t which = 0; which < count; ++which) {
    write_mpc(deck, place, terms, which);
  }
}

void read_equations(InpDeck& deck, const Keyword& keyword) {
  std::size_t k = 0;
  while (k < keyword.lines.size()) {
    const Place place = keyword.lines[k].place;
    const int count = integer_in(keyword.lines[k++], 0, "number of terms");
    std::vector<Term> terms;
    while (static_cast<int>(terms.size()) < count) {
      const DataLine& line = keyword.line(k++, "terms of the equation");
      for (std::size_t at = 0;
           at < line.fields.size() && static_cast<int>(terms.size()) < count;
           at += 3) {
        terms.push_back(term_in(deck, line, at));
      }
    }
    if (terms.empty()) {
      fail_at(place,
              "the equation has no term",
              "Give the number of terms, then node, degree of freedom and "
              "factor of each.");
    }
    write_equation(deck, place, terms);
  }
}

// Nodes of the second set beside those of the first, or one for all.
void read_mpcs(InpDeck& deck, const Keyword& keyword, LeftOutCounts& others) {
  for (const DataLine& line : keyword.lines) {
    const std::string type = upper(line.text(0));
    if (type != "BEAM" && type != "PIN" && type != "TIE") {
      constexpr std::size_t most = 20;
      count_left_out(
          others,
          "MPC " + type.substr(0, most),
          line.place,
          "a constraint is missing; use BEAM, PIN, TIE or *EQUATION");
      continue;
    }
    const std::vector<int> follow = deck.nodes_of(line.text(1), line.place);
    const std::vector<int> lead = deck.nodes_of(line.text(2), line.place);
    if (lead.size() != 1 && lead.size() != follow.size()) {
      fail_at(line.place,
              "the node sets of the MPC have different sizes",
              "Name as many nodes that lead as follow, or one.");
    }
    for (std::size_t k = 0; k < follow.size(); ++k) {
      const int leader = lead.size() == 1 ? lead[0] : lead[k];
      if (type == "BEAM") {
        deck.cards.card(line.place,
                        "RBE2",
                        {fmt::format("{}", deck.next_element++),
                         fmt::format("{}", leader),
                         "123456",
                         fmt::format("{}", follow[k])});
        continue;
      }
      for (int dof = 1; dof <= (type == "PIN" ? 3 : 6); ++dof) {
        write_mpc(deck,
                  line.place,
                  {{{follow[k]}, dof, 1.0}, {{leader}, dof, -1.0}},
                  0);
      }
    }
  }
}

}  // namespace

void write_inp_equations(InpDeck& deck) {
  LeftOutCounts others;
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.step != 0) break;
    if (keyword.name == "EQUATION") read_equations(deck, keyword);
    if (keyword.name == "MPC") read_mpcs(deck, keyword, others);
  }
  add_left_out(deck, others);
}

}  // namespace tapfit::structure
