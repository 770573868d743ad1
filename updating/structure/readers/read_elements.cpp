// CQUAD4, CTRIA3, CBAR, CBEAM, CROD, CONROD, CONM2, CELAS1, CELAS2, CDAMP1,
// CDAMP2, CMASS2, PLOTEL. CBUSH and rigid elements have files of their own.
#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace tapfit::structure {
namespace {

template <typename Properties>
int property_of(const CardReader& card,
                const Properties& properties,
                int id,
                const char* kind) {
  if (!properties.contains(id)) {
    card.fail(fmt::format("{} {} does not exist", kind, id),
              "Add the property or correct the entry.");
  }
  return id;
}

int existing_grid(const DeckBuilder& builder,
                  const CardReader& card,
                  std::size_t field) {
  const int id = card.id(field, "grid");
  return builder.grid(card, id).id;
}

void refuse_repeated(const CardReader& card, std::vector<int> grids) {
  std::sort(grids.begin(), grids.end());
  if (std::adjacent_find(grids.begin(), grids.end()) != grids.end()) {
    card.fail("the element names a grid twice", "Correct the grids.");
  }
}

// THETA, or the angle of a coordinate system's x axis when it is an integer.
double material_angle(const DeckBuilder& builder,
                      const CardReader& card,
                      std::size_t field,
                      const std::vector<int>& grids) {
  const std::string& text = card.text(field);
  if (text.empty()) return 0.0;
  const std::optional<int> system = parse_integer(text);
  if (!system) return card.real(field, "THETA");
  const auto at = [&](std::size_t i) {
    return builder.grid(card, grids[i]).position;
  };
  const Eigen::Vector3d side = at(1) - at(0);
  const Eigen::Vector3d normal = side.cross(at(2) - at(0)).stableNormalized();
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < grids.size(); ++i) middle += at(i);
  middle /= static_cast<double>(grids.size());
  const Eigen::Vector3d x =
      builder.system(card, *system).directions(middle).col(0);
  const Eigen::Vector3d flat = x - normal * normal.dot(x);
  const double angle = std::atan2(normal.dot(side.cross(flat)), side.dot(flat));
  return angle * 180.0 / std::numbers::pi;
}

void read_shell(DeckBuilder& builder,
                const CardReader& card,
                std::size_t corners) {
  Shell shell;
  shell.id = card.id(1, "EID");
  shell.where = card.where();
  builder.claim(card, shell.id);
  shell.property = property_of(card,
                               builder.deck.shell_properties,
                               card.integer_or(2, shell.id, "PID"),
                               "PSHELL");
  for (std::size_t i = 0; i < corners; ++i) {
    shell.grids.push_back(existing_grid(builder, card, 3 + i));
  }
  refuse_repeated(card, shell.grids);
  shell.theta_deg = material_angle(builder, card, 3 + corners, shell.grids);
  if (card.real_or(4 + corners, 0.0, "ZOFFS") != 0.0) {
    builder.warn(card, "ZOFFS is ignored: the plate lies in its grids' plane");
  }
  for (std::size_t i = 0; i < corners; ++i) {
    if (!card.blank(11 + i) && card.text(11 + i) != "0.") {
      builder.warn(card, "corner thicknesses are ignored, PSHELL's is used");
      break;
    }
  }
  builder.deck.shells.push_back(shell);
}

Eigen::Vector3d bar_orientation(const DeckBuilder& builder,
                                const CardReader& card,
                                const Bar& bar) {
  const Eigen::Vector3d a = builder.grid(card, bar.grids[0]).position;
  const Eigen::Vector3d b = builder.grid(card, bar.grids[1]).position;
  Eigen::Vector3d v;
  if (parse_integer(card.text(5)) && card.blank(6) && card.blank(7)) {
    const int g0 = card.id(5, "G0");
    v = builder.grid(card, g0).position - (a + bar.offsets[0]);
  } else {
    v = builder.grid(card, bar.grids[0]).axes * card.vector(5, "orientation");
  }
  const Eigen::Vector3d axis = b + bar.offsets[1] - a - bar.offsets[0];
  if (!(axis.norm() > 0.0)) {
    card.fail("the bar has no length", "Give two grids at different places.");
  }
  if (!(axis.cross(v).norm() > 1e-8 * axis.norm() * v.norm()) ||
      v.norm() == 0.0) {
    card.fail("the orientation vector is zero or lies along the bar",
              "Give a vector (or G0) off the bar's axis.");
  }
  return v;
}

void read_bar(DeckBuilder& builder, const CardReader& card) {
  Bar bar;
  bar.id = card.id(1, "EID");
  bar.where = card.where();
  builder.claim(card, bar.id);
  bar.property = property_of(card,
                             builder.deck.bar_properties,
                             card.integer_or(2, bar.id, "PID"),
                             "PBAR or PBEAM");
  bar.grids = {existing_grid(builder, card, 3),
               existing_grid(builder, card, 4)};
  for (std::size_t end = 0; end < 2; ++end) {
    bar.released[end] = card.components(9 + end);
    bar.offsets[end] = builder.grid(card, bar.grids[end]).axes *
                       card.vector(11 + 3 * end, "offset");
  }
  const std::string option = upper(card.text(8));
  if (!option.empty() && option != "GGG" && option != "1") {
    builder.warn(card, fmt::format("field 9 \"{}\" is taken as GGG", option));
  }
  bar.rotary_inertia = card.card().name() == "CBEAM";
  bar.orientation = bar_orientation(builder, card, bar);
  builder.deck.bars.push_back(bar);
}

void read_crod(DeckBuilder& builder, const CardReader& card) {
  Rod rod;
  rod.id = card.id(1, "EID");
  rod.where = card.where();
  builder.claim(card, rod.id);
  rod.property = property_of(card,
                             builder.deck.rod_properties,
                             card.integer_or(2, rod.id, "PID"),
                             "PROD");
  rod.grids = {existing_grid(builder, card, 3),
               existing_grid(builder, card, 4)};
  refuse_repeated(card, {rod.grids[0], rod.grids[1]});
  builder.deck.rods.push_back(rod);
}

void read_conrod(DeckBuilder& builder, const CardReader& card) {
  Rod rod;
  rod.id = card.id(1, "EID");
  rod.where = card.where();
  builder.claim(card, rod.id);
  rod.property = -rod.id;
  rod.grids = {existing_grid(builder, card, 2),
               existing_grid(builder, card, 3)};
  refuse_repeated(card, {rod.grids[0], rod.grids[1]});
  RodProperty p;
  p.id = rod.property;
  p.where = rod.where;
  p.material = card.id(4, "MID");
  p.area = card.real(5, "A");
  p.J = card.real_or(6, 0.0, "J");
  p.nonstructural = card.real_or(8, 0.0, "NSM");
  if (!(p.area >= 0.0 && p.J >= 0.0 && p.nonstructural >= 0.0)) {
    card.fail("A, J or NSM is below zero", "Give values of zero or more.");
  }
  builder.deck.rod_properties[p.id] = p;
  builder.deck.rods.push_back(rod);
}

void read_conm2(DeckBuilder& builder, const CardReader& card) {
  PointMass mass;
  mass.id = card.id(1, "EID");
  builder.claim(card, mass.id);
  mass.grid = existing_grid(builder, card, 2);
  mass.mass = card.real_or(4, 0.0, "M");
  if (!(mass.mass >= 0.0)) {
    card.fail(fmt::format("M = {} is no mass", mass.mass),
              "Give a mass of zero or more.");
  }
  const int cid = card.integer_or(3, 0, "CID");
  const Eigen::Vector3d& at = builder.grid(card, mass.grid).position;
  const Eigen::Matrix3d axes =
      builder.system(card, std::max(cid, 0)).directions(at);
  const Eigen::Vector3d x = card.vector(5, "X");
  mass.offset = cid == -1 ? x - at : Eigen::Vector3d(axes * x);
  Eigen::Matrix3d I = Eigen::Matrix3d::Zero();
  std::size_t field = 9;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index col = 0; col <= row; ++col, ++field) {
      const double value = card.real_or(field, 0.0, "I");
      I(row, col) = I(col, row) = row == col ? value : -value;
    }
  }
  mass.inertia = axes * I * axes.transpose();
  builder.deck.masses.push_back(mass);
}

// Fields first: G1, C1, G2, C2.
ScalarElement scalar_ends(DeckBuilder& builder,
                          const CardReader& card,
                          std::size_t first) {
  ScalarElement e;
  e.id = card.id(1, "EID");
  builder.claim(card, e.id);
  for (std::size_t end = 0; end < 2; ++end) {
    const std::size_t field = first + 2 * end;
    if (card.integer_or(field, 0, "grid") == 0) continue;
    e.grids[end] = existing_grid(builder, card, field);
    e.components[end] = card.integer_or(field + 1, 0, "component");
    if (e.components[end] < 1 || e.components[end] > 6) {
      card.fail(fmt::format("component {} of grid {} is not one of 1 to 6",
                            e.components[end],
                            e.grids[end]),
                "Correct the component.");
    }
    const Eigen::Matrix3d& axes = builder.grid(card, e.grids[end]).axes;
    if (axes != Eigen::Matrix3d::Identity()) {
      e.axes[end] = axes.col((e.components[end] - 1) % 3);
    }
  }
  if (e.grids[0] == 0 && e.grids[1] == 0) {
    card.fail("the element connects ground with ground", "Name a grid.");
  }
  return e;
}

void read_celas1(DeckBuilder& builder, const CardReader& card) {
  ScalarElement e = scalar_ends(builder, card, 3);
  const int pid = property_of(card,
                              builder.spring_properties,
                              card.integer_or(2, e.id, "PID"),
                              "PELAS");
  e.stiffness = builder.spring_properties.at(pid)[0];
  builder.deck.scalars.push_back(e);
}

void read_celas2(DeckBuilder& builder, const CardReader& card) {
  ScalarElement e = scalar_ends(builder, card, 3);
  e.stiffness = card.real(2, "K");
  builder.deck.scalars.push_back(e);
}

double passive_damping(const CardReader& card, double B) {
  if (!(B >= 0.0)) {
    card.fail(
        fmt::format("B = {} drives the structure instead of damping it", B),
        "Give a damping of zero or more.");
  }
  return B;
}

void read_cdamp1(DeckBuilder& builder, const CardReader& card) {
  ScalarElement e = scalar_ends(builder, card, 3);
  const int pid = property_of(card,
                              builder.damper_properties,
                              card.integer_or(2, e.id, "PID"),
                              "PDAMP");
  e.damping = passive_damping(card, builder.damper_properties.at(pid));
  builder.deck.scalars.push_back(e);
}

void read_cdamp2(DeckBuilder& builder, const CardReader& card) {
  ScalarElement e = scalar_ends(builder, card, 3);
  e.damping = passive_damping(card, card.real(2, "B"));
  builder.deck.scalars.push_back(e);
}

void read_cmass2(DeckBuilder& builder, const CardReader& card) {
  ScalarElement e = scalar_ends(builder, card, 3);
  e.mass = card.real(2, "M");
  builder.deck.scalars.push_back(e);
}

void read_plotel(DeckBuilder& builder, const CardReader& card) {
  builder.deck.plot_lines.push_back(
      {existing_grid(builder, card, 2), existing_grid(builder, card, 3)});
}

}  // namespace

CardTable element_cards() {
  return {{"CQUAD4",
           [](DeckBuilder& b, const CardReader& c) { read_shell(b, c, 4); }},
          {"CTRIA3",
           [](DeckBuilder& b, const CardReader& c) { read_shell(b, c, 3); }},
          {"CBAR", read_bar},
          {"CBEAM", read_bar},
          {"CROD", read_crod},
          {"CONROD", read_conrod},
          {"CONM2", read_conm2},
          {"CELAS1", read_celas1},
          {"CELAS2", read_celas2},
          {"CDAMP1", read_cdamp1},
          {"CDAMP2", read_cdamp2},
          {"CMASS2", read_cmass2},
          {"CBUSH", read_cbush},
          {"PLOTEL", read_plotel}};
}

}  // namespace tapfit::structure
