#include "updating/structure/cards/bulk_lines.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/utf8.hpp"
#include "updating/structure/abaqus/keyword_block.hpp"
#include "updating/structure/abaqus/translate_inp.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/cards/deck_source.hpp"
#include "updating/structure/cards/include_lines.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <utility>

namespace tapfit::structure {
namespace {

// What a file asks for, whatever else is wrong with it; nothing where it cannot
// be read.
std::vector<std::string> names_included(const std::filesystem::path& path) {
  std::vector<std::string> names;
  std::ifstream file;
  try {
    file = acquisition::open_input(path, max_deck_bytes);
  } catch (const InputError&) {
    return names;  // who needs the deck says what is wrong
  }
  std::string text;
  for (int number = 1; acquisition::take_line(file, text); ++number) {
    if (number == 1) drop_byte_order_mark(text);
    (void)complete_include(file, text, number);
    // In a file of unknown kind either syntax may count.
    for (std::optional<std::string> name :
         {include_name(text), included_by_keyword(text)}) {
      if (name) names.push_back(std::move(*name));
    }
  }
  return names;
}

}  // namespace

DeckLines read_deck_lines(const std::filesystem::path& path) {
  DeckSource deck = read_deck_source(path);
  DeckLines result;
  if (deck.keywords) {
    TranslatedDeck translated = translate_inp(deck.lines);
    deck.lines = std::move(translated.lines);
    result.left_out = std::move(translated.left_out);
    result.warnings = std::move(translated.warnings);
  }
  const std::vector<PlacedLine>& raw = deck.lines;
  const bool has_begin =
      std::any_of(raw.begin(), raw.end(), [](const PlacedLine& line) {
        return is_begin_bulk(without_comment(line.text));
      });
  bool in_bulk = !has_begin;
  bool ended = false;
  CaseReader cases;
  for (const PlacedLine& line : raw) {
    result.all.push_back(line.text);
    const std::string text =
        acquisition::printable(expand_tabs(without_comment(line.text)));
    if (ended || trimmed(text).empty()) continue;
    if (!in_bulk || (!has_begin && looks_like_control(text))) {
      cases.add(text, line.where);
      if (is_begin_bulk(text)) in_bulk = true;
    } else if (is_end(text)) {
      ended = true;
    } else {
      result.bulk.push_back(
          {text, line.where, line.number, result.all.size() - 1});
    }
  }
  result.control = cases.result();
  return result;
}

std::vector<std::filesystem::path> deck_files(const std::filesystem::path& path,
                                              const MayOpen& may_open) {
  std::vector<std::filesystem::path> files;
  std::set<std::filesystem::path> known;
  const auto add = [&files, &known](const std::filesystem::path& file) {
    std::error_code fault;
    const auto whole = std::filesystem::weakly_canonical(
        std::filesystem::absolute(file, fault), fault);
    if (known.insert(fault ? file : whole).second) files.push_back(file);
  };
  add(path);
  for (std::size_t k = 0; k < files.size(); ++k) {
    const std::filesystem::path asks = files[k];
    if (may_open && !may_open(asks)) continue;
    for (std::string& name : names_included(asks)) {
      add(included(asks, std::move(name), path.parent_path()));
    }
  }
  return files;
}

}  // namespace tapfit::structure
