#include "updating/structure/edit/damping_table.hpp"

#include "updating/structure/cards/bulk_cards.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {
int free_table(const std::filesystem::path& deck) {
  int most = 0;
  for (const Card& card : read_bulk_data(deck).cards) {
    if (!card.name().starts_with("TAB") || card.fields.size() < 2) continue;
    most = std::max(most, parse_integer(card.fields[1]).value_or(0));
  }
  return most + 1;
}

std::vector<std::string> damping_table_cards(
    int id, const std::vector<std::array<double, 2>>& damping) {
  if (damping.empty()) return {};
  std::vector<std::array<double, 2>> table = damping;
  table.insert(table.begin(), {0.0, damping.front()[1]});
  table.push_back({2.0 * damping.back()[0], damping.back()[1]});
  std::vector<std::string> cards{
      fmt::format("$ measured damping, a ratio of critical by frequency; "
                  "responses take it by SDAMPING = {}",
                  id),
      fmt::format("TABDMP1,{},CRIT,,,,,,,+", id)};
  constexpr std::size_t pairs_in_line = 4;
  std::string line = "+";
  for (std::size_t k = 0; k < table.size(); ++k) {
    line +=
        fmt::format(",{},{}", card_real(table[k][0]), card_real(table[k][1]));
    if ((k + 1) % pairs_in_line == 0) {
      cards.push_back(line + ",+");
      line = "+";
    }
  }
  cards.push_back(line + ",ENDT");
  return cards;
}

std::vector<std::string> damping_comments(
    const std::vector<std::array<double, 2>>& damping) {
  if (damping.empty()) return {};
  std::vector<std::string> lines{
      "$ not written: the measured damping, which a step takes by *MODAL "
      "DAMPING",
      "$ frequency [Hz], ratio of critical"};
  for (const auto& [hz, ratio] : damping) {
    lines.push_back(fmt::format("$ {}, {}", card_real(hz), card_real(ratio)));
  }
  return lines;
}

}  // namespace tapfit::structure
