// Springs, dampers and masses between single degrees of freedom: CELAS1-4,
// CDAMP1-4, CMASS1-4, their properties, and CBUSH1D along the line between two
// grids.
#include "updating/structure/readers/deck_builder.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace tapfit::structure {
namespace {

// The degree of freedom of an end; a scalar point has but one.
void take_end(DeckBuilder& builder,
              const CardReader& card,
              std::size_t field,
              int component,
              std::size_t end,
              ScalarElement& e) {
  e.grids[end] = existing_grid(builder, card, field);
  const Grid& grid = builder.grid(card, e.grids[end]);
  if (grid.scalar && component == 0) component = 1;
  const int last = grid.scalar ? 1 : 6;
  if (component < 1 || component > last) {
    card.fail(fmt::format("component {} of grid {} is not one of 1 to {}",
                          component,
                          e.grids[end],
                          last),
              "Correct the component.");
  }
  e.components[end] = component;
  if (grid.axes != Eigen::Matrix3d::Identity()) {
    e.axes[end] = grid.axes.col((component - 1) % 3);
  }
}

ScalarElement scalar_element(DeckBuilder& builder, const CardReader& card) {
  ScalarElement e;
  e.id = card.id(1, "EID");
  builder.claim(card, e.id);
  return e;
}

void refuse_ground(const CardReader& card, const ScalarElement& e) {
  if (e.grids[0] != 0 || e.grids[1] != 0) return;
  card.fail("the element connects ground with ground", "Name a grid.");
}

// Fields first: G1, C1, G2, C2.
ScalarElement with_components(DeckBuilder& builder,
                              const CardReader& card,
                              std::size_t first) {
  ScalarElement e = scalar_element(builder, card);
  for (std::size_t end = 0; end < 2; ++end) {
    const std::size_t field = first + 2 * end;
    if (card.integer_or(field, 0, "grid") == 0) continue;
    const int component = card.integer_or(field + 1, 0, "component");
    take_end(builder, card, field, component, end, e);
  }
  refuse_ground(card, e);
  return e;
}

// Fields first: S1, S2.
ScalarElement with_points(DeckBuilder& builder,
                          const CardReader& card,
                          std::size_t first) {
  ScalarElement e = scalar_element(builder, card);
  for (std::size_t end = 0; end < 2; ++end) {
    if (card.integer_or(first + end, 0, "point") == 0) continue;
    take_end(builder, card, first + end, 0, end, e);
  }
  refuse_ground(card, e);
  return e;
}

double passive_damping(const CardReader& card, double B) {
  if (!(B >= 0.0)) {
    card.fail(
        fmt::format("B = {} drives the structure instead of damping it", B),
        "Give a damping of zero or more.");
  }
  return B;
}

// What an element's number is, by the card's family.
enum class Kind { Spring, Damper, Mass };

double of_property(DeckBuilder& builder,
                   const CardReader& card,
                   int element,
                   Kind kind) {
  const int pid = card.integer_or(2, element, "PID");
  switch (kind) {
    case Kind::Spring:
      property_of(card, builder.spring_properties, pid, "PELAS");
      return builder.spring_properties.at(pid)[0];
    case Kind::Damper:
      property_of(card, builder.damper_properties, pid, "PDAMP");
      return builder.damper_properties.at(pid);
    default:
      property_of(card, builder.mass_properties, pid, "PMASS");
      return builder.mass_properties.at(pid);
  }
}

void set_value(const CardReader& card,
               Kind kind,
               double value,
               ScalarElement& e) {
  if (kind == Kind::Spring) e.stiffness = value;
  if (kind == Kind::Damper) e.damping = passive_damping(card, value);
  if (kind == Kind::Mass) e.mass = value;
}

const char* letter(Kind kind) {
  if (kind == Kind::Spring) return "K";
  return kind == Kind::Damper ? "B" : "M";
}

// The four cards of a family: by a property or a number of its own, between
// components of grids or scalar points.
void add_family(const std::string& name, Kind kind, CardTable& table) {
  const auto add = [&](const char* digit, bool own_value, bool points) {
    table[name + digit] = [=](DeckBuilder& builder, const CardReader& card) {
      ScalarElement e = points ? with_points(builder, card, 3)
                               : with_components(builder, card, 3);
      const double value = own_value ? card.real(2, letter(kind))
                                     : of_property(builder, card, e.id, kind);
      set_value(card, kind, value, e);
      builder.deck.scalars.push_back(e);
    };
  };
  add("1", false, false);
  add("2", true, false);
  add("3", false, true);
  add("4", true, true);
}

void read_pelas(DeckBuilder& builder, const CardReader& card) {
  for (std::size_t at : {std::size_t{1}, std::size_t{5}}) {
    if (card.blank(at)) continue;
    const int id = card.id(at, "PID");
    builder.define(card, "PELAS", id);
    builder.spring_properties[id] = {card.real(at + 1, "K"),
                                     card.real_or(at + 2, 0.0, "GE")};
  }
}

// Four pairs of an id and a number fit on a card.
void read_pairs(DeckBuilder& builder,
                const CardReader& card,
                const char* kind,
                std::map<int, double>& values) {
  for (std::size_t at = 1; at < 9; at += 2) {
    if (card.blank(at)) continue;
    const int id = card.id(at, "PID");
    builder.define(card, kind, id);
    values[id] = card.real(at + 1, kind);
  }
}

void read_pbush1d(DeckBuilder& builder, const CardReader& card) {
  const int id = card.id(1, "PID");
  builder.define(card, "PBUSH1D", id);
  builder.line_spring_properties[id] = {card.real_or(2, 0.0, "K"),
                                        card.real_or(3, 0.0, "C"),
                                        card.real_or(4, 0.0, "M")};
  if (card.size() > 9) {
    builder.warn(card, "only K, C and M count, all that is nonlinear does not");
  }
}

// Half of a line spring's mass at each end.
void add_end_masses(DeckBuilder& builder, const ScalarElement& e, double mass) {
  if (mass == 0.0) return;
  const double ends = e.grids[1] == 0 ? 1.0 : 2.0;
  for (const int grid : e.grids) {
    if (grid == 0) continue;
    PointMass at_end;
    at_end.id = e.id;
    at_end.grid = grid;
    at_end.mass = mass / ends;
    builder.deck.masses.push_back(at_end);
  }
}

void read_cbush1d(DeckBuilder& builder, const CardReader& card) {
  ScalarElement e = scalar_element(builder, card);
  const int pid = property_of(card,
                              builder.line_spring_properties,
                              card.integer_or(2, e.id, "PID"),
                              "PBUSH1D");
  const auto [k, c, m] = builder.line_spring_properties.at(pid);
  const Grid& a = builder.grid(card, card.id(3, "GA"));
  e.grids = {a.id, 0};
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
  if (!card.blank(4)) {
    const Grid& b = builder.grid(card, card.id(4, "GB"));
    e.grids[1] = b.id;
    along = b.position - a.position;
  }
  if (!card.blank(5)) {
    along = builder.system(card, card.integer(5, "CID"))
                .directions(a.position)
                .col(0);
  }
  if (!(along.norm() > 0.0)) {
    card.fail("the spring has no direction",
              "Give CID where its grids are at one place.");
  }
  e.components = {1, e.grids[1] == 0 ? 0 : 1};
  e.axes = {along.normalized(), along.normalized()};
  e.stiffness = k;
  e.damping = passive_damping(card, c);
  add_end_masses(builder, e, m);
  builder.deck.scalars.push_back(e);
}

}  // namespace

CardTable scalar_property_cards() {
  return {{"PELAS", read_pelas},
          {"PDAMP",
           [](DeckBuilder& b, const CardReader& c) {
             read_pairs(b, c, "PDAMP", b.damper_properties);
           }},
          {"PMASS",
           [](DeckBuilder& b, const CardReader& c) {
             read_pairs(b, c, "PMASS", b.mass_properties);
           }},
          {"PBUSH", read_pbush},
          {"PBUSH1D", read_pbush1d}};
}

CardTable scalar_cards() {
  CardTable table{{"CBUSH1D", read_cbush1d}};
  add_family("CELAS", Kind::Spring, table);
  add_family("CDAMP", Kind::Damper, table);
  add_family("CMASS", Kind::Mass, table);
  return table;
}

}  // namespace tapfit::structure
