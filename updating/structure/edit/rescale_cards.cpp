#include "updating/structure/edit/rescale_cards.hpp"

#include "updating/structure/cards/bulk_numbers.hpp"

#include <fmt/format.h>

#include <utility>

namespace tapfit::structure {
namespace {

// Multiplies or sets what a scale names; false where there is no such number.
bool rescale(Card& card, const CardScale& scale) {
  bool changed = false;
  for (const std::size_t at : scale.fields) {
    if (scale.value) {
      if (at >= card.fields.size()) card.fields.resize(at + 1);
      card.fields[at] = fmt::format("{:.8E}", *scale.value);
      changed = true;
    }
    if (scale.value || at >= card.fields.size()) continue;
    const auto value = parse_real(card.fields[at]);
    if (!value) continue;
    card.fields[at] = fmt::format("{:.8E}", *value * scale.factor);
    changed = true;
  }
  return changed;
}

bool is_meant(const Card& card, const CardScale& scale) {
  return card.name() == scale.name && card.fields.size() > 1 &&
         parse_integer(card.fields[1]) == scale.id;
}

}  // namespace

Card rescaled(const Card& card,
              const std::vector<CardScale>& scales,
              std::vector<bool>& done) {
  Card scaled = card;
  for (std::size_t k = 0; k < scales.size(); ++k) {
    if (is_meant(card, scales[k]) && rescale(scaled, scales[k])) done[k] = true;
  }
  return scaled;
}

CardEdit rescale_cards(const std::vector<CardScale>& scales,
                       std::vector<bool>& done) {
  done.assign(scales.size(), false);
  return [&](const Card& card) -> std::optional<std::vector<Card>> {
    Card scaled = rescaled(card, scales, done);
    if (scaled.fields == card.fields) return std::nullopt;
    return std::vector<Card>{std::move(scaled)};
  };
}

}  // namespace tapfit::structure
