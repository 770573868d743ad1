#include "updating/structure/edit/keyword_text.hpp"

#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/edit/keyword_cards.hpp"
#include "updating/structure/edit/keyword_deck.hpp"
#include "updating/structure/edit/keyword_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace tapfit::structure {
namespace {

using Lines = std::vector<std::string>;

bool is_element(const Card& card) {
  return card.name().starts_with('C') && !card.name().starts_with("CORD");
}

bool is_material(const Card& card) { return card.name().starts_with("MAT"); }

bool is_section(const Card& card) { return card.name().starts_with('P'); }

int number_at(const Card& card, std::size_t at) {
  if (at >= card.fields.size()) return 0;
  return parse_integer(card.fields[at]).value_or(0);
}

class KeywordWriter {
 public:
  KeywordWriter(const Deck& deck, const CardChanges& changes)
      : source_(read_keyword_deck(deck.path)),
        names_(source_),
        bulk_(&changes.bulk),
        changes_(&changes.changed) {
    for (const Card& card : bulk_->cards) {
      ++cards_at_[source_.line_of(card)][card.name()];
    }
  }

  // @param left_out grids of what is added that have no keyword
  void write_changes(const std::set<int>& left_out) {
    each(is_material, &KeywordWriter::write_material);
    for (const ChangedCard& change : *changes_) {
      if (is_element(card_of(change))) write_element(change, left_out);
    }
    each(is_section, &KeywordWriter::write_section);
    for (const ChangedCard& change : *changes_) {
      const Card& card = card_of(change);
      if (is_material(card) || is_element(card) || is_section(card)) continue;
      card.name() == "SPC1" ? write_boundary(change) : leave(card);
    }
    comment_empty_boundaries();
  }

  KeywordNames& names() { return names_; }

  EditedDeck edited(const AddedKeywords& added) {
    EditedDeck deck{source_.lines, {}};
    for (auto& [line, edit] : edits_) {
      Lines& there = deck.replaced[line];
      there = std::move(edit.before);
      std::ranges::move(edit.own.value_or(Lines{source_.lines[line]}),
                        std::back_inserter(there));
      std::ranges::move(edit.behind, std::back_inserter(there));
    }
    Lines of_part = added.of_part;
    of_part.insert(of_part.begin(), notes_.begin(), notes_.end());
    const std::size_t model_end = line_of("STEP");
    const std::size_t part_end = line_of("ENDPART");
    // The later ones first, as both may stand in front of the same line.
    deck.add(added.of_model, model_end);
    deck.add(of_part, std::min(part_end, model_end));
    return deck;
  }

 private:
  struct LineEdit {
    Lines before;
    std::optional<Lines> own;
    Lines behind;
  };

  // Of the first keyword of that name; behind all where there is none.
  std::size_t line_of(const std::string& name) const {
    const auto found =
        std::ranges::find(source_.keywords, name, &Keyword::name);
    return found == source_.keywords.end() ? source_.lines.size()
                                           : found->place.index;
  }

  const Card& card_of(const ChangedCard& change) const {
    return bulk_->cards[change.at];
  }

  void each(bool (*is_meant)(const Card&),
            void (KeywordWriter::*write)(const ChangedCard&)) {
    for (const ChangedCard& change : *changes_) {
      if (is_meant(card_of(change))) (this->*write)(change);
    }
  }

  void leave(const Card& card) {
    notes_.push_back(fmt::format(
        "** not written: what changes of *{} ({}), read as {}",
        source_.keywords[source_.keyword_at(source_.line_of(card))].shown,
        card.where,
        card.name()));
  }

  // Lines that say something else than the deck, as they are and as they were.
  void put(const KeywordText& text) {
    for (const auto& [at, line] : text) {
      const std::string& old = source_.lines[at];
      if (line.text() != old) edits_[at].own = {"** was: " + old, line.text()};
    }
  }

  // Behind the last line of the text.
  void put_behind(const KeywordText& text, const Lines& lines) {
    Lines& there = edits_[text.rbegin()->first].behind;
    there.insert(there.end(), lines.begin(), lines.end());
  }

  static Lines lines_of(const KeywordText& text) {
    Lines lines;
    for (const auto& [at, line] : text) lines.push_back(line.text());
    return lines;
  }

  KeywordText text_of_card(const Card& card) const {
    const std::size_t first = source_.keyword_at(source_.line_of(card));
    KeywordText text = source_.text_of(first);
    if (source_.keywords[first].name != "MATERIAL") return text;
    for (std::size_t k = first + 1; k < source_.material_end(first); ++k) {
      text.merge(source_.text_of(k));
    }
    return text;
  }

  // The numbers of a card, where its lines are no other's.
  void write_own(const Card& card, const Card& now) {
    if (now.fields == card.fields) return;
    KeywordText text = text_of_card(card);
    const auto& others = cards_at_[source_.line_of(card)];
    const bool alone = !is_material(card) || others.size() == 1;
    if (alone && scale_numbers(source_, card, now, text)) return put(text);
    leave(card);
  }

  void write_material(const ChangedCard& change) {
    const Card& card = card_of(change);
    write_own(card, change.now.front());
    const std::size_t at = source_.keyword_at(source_.line_of(card));
    for (std::size_t k = 1; k < change.now.size(); ++k) {
      const int id = number_at(change.now[k], 1);
      if (source_.keywords[at].name != "MATERIAL") {
        own_materials_[id] = {&card, &change.now[k]};
        continue;
      }
      KeywordText text = text_of_card(card);
      if (!scale_numbers(source_, card, change.now[k], text)) leave(card);
      materials_[id] = names_.next();
      set_option("NAME", materials_[id], text);
      put_behind(text_of_card(card), lines_of(text));
    }
  }

  // Which section it has now, and which nodes.
  void write_element(const ChangedCard& change, const std::set<int>& left_out) {
    const Card& card = card_of(change);
    const Card& now = change.now.front();
    const std::size_t at = source_.line_of(card);
    if (number_at(now, 2) != number_at(card, 2)) {
      ++moved_[number_at(now, 2)][at];
    }
    KeywordText text;
    text.emplace(at, FieldLine::of_keyword(source_.lines[at]));
    FieldLine& line = text.at(at);
    for (std::size_t k = 3; k < now.fields.size(); ++k) {
      const int from = number_at(card, k);
      const int to = number_at(now, k);
      if (from == to || from == 0 || left_out.contains(to)) continue;
      for (std::size_t field = 1; field < line.size(); ++field) {
        if (integer_of(line.field(field)) == from) {
          line.set(field, std::to_string(to));
        }
      }
    }
    put(text);
  }

  // Lines of the elements that have this section now.
  std::vector<std::size_t> moved_to(int property) {
    std::vector<std::size_t> lines;
    for (const auto& [at, count] : moved_[property]) {
      lines.push_back(at);
      // With a node in its middle it is two bars.
      if (count == cards_at_[at].begin()->second) continue;
      notes_.push_back(fmt::format(
          "** not written: that one half of the beam in \"{}\" stays as it was",
          source_.lines[at]));
    }
    return lines;
  }

  // Elements of the deck by their lines.
  std::vector<int> elements_at(const std::vector<std::size_t>& lines) const {
    std::vector<int> ids;
    for (const std::size_t at : lines) {
      const FieldLine line = FieldLine::of_keyword(source_.lines[at]);
      ids.push_back(integer_of(line.field(0)).value_or(0));
    }
    return ids;
  }

  // Lines of the elements whose section this is, by any of its cards.
  std::set<std::size_t> lines_of_section(std::size_t keyword) const {
    std::set<int> properties;
    for (const Card& card : bulk_->cards) {
      if (is_section(card) && number_at(card, 1) > 0 &&
          source_.keyword_at(source_.line_of(card)) == keyword) {
        properties.insert(number_at(card, 1));
      }
    }
    std::set<std::size_t> lines;
    for (const Card& card : bulk_->cards) {
      if (is_element(card) && properties.contains(number_at(card, 2))) {
        lines.insert(source_.line_of(card));
      }
    }
    return lines;
  }

  // Materials that the copy of a section has instead.
  void rename_materials(const Card& card, const Card& copy, KeywordText& text) {
    const std::size_t at = source_.keyword_at(source_.line_of(card));
    const std::vector<DataLine>& layers = source_.keywords[at].lines;
    for (std::size_t k = 2; k < copy.fields.size(); ++k) {
      const int id = number_at(copy, k);
      if (const auto own = own_materials_.find(id);
          own != own_materials_.end()) {
        const auto& [from, to] = own->second;
        if (!scale_numbers(source_, *from, *to, text)) leave(*from);
      }
      const auto named = materials_.find(id);
      if (named == materials_.end() || id == number_at(card, k)) continue;
      if (card.name() != "PCOMP") {
        set_option("MATERIAL", named->second, text);
        continue;
      }
      constexpr std::size_t first_layer = 9;
      const std::size_t layer = (k - first_layer) / 4;
      text.at(layers.at(layer).place.index).set(2, named->second);
    }
  }

  void write_section(const ChangedCard& change) {
    const Card& card = card_of(change);
    write_own(card, change.now.front());
    const std::size_t keyword = source_.keyword_at(source_.line_of(card));
    const KeywordText section = text_of_card(card);
    std::set<std::size_t> rest = lines_of_section(keyword);
    for (std::size_t k = 1; k < change.now.size(); ++k) {
      const Card& copy = change.now[k];
      const std::vector<std::size_t> own = moved_to(number_at(copy, 1));
      if (own.empty()) continue;
      for (const std::size_t at : own) rest.erase(at);
      KeywordText text = section;
      if (!scale_numbers(source_, card, copy, text)) leave(card);
      rename_materials(card, copy, text);
      const std::string name = names_.next();
      set_option("ELSET", name, text);
      put_behind(section, element_set(name, elements_at(own)));
      put_behind(section, lines_of(text));
    }
    if (change.now.size() > 1) narrow(section, {rest.begin(), rest.end()});
  }

  // Leaves a section its other elements, under a set of their own.
  void narrow(const KeywordText& section,
              const std::vector<std::size_t>& rest) {
    if (rest.empty()) {
      for (const auto& [at, line] : section) {
        edits_[at].own = {"** was: " + source_.lines[at]};
      }
      return;
    }
    LineEdit& first = edits_[section.begin()->first];
    const std::string name = names_.next();
    first.before = element_set(name, elements_at(rest));
    KeywordText text = section;
    set_option("ELSET", name, text);
    put(text);
  }

  void write_boundary(const ChangedCard& change) {
    const Card& card = card_of(change);
    const std::size_t at = source_.line_of(card);
    // Two cards: of a rigid body's turns and of its motion.
    if (cards_at_[at]["SPC1"] != 1) return leave(card);
    Lines lines = {"** was: " + source_.lines[at]};
    for (const Card& now : change.now) {
      for (std::size_t k = 3; k < now.fields.size(); ++k) {
        const int grid = number_at(now, k);
        if (grid == 0) continue;
        std::ranges::move(boundary_lines(names_.node(grid), now.fields[2]),
                          std::back_inserter(lines));
      }
    }
    if (lines.size() == 1) empty_.insert(at);
    edits_[at].own = std::move(lines);
  }

  // A keyword that holds nothing any more.
  void comment_empty_boundaries() {
    for (const std::size_t at : empty_) {
      const Keyword& keyword = source_.keywords[source_.keyword_at(at)];
      const bool all =
          std::ranges::all_of(keyword.lines, [this](const DataLine& line) {
            return empty_.contains(line.place.index);
          });
      const std::size_t own = keyword.place.index;
      if (all) edits_[own].own = {"** was: " + source_.lines[own]};
    }
  }

  KeywordDeck source_;
  KeywordNames names_;
  const BulkData* bulk_;
  const std::vector<ChangedCard>* changes_;
  std::map<std::size_t, std::map<std::string, int>> cards_at_;  // by line
  std::map<std::size_t, LineEdit> edits_;
  Lines notes_;
  std::map<int, std::string> materials_;  // copies, by the id of their card
  // Copies of materials that stand in a section: the card and what it becomes.
  std::map<int, std::pair<const Card*, const Card*>> own_materials_;
  // Property -> lines of elements, how many bars of each.
  std::map<int, std::map<std::size_t, int>> moved_;
  std::set<std::size_t> empty_;  // lines of *BOUNDARY
};

}  // namespace

EditedDeck keyword_text(const Deck& deck,
                        const CardChanges& changes,
                        const Lines& added) {
  const std::vector<AddedCard> cards = added_cards(added);
  const std::set<int> left_out = grids_left_out(cards);
  KeywordWriter writer(deck, changes);
  writer.write_changes(left_out);
  return writer.edited(keyword_lines(deck, cards, left_out, writer.names()));
}

}  // namespace tapfit::structure
