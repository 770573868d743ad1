#include "updating/set_up/card_slip.hpp"

#include "updating/properties/uncertain_property.hpp"
#include "updating/structure/assembly/assemble.hpp"

#include <set>
#include <utility>

namespace tapfit::updating {
namespace {

using structure::Deck;

template <typename Element>
void collect(const std::vector<Element>& all,
             int property,
             std::set<int>& ids) {
  for (const Element& e : all) {
    if (e.property == property) ids.insert(e.id);
  }
}

std::set<int> elements_with(const Deck& deck,
                            const acquisition::UncertainProperty& number) {
  if (number.card == "material") {
    const std::vector<int> ids =
        structure::elements_of_material(deck, number.id);
    return {ids.begin(), ids.end()};
  }
  std::set<int> ids;
  collect(deck.shells, number.id, ids);
  collect(deck.bars, number.id, ids);
  collect(deck.rods, number.id, ids);
  return ids;
}

}  // namespace

ScaledNumber scaled_number(const std::string& card,
                           int id,
                           const std::string& property,
                           double factor) {
  ScaledNumber result;
  result.number.card = card;
  result.number.id = id;
  result.number.property = property;
  result.factor = factor;
  return result;
}

CardSlip slip_of(const structure::Deck& deck,
                 const std::string& what,
                 const std::string& kind,
                 std::vector<ScaledNumber> numbers) {
  std::set<int> elements;
  for (const ScaledNumber& one : numbers) {
    elements.merge(elements_with(deck, one.number));
  }
  return {"model: " + what,
          {elements.begin(), elements.end()},
          kind,
          std::move(numbers)};
}

std::string card_name(const std::string& where, const std::string& other) {
  const std::size_t space = where.find(' ');
  return space == std::string::npos ? other : where.substr(space + 1);
}

void put_right(structure::Deck& deck, const CardSlip& slip) {
  for (const ScaledNumber& one : slip.numbers) {
    scale_property(deck, one.number, one.factor);
  }
}

}  // namespace tapfit::updating
