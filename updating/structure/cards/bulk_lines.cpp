#include "updating/structure/cards/bulk_lines.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/utf8.hpp"
#include "updating/structure/abaqus/keyword_block.hpp"
#include "updating/structure/abaqus/keyword_shapes.hpp"
#include "updating/structure/abaqus/translate_inp.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/cards/card_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <utility>

namespace tapfit::structure {
namespace {

constexpr std::size_t max_depth = 20;
// Of INCLUDE files read, each time one is asked for.
constexpr std::size_t max_includes = 1000;
// Of the deck as a whole: some five million cards.
constexpr std::uintmax_t max_bytes = 512U << 20U;

// Editors may begin a file with the mark of UTF-8.
void drop_byte_order_mark(std::string& text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
}

bool ends_inside_quotes(const std::string& text) {
  const std::size_t open = text.find_first_of("'\"");
  return open != std::string::npos &&
         text.find(text[open], open + 1) == std::string::npos;
}

std::optional<std::string> include_name(const std::string& text) {
  const std::string line = trimmed(text);
  if (line.size() < 8 || upper(line.substr(0, 7)) != "INCLUDE") return {};
  const char next = line[7];
  if (next != ' ' && next != '\'' && next != '"' && next != '=') return {};
  const std::size_t open = line.find_first_of("'\"");
  if (open == std::string::npos) return trimmed(line.substr(8));
  const std::size_t close = line.find(line[open], open + 1);
  return line.substr(open + 1, close - open - 1);
}

// Beside the file that asks, or beside the deck itself, where solvers are
// started.
std::filesystem::path included(const std::filesystem::path& asks,
                               std::string name,
                               const std::filesystem::path& main) {
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::filesystem::path beside = asks.parent_path() / name;
  const std::filesystem::path at_main = main / name;
  std::error_code error;
  return !std::filesystem::exists(beside, error) &&
                 std::filesystem::exists(at_main, error)
             ? at_main
             : beside;
}

// A long name goes on in the next lines; false where the file ends in it.
bool complete_include(std::istream& file, std::string& text, int& number) {
  if (is_keyword_line(text) && upper(trimmed(text)) == "*INCLUDE,") {
    std::string more;
    if (!acquisition::take_line(file, more)) return false;
    text = trimmed(text) + trimmed(more);
    ++number;
  }
  for (std::string more; include_name(text) && ends_inside_quotes(text);) {
    if (!acquisition::take_line(file, more)) return false;
    text += trimmed(more);
    ++number;
  }
  return true;
}

// What a file asks for, whatever else is wrong with it; nothing where it cannot
// be read.
std::vector<std::string> names_included(const std::filesystem::path& path) {
  std::vector<std::string> names;
  std::ifstream file;
  try {
    file = acquisition::open_input(path, max_bytes);
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

/// A deck with its INCLUDE files inlined.
struct RawDeck {
  std::size_t files = 0;  ///< read, each time one is asked for
  std::vector<PlacedLine> lines;
  std::uintmax_t bytes = 0;
  bool keywords = false;  ///< an Abaqus or CalculiX deck
};

// Opens a file of the deck, as long as there is no end of them.
std::ifstream open_part(const std::filesystem::path& path,
                        const std::string& asked_by,
                        RawDeck& deck) {
  if (deck.files > max_includes + 1) {
    throw InputError(
        fmt::format("more than {} INCLUDE files are asked for", max_includes),
        asked_by,
        "Name each file once; files that include the next one twice double "
        "the deck at each step.");
  }
  std::ifstream file = acquisition::open_input(path, max_bytes);
  if (!file) {
    throw InputError(fmt::format("cannot open the model {}", path.string()),
                     asked_by,
                     "Check the file's name and that it may be read.");
  }
  std::error_code ignored;
  deck.bytes += std::filesystem::file_size(path, ignored);
  if (deck.bytes > max_bytes) {
    throw InputError(
        fmt::format("the deck with its INCLUDE files has more than {} MB",
                    max_bytes >> 20U),
        asked_by,
        "Leave out what is no part of the model.");
  }
  return file;
}

void read_file(const std::filesystem::path& path,
               const std::filesystem::path& folder,
               const std::string& asked_by,
               std::size_t depth,
               RawDeck& deck) {
  ++deck.files;
  if (depth > max_depth) {
    throw InputError("INCLUDE files include each other without end",
                     asked_by,
                     "Remove the INCLUDE that leads back.");
  }
  std::ifstream file = open_part(path, asked_by, deck);
  CardShapes cards;
  KeywordShapes keywords;
  std::string text;
  for (int number = 1; acquisition::take_line(file, text); ++number) {
    if (number == 1) drop_byte_order_mark(text);
    const std::string where =
        fmt::format("{}:{}", path.filename().string(), number);
    if (!complete_include(file, text, number)) {
      throw InputError("the name of the INCLUDE file does not end",
                       where,
                       "Close the quotes.");
    }
    const std::optional<std::string> name =
        deck.keywords ? included_by_keyword(text) : include_name(text);
    if (name) {
      const char* mark = deck.keywords ? "** " : "$ ";
      deck.lines.push_back(
          {mark + ("inlined: " + trimmed(text)), where, number});
      read_file(included(path, *name, folder), folder, where, depth + 1, deck);
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

// NAME = value, in capitals; empty for other lines.
struct Selection {
  std::string name;
  std::string value;
};

Selection selection(const std::string& text) {
  const std::string line = upper(trimmed(text));
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos) return {};
  return {trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1))};
}

// NAME, or 2.0*NAME, one after the other.
std::vector<std::string> matrix_names(const std::string& value) {
  std::vector<std::string> names;
  std::size_t from = 0;
  while (from < value.size()) {
    const std::size_t comma = std::min(value.find(',', from), value.size());
    const std::string one = trimmed(value.substr(from, comma - from));
    if (!one.empty()) names.push_back(one);
    from = comma + 1;
  }
  return names;
}

// Takes the case control line by line. What stands above all subcases holds in
// the first, unless that has its own.
class CaseReader {
 public:
  void add(const std::string& text, CaseControl& control) {
    const std::string line = upper(trimmed(text));
    if (line.starts_with("SUBCASE")) {
      ++subcase_;
      return;
    }
    const Selection chosen = selection(text);
    if (chosen.name == "METHOD") control.for_modes = true;
    if (chosen.name == "SPC") take_spc(parse_integer(chosen.value), control);
    if (chosen.name == "MPC" && (subcase_ < 2 || !control.mpc_set)) {
      const std::optional<int> set = parse_integer(chosen.value);
      if (set) control.mpc_set = set;
    }
    if (subcase_ > 1) return;
    if (chosen.name == "K2GG") {
      control.stiffness_matrices = matrix_names(chosen.value);
    } else if (chosen.name == "M2GG") {
      control.mass_matrices = matrix_names(chosen.value);
    }
  }

 private:
  void take_spc(std::optional<int> set, CaseControl& control) const {
    if (!set || set == control.spc_set) return;
    std::vector<int>& others = control.other_spc_sets;
    if (!control.spc_set || subcase_ < 2) {
      control.spc_set = set;
    } else if (std::find(others.begin(), others.end(), *set) == others.end()) {
      others.push_back(*set);
    }
  }

  int subcase_ = 0;
};

}  // namespace

DeckLines read_deck_lines(const std::filesystem::path& path) {
  RawDeck deck;
  DeckLines result;
  deck.keywords = is_keyword_deck(path);
  read_file(path, path.parent_path(), path.string(), 0, deck);
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
      cases.add(text, result.control);
      if (is_begin_bulk(text)) in_bulk = true;
    } else if (is_end(text)) {
      ended = true;
    } else {
      result.bulk.push_back(
          {text, line.where, line.number, result.all.size() - 1});
    }
  }
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
