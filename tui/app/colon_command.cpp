#include "tui/app/colon_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/nearest_word.hpp"
#include "tui/app/place_words.hpp"
#include "updating/catalogue/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>
#include <utility>

namespace tapfit::tui {
namespace {

using Kind = ColonCommand::Kind;

constexpr std::array<std::pair<std::string_view, Kind>, 19> commands{{
    {"quit", Kind::Quit},     {"help", Kind::Help},     {"add", Kind::Add},
    {"toggle", Kind::Toggle}, {"undo", Kind::Undo},     {"redo", Kind::Redo},
    {"drop", Kind::Drop},     {"pick", Kind::Pick},     {"pair", Kind::Pair},
    {"band", Kind::Band},     {"screen", Kind::Screen}, {"run", Kind::Run},
    {"report", Kind::Report}, {"deck", Kind::Deck},     {"uff", Kind::Uff},
    {"plot", Kind::Plot},     {"stop", Kind::Stop},     {"retry", Kind::Retry},
    {"exit", Kind::Quit},
}};

[[noreturn]] void refuse(std::string_view word, std::string_view text) {
  std::vector<std::string> names;
  for (const auto& [name, kind] : commands) names.emplace_back(name);
  throw InputError(
      fmt::format("no such command: {}", text),
      "after ':'",
      did_you_mean(word, names) +
          "there are :q :help :add EFFECT@PLACE ... :toggle N :undo :redo "
          ":drop HZ :pick HZ :pair I:K :band LOW HIGH :screen N "
          ":run N :report :deck :uff :plot :stop :retry");
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::size_t digit(char c) { return static_cast<std::size_t>(c - '0'); }

Kind kind_of(std::string_view word, std::string_view text) {
  if (word.empty()) refuse(word, text);
  int found = 0;
  Kind kind = Kind::Help;
  for (const auto& [name, its] : commands) {
    if (name == word) return its;
    if (!name.starts_with(word)) continue;
    ++found;
    kind = its;
  }
  if (found != 1) refuse(word, text);
  return kind;
}

bool takes_nothing(Kind kind) {
  constexpr std::array<Kind, 6> alone{
      Kind::Quit, Kind::Help, Kind::Undo, Kind::Redo, Kind::Stop, Kind::Retry};
  return std::ranges::find(alone, kind) != alone.end();
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
  ColonCommand command{kind_of(word, line), std::string(rest), 0};
  if (command.kind == Kind::Add && rest.empty()) {
    throw InputError(
        "which effect?", ":add", "write for example :add added-mass@201");
  }
  if (takes_nothing(command.kind) && !rest.empty()) {
    throw InputError("takes no argument",
                     fmt::format(":{} {}", word, rest),
                     fmt::format("write :{} alone", word));
  }
  if (command.kind == Kind::Screen) {
    if (rest.size() != 1 || rest[0] < '1' || rest[0] > '7') {
      throw InputError("which screen?", ":screen", "write 1 to 7");
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

std::vector<std::string> completions(std::string_view text,
                                     const effects::TestContext& context) {
  std::vector<std::string> found;
  const std::size_t space = text.find(' ');
  if (space == std::string_view::npos) {
    for (const auto& [name, kind] : commands) {
      if (name.starts_with(text)) found.emplace_back(name);
    }
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
  std::string common = all.front();
  for (const std::string& one : all) {
    const auto apart =
        std::mismatch(common.begin(), common.end(), one.begin(), one.end());
    common.erase(apart.first, common.end());
  }
  // One that takes something after it goes on to that.
  const bool takes = common == "add" || common == "toggle" ||
                     common == "screen" || common == "run";
  return all.size() == 1 && takes ? common + " " : common;
}

}  // namespace tapfit::tui
