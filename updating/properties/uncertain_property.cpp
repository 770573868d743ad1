#include "updating/properties/uncertain_property.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/system.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::updating {
namespace {

using acquisition::UncertainProperty;
using structure::Deck;
using structure::Material;

constexpr int rational = 4;

struct Field {
  double* value = nullptr;
  std::string unit;
  std::string known;  ///< what the card has, for messages
};

Field material_field(Material& m, const std::string& property) {
  Field field{nullptr, "Pa", "E, rho, nu"};
  const bool general = m.is_plane() || m.is_solid();
  if (general) field.known = "E, rho";
  if (m.orthotropic) field.known += ", E1, E2, G12";
  if (property == "E" || (m.orthotropic && property == "E1")) {
    field.value = &m.E;
  } else if (property == "rho") {
    field = {&m.rho, "kg/m^3", field.known};
  } else if (property == "nu" && !general) {
    field = {&m.nu, "1", field.known};
  } else if (m.orthotropic && property == "E2") {
    field.value = &m.E2;
  } else if (m.orthotropic && property == "G12") {
    field.value = &m.G;
  }
  return field;
}

Field bar_field(structure::BarProperty& p, const std::string& property) {
  const std::string known = "A, I1, I2, J";
  if (property == "A") return {&p.area, "m^2", known};
  if (property == "I1") return {&p.I1, "m^4", known};
  if (property == "I2") return {&p.I2, "m^4", known};
  if (property == "J") return {&p.J, "m^4", known};
  return {nullptr, "", known};
}

Field rod_field(structure::RodProperty& p, const std::string& property) {
  if (property == "A") return {&p.area, "m^2", "A, J"};
  if (property == "J") return {&p.J, "m^4", "A, J"};
  return {nullptr, "", "A, J"};
}

// An empty `known` where the deck has no such card.
Field find_field(Deck& deck, const UncertainProperty& u) {
  if (u.card == "material") {
    const auto found = deck.materials.find(u.id);
    if (found == deck.materials.end()) return {};
    return material_field(found->second, u.property);
  }
  if (const auto p = deck.shell_properties.find(u.id);
      p != deck.shell_properties.end()) {
    return {u.property == "t" ? &p->second.thickness : nullptr, "m", "t"};
  }
  if (const auto p = deck.bar_properties.find(u.id);
      p != deck.bar_properties.end()) {
    return bar_field(p->second, u.property);
  }
  if (const auto p = deck.rod_properties.find(u.id);
      p != deck.rod_properties.end()) {
    return rod_field(p->second, u.property);
  }
  return {};
}

Field checked_field(Deck& deck,
                    const UncertainProperty& u,
                    const std::string& place) {
  Field field = find_field(deck, u);
  const bool material = u.card == "material";
  if (field.known.empty()) {
    throw InputError(fmt::format("the deck has no {} {}", u.card, u.id),
                     place,
                     material ? "name a MAT card of the deck"
                              : "name a property of a shell, bar or rod of "
                                "the deck");
  }
  if (field.value == nullptr) {
    throw InputError(
        fmt::format("property \"{}\" cannot be fitted", u.property),
        place,
        "use one of " + field.known);
  }
  if (*field.value == 0.0) {
    throw InputError(fmt::format("{} of {} {} is 0", u.property, u.card, u.id),
                     place,
                     "give the deck a value to start from");
  }
  return field;
}

// Whether a bar's stiffness is a sum of terms in A, I1, I2 and J.
bool is_linear_bar(const Deck& deck, int property) {
  const structure::BarProperty& p = deck.bar_properties.at(property);
  return p.K1 == 0.0 && p.K2 == 0.0 && p.I12 == 0.0 &&
         std::none_of(
             deck.bars.begin(), deck.bars.end(), [property](const auto& bar) {
               return bar.property == property &&
                      !(bar.released[0].empty() && bar.released[1].empty());
             });
}

// Whether shells have the material beside others: what they share out then is
// no sum of terms in each.
bool shares_shells(const Deck& deck, int material) {
  const auto shares = [material](const auto& entry) {
    const structure::ShellProperty& p = entry.second;
    std::set<int> all{p.membrane, p.bending, p.shear, p.coupling};
    for (const structure::Ply& ply : p.plies) all.insert(ply.material);
    all.erase(0);
    return all.contains(material) && all.size() > 1;
  };
  return std::any_of(
      deck.shell_properties.begin(), deck.shell_properties.end(), shares);
}

// Quadratic shells give what is stiff in shear a share of the membrane's.
bool has_mids(const Deck& deck, int property) {
  return std::any_of(
      deck.shells.begin(), deck.shells.end(), [property](const auto& e) {
        return e.property == property && !e.mids.empty();
      });
}

void set_degrees(const Deck& deck,
                 const UncertainProperty& u,
                 PropertyLaw& law) {
  if (u.card == "material") {
    const bool linear = u.property == "E" && !shares_shells(deck, u.id);
    law.stiffness_degree = linear ? 1 : rational;
    if (u.property == "rho") {
      law.stiffness_degree = 0;
      law.mass_degree = 1;
    }
  } else if (u.property == "t") {
    const structure::ShellProperty& p = deck.shell_properties.at(u.id);
    // The elements' shear, and inner modes that bend with the plane.
    const bool sheared = p.shear != 0 || p.coupling != 0 || !p.plies.empty();
    law.stiffness_degree = sheared || has_mids(deck, u.id) ? rational : 3;
    law.mass_degree = 3;
  } else {
    const bool linear =
        deck.rod_properties.contains(u.id) || is_linear_bar(deck, u.id);
    law.stiffness_degree = law.mass_degree = linear ? 1 : rational;
  }
}

template <class Element>
void collect(const std::vector<Element>& elements,
             int property,
             std::set<int>& ids) {
  for (const Element& e : elements) {
    if (e.property == property) ids.insert(e.id);
  }
}

// The one material of a model given as matrices is all of it.
void check_given(const UncertainProperty& u, const std::string& place) {
  const bool known = u.property == "E" || u.property == "rho";
  if (u.card == "material" && u.id == 1 && known) return;
  throw InputError("the model is given as matrices, which have no such card",
                   place,
                   "use material 1: E for all of the stiffness, rho for all of "
                   "the mass");
}

}  // namespace

PropertyLaw property_law(const Deck& deck,
                         const UncertainProperty& u,
                         const std::string& place) {
  if (deck.given) check_given(u, place);
  Deck cards;
  cards.materials = deck.materials;
  cards.shell_properties = deck.shell_properties;
  cards.bar_properties = deck.bar_properties;
  cards.rod_properties = deck.rod_properties;
  const Field field = checked_field(cards, u, place);
  PropertyLaw law;
  law.name = fmt::format("{}:{}", u.property, u.id);
  law.unit = deck.given ? "of what is given" : field.unit;
  law.nominal = *field.value;
  set_degrees(deck, u, law);
  if (u.card == "material") {
    const std::vector<int> ids = structure::elements_of_material(deck, u.id);
    law.elements = {ids.begin(), ids.end()};
  } else {
    collect(deck.shells, u.id, law.elements);
    collect(deck.bars, u.id, law.elements);
    collect(deck.rods, u.id, law.elements);
    collect(deck.solids, u.id, law.elements);
  }
  return law;
}

void scale_property(Deck& deck, const UncertainProperty& u, double factor) {
  *find_field(deck, u).value *= factor;
  if (u.card != "material") return;
  Material& m = deck.materials.at(u.id);
  if (u.property == "E") {
    for (double* modulus : {&m.G, &m.E2, &m.G1z, &m.G2z}) *modulus *= factor;
    m.plane *= factor;
    m.solid *= factor;
  }
  if (u.property == "nu" && !m.orthotropic) m.G = m.E / (2.0 * (1.0 + m.nu));
}

}  // namespace tapfit::updating
