#include "updating/structure/edit/card_difference.hpp"

#include "updating/structure/cards/bulk_cards.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace tapfit::structure {
namespace {

// Blanks at a card's end say nothing.
std::string text_of(const Card& card) {
  std::size_t count = card.fields.size();
  while (count > 1 && card.fields[count - 1].empty()) --count;
  return fmt::format(
      "{}",
      fmt::join(card.fields.begin(),
                card.fields.begin() + static_cast<std::ptrdiff_t>(count),
                ","));
}

// Numbers by their value: 7.+10 is 7.0E10.
std::string meaning_of(const Card& card) {
  Card same = card;
  for (std::size_t k = 1; k < same.fields.size(); ++k) {
    const std::optional<double> number = parse_real(same.fields[k]);
    if (number) same.fields[k] = fmt::format("{:.12g}", *number);
  }
  return text_of(same);
}

std::string title_of(const Card& card) {
  const bool named = card.fields.size() > 1 && !card.fields[1].empty();
  return named ? card.name() + " " + card.fields[1] : card.name();
}

}  // namespace

std::vector<CardChange> card_difference(const std::filesystem::path& before,
                                        const std::filesystem::path& after) {
  const std::vector<Card> old = read_bulk_data(before).cards;
  const std::vector<Card> now = read_bulk_data(after).cards;
  std::multiset<std::string> left;
  for (const Card& card : old) left.insert(meaning_of(card));
  std::map<std::string, std::deque<const Card*>> fresh;  // by title
  std::vector<const Card*> order;
  for (const Card& card : now) {
    if (const auto same = left.find(meaning_of(card)); same != left.end()) {
      left.erase(same);
      continue;
    }
    fresh[title_of(card)].push_back(&card);
    order.push_back(&card);
  }
  std::vector<CardChange> changes;
  std::set<const Card*> paired;
  for (const Card& card : old) {
    const auto gone = left.find(meaning_of(card));
    if (gone == left.end()) continue;
    left.erase(gone);
    CardChange change{title_of(card), card.where, text_of(card), {}};
    std::deque<const Card*>& others = fresh[change.card];
    if (!others.empty()) {
      change.after = text_of(*others.front());
      paired.insert(others.front());
      others.pop_front();
    }
    changes.push_back(std::move(change));
  }
  for (const Card* card : order) {
    if (paired.contains(card)) continue;
    changes.push_back({title_of(*card), card->where, {}, text_of(*card)});
  }
  return changes;
}

}  // namespace tapfit::structure
