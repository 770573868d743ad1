#include "updating/export/written_deck.hpp"

#include "acquisition/foundation/output_file.hpp"
#include "acquisition/foundation/trimmed_text.hpp"
#include "updating/structure/abaqus/keyword_shapes.hpp"
#include "updating/structure/edit/damping_table.hpp"
#include "updating/structure/edit/direct_matrix.hpp"
#include "updating/structure/edit/keyword_text.hpp"
#include "updating/structure/edit/write_layout.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace tapfit::updating {
namespace {

using Lines = std::vector<std::string>;

// What the deck says that it does not hold, or not for both programs.
std::vector<std::string> notes_in(const structure::EditedDeck& edited) {
  std::vector<std::string> notes;
  const auto take = [&notes](const Lines& lines) {
    for (const std::string& line : lines) {
      const std::size_t text = line.find_first_not_of("$* ");
      if (text == 0 || text == std::string::npos) continue;
      const std::string said = line.substr(text);
      if (said.starts_with("not written") || said.starts_with("CalculiX ")) {
        notes.push_back(said);
      }
    }
  };
  for (const auto& [at, lines] : edited.replaced) take(lines);
  take(edited.behind);
  return notes;
}

structure::EditedDeck bulk_deck(const structure::Deck& deck,
                                const UpdatedDeck& updated) {
  Lines added = updated.added;
  std::ranges::move(structure::damping_table_cards(
                        structure::free_table(deck.path), updated.damping),
                    std::back_inserter(added));
  structure::EditedDeck edited = structure::bulk_text(updated.changes, added);
  const bool direct = std::ranges::any_of(
      added, [](const auto& card) { return card.starts_with("DMIG,K2GG"); });
  if (direct) structure::name_direct_stiffness("K2GG", edited);
  return edited;
}

structure::EditedDeck keyword_deck(const structure::Deck& deck,
                                   const UpdatedDeck& updated) {
  Lines added = updated.added;
  std::ranges::move(structure::damping_comments(updated.damping),
                    std::back_inserter(added));
  return structure::keyword_text(deck, updated.changes, added);
}

}  // namespace

bool as_keywords(const std::filesystem::path& deck,
                 const std::filesystem::path& target) {
  return upper(target.extension().string()) == ".INP" &&
         structure::is_keyword_deck(deck);
}

WrittenDeck write_as_read(const structure::Deck& deck,
                          const UpdatedDeck& updated,
                          const std::filesystem::path& path,
                          const acquisition::OutputRule& rule) {
  const bool keywords = as_keywords(deck.path, path);
  structure::EditedDeck edited =
      keywords ? keyword_deck(deck, updated) : bulk_deck(deck, updated);
  WrittenDeck written{{path}, notes_in(edited)};
  if (keywords || !structure::is_keyword_deck(deck.path)) {
    structure::WrittenLayout layout =
        structure::write_layout(deck.path, edited, path, rule);
    if (layout.hindrance.empty()) {
      written.files = std::move(layout.files);
      return written;
    }
    written.notes.push_back("INCLUDE files stand in the deck itself: " +
                            layout.hindrance);
    edited.behind.push_back((keywords ? "** " : "$ ") + written.notes.back());
  }
  acquisition::OutputFile output(path, rule);
  for (const std::string& line : edited.text()) output.stream() << line << '\n';
  output.commit();
  return written;
}

}  // namespace tapfit::updating
