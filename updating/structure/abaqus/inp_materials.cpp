// *MATERIAL, *ELASTIC, *DENSITY; MAT1, MAT8, MAT9.
//
// Moduli of the deck count along (11, 22, 33, 12, 13, 23), those of MAT9 along
// (xx, yy, zz, xy, yz, zx).
// Source: Abaqus Keywords Reference Guide, *ELASTIC; CalculiX CrunchiX User's
// Manual, *ELASTIC; MSC Nastran Quick Reference Guide, MAT8, MAT9.
#include "updating/structure/abaqus/inp_deck.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace tapfit::structure {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

// How many moduli a type has.
const std::map<std::string, std::size_t>& counts() {
  static const std::map<std::string, std::size_t> known{
      {"ISOTROPIC", 2},
      {"ORTHOTROPIC", 9},
      {"ENGINEERINGCONSTANTS", 9},
      {"LAMINA", 6},
      {"ANISOTROPIC", 21}};
  return known;
}

std::string elastic_type(const Keyword& keyword) {
  std::string type = keyword.option("TYPE");
  std::erase(type, ' ');
  if (type.empty() || type == "ISO") return "ISOTROPIC";
  if (type == "ORTHO") return "ORTHOTROPIC";
  if (type == "ANISO") return "ANISOTROPIC";
  if (counts().contains(type)) return type;
  keyword.fail(fmt::format("TYPE={} is not read", type),
               "Use ISOTROPIC, ORTHOTROPIC, ENGINEERING CONSTANTS, LAMINA or "
               "ANISOTROPIC.");
}

// Moduli run over several lines of eight; the temperature follows them.
void read_elastic(InpDeck& deck, const Keyword& keyword, InpMaterial& m) {
  if (!m.type.empty()) return;  // of other steps or temperatures
  m.type = elastic_type(keyword);
  const std::size_t count = counts().at(m.type);
  std::size_t k = 0;
  while (m.moduli.size() < count) {
    const DataLine& line = keyword.line(k, "moduli");
    const std::size_t left = count - m.moduli.size();
    const std::size_t here = std::min<std::size_t>(left, 8);
    for (std::size_t at = 0; at < here; ++at) {
      // Poisson's ratio may be left out.
      const bool may = m.type == "ISOTROPIC" && at == 1;
      m.moduli.push_back(may ? number_or(line, at, 0.0, "modulus")
                             : number_in(line, at, "modulus"));
    }
    ++k;
  }
  if (k < keyword.lines.size()) {
    say(deck,
        keyword.place.where +
            ": of the temperatures of *ELASTIC the first is "
            "taken");
  }
}

// Compliance of engineering constants.
Matrix6d compliance(const std::vector<double>& c) {
  Matrix6d S = Matrix6d::Zero();
  S.diagonal() << 1.0 / c[0], 1.0 / c[1], 1.0 / c[2], 1.0 / c[6], 1.0 / c[7],
      1.0 / c[8];
  S(0, 1) = S(1, 0) = -c[3] / c[0];
  S(0, 2) = S(2, 0) = -c[4] / c[0];
  S(1, 2) = S(2, 1) = -c[5] / c[1];
  return S;
}

// Stiffness along (11, 22, 33, 12, 13, 23).
Matrix6d stiffness(const InpMaterial& m) {
  const std::vector<double>& c = m.moduli;
  if (m.type == "ENGINEERINGCONSTANTS") return compliance(c).inverse();
  Matrix6d D = Matrix6d::Zero();
  if (m.type == "ANISOTROPIC") {
    std::size_t k = 0;
    for (Eigen::Index column = 0; column < 6; ++column) {
      for (Eigen::Index row = 0; row <= column; ++row, ++k) {
        D(row, column) = D(column, row) = c[k];
      }
    }
    return D;
  }
  D.diagonal() << c[0], c[2], c[5], c[6], c[7], c[8];
  D(0, 1) = D(1, 0) = c[1];
  D(0, 2) = D(2, 0) = c[3];
  D(1, 2) = D(2, 1) = c[4];
  return D;
}

std::string density_field(const InpMaterial& m) {
  return m.density == 0.0 ? "" : real_field(m.density);
}

// The first moduli of these types are those of Young.
void check_moduli(const InpMaterial& m) {
  static const std::map<std::string, std::size_t> youngs{
      {"ISOTROPIC", 1}, {"ENGINEERINGCONSTANTS", 3}, {"LAMINA", 2}};
  const auto known = youngs.find(m.type);
  const std::size_t count = known == youngs.end() ? 0 : known->second;
  for (std::size_t k = 0; k < count; ++k) {
    if (m.moduli[k] > 0.0) continue;
    fail_at(
        m.place,
        fmt::format(
            "the modulus {:g} of {} is not above zero", m.moduli[k], m.name),
        "Correct *ELASTIC.");
  }
}

// E1, E2, nu12, G12, G13, G23.
std::vector<double> layer_moduli(const InpMaterial& m, const Place& asks) {
  if (m.type == "LAMINA") return m.moduli;
  if (m.type == "ENGINEERINGCONSTANTS") {
    const std::vector<double>& c = m.moduli;
    return {c[0], c[1], c[3], c[6], c[7], c[8]};
  }
  const Matrix6d S = stiffness(m).inverse();
  if (!(S.allFinite() && S(0, 0) > 0.0 && S(1, 1) > 0.0)) {
    fail_at(asks,
            "the moduli of " + m.name + " are no elastic material",
            "Correct *ELASTIC.");
  }
  return {1.0 / S(0, 0),
          1.0 / S(1, 1),
          -S(0, 1) / S(0, 0),
          1.0 / S(3, 3),
          1.0 / S(4, 4),
          1.0 / S(5, 5)};
}

std::vector<std::string> mat1_fields(const InpMaterial& m) {
  return {
      real_field(m.moduli[0]), "", real_field(m.moduli[1]), density_field(m)};
}

std::vector<std::string> mat8_fields(const InpMaterial& m, const Place& asks) {
  std::vector<std::string> fields;
  for (const double value : layer_moduli(m, asks)) {
    fields.push_back(real_field(value));
  }
  fields.push_back(density_field(m));
  return fields;
}

std::vector<std::string> mat9_fields(const InpMaterial& m) {
  static const std::vector<Eigen::Index> to_deck{0, 1, 2, 3, 5, 4};
  const Matrix6d D = stiffness(m)(to_deck, to_deck);
  std::vector<std::string> fields;
  for (Eigen::Index row = 0; row < 6; ++row) {
    for (Eigen::Index column = row; column < 6; ++column) {
      const double value = D(row, column);
      fields.push_back(value == 0.0 ? "" : real_field(value));
    }
  }
  fields.push_back(density_field(m));
  return fields;
}

InpMaterial* find_material(InpDeck& deck, const std::string& name) {
  const auto found =
      std::ranges::find(deck.materials, name, &InpMaterial::name);
  return found == deck.materials.end() ? nullptr : &*found;
}

InpMaterial& known_material(InpDeck& deck,
                            const std::string& name,
                            const Place& asks) {
  InpMaterial* m = find_material(deck, name);
  if (m == nullptr) {
    constexpr std::size_t most = 40;
    fail_at(asks,
            fmt::format("the material {} is not defined", name.substr(0, most)),
            "Define it by *MATERIAL, NAME=..., or correct the name.");
  }
  if (m->type.empty()) {
    fail_at(m->place,
            "the material " + m->name + " has no *ELASTIC",
            "Give its moduli by *ELASTIC.");
  }
  check_moduli(*m);
  return *m;
}

}  // namespace

void read_inp_materials(InpDeck& deck) {
  bool open = false;
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.step != 0) break;
    if (keyword.name == "MATERIAL") {
      const std::string name = keyword.needed_option("NAME");
      if (find_material(deck, name) != nullptr) {
        keyword.fail("a material of this name exists already",
                     "Rename one of the two.");
      }
      deck.materials.push_back({});
      deck.materials.back().name = name;
      deck.materials.back().place = keyword.place;
      open = true;
    } else if (open && keyword.name == "ELASTIC") {
      read_elastic(deck, keyword, deck.materials.back());
    } else if (open && keyword.name == "DENSITY") {
      deck.materials.back().density =
          number_in(keyword.line(0, "density"), 0, "density");
    }
  }
}

bool is_isotropic(const InpDeck& deck,
                  const std::string& name,
                  const Place& /*asks*/) {
  const auto found =
      std::ranges::find(deck.materials, name, &InpMaterial::name);
  return found == deck.materials.end() || found->type == "ISOTROPIC";
}

int material_card(InpDeck& deck,
                  const std::string& name,
                  const std::string& card,
                  const Place& asks) {
  InpMaterial& m = known_material(deck, name, asks);
  const bool isotropic = m.type == "ISOTROPIC";
  const std::string kind = isotropic ? "MAT1" : card;
  if (kind == "MAT1" && !isotropic) {
    fail_at(asks,
            fmt::format("the material {} is not isotropic", m.name),
            "Beams, trusses and membranes need TYPE=ISOTROPIC.");
  }
  if (kind == "MAT9" && m.type == "LAMINA") {
    fail_at(
        asks,
        fmt::format("the material {} is a LAMINA, which is for shells", m.name),
        "Give ENGINEERING CONSTANTS for solids.");
  }
  int& id = kind == "MAT1" ? m.plain : (kind == "MAT8" ? m.layer : m.solid);
  if (id != 0) return id;
  id = deck.next_material++;
  std::vector<std::string> fields = kind == "MAT1"   ? mat1_fields(m)
                                    : kind == "MAT8" ? mat8_fields(m, asks)
                                                     : mat9_fields(m);
  fields.insert(fields.begin(), fmt::format("{}", id));
  deck.cards.comment(fmt::format("{} {}: material {}", kind, id, m.name),
                     m.place);
  deck.cards.card(m.place, kind, fields);
  deck.named.push_back(fmt::format("{} {} is {}", kind, id, m.name));
  return id;
}

}  // namespace tapfit::structure
