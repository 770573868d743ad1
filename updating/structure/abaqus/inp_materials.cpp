// *MATERIAL, *ELASTIC, *DENSITY; MAT1, MAT8, MAT9.
//
// Moduli of the deck count along (11, 22, 33, 12, 13, 23), those of MAT9 along
// (xx, yy, zz, xy, yz, zx).
// Source: Abaqus Keywords Reference Guide, *ELASTIC; CalculiX CrunchiX User's
// Manual, *ELASTIC; MSC Nastran Quick Reference Guide, MAT8, MAT9.
#include "updating/structure/abaqus/inp_deck.hpp"

#include <Eigen/Dense>

#include <algorithm>

namespace tapfit::structure {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

// How many moduli a type has.
const std::map<std::string, std::size_t> counts{{"ISOTROPIC", 2},
                                                {"ORTHOTROPIC", 9},
                                                {"ENGINEERINGCONSTANTS", 9},
                                                {"LAMINA", 6},
                                                {"ANISOTROPIC", 21}};

std::string elastic_type(const Keyword& keyword) {
  std::string type = keyword.option("TYPE");
  std::erase(type, ' ');
  if (type.empty() || type == "ISO") return "ISOTROPIC";
  if (type == "ORTHO") return "ORTHOTROPIC";
  if (type == "ANISO") return "ANISOTROPIC";
  if (counts.contains(type)) return type;
  keyword.fail(fmt::format("TYPE={} is not read", shortened(type)),
               "Use ISOTROPIC, ORTHOTROPIC, ENGINEERING CONSTANTS, LAMINA or "
               "ANISOTROPIC.");
}

// Moduli run over several lines of eight; the temperature follows them.
void read_elastic(InpDeck& deck, const Keyword& keyword, InpMaterial& m) {
  if (!m.type.empty()) return;
  m.type = elastic_type(keyword);
  const std::size_t count = counts.at(m.type);
  std::size_t k = 0;
  while (m.moduli.size() < count) {
    const DataLine& line = keyword.line(k++, "moduli");
    const std::size_t here = std::min<std::size_t>(count - m.moduli.size(), 8);
    for (std::size_t at = 0; at < here; ++at) {
      // Poisson's ratio may be left out.
      const bool may = m.type == "ISOTROPIC" && at == 1;
      m.moduli.push_back(may ? number_or(line, at, 0.0, "modulus")
                             : number_in(line, at, "modulus"));
    }
  }
  if (k < keyword.lines.size()) {
    deck.say(keyword.place.where +
             ": of the temperatures of *ELASTIC the first is taken");
  }
}

// Of engineering constants E1, E2, E3, nu12, nu13, nu23, G12, G13, G23.
Matrix6d compliance(const std::vector<double>& c) {
  Matrix6d S = Matrix6d::Zero();
  S.diagonal() << 1.0 / c[0], 1.0 / c[1], 1.0 / c[2], 1.0 / c[6], 1.0 / c[7],
      1.0 / c[8];
  S(0, 1) = S(1, 0) = -c[3] / c[0];
  S(0, 2) = S(2, 0) = -c[4] / c[0];
  S(1, 2) = S(2, 1) = -c[5] / c[1];
  return S;
}

// Upper triangle column by column.
Matrix6d anisotropic(const std::vector<double>& c) {
  Matrix6d D = Matrix6d::Zero();
  std::size_t k = 0;
  for (Eigen::Index column = 0; column < 6; ++column) {
    for (Eigen::Index row = 0; row <= column; ++row) {
      D(row, column) = D(column, row) = c[k++];
    }
  }
  return D;
}

// D1111, D1122, D2222, D1133, D2233, D3333, D1212, D1313, D2323.
Matrix6d orthotropic(const std::vector<double>& c) {
  std::vector<double> all(21, 0.0);
  std::copy_n(c.begin(), 6, all.begin());
  all[9] = c[6];
  all[14] = c[7];
  all[20] = c[8];
  return anisotropic(all);
}

[[noreturn]] void refuse_moduli(const InpMaterial& m, const std::string& name) {
  fail_at(m.place,
          fmt::format("the moduli of {} are those of no elastic material",
                      shortened(name)),
          "Correct *ELASTIC: moduli are above zero, ratios below its limits.");
}

// Stiffness along (11, 22, 33, 12, 13, 23).
Matrix6d stiffness(const InpMaterial& m, const std::string& name) {
  Matrix6d D;
  if (m.type == "ENGINEERINGCONSTANTS") {
    D = compliance(m.moduli).inverse();
  } else {
    D = m.type == "ANISOTROPIC" ? anisotropic(m.moduli) : orthotropic(m.moduli);
  }
  if (!D.allFinite() || D.llt().info() != Eigen::Success) {
    refuse_moduli(m, name);
  }
  return D;
}

CardFields mat1_fields(const InpMaterial& m, const std::string& name) {
  if (!(m.moduli[0] > 0.0)) refuse_moduli(m, name);
  return {m.moduli[0], "", m.moduli[1], m.density};
}

// E1, E2, nu12, G12, G1z, G2z.
CardFields mat8_fields(const InpMaterial& m, const std::string& name) {
  std::vector<double> c = m.moduli;
  if (m.type != "LAMINA") {
    const Matrix6d S = stiffness(m, name).inverse();
    c = {1.0 / S(0, 0),
         1.0 / S(1, 1),
         -S(0, 1) / S(0, 0),
         1.0 / S(3, 3),
         1.0 / S(4, 4),
         1.0 / S(5, 5)};
  }
  if (!(c[0] > 0.0 && c[1] > 0.0 && c[3] > 0.0)) refuse_moduli(m, name);
  CardFields fields(c.begin(), c.end());
  fields.emplace_back(m.density);
  return fields;
}

CardFields mat9_fields(const InpMaterial& m, const std::string& name) {
  static const std::vector<Eigen::Index> to_deck{0, 1, 2, 3, 5, 4};
  const Matrix6d D = stiffness(m, name)(to_deck, to_deck);
  CardFields fields;
  for (Eigen::Index row = 0; row < 6; ++row) {
    for (Eigen::Index column = row; column < 6; ++column) {
      fields.emplace_back(D(row, column));
    }
  }
  fields.emplace_back(m.density);
  return fields;
}

}  // namespace

void read_inp_materials(InpDeck& deck) {
  InpMaterial* open = nullptr;
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.step != 0) break;
    if (keyword.name == "MATERIAL") {
      const auto [added, fresh] =
          deck.materials.try_emplace(keyword.needed_option("NAME"));
      if (!fresh) {
        keyword.fail("a material of this name exists already",
                     "Rename one of the two.");
      }
      open = &added->second;
      open->place = keyword.place;
    } else if (open != nullptr && keyword.name == "ELASTIC") {
      read_elastic(deck, keyword, *open);
    } else if (open != nullptr && keyword.name == "DENSITY") {
      open->density = number_in(keyword.line(0, "density"), 0, "density");
    }
  }
}

bool is_isotropic(const InpDeck& deck, const std::string& name) {
  const auto found = deck.materials.find(name);
  return found == deck.materials.end() || found->second.type == "ISOTROPIC";
}

int material_card(InpDeck& deck,
                  const std::string& name,
                  const std::string& card,
                  const Place& asks) {
  InpMaterial& m = named_in(deck.materials, name, "material", asks);
  if (m.type.empty()) {
    fail_at(m.place,
            fmt::format("the material {} has no *ELASTIC", shortened(name)),
            "Give its moduli by *ELASTIC.");
  }
  const bool isotropic = m.type == "ISOTROPIC";
  if (card == "MAT1" && !isotropic) {
    fail_at(asks,
            fmt::format("the material {} is not isotropic", shortened(name)),
            "Beams, trusses and membranes need TYPE=ISOTROPIC.");
  }
  if (card == "MAT9" && m.type == "LAMINA") {
    fail_at(asks,
            fmt::format("the material {} is a LAMINA, which is for shells",
                        shortened(name)),
            "Give ENGINEERING CONSTANTS for solids.");
  }
  const std::string kind = isotropic ? "MAT1" : card;
  const auto [known, fresh] = m.ids.try_emplace(kind, deck.next_material);
  if (!fresh) return known->second;
  CardFields fields = kind == "MAT1"   ? mat1_fields(m, name)
                      : kind == "MAT8" ? mat8_fields(m, name)
                                       : mat9_fields(m, name);
  fields.insert(fields.begin(), deck.next_material);
  deck.name_card(kind, deck.next_material, name, m.place);
  deck.cards.card(m.place, kind, fields);
  return deck.next_material++;
}

}  // namespace tapfit::structure
