// Shells, CBAR, CBEAM, CROD, CTUBE, CONROD, CONM1, CONM2, PLOTEL. Solids,
// scalar elements, CBUSH and rigid elements have files of their own.
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace tapfit::structure {
namespace {

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

// The mean of the corners' thicknesses, which blank ones have of the property;
// 0 where none is given.
double mean_thickness(DeckBuilder& builder,
                      const CardReader& card,
                      const Shell& shell,
                      std::size_t first,
                      std::size_t flag) {
  double& own = builder.deck.shell_properties.at(shell.property).thickness;
  // TFLAG: what they give is a share of the property's.
  const bool relative = card.text(flag) == "1";
  double sum = 0.0;
  bool any = false;
  for (std::size_t i = 0; i < shell.grids.size(); ++i) {
    const double t = card.real_or(first + i, 0.0, "T");
    if (own == 0.0 && t == 0.0) {
      card.fail(fmt::format("neither it nor PSHELL {} has a thickness",
                            shell.property),
                "Give T of the property, or T1 and so on of all corners.");
    }
    if (card.blank(first + i)) {
      sum += own;
      continue;
    }
    if (t == 0.0) return 0.0;  // as some programs write blanks
    if (!(t > 0.0)) {
      card.fail(fmt::format("the corner thickness {} is below zero", t),
                "Correct it, or leave it blank.");
    }
    sum += relative ? t * own : t;
    any = true;
  }
  const double mean = sum / static_cast<double>(shell.grids.size());
  // A property without any has that of its first element.
  if (own == 0.0) own = mean;
  return any && mean != own ? mean : 0.0;
}

// Where a shell's card has what.
struct ShellFields {
  std::size_t corners;
  std::size_t mids;       // how many
  std::size_t theta;      // THETA or MCID
  std::size_t offset;     // ZOFFS
  std::size_t thickness;  // T1
  std::size_t flag;       // TFLAG
};

void read_shell(DeckBuilder& builder,
                const CardReader& card,
                const ShellFields& fields) {
  auto shell = claimed_by<Shell>(builder, card);
  shell.property = property_of(card,
                               builder.deck.shell_properties,
                               card.integer_or(2, shell.id, "PID"),
                               "PSHELL");
  read_corners(builder, card, fields.corners, fields.mids, shell);
  refuse_repeated(card, shell.all_grids());
  shell.theta_deg = material_angle(builder, card, fields.theta, shell.grids);
  shell.offset = card.real_or(fields.offset, 0.0, "ZOFFS");
  shell.thickness =
      mean_thickness(builder, card, shell, fields.thickness, fields.flag);
  if (shell.thickness > 0.0) {
    builder.warn(card, "the mean of its corners' thicknesses is taken");
  }
  builder.deck.shells.push_back(shell);
}

// CSHEAR: four grids and nothing else.
void read_panel(DeckBuilder& builder, const CardReader& card) {
  read_shell(builder, card, {4, 0, 32, 33, 35, 34});
  if (builder.deck.shell_properties.at(builder.deck.shells.back().property)
          .panel) {
    return;
  }
  card.fail("its property is no PSHEAR", "Name a PSHEAR, or use a CQUAD4.");
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
    v = card.vector(5, "orientation");
    // OFFT: along the first grid's axes, unless it begins with B (basic).
    if (!upper(card.text(8)).starts_with("B")) {
      v = builder.grid(card, bar.grids[0]).axes * v;
    }
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

// OFFT with O: that end's offset counts along the axes of the element that
// joins the grids.
void take_own_offsets(DeckBuilder& builder, const CardReader& card, Bar& bar) {
  const std::string option = upper(card.text(8));
  if (option.size() != 3) {
    if (!option.empty() && option != "1") {
      builder.warn(card, fmt::format("field 9 \"{}\" is taken as GGG", option));
    }
    return;
  }
  if (option[1] != 'O' && option[2] != 'O') return;
  Bar straight = bar;
  straight.offsets = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  const Eigen::Vector3d v = bar_orientation(builder, card, straight);
  const Eigen::Vector3d x = (builder.grid(card, bar.grids[1]).position -
                             builder.grid(card, bar.grids[0]).position)
                                .normalized();
  const Eigen::Vector3d z = x.cross(v).normalized();
  Eigen::Matrix3d axes;
  axes << x, z.cross(x), z;
  for (std::size_t end = 0; end < 2; ++end) {
    if (option[1 + end] != 'O') continue;
    bar.offsets[end] = axes * card.vector(11 + 3 * end, "offset");
  }
}

void read_bar(DeckBuilder& builder, const CardReader& card) {
  auto bar = claimed_by<Bar>(builder, card);
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
  take_own_offsets(builder, card, bar);
  bar.rotary_inertia = card.card().name() == "CBEAM";
  bar.orientation = bar_orientation(builder, card, bar);
  builder.deck.bars.push_back(bar);
}

void read_crod(DeckBuilder& builder, const CardReader& card) {
  auto rod = claimed_by<Rod>(builder, card);
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
  auto rod = claimed_by<Rod>(builder, card);
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

// A mass matrix along the axes of a system, its lower triangle row by row.
void read_conm1(DeckBuilder& builder, const CardReader& card) {
  PointMass mass;
  mass.id = card.id(1, "EID");
  builder.claim(card, mass.id);
  mass.grid = existing_grid(builder, card, 2);
  Eigen::Matrix<double, 6, 6> M = Eigen::Matrix<double, 6, 6>::Zero();
  std::size_t field = 4;
  for (Eigen::Index i = 0; i < 6; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j, ++field) {
      M(i, j) = M(j, i) = card.real_or(field, 0.0, "M");
    }
  }
  Eigen::Matrix<double, 6, 6> R = Eigen::Matrix<double, 6, 6>::Zero();
  const Eigen::Matrix3d axes =
      builder.system(card, card.integer_or(3, 0, "CID"))
          .directions(builder.grid(card, mass.grid).position);
  R.topLeftCorner<3, 3>() = R.bottomRightCorner<3, 3>() = axes;
  mass.matrix = R * M * R.transpose();
  builder.deck.masses.push_back(mass);
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

void read_plotel(DeckBuilder& builder, const CardReader& card) {
  builder.deck.plot_lines.push_back(
      {existing_grid(builder, card, 2), existing_grid(builder, card, 3)});
}

}  // namespace

CardTable element_cards() {
  const auto shell = [](const ShellFields& fields) {
    return [fields](DeckBuilder& b, const CardReader& c) {
      read_shell(b, c, fields);
    };
  };
  const ReadCard quad = shell({4, 0, 7, 8, 11, 10});
  const ReadCard triangle = shell({3, 0, 6, 7, 11, 10});
  return {{"CQUAD4", quad},
          {"CQUADR", quad},
          {"CQUAD8", shell({4, 4, 15, 16, 11, 17})},
          {"CTRIA3", triangle},
          {"CTRIAR", triangle},
          {"CTRIA6", shell({3, 3, 9, 10, 11, 14})},
          {"CSHEAR", read_panel},
          {"CBAR", read_bar},
          {"CBEAM", read_bar},
          {"CROD", read_crod},
          {"CTUBE", read_crod},
          {"CONROD", read_conrod},
          {"CONM1", read_conm1},
          {"CONM2", read_conm2},
          {"CBUSH", read_cbush},
          {"PLOTEL", read_plotel}};
}

}  // namespace tapfit::structure
