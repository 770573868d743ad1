#include "updating/structure/edit/card_difference.hpp"

#include "updating/structure/abaqus/keyword_shapes.hpp"
#include "updating/structure/cards/bulk_cards.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/cards/deck_source.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace tapfit::structure {
namespace {

using Fields = std::vector<std::string>;

struct Said {
  std::string title;
  std::string where;
  std::string text;
  std::string meaning;  // the same where it is written otherwise
};

// Blanks at a card's end say nothing.
std::string joined(const Fields& fields, const char* between) {
  std::size_t count = fields.size();
  while (count > 1 && fields[count - 1].empty()) --count;
  const auto end = fields.begin() + static_cast<std::ptrdiff_t>(count);
  return fmt::format("{}", fmt::join(fields.begin(), end, between));
}

// Numbers by their value: 7.+10 is 7.0E10.
std::string meaning_of(Fields fields) {
  for (std::string& field : fields) {
    const std::optional<double> number = parse_real(field);
    if (number) field = fmt::format("{:.12g}", *number);
  }
  return joined(fields, ",");
}

std::vector<Said> said_by_cards(const std::filesystem::path& deck) {
  std::vector<Said> all;
  for (const Card& card : read_bulk_data(deck).cards) {
    const bool named = card.fields.size() > 1 && !card.fields[1].empty();
    all.push_back({named ? card.name() + " " + card.fields[1] : card.name(),
                   card.where,
                   joined(card.fields, ","),
                   meaning_of(card.fields)});
  }
  return all;
}

// Lines of data are called by what stands first in them, as cards are, or by
// their material.
std::string title_of(const Keyword& keyword,
                     const DataLine& line,
                     const std::string& material) {
  const std::string name = "*" + keyword.shown;
  const bool by_id = keyword.name == "NODE" || keyword.name == "ELEMENT" ||
                     keyword.name == "BOUNDARY";
  if (by_id) return name + " " + line.text(0);
  const bool of_material =
      keyword.name == "ELASTIC" || keyword.name == "DENSITY";
  return of_material ? name + " " + material : name;
}

std::vector<Said> said_by_keywords(const std::filesystem::path& deck) {
  std::vector<Said> all;
  std::string material;
  for (const Keyword& keyword : keyword_blocks(read_deck_source(deck).lines)) {
    Fields own = {"*" + keyword.shown};
    for (const auto& [option, value] : keyword.options) {
      own.push_back(value.empty() ? option : option + "=" + value);
    }
    const std::string text = joined(own, ", ");
    all.push_back({text, keyword.place.where, text, upper(text)});
    if (keyword.name == "MATERIAL") material = keyword.option("NAME");
    for (const DataLine& line : keyword.lines) {
      const std::string title = title_of(keyword, line, material);
      const std::string data = joined(line.fields, ", ");
      all.push_back({title,
                     line.place.where,
                     title + ": " + data,
                     title + ": " + meaning_of(line.fields)});
    }
  }
  return all;
}

}  // namespace

std::vector<CardChange> card_difference(const std::filesystem::path& before,
                                        const std::filesystem::path& after) {
  const bool keywords = is_keyword_deck(before) && is_keyword_deck(after);
  const auto said_by = keywords ? said_by_keywords : said_by_cards;
  const std::vector<Said> old = said_by(before);
  const std::vector<Said> now = said_by(after);
  std::multiset<std::string> left;
  for (const Said& card : old) left.insert(card.meaning);
  std::map<std::string, std::deque<const Said*>> fresh;  // by title
  std::vector<const Said*> order;
  for (const Said& card : now) {
    if (const auto same = left.find(card.meaning); same != left.end()) {
      left.erase(same);
      continue;
    }
    fresh[card.title].push_back(&card);
    order.push_back(&card);
  }
  std::vector<CardChange> changes;
  std::set<const Said*> paired;
  for (const Said& card : old) {
    const auto gone = left.find(card.meaning);
    if (gone == left.end()) continue;
    left.erase(gone);
    CardChange change{card.title, card.where, card.text, {}};
    std::deque<const Said*>& others = fresh[change.card];
    if (!others.empty()) {
      change.after = others.front()->text;
      paired.insert(others.front());
      others.pop_front();
    }
    changes.push_back(std::move(change));
  }
  for (const Said* card : order) {
    if (paired.contains(card)) continue;
    changes.push_back({card->title, card->where, {}, card->text});
  }
  return changes;
}

}  // namespace tapfit::structure
