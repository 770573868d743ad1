#include "updating/export/written_deck.hpp"

#include "updating/structure/abaqus/keyword_shapes.hpp"
#include "updating/structure/edit/write_layout.hpp"

#include <utility>

namespace tapfit::updating {
namespace {

// What the deck says that it does not hold.
std::vector<std::string> notes_in(const std::vector<std::string>& added) {
  std::vector<std::string> notes;
  for (const std::string& line : added) {
    if (line.starts_with("$ not written")) notes.push_back(line.substr(2));
  }
  return notes;
}

}  // namespace

WrittenDeck write_as_read(const structure::Deck& deck,
                          UpdatedDeck updated,
                          const std::filesystem::path& path,
                          const acquisition::OutputRule& rule) {
  WrittenDeck written{{path}, notes_in(updated.added)};
  if (!structure::is_keyword_deck(deck.path)) {
    structure::WrittenLayout layout = structure::write_layout(
        deck.path, updated.edited, updated.added, path, rule);
    if (layout.hindrance.empty()) {
      written.files = std::move(layout.files);
      return written;
    }
    written.notes.push_back("INCLUDE files stand in the deck itself: " +
                            layout.hindrance);
    updated.added.push_back("$ " + written.notes.back());
  }
  structure::Deck changed = deck;
  changed.cards = updated.edited.text();
  structure::write_deck(changed, updated.added, path, rule);
  return written;
}

}  // namespace tapfit::updating
