#include "updating/uncertain_parts.hpp"

#include "acquisition/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::updating {

std::vector<UncertainPart> uncertain_parts(
    const structure::Deck& deck,
    const std::vector<acquisition::UncertainProperty>& uncertain) {
  std::vector<UncertainPart> parts;
  for (std::size_t k = 0; k < uncertain.size(); ++k) {
    const acquisition::UncertainProperty& u = uncertain[k];
    const std::string place = fmt::format("test.json: uncertain[{}]", k);
    const auto material = deck.materials.find(u.id);
    if (u.card != "material" || material == deck.materials.end()) {
      throw InputError(fmt::format("the deck has no {} {}", u.card, u.id),
                       place,
                       "name a MAT1 or MAT8 of the deck");
    }
    const bool twice =
        std::any_of(uncertain.begin(),
                    uncertain.begin() + static_cast<std::ptrdiff_t>(k),
                    [&u](const auto& other) {
                      return other.id == u.id && other.property == u.property &&
                             other.card == u.card;
                    });
    if (twice) {
      throw InputError(
          fmt::format("{} of {} {} is listed twice", u.property, u.card, u.id),
          place,
          "keep one of the two");
    }
    const bool stiffness = u.property == "E";
    if (!stiffness && u.property != "rho") {
      throw InputError(
          fmt::format("property \"{}\" cannot be fitted", u.property),
          place,
          "use \"E\" or \"rho\"");
    }
    const std::vector<int> ids = structure::elements_of_material(deck, u.id);
    UncertainPart part;
    part.elements = {ids.begin(), ids.end()};
    const auto wanted = [&part](int id) { return part.elements.contains(id); };
    part.name = fmt::format("{}:{}", u.property, u.id);
    part.unit = stiffness ? "Pa" : "kg/m^3";
    part.nominal = stiffness ? material->second.E : material->second.rho;
    part.sd = u.sd_percent / 100.0;
    const auto n = static_cast<Eigen::Index>(6 * deck.grids.size());
    part.K.resize(n, n);
    part.M.resize(n, n);
    if (stiffness) {
      part.K = structure::assemble_stiffness(deck, wanted);
    } else {
      part.M = structure::assemble_mass(deck, wanted);
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace tapfit::updating
