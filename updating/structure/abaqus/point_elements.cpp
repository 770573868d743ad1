// *MASS, *ROTARY INERTIA, *SPRING, *DASHPOT with their elements: CONM2, CELAS2,
// CDAMP2, CBUSH1D.
#include "updating/structure/abaqus/inp_deck.hpp"

#include <fmt/format.h>

namespace tapfit::structure {
namespace {

std::vector<InpElement*> of_family(InpDeck& deck,
                                   const Keyword& keyword,
                                   InpFamily family) {
  std::vector<InpElement*> found;
  const std::string set = keyword.needed_option("ELSET");
  for (const std::size_t k : deck.elements_of(set, keyword.place)) {
    InpElement& e = deck.elements[k];
    if (e.type != nullptr && e.type->family == family) found.push_back(&e);
  }
  return found;
}

void refuse_option(const Keyword& keyword, const char* option) {
  if (!keyword.has(option)) return;
  keyword.fail(fmt::format("the option {} is not read", option),
               "Write the elements along the axes of the model, with numbers "
               "that are constant.");
}

void write_masses(InpDeck& deck, const Keyword& keyword) {
  refuse_option(keyword, "ORIENTATION");
  const double mass = number_in(keyword.line(0, "mass"), 0, "mass");
  for (InpElement* e : of_family(deck, keyword, InpFamily::Mass)) {
    e->property = 1;
    deck.cards.card(e->place,
                    "CONM2",
                    {fmt::format("{}", e->id),
                     fmt::format("{}", e->nodes[0]),
                     "0",
                     real_field(mass)});
  }
}

// I11, I22, I33, I12, I13, I23 of the tensor; CONM2 has the products of
// inertia, which are those off its diagonal with the other sign.
void write_inertias(InpDeck& deck, const Keyword& keyword) {
  refuse_option(keyword, "ORIENTATION");
  const DataLine& line = keyword.line(0, "moments of inertia");
  std::array<double, 6> I{};
  for (std::size_t k = 0; k < I.size(); ++k) {
    I[k] = number_or(line, k, 0.0, "moment of inertia");
  }
  for (InpElement* e : of_family(deck, keyword, InpFamily::RotaryInertia)) {
    e->property = 1;
    std::vector<std::string> fields{
        fmt::format("{}", e->id), fmt::format("{}", e->nodes[0]), "0", "0."};
    fields.resize(8);
    for (const double value : {I[0], -I[3], I[1], -I[4], -I[5], I[2]}) {
      fields.push_back(real_field(value));
    }
    deck.cards.card(e->place, "CONM2", fields);
  }
}

// One end, or two, of a spring or damper on degrees of freedom.
void write_scalar(InpDeck& deck,
                  const InpElement& e,
                  const DataLine& dofs,
                  double value) {
  std::vector<std::string> fields{fmt::format("{}", e.id), real_field(value)};
  for (std::size_t end = 0; end < e.nodes.size(); ++end) {
    const int dof = integer_in(dofs, end, "degree of freedom");
    if (dof < 1 || dof > 6) {
      fail_at(dofs.place,
              fmt::format("{} is no degree of freedom", dof),
              "Give one of 1 to 6.");
    }
    fields.push_back(fmt::format("{}", e.nodes[end]));
    fields.push_back(fmt::format("{}", dof));
  }
  deck.cards.card(e.place, e.type->card, fields);
}

void write_springs(InpDeck& deck, const Keyword& keyword, InpFamily family) {
  refuse_option(keyword, "NONLINEAR");
  refuse_option(keyword, "ORIENTATION");
  const bool spring = family == InpFamily::Spring;
  const char* meaning = spring ? "stiffness" : "damping";
  int property = 0;
  for (InpElement* e : of_family(deck, keyword, family)) {
    e->property = 1;
    const bool along = e->type_name.ends_with('A');
    const DataLine& numbers = keyword.line(along ? 0 : 1, meaning);
    const double value = number_in(numbers, 0, meaning);
    if (!along) {
      write_scalar(deck, *e, keyword.line(0, "degrees of freedom"), value);
      continue;
    }
    if (property == 0) {
      property = deck.next_property++;
      deck.cards.card(keyword.place,
                      "PBUSH1D",
                      {fmt::format("{}", property),
                       spring ? real_field(value) : "",
                       spring ? "" : real_field(value)});
    }
    deck.cards.card(e->place,
                    "CBUSH1D",
                    {fmt::format("{}", e->id),
                     fmt::format("{}", property),
                     fmt::format("{}", e->nodes[0]),
                     fmt::format("{}", e->nodes[1])});
  }
}

}  // namespace

void write_point_elements(InpDeck& deck) {
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.step != 0) break;
    if (keyword.name == "MASS") write_masses(deck, keyword);
    if (keyword.name == "ROTARYINERTIA") write_inertias(deck, keyword);
    if (keyword.name == "SPRING") {
      write_springs(deck, keyword, InpFamily::Spring);
    }
    if (keyword.name == "DASHPOT") {
      write_springs(deck, keyword, InpFamily::Dashpot);
    }
  }
}

}  // namespace tapfit::structure
