// What is typed on the bottom line: filters and ":" commands.
#include "acquisition/foundation/input_error.hpp"
#include "tui/app/actions.hpp"
#include "tui/app/colon_command.hpp"
#include "tui/app/mode_actions.hpp"
#include "tui/app/program.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/recording_view.hpp"

#include <fmt/format.h>

namespace tapfit::tui {
namespace {

/// As a shell's line: Ctrl-U takes all away, Ctrl-W the last word.
bool clear_key(std::string& line, Key key) {
  if (key == Key(U'u', true)) {
    line.clear();
  } else if (key == Key(U'w', true)) {
    while (!line.empty() && line.back() == ' ') line.pop_back();
    while (!line.empty() && line.back() != ' ') line.pop_back();
  } else {
    return false;
  }
  return true;
}

/// Puts a character to the end, where the key is one.
void type_key(std::string& line, Key key) {
  const bool named = key.code >= 0xE000 && key.code <= 0xF8FF;
  if (key.ctrl || key.code < U' ' || key.code == 0x7F || named) return;
  append_utf8(line, key.code);
}

/// The last character, with all bytes that it takes.
void take_back(std::string& line) {
  const auto follows = [](char c) { return (c & '\xC0') == '\x80'; };
  while (!line.empty() && follows(line.back())) line.pop_back();
  if (!line.empty()) line.pop_back();
}

}  // namespace

void Program::press_filter(Key key) {
  ListState* list = page().list();
  if (list == nullptr || key == keys::enter) {
    mode_ = Mode::Normal;
  } else if (key == keys::escape || key == Key(U'c', true)) {
    list->filter.clear();
    mode_ = Mode::Normal;
  } else if (key == keys::backspace) {
    take_back(list->filter);
  } else if (!clear_key(list->filter, key)) {
    type_key(list->filter, key);
  }
}

void Program::press_colon(Key key) {
  if (key == keys::escape || key == Key(U'c', true)) {
    mode_ = Mode::Normal;
  } else if (key == keys::enter) {
    run_typed();
  } else if (key == keys::tab) {
    typed_ = completed(typed_, context());
  } else if (key == keys::up && !typed_before_.empty()) {
    typed_ = typed_before_;
  } else if (key == keys::backspace) {
    if (typed_.empty()) {
      mode_ = Mode::Normal;
    } else {
      take_back(typed_);
    }
  } else if (!clear_key(typed_, key)) {
    type_key(typed_, key);
  }
}

void Program::run_typed() {
  if (const std::string guess = guessed(typed_); !guess.empty()) {
    typed_ = guess;
    return;
  }
  mode_ = Mode::Normal;
  if (!typed_.empty()) typed_before_ = typed_;
  run_colon(typed_);
}

void Program::choose_command(std::size_t entry) {
  const std::vector<CommandWords> words = palette(typed_);
  if (entry >= words.size()) return;
  typed_.replace(0, typed_.find(' '), words[entry].name);
  const bool waits = words[entry].takes_more && typed_ == words[entry].name;
  waits ? typed_.push_back(' ') : run_typed();
}

effects::TestContext Program::context() const {
  effects::TestContext context;
  context.bundle = known_.bundle.get();
  context.deck = known_.deck.get();
  return context;
}

void Program::run_colon(const std::string& text) {
  if (text.empty()) return;
  using Kind = ColonCommand::Kind;
  ColonCommand command;
  try {
    command = parse_colon_command(text);
  } catch (const InputError& error) {
    return tell(error.what(), true);
  }
  switch (command.kind) {
    case Kind::Quit:
      return ask_to_quit();
    case Kind::Help:
      return open_help();
    case Kind::Add:
      return act(add_effects(command.argument));
    case Kind::Toggle:
      return act(toggle_effect(command.number - 1));
    case Kind::Run:
      return show_run(command.number);
    case Kind::Report:
      return write(Output::Report, command.argument);
    case Kind::Deck:
      return write(Output::Deck, command.argument);
    case Kind::Uff:
      return write(Output::Uff, command.argument);
    case Kind::Plot:
      return write_plots(command.argument);
    case Kind::Undo:
      return step_back();
    case Kind::Redo:
      return step_on();
    case Kind::Copy:
      return copy_plots();
    case Kind::Keep:
      return keep_reached();
    case Kind::Drop:
    case Kind::Pick:
    case Kind::Pair:
    case Kind::Band:
      return run_mode_action(command);
    case Kind::Stop:
      return running_ ? stop_work() : tell("nothing runs");
    case Kind::Retry:
      return retry();
    case Kind::Tour:
      return show_tour(!tour_);
    case Kind::Split:
      if (split_ && command.number == 0) return end_split(true);
      return split(command.number == 0 ? std::nullopt
                                       : std::optional(command.number - 1));
    case Kind::Only:
      return end_split(true);
    case Kind::Close:
      return end_split(false);
    case Kind::Screen:
      return show_screen(command.number - 1);
  }
}

void Program::show_run(std::size_t number) {
  const std::size_t runs = known_.bundle ? known_.bundle->runs.size() : 0;
  if (number > runs) {
    return tell(fmt::format("there is no run {}, of {}", number, runs), true);
  }
  recording_page_->select(number - 1);
  show_screen(0);
}

void Program::run_mode_action(const ColonCommand& command) {
  using Kind = ColonCommand::Kind;
  const char* word = command.kind == Kind::Drop   ? "drop"
                     : command.kind == Kind::Pick ? "pick"
                     : command.kind == Kind::Pair ? "pair"
                                                  : "band";
  try {
    act(mode_action(word, command.argument));
  } catch (const InputError& error) {
    tell(error.what(), true);
  }
}

}  // namespace tapfit::tui
