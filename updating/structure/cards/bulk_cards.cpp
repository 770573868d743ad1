#include "updating/structure/cards/bulk_cards.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/cards/case_changes.hpp"
#include "updating/structure/cards/repeated_cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <unordered_map>
#include <utility>

namespace tapfit::structure {
namespace {

constexpr std::size_t data_fields = 8;

struct Fields {
  std::string name;               // first field as written
  std::vector<std::string> data;  // exactly 8, or 4 for large field
  std::string marker;             // tenth field
};

Fields split_free(const std::string& text, const std::string& where) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  while (true) {
    const std::size_t comma = text.find(',', from);
    parts.push_back(trimmed(text.substr(from, comma - from)));
    if (comma == std::string::npos) break;
    from = comma + 1;
  }
  Fields fields;
  fields.name = parts.front();
  const bool large = fields.name.find('*') != std::string::npos;
  const std::size_t width = large ? data_fields / 2 : data_fields;
  while (parts.size() > width + 2 && parts.back().empty()) parts.pop_back();
  if (parts.size() > width + 2) {
    throw InputError(
        fmt::format(
            "the line has {} fields, {} are the most", parts.size(), width + 2),
        where,
        "Split the entry into a first line and continuation lines.");
  }
  parts.resize(width + 2);
  fields.data.assign(parts.begin() + 1, parts.end() - 1);
  fields.marker = parts.back();
  return fields;
}

Fields split_fixed(std::string text) {
  text.resize(std::max<std::size_t>(text.size(), 80), ' ');
  Fields fields;
  fields.name = trimmed(text.substr(0, 8));
  const bool large = fields.name.find('*') != std::string::npos;
  const std::size_t width = large ? 16 : 8;
  for (std::size_t at = 8; at < 72; at += width) {
    fields.data.push_back(trimmed(text.substr(at, width)));
  }
  fields.marker = trimmed(text.substr(72, 8));
  return fields;
}

bool is_continuation(const std::string& name) {
  return name.empty() || name.front() == '+' || name.front() == '*';
}

// Puts lines into cards. A continuation goes on the card whose line before it
// ends in its marker, wherever that is; without a marker on the line above it.
class CardJoiner {
 public:
  explicit CardJoiner(std::vector<Card>& cards) : cards_(&cards) {}

  void add(const SourceLine& line) {
    const Fields fields = line.text.find(',') != std::string::npos
                              ? split_free(line.text, line.where)
                              : split_fixed(line.text);
    if (is_continuation(fields.name)) {
      last_ = continued(fields.name, line.where);
    } else {
      last_ = cards_->size();
      cards_->push_back(begin_card(fields.name, line));
    }
    Card& card = (*cards_)[last_];
    card.lines.push_back(line.index);
    card.fields.insert(
        card.fields.end(), fields.data.begin(), fields.data.end());
    marker_ = own_part(fields.marker);
    if (!marker_.empty()) asking_[marker_] = last_;
  }

 private:
  // The first character of a marker is its own (+, * or anything).
  static std::string own_part(const std::string& marker) {
    return marker.size() > 1 ? upper(marker.substr(1)) : "";
  }

  static Card begin_card(const std::string& written, const SourceLine& line) {
    std::string name = upper(written);
    std::erase(name, '*');
    Card card;
    card.fields.push_back(trimmed(name));
    card.where = line.where;
    card.line = line.number;
    return card;
  }

  std::size_t continued(const std::string& name, const std::string& where) {
    const std::string marker = own_part(name);
    const auto asked = asking_.find(marker);
    if (!marker.empty() && asked != asking_.end()) {
      const std::size_t card = marker == marker_ ? last_ : asked->second;
      asking_.erase(asked);
      return card;
    }
    if (cards_->empty() || (!marker.empty() && !marker_.empty())) {
      throw InputError(
          fmt::format("the continuation \"{}\" follows no entry that asks "
                      "for it",
                      name),
          where,
          "Put continuation lines below the line they continue, whose tenth "
          "field is the same marker.");
    }
    return last_;
  }

  std::vector<Card>* cards_;
  std::size_t last_ = 0;
  std::string marker_;  // of the line before
  std::unordered_map<std::string, std::size_t> asking_;
};

}  // namespace

BulkData read_bulk_data(const std::filesystem::path& path) {
  DeckLines source = read_deck_lines(path);
  BulkData result;
  result.lines = std::move(source.all);
  result.control = std::move(source.control);
  result.left_out = std::move(source.left_out);
  result.warnings = std::move(source.warnings);
  CardJoiner joiner(result.cards);
  for (const SourceLine& line : source.bulk) joiner.add(line);
  result.cards = written_out(std::move(result.cards));
  std::set<std::string> names;
  for (const Card& card : result.cards) names.insert(card.name());
  CaseChanges changes = case_changes(result.control, names);
  std::ranges::move(changes.left_out, std::back_inserter(result.left_out));
  std::ranges::move(changes.warnings, std::back_inserter(result.warnings));
  return result;
}

std::vector<Card> cards_in(const std::vector<std::string>& lines) {
  std::vector<Card> cards;
  CardJoiner joiner(cards);
  for (const std::string& line : lines) {
    const std::string text = expand_tabs(without_comment(line));
    if (!trimmed(text).empty()) joiner.add({text, "", 0, 0});
  }
  return cards;
}

}  // namespace tapfit::structure
