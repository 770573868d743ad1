// *MASS, *ROTARY INERTIA, *SPRING, *DASHPOT with their elements: CONM2, CELAS2,
// CDAMP2, CBUSH1D.
#include "updating/structure/abaqus/inp_deck.hpp"

#include <algorithm>
#include <array>

namespace tapfit::structure {
namespace {

void refuse_option(const Keyword& keyword, const char* option) {
  if (!keyword.has(option)) return;
  keyword.fail(fmt::format("the option {} is not read", option),
               "Write the elements along the axes of the model, with numbers "
               "that are constant.");
}

// Elements of a family that the keyword gives their numbers.
std::vector<InpElement> take(InpDeck& deck,
                             const Keyword& keyword,
                             InpFamily family) {
  refuse_option(keyword, "ORIENTATION");
  std::vector<InpElement> taken;
  for (const std::size_t k : section_elements(deck, keyword, {family})) {
    deck.elements[k].property = 1;
    taken.push_back(deck.elements[k]);
  }
  return taken;
}

void write_masses(InpDeck& deck, const Keyword& keyword) {
  if (keyword.option("TYPE") != "ISOTROPIC") refuse_option(keyword, "TYPE");
  const double mass = number_in(keyword.line(0, "mass"), 0, "mass");
  for (const InpElement& e : take(deck, keyword, InpFamily::Mass)) {
    deck.cards.card(e.place, "CONM2", {e.id, e.nodes[0], 0, mass});
  }
}

// I11, I22, I33, I12, I13, I23 of the tensor; CONM2 has the products of
// inertia, which are those off its diagonal with the other sign.
void write_inertias(InpDeck& deck, const Keyword& keyword) {
  const DataLine& line = keyword.line(0, "moments of inertia");
  std::array<double, 6> I{};
  for (std::size_t k = 0; k < I.size(); ++k) {
    I.at(k) = number_or(line, k, 0.0, "moment of inertia");
  }
  for (const InpElement& e : take(deck, keyword, InpFamily::RotaryInertia)) {
    CardFields fields{e.id, e.nodes[0], 0, 0.0};
    fields.resize(8);
    for (const double value : {I[0], -I[3], I[1], -I[4], -I[5], I[2]}) {
      fields.emplace_back(value);
    }
    deck.cards.card(e.place, "CONM2", fields);
  }
}

// One end, or two, of a spring or damper on degrees of freedom.
void write_scalar(InpDeck& deck,
                  const InpElement& e,
                  const DataLine& dofs,
                  double value) {
  CardFields fields{e.id, value};
  for (std::size_t end = 0; end < e.nodes.size(); ++end) {
    fields.emplace_back(e.nodes[end]);
    fields.emplace_back(dof_in(dofs, end));
  }
  deck.cards.card(e.place, e.type->card, fields);
}

void write_springs(InpDeck& deck, const Keyword& keyword, InpFamily family) {
  refuse_option(keyword, "NONLINEAR");
  const bool spring = family == InpFamily::Spring;
  const char* meaning = spring ? "stiffness" : "damping";
  int property = 0;
  for (const InpElement& e : take(deck, keyword, family)) {
    const bool along = e.type_name.ends_with('A');
    // Above it the degrees of freedom; along the line of the nodes nothing,
    // which may be written as a comma.
    const bool blank_above =
        !keyword.lines.empty() && keyword.lines[0].text(0).empty();
    const DataLine& numbers =
        keyword.line(along && !blank_above ? 0 : 1, meaning);
    const double value = number_in(numbers, 0, meaning);
    if (!along) {
      write_scalar(deck, e, keyword.line(0, "degrees of freedom"), value);
      continue;
    }
    if (property == 0) {
      property = deck.next_property++;
      deck.cards.card(keyword.place,
                      "PBUSH1D",
                      spring ? CardFields{property, value}
                             : CardFields{property, "", value});
    }
    deck.cards.card(
        e.place, "CBUSH1D", {e.id, property, e.nodes[0], e.nodes[1]});
  }
}

}  // namespace

void write_point_elements(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("MASS")) write_masses(deck, *keyword);
  for (const Keyword* keyword : deck.of("ROTARYINERTIA")) {
    write_inertias(deck, *keyword);
  }
  for (const Keyword* keyword : deck.of("SPRING")) {
    write_springs(deck, *keyword, InpFamily::Spring);
  }
  for (const Keyword* keyword : deck.of("DASHPOT")) {
    write_springs(deck, *keyword, InpFamily::Dashpot);
  }
}

}  // namespace tapfit::structure
