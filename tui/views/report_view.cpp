#include "tui/views/report_view.hpp"

#include "tui/report/effect_output.hpp"
#include "tui/report/mode_remarks.hpp"
#include "tui/report/report_parameters.hpp"
#include "tui/report/report_words.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/compared_modes.hpp"
#include "tui/views/modes_view.hpp"
#include "tui/widgets/bars.hpp"
#include "tui/widgets/heat_map.hpp"
#include "tui/widgets/mac_map.hpp"
#include "tui/workbench/diagnosed_effects.hpp"
#include "updating/fit/early_stopped_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tapfit::tui {
namespace {

using updating::Comparison;
using updating::ModePair;

constexpr int tallest = 2000;

/// Writes downwards.
struct Sheet {
  Screen screen;
  int y = 0;

  void line(const std::string& words, Style style = {}) {
    screen.text(1, y++, words, style, screen.width() - 2);
  }
  void heading(const std::string& words) {
    if (y > 0) ++y;
    line(words, {.colour = Colour::Sky, .bold = true});
  }
  void paragraph(const std::string& words, Style style = {}) {
    for (const std::string& row : wrapped(words, screen.width() - 4)) {
      line(row, style);
    }
  }
};

/// Whether anything was added to the base model or fitted in it.
bool changed(const ReportInput& input) { return input.ladder.size() > 1; }

std::string found_text(const updating::Diagnosis& d) {
  if (d.ladder.empty()) return d.verdict;
  std::string text = d.verdict == "unexplained" ? "unexplained; best " : "";
  for (const updating::Rung& rung : d.ladder) {
    if (&rung != &d.ladder.front()) text += " + ";
    text += effect_text(rung.added, rung.where);
  }
  return text;
}

void write_diagnoses(Sheet& sheet, const ReportInput& input) {
  if (input.diagnoses.empty()) {
    sheet.line("not diagnosed yet: 5 finds what may be missing");
  }
  for (const auto& [effects, diagnosis] : input.diagnoses) {
    const std::string model =
        effects == 0 ? "the base model"
                     : fmt::format("the model with {}", effects_text(effects));
    sheet.paragraph(
        fmt::format("missing from {}: {}", model, found_text(*diagnosis)));
    // A diagnosis tells its error from the base model's, the rung its own.
    const double before = error_with(input.ladder, effects, *diagnosis);
    sheet.line(fmt::format(
        "    error {} → {}, floor {}",
        percent(before),
        percent(diagnosis->ladder.empty()
                    ? before
                    : error_found(input.ladder, effects, *diagnosis)),
        percent(diagnosis->floor)));
  }
}

void write_verdict(Sheet& sheet, const ReportInput& input) {
  sheet.heading("Verdict");
  const std::string error =
      changed(input) ? fmt::format("model now: error {} → {}",
                                   percent(input.base.error),
                                   percent(input.current.error))
                     : "model as delivered: error " + percent(input.base.error);
  sheet.line(fmt::format("{}, floor {} ({})",
                         error,
                         percent(input.current.floor),
                         floor_words(input.current)),
             {.bold = true});
  write_diagnoses(sheet, input);
  sheet.paragraph(contour_words(input.current.contour),
                  {.colour = Colour::Grey});
}

void write_ladder(Sheet& sheet, const ReportInput& input) {
  sheet.heading("Error ladder");
  double largest = 1e-9;
  for (const updating::Rung& rung : input.ladder) {
    if (std::isfinite(rung.error)) largest = std::max(largest, rung.error);
  }
  const int names = std::clamp(sheet.screen.width() / 2, 20, 50);
  for (const updating::Rung& rung : input.ladder) {
    const bool base = rung.added == updating::base_rung;
    const std::string what =
        base ? std::string("base model")
        : rung.added == updating::uncertain_rung
            ? std::string("uncertain properties fitted")
            : fmt::format("+ {} {}", rung.added, place(rung.where));
    sheet.screen.text(1, sheet.y, what, {}, names - 2);
    sheet.screen.text_right(names + 8, sheet.y, percent(rung.error));
    draw_error_bar(sheet.screen,
                   {names + 10, sheet.y, sheet.screen.width() - names - 12, 1},
                   rung.error,
                   input.current.floor,
                   largest);
    ++sheet.y;
    if (base) continue;
    if (rung.stopped_after > 0) {
      sheet.line("    " + updating::stopped_text(rung.stopped_after),
                 {.colour = Colour::Yellow});
    }
  }
  // Of the last model: rungs hold what was found when each was the last.
  if (input.parameters.empty() || !changed(input)) return;
  sheet.heading("Identified");
  for (const updating::Estimate& p : told(input.parameters)) {
    const bool known = input.bundle != nullptr && input.deck != nullptr;
    const std::string change =
        known ? change_words(*input.bundle, *input.deck, p) : "";
    sheet.line(describe(p) +
               (change.empty() ? "" : ", " + change + " to the deck"));
  }
}

void write_frequencies(Sheet& sheet, const ReportInput& input) {
  const bool both = changed(input);
  const Comparison* after = both ? &input.current : nullptr;
  sheet.heading(both ? "Frequencies and MAC, before and after"
                     : "Frequencies and MAC");
  const Table table = pair_table(input.base, after);
  if (table.rows.empty()) {
    return sheet.paragraph(
        "No measured mode was paired with one of the model: none is near "
        "enough in frequency and shape. 4 lists both.");
  }
  const int rows = static_cast<int>(table.rows.size()) + 1;
  draw_table(
      sheet.screen, {0, sheet.y, sheet.screen.width(), rows}, table, {}, false);
  sheet.y += rows;
  if (input.base.pairs.empty() || input.current.pairs.empty()) return;
  sheet.line("mean frequency error " + mean_error_words(input.base) +
             (both ? " → " + mean_error_words(input.current) : ""));
  for (const std::string& remark : mode_remarks(input.current)) {
    sheet.paragraph(remark, {.colour = Colour::Grey});
  }
}

HeatMap numbered_mac(const Comparison& c, int column) {
  HeatMap map = mac_map(c.mac, c.modes.frequency_hz);
  for (Eigen::Index i = 0; i < c.mac.rows(); ++i) {
    map.row_names.push_back(std::to_string(i + 1));
  }
  const int last = static_cast<int>(c.mac.cols()) - 1;
  map.left =
      std::clamp(map.first + column, map.first, std::max(map.first, last));
  return map;
}

void write_macs(Sheet& sheet, const ReportInput& input, int column) {
  const auto known = [](const Comparison& c) {
    return c.mac.size() > 0 &&
           std::ranges::all_of(c.pairs, &ModePair::has_shape);
  };
  if (!known(input.base) || !known(input.current)) return;
  if (!changed(input)) {
    sheet.heading("MAC in %, measured (rows) with model" +
                  rigid_words(input.base.modes.frequency_hz));
    const int rows = static_cast<int>(input.base.mac.rows()) + 1;
    draw_heat_map(sheet.screen,
                  {1, sheet.y, sheet.screen.width() - 2, rows},
                  numbered_mac(input.base, column));
    sheet.y += rows;
    return;
  }
  sheet.heading(
      fitting({"MAC in %, measured (rows) with model (columns, Hz): before | "
               "after" +
                   rigid_words(input.base.modes.frequency_hz),
               "MAC in %, measured (rows) with model: before | after"},
              sheet.screen.width() - 2));
  const int half = sheet.screen.width() / 2;
  const int rows = static_cast<int>(std::max(input.base.mac.rows(),
                                             input.current.mac.rows())) +
                   1;
  HeatMap before = numbered_mac(input.base, column);
  HeatMap after = numbered_mac(input.current, column);
  before.title += ", before";
  after.title += ", after";
  draw_heat_map(sheet.screen, {1, sheet.y, half - 2, rows}, before);
  draw_heat_map(sheet.screen, {half + 1, sheet.y, half - 2, rows}, after);
  sheet.y += rows;
}

std::vector<std::string> all_warnings(const Snapshot& known) {
  std::vector<std::string> found = known.bundle->warnings;
  const auto take = [&found](const std::vector<std::string>& more) {
    found.insert(found.end(), more.begin(), more.end());
  };
  if (known.deck) take(known.deck->warnings);
  if (known.modes) take(known.modes->warnings);
  if (known.diagnosis) take(known.diagnosis->warnings);
  return found;
}

ReportInput report_input(const Snapshot& known) {
  std::map<std::size_t, Snapshot::Shared<updating::Diagnosis>> diagnoses;
  for (const Snapshot::Effects& effects :
       {Snapshot::Effects{}, known.effects_on()}) {
    if (auto found = known.diagnosis_of(effects)) {
      diagnoses[effects.size()] = std::move(found);
    }
  }
  return {*known.base_comparison,
          *known.comparison,
          *known.ladder,
          *known.parameters,
          std::move(diagnoses),
          all_warnings(known),
          known.bundle.get(),
          known.deck.get()};
}

/// Where the work ends with the modes.
void write_modes(Sheet& sheet, const Snapshot& known) {
  sheet.heading("Modes");
  const Table table = mode_table(*known.modes);
  if (table.rows.empty()) sheet.line("No mode was found.");
  const int rows = static_cast<int>(table.rows.size()) + 1;
  if (!table.rows.empty()) {
    draw_table(sheet.screen,
               {0, sheet.y, sheet.screen.width(), rows},
               table,
               {},
               false);
    sheet.y += rows;
  }
  sheet.heading("Model");
  sheet.paragraph(
      "This bundle has no model, so the work ends with the modes; a deck named "
      "as \"model\" in test.json goes on with it.");
}

void write_warnings(Sheet& sheet, const std::vector<std::string>& warnings) {
  if (warnings.empty()) return;
  sheet.heading("Warnings");
  for (const std::string& warning : warnings) {
    sheet.paragraph(fmt::format("! {}", warning), {.colour = Colour::Yellow});
  }
}

Screen cut_to_height(const Sheet& sheet) {
  const Screen& whole = sheet.screen;
  Screen cut(whole.width(), std::min(sheet.y, tallest), whole.ascii());
  cut.place(0, 0, whole);
  return cut;
}

Screen scrolled(const Screen& sheet, int first_row, const Canvas& canvas) {
  Screen screen(canvas);
  const int last = std::max(sheet.height() - canvas.height, 0);
  screen.place(0, -std::clamp(first_row, 0, last), sheet);
  if (first_row < last) screen.put(canvas.width - 1, canvas.height - 1, U'↓');
  if (first_row > 0) screen.put(canvas.width - 1, 0, U'↑');
  return screen;
}

Screen sheet_of(const Snapshot& known, Canvas canvas, int mac_column) {
  if (known.has_model) {
    return report_sheet(report_input(known), canvas, mac_column);
  }
  canvas.height = tallest;
  Sheet sheet{Screen(canvas)};
  write_modes(sheet, known);
  write_warnings(sheet, all_warnings(known));
  return cut_to_height(sheet);
}

}  // namespace

Screen report_sheet(const ReportInput& input, Canvas canvas, int mac_column) {
  canvas.height = tallest;
  Sheet sheet{Screen(canvas)};
  write_verdict(sheet, input);
  write_ladder(sheet, input);
  write_frequencies(sheet, input);
  write_macs(sheet, input, mac_column);
  write_warnings(sheet, input.warnings);
  return cut_to_height(sheet);
}

Screen report_view(const ReportInput& input,
                   const ReportState& state,
                   const Canvas& canvas) {
  return scrolled(
      report_sheet(input, canvas, state.mac_column), state.first_row, canvas);
}

Screen ReportPage::draw(const Snapshot& known, const Canvas& canvas) const {
  return scrolled(
      sheet_of(known, canvas, state_.mac_column), state_.first_row, canvas);
}

bool ReportPage::press_mac(const Snapshot& known, Key key) {
  if (key == U'h' || key == keys::left) {
    state_.mac_column = std::max(state_.mac_column - 1, 0);
  } else if (key == U'l' || key == keys::right) {
    const auto columns = static_cast<int>(std::max(
        known.comparison->mac.cols(), known.base_comparison->mac.cols()));
    const int own =
        columns - rigid_modes(known.base_comparison->modes.frequency_hz);
    state_.mac_column =
        std::clamp(state_.mac_column + 1, 0, std::max(own - 1, 0));
  } else {
    return false;
  }
  return true;
}

bool ReportPage::press(const Snapshot& known, Key key, Command& command) {
  const int rows = sheet_of(known, {}, 0).height();
  if (key == keys::down || key == U'j' || key == keys::wheel_down) {
    ++state_.first_row;
  } else if (key == keys::up || key == U'k' || key == keys::wheel_up) {
    --state_.first_row;
  } else if (key == U'w' || key == U'f' || (key == U'e' && known.has_model)) {
    command.kind = Command::Kind::Write;
    command.output = key == U'w'   ? Output::Report
                     : key == U'f' ? Output::Uff
                                   : Output::Deck;
  } else if (key == keys::page_down || key == U' ') {
    state_.first_row += 10;
  } else if (key == keys::page_up) {
    state_.first_row -= 10;
  } else if (key == keys::home || key == U'g') {
    state_.first_row = 0;
  } else if (key == keys::end || key == U'G') {
    state_.first_row = rows;
  } else if (!known.has_model || !press_mac(known, key)) {
    return false;
  }
  state_.first_row = std::clamp(state_.first_row, 0, std::max(rows - 10, 0));
  return true;
}

std::vector<KeyHelp> ReportPage::keys(const Snapshot& known) const {
  if (!known.has_model) {
    return {{"w", "write report"}, {"f", "write UFF"}, {"j k", "scroll"}};
  }
  return {{"j k", "scroll"},
          {"w", "write report"},
          {"e", "deck"},
          {"f", "UFF"},
          {"PgUp PgDn", "page"},
          {"h l", "MAC columns"},
          {"g G", "top, end"},
          {"u", "undo"},
          {"^R", "redo"}};
}

std::string ReportPage::help() const {
  return "What was found, on one sheet: the error with each effect that was "
         "added, the frequencies and MAC of the base model and the current "
         "one against the measurement, and every warning that was given. w "
         "writes "
         "a report with pictures, set-up, hits, FRFs and modes to report.html "
         "beside the bundle's test.json (nothing added: with what the "
         "diagnosis "
         "finds), e the deck with what was identified to updated.bdf (.inp for "
         "a deck of Abaqus or CalculiX), f "
         "FRFs and modes to measured.uff; :report FILE, :deck FILE and :uff "
         "FILE write elsewhere.";
}

}  // namespace tapfit::tui
