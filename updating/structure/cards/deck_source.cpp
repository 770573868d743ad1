#include "updating/structure/cards/deck_source.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "updating/structure/abaqus/keyword_shapes.hpp"
#include "updating/structure/cards/card_shapes.hpp"
#include "updating/structure/cards/include_lines.hpp"
#include "updating/structure/cards/line_text.hpp"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

namespace tapfit::structure {
namespace {

constexpr std::size_t max_depth = 20;
// Of INCLUDE files read, each time one is asked for.
constexpr std::size_t max_includes = 1000;

/// What is read so far.
struct Reading {
  DeckSource deck;
  std::filesystem::path folder;
  std::uintmax_t bytes = 0;
};

// Opens a file of the deck, as long as there is no end of them.
std::ifstream open_part(const std::filesystem::path& path,
                        const std::string& asked_by,
                        Reading& reading) {
  if (reading.deck.files.size() > max_includes + 1) {
    throw InputError(
        fmt::format("more than {} INCLUDE files are asked for", max_includes),
        asked_by,
        "Name each file once; files that include the next one twice double "
        "the deck at each step.");
  }
  std::ifstream file = acquisition::open_input(path, max_deck_bytes);
  if (!file) {
    throw InputError(fmt::format("cannot open the model {}", path.string()),
                     asked_by,
                     "Check the file's name and that it may be read.");
  }
  std::error_code ignored;
  reading.bytes += std::filesystem::file_size(path, ignored);
  if (reading.bytes > max_deck_bytes) {
    throw InputError(
        fmt::format("the deck with its INCLUDE files has more than {} MB",
                    max_deck_bytes >> 20U),
        asked_by,
        "Leave out what is no part of the model.");
  }
  return file;
}

void read_part(DeckFile part,
               const std::string& asked_by,
               std::size_t depth,
               Reading& reading) {
  DeckSource& deck = reading.deck;
  const std::filesystem::path path = part.path;
  const auto index = static_cast<std::uint32_t>(deck.files.size());
  deck.files.push_back(std::move(part));
  if (depth > max_depth) {
    throw InputError("INCLUDE files include each other without end",
                     asked_by,
                     "Remove the INCLUDE that leads back.");
  }
  std::ifstream file = open_part(path, asked_by, reading);
  CardShapes cards;
  KeywordShapes keywords;
  std::string text;
  for (int number = 1; acquisition::take_line(file, text); ++number) {
    if (number == 1) drop_byte_order_mark(text);
    const int first = number;
    const std::string where =
        fmt::format("{}:{}", path.filename().string(), number);
    if (!complete_include(file, text, number)) {
      throw InputError("the name of the INCLUDE file does not end",
                       where,
                       "Close the quotes.");
    }
    const std::optional<std::string> name =
        deck.keywords ? included_by_keyword(text) : include_name(text);
    deck.origins.push_back({index, first, number - first + 1});
    if (name) {
      const char* mark = deck.keywords ? "** " : "$ ";
      deck.lines.push_back(
          {mark + ("inlined: " + trimmed(text)), where, number});
      read_part(
          {included(path, *name, reading.folder), *name, deck.lines.size() - 1},
          where,
          depth + 1,
          reading);
    } else {
      deck.lines.push_back({text, where, number});
      deck.keywords ? keywords.add(text) : cards.add(text);
    }
  }
  if (file.bad()) {
    throw InputError(
        fmt::format("cannot be read to its end: {}", path.string()),
        asked_by,
        "Check the disk, and that it is a file of cards.");
  }
  // Before anything that it holds is looked at closer, and quoted.
  deck.keywords ? keywords.check(path, asked_by) : cards.check(path, asked_by);
}

}  // namespace

DeckSource read_deck_source(const std::filesystem::path& path) {
  acquisition::check_input(path, max_deck_bytes);
  Reading reading;
  reading.deck.keywords = is_keyword_deck(path);
  reading.folder = path.parent_path();
  read_part({path, {}, 0}, path.string(), 0, reading);
  return std::move(reading.deck);
}

void drop_byte_order_mark(std::string& text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
}

}  // namespace tapfit::structure
