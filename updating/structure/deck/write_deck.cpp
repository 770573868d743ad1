#include "acquisition/foundation/output_file.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/deck/deck.hpp"

#include <algorithm>
#include <ostream>

namespace tapfit::structure {

void write_deck(const Deck& deck,
                const std::vector<std::string>& added_cards,
                const std::filesystem::path& path,
                const acquisition::OutputRule& rule) {
  const auto end = std::find_if(
      deck.cards.begin(), deck.cards.end(), [](const std::string& line) {
        return upper(trimmed(line)).starts_with("ENDDATA");
      });
  acquisition::OutputFile output(path, rule);
  std::ostream& file = output.stream();
  for (auto line = deck.cards.begin(); line != end; ++line) {
    file << *line << '\n';
  }
  for (const std::string& card : added_cards) file << card << '\n';
  if (end == deck.cards.end()) file << "ENDDATA\n";
  for (auto line = end; line != deck.cards.end(); ++line) {
    file << *line << '\n';
  }
  output.commit();
}

}  // namespace tapfit::structure
