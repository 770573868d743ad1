// MAT1, MAT2, MAT8, MAT9, MAT11.
#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace tapfit::structure {
namespace {

void refuse_negative_density(const CardReader& card, double rho) {
  if (!(rho >= 0.0)) {
    card.fail(fmt::format("RHO = {} is no density", rho),
              "Give a mass per volume of zero or more.");
  }
}

Material material_of(DeckBuilder& builder, const CardReader& card) {
  return defined_by<Material>(builder, card, "material", "MID");
}

void warn_disagreement(DeckBuilder& builder,
                       const CardReader& card,
                       const Material& m) {
  const double implied = m.E / (2.0 * (1.0 + m.nu));
  if (std::abs(m.G - implied) > 0.01 * m.G) {
    builder.warn(card,
                 fmt::format("E, G and NU do not agree, E / (2 (1 + NU)) is "
                             "{:.4g}: shear and twist go with G, all else with "
                             "E and NU",
                             implied));
  }
  if (m.nu < 0.0) {
    builder.warn(card, fmt::format("NU = {:.4g} is unusual", m.nu));
  }
}

void read_mat1(DeckBuilder& builder, const CardReader& card) {
  Material m = material_of(builder, card);
  m.E = card.real_or(2, 0.0, "E");
  m.G = card.real_or(3, 0.0, "G");
  m.nu = card.real_or(4, 0.0, "NU");
  m.rho = card.real_or(5, 0.0, "RHO");
  if (card.blank(2) && card.blank(3)) {
    card.fail("neither E nor G is given", "Give two of E, G and NU.");
  }
  if (card.blank(2)) m.E = 2.0 * m.G * (1.0 + m.nu);
  if (card.blank(3)) m.G = m.E / (2.0 * (1.0 + m.nu));
  const bool both = !card.blank(2) && !card.blank(3);
  if (card.blank(4) && both && m.G > 0.0) m.nu = m.E / (2.0 * m.G) - 1.0;
  if (card.blank(4) && !both) {
    builder.warn(card, "only one of E, G, NU is given; NU = 0 is used");
  }
  refuse_negative_density(card, m.rho);
  const bool odd = m.nu <= -1.0 || m.nu > 0.5;
  if (!(m.E >= 0.0) || m.G < 0.0 || (odd && !both)) {
    card.fail(
        fmt::format(
            "E = {}, G = {}, NU = {} is no elastic material", m.E, m.G, m.nu),
        "Give two of E, G and NU, positive, NU 0.5 at most.");
  }
  if (odd) {
    builder.odd_materials.insert(m.id);
  } else {
    warn_disagreement(builder, card, m);
  }
  builder.deck.materials[m.id] = m;
}

void read_mat8(DeckBuilder& builder, const CardReader& card) {
  Material m = material_of(builder, card);
  m.orthotropic = true;
  m.E = card.real(2, "E1");
  m.E2 = card.real(3, "E2");
  m.nu = card.real_or(4, 0.0, "NU12");
  m.G = card.real(5, "G12");
  m.G1z = card.real_or(6, 0.0, "G1Z");
  m.G2z = card.real_or(7, 0.0, "G2Z");
  m.rho = card.real_or(8, 0.0, "RHO");
  if (m.E <= 0.0 || m.E2 <= 0.0 || m.G <= 0.0 || m.nu * m.nu * m.E2 >= m.E) {
    const bool exchanged =
        std::min({m.E, m.E2, m.G}) > 0.0 && m.nu * m.nu * m.E < m.E2;
    card.fail(
        fmt::format(
            "E1 = {}, E2 = {}, NU12 = {}, G12 = {} is no elastic material",
            m.E,
            m.E2,
            m.nu,
            m.G),
        exchanged
            ? "NU12^2 must be below E1/E2: are E1 and E2 exchanged?"
            : "E1, E2 and G12 must be above zero, and NU12^2 below E1/E2.");
  }
  refuse_negative_density(card, m.rho);
  builder.deck.materials[m.id] = m;
}

// The upper triangle, row by row, from a field on.
Eigen::MatrixXd symmetric(const CardReader& card,
                          std::size_t first,
                          Eigen::Index size) {
  Eigen::MatrixXd G(size, size);
  std::size_t field = first;
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = i; j < size; ++j, ++field) {
      G(i, j) = G(j, i) = card.real_or(field, 0.0, "G");
    }
  }
  return G;
}

void refuse_indefinite(const CardReader& card, const Eigen::MatrixXd& G) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      G, Eigen::EigenvaluesOnly);
  const double least = solver.eigenvalues()(0);
  const double most = solver.eigenvalues()(G.rows() - 1);
  if (most > 0.0 && least >= -1e-9 * most) return;
  card.fail("the moduli Gij are no elastic material: some strain has no energy",
            "Correct them; the matrix must be positive.");
}

void read_mat2(DeckBuilder& builder, const CardReader& card) {
  Material m = material_of(builder, card);
  m.plane = symmetric(card, 2, 3);
  refuse_indefinite(card, m.plane);
  m.E = m.plane(0, 0);
  m.G = m.plane(2, 2);
  m.rho = card.real_or(8, 0.0, "RHO");
  refuse_negative_density(card, m.rho);
  builder.deck.materials[m.id] = m;
}

void add_solid(DeckBuilder& builder,
               const CardReader& card,
               Material m,
               std::size_t density) {
  refuse_indefinite(card, m.solid);
  m.E = m.solid(0, 0);
  m.G = m.solid(3, 3);
  m.rho = card.real_or(density, 0.0, "RHO");
  refuse_negative_density(card, m.rho);
  builder.deck.materials[m.id] = m;
}

void read_mat9(DeckBuilder& builder, const CardReader& card) {
  Material m = material_of(builder, card);
  m.solid = symmetric(card, 2, 6);
  add_solid(builder, card, m, 23);
}

void read_mat11(DeckBuilder& builder, const CardReader& card) {
  Material m = material_of(builder, card);
  const Eigen::Vector3d E(
      card.real(2, "E1"), card.real(3, "E2"), card.real(4, "E3"));
  const Eigen::Vector3d G(
      card.real(8, "G12"), card.real(10, "G23"), card.real(9, "G13"));
  if (!(E.minCoeff() > 0.0 && G.minCoeff() > 0.0)) {
    card.fail("a modulus is not above zero", "Correct E1 to E3, G12 to G23.");
  }
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(6, 6);  // compliance
  S.diagonal() << E.cwiseInverse(), G.cwiseInverse();
  S(0, 1) = S(1, 0) = -card.real(5, "NU12") / E(0);
  S(0, 2) = S(2, 0) = -card.real(6, "NU13") / E(0);
  S(1, 2) = S(2, 1) = -card.real(7, "NU23") / E(1);
  m.solid = S.inverse();
  add_solid(builder, card, m, 11);
}

// Materials of elements that need NU: all but bars and rods.
std::set<int> plated(const Deck& deck) {
  std::set<int> ids;
  for (const Shell& e : deck.shells) {
    const auto p = deck.shell_properties.find(e.property);
    if (p == deck.shell_properties.end() || p->second.panel) continue;
    const ShellProperty& own = p->second;
    ids.insert({own.membrane, own.bending, own.coupling});
    for (const Ply& ply : own.plies) ids.insert(ply.material);
  }
  for (const Solid& e : deck.solids) {
    const auto p = deck.solid_properties.find(e.property);
    if (p != deck.solid_properties.end()) ids.insert(p->second.material);
  }
  return ids;
}

}  // namespace

CardTable material_cards() {
  return {{"MAT1", read_mat1},
          {"MAT2", read_mat2},
          {"MAT8", read_mat8},
          {"MAT9", read_mat9},
          {"MAT11", read_mat11}};
}

void check_odd_materials(DeckBuilder& builder) {
  const std::set<int> used = plated(builder.deck);
  for (const int id : builder.odd_materials) {
    const Material& m = builder.deck.materials.at(id);
    const std::string what =
        fmt::format("E = {}, G = {}, NU = {:.6g}", m.E, m.G, m.nu);
    if (used.contains(id)) {
      throw InputError(
          what + " is no elastic material",
          m.where,
          "Give two of E, G and NU, positive, NU 0.5 at most; only bars and "
          "rods take an E and G that do not belong together.");
    }
    builder.deck.warnings.push_back(
        fmt::format("{}: {} is no solid's; bars and rods take E and G as they "
                    "are",
                    m.where,
                    what));
  }
}

}  // namespace tapfit::structure
