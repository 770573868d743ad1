#include "updating/structure/edit/edit_cards.hpp"

#include "updating/structure/cards/card_defaults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace tapfit::structure {
namespace {

constexpr std::size_t per_line = 4;  // fields of a large-field line

std::optional<std::vector<std::string>> replaced(
    const Card& card, const std::vector<CardEdit>& edits) {
  for (const CardEdit& edit : edits) {
    auto lines = edit(card);
    if (lines) return lines;
  }
  return std::nullopt;
}

}  // namespace

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

std::vector<std::string> EditedDeck::text() const {
  std::vector<std::string> all;
  auto next = replaced.begin();
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (next == replaced.end() || next->first != k) {
      all.push_back(lines[k]);
      continue;
    }
    all.insert(all.end(), next->second.begin(), next->second.end());
    ++next;
  }
  return all;
}

EditedDeck edit_deck(const std::filesystem::path& deck,
                     const std::vector<CardEdit>& edits) {
  BulkData bulk = read_bulk_data(deck);
  fill_defaults(bulk);
  EditedDeck edited;
  for (const Card& card : bulk.cards) {
    auto replacement = replaced(card, edits);
    if (!replacement) continue;
    for (const std::size_t k : card.lines) {
      edited.replaced[k] = {"$ was: " + bulk.lines[k]};
    }
    std::vector<std::string>& last = edited.replaced[card.lines.back()];
    std::ranges::move(*replacement, std::back_inserter(last));
  }
  edited.lines = std::move(bulk.lines);
  return edited;
}

std::vector<std::string> edit_cards(const std::filesystem::path& deck,
                                    const std::vector<CardEdit>& edits) {
  return edit_deck(deck, edits).text();
}

}  // namespace tapfit::structure
