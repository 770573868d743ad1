#include "updating/structure/edit/edit_cards.hpp"

#include "updating/structure/cards/card_defaults.hpp"

#include <fmt/format.h>

#include <algorithm>
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

std::vector<std::string> edit_cards(const std::filesystem::path& deck,
                                    const std::vector<CardEdit>& edits) {
  BulkData bulk = read_bulk_data(deck);
  fill_defaults(bulk);
  std::vector<std::vector<std::string>> below(bulk.lines.size());
  for (const Card& card : bulk.cards) {
    auto replacement = replaced(card, edits);
    if (!replacement) continue;
    for (const std::size_t k : card.lines) {
      bulk.lines[k] = "$ was: " + bulk.lines[k];
    }
    below[card.lines.back()] = std::move(*replacement);
  }
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < below.size(); ++k) {
    lines.push_back(std::move(bulk.lines[k]));
    lines.insert(lines.end(), below[k].begin(), below[k].end());
  }
  return lines;
}

}  // namespace tapfit::structure
