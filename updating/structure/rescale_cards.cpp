#include "updating/structure/rescale_cards.hpp"

#include "updating/structure/bulk_cards.hpp"

#include <fmt/format.h>

namespace tapfit::structure {
namespace {

constexpr std::size_t per_line = 4;  // fields of a large-field line

// Multiplies what the scales name; false when none of them means this card.
bool rescale(Card& card,
             const std::vector<CardScale>& scales,
             std::vector<bool>& done) {
  bool changed = false;
  for (std::size_t k = 0; k < scales.size(); ++k) {
    const CardScale& scale = scales[k];
    const bool meant = card.name() == scale.name && card.fields.size() > 1 &&
                       parse_integer(card.fields[1]) == scale.id;
    if (!meant) continue;
    for (const std::size_t at : scale.fields) {
      if (at >= card.fields.size()) continue;
      const auto value = parse_real(card.fields[at]);
      if (!value) continue;
      card.fields[at] = fmt::format("{:.8E}", *value * scale.factor);
      done[k] = true;
    }
    changed = changed || done[k];
  }
  return changed;
}

std::vector<std::string> large_field(const Card& card) {
  std::size_t end = card.fields.size();
  while (end > 1 && card.fields[end - 1].empty()) --end;
  std::vector<std::string> lines;
  for (std::size_t at = 1; at < end; at += per_line) {
    std::string line = fmt::format("{:<8}", at == 1 ? card.name() + "*" : "*");
    for (std::size_t k = at; k < std::min(at + per_line, end); ++k) {
      line += fmt::format("{:>16}", card.fields[k]);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

RescaledDeck rescale_cards(const std::filesystem::path& deck,
                           const std::vector<CardScale>& scales) {
  BulkData bulk = read_bulk_data(deck);
  std::vector<bool> done(scales.size(), false);
  // From the end, so that earlier lines keep their places.
  for (auto card = bulk.cards.rbegin(); card != bulk.cards.rend(); ++card) {
    if (!rescale(*card, scales, done)) continue;
    for (std::size_t k = card->first; k <= card->last; ++k) {
      bulk.lines[k] = "$ was: " + bulk.lines[k];
    }
    const std::vector<std::string> lines = large_field(*card);
    bulk.lines.insert(
        bulk.lines.begin() + static_cast<std::ptrdiff_t>(card->last) + 1,
        lines.begin(),
        lines.end());
  }
  return {std::move(bulk.lines), std::move(done)};
}

}  // namespace tapfit::structure
