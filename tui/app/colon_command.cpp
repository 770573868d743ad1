#include "tui/app/colon_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/nearest_word.hpp"
#include "tui/app/place_words.hpp"
#include "updating/catalogue/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <system_error>
#include <utility>

namespace tapfit::tui {
namespace {

using Kind = ColonCommand::Kind;

struct Entry {
  Kind kind;
  std::string_view name;
  std::string_view takes;
  std::string_view does;
  std::string_view key = {};    ///< that does it on any screen, as of read_key
  std::string_view brief = {};  ///< what the help has beside the key, if any
};

constexpr std::array<Entry, 25> commands{{
    {Kind::Add, "add", "EFFECT[@PLACE] ...", "adds effects to the model"},
    {Kind::Band, "band", "LOW HIGH", "looks for modes in this band [Hz]"},
    {Kind::Close, "close", "", "ends a split, keeps the other screen"},
    {Kind::Copy, "copy", "", "copies what is plotted", "y", "copy plot"},
    {Kind::Deck, "deck", "[FILE]", "writes the updated deck"},
    {Kind::Drop, "drop", "HZ", "takes the mode there out"},
    {Kind::Quit, "exit", "", "leaves the program"},
    {Kind::Help, "help", "", "what the screen shows, and all keys", "?"},
    {Kind::Keep,
     "keep",
     "",
     "ends a fit and keeps it",
     "S",
     "end fit, keep it"},
    {Kind::Only, "only", "", "ends a split, keeps this screen"},
    {Kind::Pair, "pair", "I:K", "pairs a measured mode with the model's"},
    {Kind::Pick, "pick", "HZ", "puts a mode in there"},
    {Kind::Plot,
     "plot",
     "[NAME]",
     "writes what is plotted, SVG and CSV",
     "P",
     "write plot"},
    {Kind::Quit, "quit", "", "leaves the program", "q", "quit"},
    {Kind::Redo, "redo", "", "does what was undone again", "<C-r>", "redo"},
    {Kind::Report, "report", "[FILE]", "writes the report"},
    {Kind::Retry, "retry", "", "tries what failed again", "r", "try again"},
    {Kind::Run, "run", "N", "shows a run of the recording"},
    {Kind::Screen, "screen", "1 ... 7", "shows a screen"},
    {Kind::Split,
     "split",
     "[1 ... 7]",
     "shows another screen beside, or ends that",
     "|",
     "split the screen"},
    {Kind::Stop, "stop", "", "stops what runs"},
    {Kind::Toggle, "toggle", "N", "switches an added effect off and on"},
    {Kind::Tour, "tour", "", "words on each screen, on and off"},
    {Kind::Uff, "uff", "[FILE]", "writes FRFs and modes"},
    {Kind::Undo, "undo", "", "takes the last step back", "u", "undo"},
}};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::size_t digit(char c) { return static_cast<std::size_t>(c - '0'); }

/// Whether the letters stand in the name, in this order.
bool has_letters(std::string_view name, std::string_view letters) {
  for (const char letter : letters) {
    const std::size_t at = name.find(letter);
    if (at == std::string_view::npos) return false;
    name.remove_prefix(at + 1);
  }
  return true;
}

/// Those that begin so, or the one that is called so.
std::vector<const Entry*> named_by(std::string_view word) {
  std::vector<const Entry*> begin;
  for (const Entry& entry : commands) {
    if (entry.name == word) return {&entry};
    if (entry.name.starts_with(word)) begin.push_back(&entry);
  }
  return begin;
}

std::vector<std::string> names_of(const std::vector<const Entry*>& entries) {
  std::vector<std::string> names;
  for (const Entry* entry : entries) names.emplace_back(entry->name);
  return names;
}

/// Whether a word of what it does begins so and holds the letters.
bool tells_of(const Entry& entry, std::string_view letters) {
  std::string word;
  const auto is_it = [&] {
    return letters.size() > 1 && word.starts_with(letters.front()) &&
           has_letters(word, letters);
  };
  for (const char c : entry.does) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      continue;
    }
    if (is_it()) return true;
    word.clear();
  }
  return is_it();
}

/// Where none begins so, those that hold its letters; where none does, the one
/// that is nearly called so and those that tell of it.
std::vector<const Entry*> meant_by(std::string_view word) {
  std::vector<const Entry*> meant = named_by(word);
  if (!meant.empty()) return meant;
  for (const Entry& entry : commands) {
    if (has_letters(entry.name, word)) meant.push_back(&entry);
  }
  if (!meant.empty()) return meant;
  const auto near = nearest_word(word, names_of(named_by("")));
  for (const Entry& entry : commands) {
    if (entry.name == near || tells_of(entry, word)) meant.push_back(&entry);
  }
  return meant;
}

[[noreturn]] void refuse(std::string_view word, std::string_view text) {
  std::vector<const Entry*> meant;
  if (!word.empty()) meant = meant_by(word);
  const std::string hint = meant.empty()
                               ? std::string()
                               : fmt::format("did you mean :{}? ",
                                             fmt::join(names_of(meant), ", :"));
  throw InputError(
      fmt::format("no such command: {}", text),
      "after ':'",
      fmt::format(
          "{}there are :{}", hint, fmt::join(names_of(named_by("")), " :")));
}

const Entry& entry_of(std::string_view word, std::string_view text) {
  if (word.empty()) refuse(word, text);
  const std::vector<const Entry*> meant = named_by(word);
  if (meant.empty()) refuse(word, text);
  if (meant.size() == 1) return *meant.front();
  throw InputError(
      fmt::format("{} may be any of several commands", word),
      "after ':'",
      fmt::format("write one of :{}", fmt::join(names_of(meant), " :")));
}

bool takes_more(const Entry& entry) {
  return !entry.takes.empty() && !entry.takes.starts_with('[');
}

}  // namespace

ColonCommand parse_colon_command(std::string_view text) {
  const std::string_view line = trimmed(text);
  if (line.size() == 1 && line[0] >= '1' && line[0] <= '7') {
    return {Kind::Screen, "", digit(line[0])};
  }
  const std::size_t space = line.find(' ');
  const std::string_view word = line.substr(0, space);
  const std::string_view rest =
      space == std::string_view::npos ? "" : trimmed(line.substr(space));
  const Entry& entry = entry_of(word, line);
  ColonCommand command{entry.kind, std::string(rest), 0};
  if (command.kind == Kind::Add && rest.empty()) {
    throw InputError(
        "which effect?", ":add", "write for example :add added-mass@201");
  }
  if (entry.takes.empty() && !rest.empty()) {
    throw InputError("takes no argument",
                     fmt::format(":{} {}", word, rest),
                     fmt::format("write :{} alone", word));
  }
  const bool splits = command.kind == Kind::Split && !rest.empty();
  if (command.kind == Kind::Screen || splits) {
    if (rest.size() != 1 || rest[0] < '1' || rest[0] > '7') {
      throw InputError(
          "which screen?", fmt::format(":{}", entry.name), "write 1 to 7");
    }
    command.number = digit(rest[0]);
  }
  if (command.kind == Kind::Run) {
    const char* end = rest.data() + rest.size();
    const auto [read, error] =
        std::from_chars(rest.data(), end, command.number);
    if (error != std::errc() || read != end || command.number == 0) {
      throw InputError("which run?", ":run", "write its number");
    }
  }
  if (command.kind == Kind::Toggle) {
    if (rest.size() != 1 || rest[0] < '1' || rest[0] > '9') {
      throw InputError(
          "which effect?", ":toggle", "write the number of an added one");
    }
    command.number = digit(rest[0]);
  }
  return command;
}

std::string guessed(std::string_view text) {
  const std::string_view word = text.substr(0, text.find(' '));
  if (word.empty() || !named_by(word).empty()) return {};
  const std::vector<const Entry*> meant = meant_by(word);
  if (meant.size() != 1) return {};
  return std::string(meant.front()->name) +
         std::string(text.substr(word.size()));
}

std::vector<CommandWords> palette(std::string_view text) {
  const std::size_t space = text.find(' ');
  std::vector<CommandWords> words;
  for (const Entry* entry : meant_by(text.substr(0, space))) {
    words.push_back({std::string(entry->name),
                     std::string(entry->takes),
                     std::string(entry->does),
                     takes_more(*entry)});
  }
  return words;
}

const std::vector<KeyBinding>& usual_bindings() {
  static const std::vector<KeyBinding> bindings = [] {
    std::vector<KeyBinding> all;
    for (const Entry& entry : commands) {
      if (const auto named = read_key(entry.key)) {
        all.push_back(
            {named->key, std::string(entry.name), std::string(entry.brief)});
      }
    }
    return all;
  }();
  return bindings;
}

const KeyBinding* binding_of(const std::vector<KeyBinding>& bindings, Key key) {
  const auto found = std::ranges::find(bindings, key, &KeyBinding::key);
  return found == bindings.end() ? nullptr : &*found;
}

std::vector<std::string> completions(std::string_view text,
                                     const effects::TestContext& context) {
  std::vector<std::string> found;
  const std::size_t space = text.find(' ');
  if (space == std::string_view::npos) {
    for (const Entry* entry : meant_by(text)) found.emplace_back(entry->name);
    return found;
  }
  const std::string_view word = text.substr(0, space);
  if (word != "add") return found;
  // The last one; those before it stay.
  const std::size_t begin = text.rfind(' ') + 1;
  const std::string before(text.substr(0, begin));
  const std::string_view rest = text.substr(begin);
  const std::size_t at = rest.find('@');
  for (const effects::Effect* effect : effects::catalogue()) {
    const std::string name = effect->name();
    if (at == std::string_view::npos) {
      if (name.starts_with(rest)) found.push_back(before + name);
    } else if (name == rest.substr(0, at)) {
      for (const std::string& place :
           place_words(*effect, context, rest.substr(at + 1))) {
        found.push_back(fmt::format("{}{}@{}", before, name, place));
      }
    }
  }
  return found;
}

std::string completed(std::string_view text,
                      const effects::TestContext& context) {
  const std::vector<std::string> all = completions(text, context);
  if (all.empty()) return std::string(text);
  const bool begins = all.front().starts_with(text);
  if (!begins && all.size() > 1) return std::string(text);
  std::string common = all.front();
  for (const std::string& one : all) {
    const auto apart =
        std::mismatch(common.begin(), common.end(), one.begin(), one.end());
    common.erase(apart.first, common.end());
  }
  // One that takes something after it goes on to that.
  const auto* named = std::ranges::find(commands, common, &Entry::name);
  const bool goes_on = named != commands.end() && takes_more(*named);
  return goes_on ? common + " " : common;
}

}  // namespace tapfit::tui
