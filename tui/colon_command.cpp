#include "tui/colon_command.hpp"

#include "acquisition/input_error.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace tapfit::tui {
namespace {

using Kind = ColonCommand::Kind;

constexpr std::array<std::pair<std::string_view, Kind>, 14> commands{{
    {"quit", Kind::Quit},
    {"help", Kind::Help},
    {"add", Kind::Add},
    {"toggle", Kind::Toggle},
    {"undo", Kind::Undo},
    {"redo", Kind::Redo},
    {"drop", Kind::Drop},
    {"pick", Kind::Pick},
    {"pair", Kind::Pair},
    {"band", Kind::Band},
    {"screen", Kind::Screen},
    {"stop", Kind::Stop},
    {"retry", Kind::Retry},
    {"exit", Kind::Quit},
}};

[[noreturn]] void refuse(std::string_view text) {
  throw InputError(fmt::format("no such command: {}", text),
                   "after ':'",
                   "there are :q :help :add EFFECT@PLACE :undo :redo :drop HZ "
                   ":pick HZ :pair I:K :band LOW HIGH :screen N :stop :retry");
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::size_t digit(char c) { return static_cast<std::size_t>(c - '0'); }

Kind kind_of(std::string_view word, std::string_view text) {
  if (word.empty()) refuse(text);
  int found = 0;
  Kind kind = Kind::Help;
  for (const auto& [name, its] : commands) {
    if (name == word) return its;
    if (!name.starts_with(word)) continue;
    ++found;
    kind = its;
  }
  if (found != 1) refuse(text);
  return kind;
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
  if (command.kind == Kind::Screen) {
    if (rest.size() != 1 || rest[0] < '1' || rest[0] > '7') {
      throw InputError("which screen?", ":screen", "write 1 to 7");
    }
    command.number = digit(rest[0]);
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

}  // namespace tapfit::tui
