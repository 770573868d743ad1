// What is written for others: never over what the test reads, over another file
// only after a `y`.
#include "tui/app/actions.hpp"
#include "tui/app/program.hpp"
#include "tui/report/session_report.hpp"
#include "tui/screen/text.hpp"
#include "updating/export/output_rule_of.hpp"
#include "updating/export/report_files.hpp"
#include "updating/export/written_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace tapfit::tui {
namespace {

const char* usual_name(Output what, const acquisition::TestBundle& bundle) {
  switch (what) {
    case Output::Report:
      return usual_report;
    case Output::Uff:
      return "measured.uff";
    case Output::Deck:
      break;
  }
  const bool keywords =
      bundle.deck && updating::as_keywords(*bundle.deck, "updated.inp");
  return keywords ? "updated.inp" : "updated.bdf";
}

// All that is written, or may be replaced by it.
std::vector<std::filesystem::path> files_of(Output what,
                                            const std::filesystem::path& to) {
  if (what == Output::Report) return updating::report_files(to);
  return {to};
}

std::filesystem::path free_for(Output what,
                               const std::filesystem::path& to,
                               const acquisition::OutputRule& rule) {
  return what == Output::Report ? updating::free_report(rule, to)
                                : rule.free_name(to);
}

// Pictures with their folder.
std::string shown_name(const std::filesystem::path& file,
                       const std::filesystem::path& to) {
  const std::filesystem::path name = file.filename();
  const std::filesystem::path folder = file.parent_path().filename();
  return (file == to ? name : folder / name).string();
}

}  // namespace

void Program::write(Output what, const std::string& named) {
  if (!known_.bundle) return tell("the bundle is not open yet", true);
  const std::filesystem::path to =
      named.empty() ? known_.bundle->folder / usual_name(what, *known_.bundle)
                    : std::filesystem::path(named);
  const std::string fault =
      what == Output::Report ? updating::report_name_fault(to) : "";
  if (!fault.empty()) return tell(fault + ": name it .html or .md", true);
  const acquisition::OutputRule rule =
      updating::output_rule_of(*known_.bundle, true, {to});
  const std::filesystem::path free = free_for(what, to, rule);
  const std::vector<std::filesystem::path> files = files_of(what, to);
  const auto input = std::ranges::find_if(
      files, [&rule](const auto& file) { return rule.is_input(file); });
  if (input != files.end()) {
    return act(
        write_output(what,
                     free,
                     false,
                     shown_name(*input, to) + " is an input and stays; "));
  }
  const auto there =
      std::ranges::find_if(files, acquisition::would_be_replaced);
  if (there == files.end()) return act(write_output(what, to, false));
  asked_to_replace_ = Replacement{what, to, free, shown_name(*there, to)};
}

void Program::answer_replacing(const Replacement& asked, Key key) {
  if (key == U'y') return act(write_output(asked.what, asked.there, true));
  if (key == U'n' || key == keys::enter) {
    return act(write_output(asked.what, asked.free, false));
  }
  tell("nothing written");
}

void Program::draw_question(Screen& screen, int y) const {
  const int width = screen.width() - 2;
  const std::string answers = fmt::format(
      " is there: y replaces it, n writes {}, Esc neither",
      clipped(asked_to_replace_->free.filename().string(), width / 4));
  const std::string name = clipped(asked_to_replace_->shown,
                                   std::max(8, width - text_width(answers)));
  screen.text(1, y, name + answers, {.colour = Colour::Yellow}, width);
}

}  // namespace tapfit::tui
