// What is written for others: never over what the test reads, over another file
// only after a `y`.
#include "tui/app/actions.hpp"
#include "tui/app/program.hpp"
#include "tui/report/session_report.hpp"
#include "tui/screen/text.hpp"
#include "updating/export/output_rule_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace tapfit::tui {
namespace {

const char* usual_name(Output what) {
  switch (what) {
    case Output::Report:
      return usual_report;
    case Output::Uff:
      return "measured.uff";
    case Output::Deck:
      break;
  }
  return "updated.bdf";
}

}  // namespace

void Program::write(Output what, const std::string& named) {
  if (!known_.bundle) return tell("the bundle is not open yet", true);
  const std::filesystem::path to =
      named.empty() ? known_.bundle->folder / usual_name(what)
                    : std::filesystem::path(named);
  const acquisition::OutputRule rule =
      updating::output_rule_of(*known_.bundle, true);
  const std::filesystem::path free = rule.free_name(to);
  if (rule.is_input(to)) {
    return act(write_output(
        what, free, to.filename().string() + " is an input and stays; "));
  }
  std::error_code fault;
  if (std::filesystem::is_regular_file(to, fault)) {
    asked_to_replace_ = Replacement{what, to, free};
    return;
  }
  act(write_output(what, to));
}

void Program::answer_replacing(const Replacement& asked, Key key) {
  if (key == U'y') return act(write_output(asked.what, asked.there));
  if (key == U'n' || key == keys::enter) {
    return act(write_output(asked.what, asked.free));
  }
  tell("nothing written");
}

void Program::draw_question(Screen& screen, int y) const {
  const int width = screen.width() - 2;
  const std::string answers = fmt::format(
      " is there: y replaces it, n writes {}, Esc neither",
      clipped(asked_to_replace_->free.filename().string(), width / 4));
  const std::string name = clipped(asked_to_replace_->there.filename().string(),
                                   std::max(8, width - text_width(answers)));
  screen.text(1, y, name + answers, {.colour = Colour::Yellow}, width);
}

}  // namespace tapfit::tui
