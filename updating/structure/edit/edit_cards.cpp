#include "updating/structure/edit/edit_cards.hpp"

#include "updating/structure/cards/card_defaults.hpp"
#include "updating/structure/cards/line_text.hpp"
#include "updating/structure/edit/field_line.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace tapfit::structure {
namespace {

using Lines = std::vector<std::string>;

std::optional<std::vector<Card>> replaced(const Card& card,
                                          const std::vector<CardEdit>& edits) {
  for (const CardEdit& edit : edits) {
    auto cards = edit(card);
    if (cards) return cards;
  }
  return std::nullopt;
}

std::string field_of(const Card& card, std::size_t at) {
  return at < card.fields.size() ? card.fields[at] : "";
}

// Writes what a line of a card says otherwise than that of another.
// @param at its first field, counted on
bool write_fields(const Card& card,
                  const Card& other,
                  std::size_t& at,
                  FieldLine& line) {
  bool changed = false;
  for (std::size_t k = 1; k <= line.data_fields(); ++k, ++at) {
    const std::string text = field_of(card, at);
    if (text == field_of(other, at)) continue;
    line.set(k, text);
    changed = true;
  }
  return changed;
}

// A card in the lines of another, as far as they say the same.
Lines lines_like(const Card& card, const Card& like, const Lines& written) {
  std::size_t end = card.fields.size();
  while (end > 1 && card.fields[end - 1].empty()) --end;
  const bool is_other =
      card.name() != like.name() || field_of(card, 1) != field_of(like, 1);
  Lines lines;
  std::size_t at = 1;
  std::optional<FieldLine> line;
  for (std::size_t k = 0; k == 0 || at < end; ++k) {
    const bool given = k < written.size();
    line = given ? FieldLine::of_card(written[k]) : line->continuation();
    const bool changed = write_fields(card, given ? like : Card{}, at, *line);
    if (is_other) line->drop_marker();
    if (k == 0 && card.name() != like.name()) line->set_name(card.name());
    lines.push_back(given && !changed && !is_other ? written[k] : line->text());
  }
  return lines;
}

Lines lines_of(const Card& card, const BulkData& bulk) {
  Lines lines;
  for (const std::size_t k : card.lines) lines.push_back(bulk.lines[k]);
  return lines;
}

// Repeated cards stay what they were where the one before them changes.
// @return by card; where none changes, repetitions may stay as written
std::map<std::size_t, Lines> repeated_cards(const CardChanges& changes) {
  std::map<std::size_t, Lines> text;
  if (changes.changed.empty()) return text;
  const auto plain = [](const Card& card) {
    Card name;
    name.fields = {card.name()};
    return lines_like(card, name, {card.name() + ","});
  };
  const std::vector<Card>& cards = changes.bulk.cards;
  for (std::size_t at = 0; at < cards.size(); ++at) {
    if (cards[at].repeated) text[at] = plain(cards[at]);
  }
  for (const ChangedCard& change : changes.changed) {
    const auto own = text.find(change.at);
    if (own == text.end()) continue;
    own->second.clear();
    for (const Card& now : change.now) {
      std::ranges::move(plain(now), std::back_inserter(own->second));
    }
  }
  return text;
}

void write_out(const CardChanges& changes,
               const std::map<std::size_t, Lines>& repeated,
               EditedDeck& edited) {
  for (const auto& [at, text] : repeated) {
    const std::vector<std::size_t>& lines = changes.bulk.cards[at].lines;
    for (const std::size_t k : lines) {
      edited.replaced.try_emplace(k, Lines{"$ was: " + edited.lines[k]});
    }
    Lines& there = edited.replaced.at(lines.back());
    there.insert(there.end(), text.begin(), text.end());
  }
}

}  // namespace

CardChanges change_cards(const std::filesystem::path& deck,
                         const std::vector<CardEdit>& edits) {
  CardChanges changes{read_bulk_data(deck), {}};
  fill_defaults(changes.bulk);
  const std::vector<Card>& cards = changes.bulk.cards;
  for (std::size_t at = 0; at < cards.size(); ++at) {
    auto now = replaced(cards[at], edits);
    if (now) changes.changed.push_back({at, std::move(*now)});
  }
  return changes;
}

void EditedDeck::add(const Lines& added, std::size_t in_front_of) {
  if (added.empty()) return;
  Lines* there = &behind;
  if (in_front_of < lines.size()) {
    const Lines as_read{lines[in_front_of]};
    there = &replaced.try_emplace(in_front_of, as_read).first->second;
  }
  there->insert(there->begin(), added.begin(), added.end());
}

Lines EditedDeck::text() const {
  Lines all;
  auto next = replaced.begin();
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (next == replaced.end() || next->first != k) {
      all.push_back(lines[k]);
      continue;
    }
    all.insert(all.end(), next->second.begin(), next->second.end());
    ++next;
  }
  all.insert(all.end(), behind.begin(), behind.end());
  return all;
}

EditedDeck bulk_text(const CardChanges& changes, const Lines& added) {
  EditedDeck edited{changes.bulk.lines, {}};
  const std::map<std::size_t, Lines> repeated = repeated_cards(changes);
  write_out(changes, repeated, edited);
  for (const ChangedCard& change : changes.changed) {
    if (repeated.contains(change.at)) continue;
    const Card& card = changes.bulk.cards[change.at];
    const Lines written = lines_of(card, changes.bulk);
    const bool stays =
        !change.now.empty() && change.now.front().fields == card.fields;
    for (const std::size_t k : card.lines) {
      if (!stays) edited.replaced[k] = {"$ was: " + edited.lines[k]};
    }
    const std::size_t last = card.lines.back();
    Lines& there = edited.replaced.try_emplace(last, Lines{edited.lines[last]})
                       .first->second;
    for (std::size_t k = stays ? 1 : 0; k < change.now.size(); ++k) {
      std::ranges::move(lines_like(change.now[k], card, written),
                        std::back_inserter(there));
    }
  }
  const auto end = std::ranges::find_if(edited.lines, is_end);
  edited.add(added, static_cast<std::size_t>(end - edited.lines.begin()));
  return edited;
}

EditedDeck edit_deck(const std::filesystem::path& deck,
                     const std::vector<CardEdit>& edits) {
  return bulk_text(change_cards(deck, edits));
}

Lines edit_cards(const std::filesystem::path& deck,
                 const std::vector<CardEdit>& edits) {
  return edit_deck(deck, edits).text();
}

}  // namespace tapfit::structure
