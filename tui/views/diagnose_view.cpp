#include "tui/views/diagnose_view.hpp"

#include "tui/report/report_words.hpp"
#include "tui/screen/layout.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/diagnose_details.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

using updating::Candidate;

/// Lines below each other from row y; returns the row after them.
int write(Screen& screen,
          int y,
          const std::vector<std::string>& lines,
          Colour colour) {
  for (const std::string& line : lines) {
    screen.text(1, y++, line, {.colour = colour}, screen.width() - 2);
  }
  return y;
}

/// How large the chosen one is, and what else it could be.
int write_chosen(Screen& screen,
                 int y,
                 const DiagnoseInput& input,
                 const Candidate& chosen) {
  const updating::Diagnosis& d = input.diagnosis;
  const int width = screen.width() - 2;
  y = write(screen, y, wrapped(all_sizes(chosen), width, 2), Colour::Default);
  if (d.verdict.empty()) return y;
  // The narrow table has no column for it.
  const bool tried = chosen.held_out_error > 0.0 && !is_wide(screen.width());
  const std::string error =
      tried ? fmt::format("hold-out error {}; ", left_out(chosen)) : "";
  // A long list of look-alikes may be cut off, what to do about it not.
  const std::string words =
      next_step(d, chosen) + error +
      indistinguishable(d, chosen, input.bundle.modes.has_value());
  const bool unsure = !chosen.indistinguishable_from.empty();
  return write(screen,
               y,
               wrapped(words, width, 3),
               unsure ? Colour::Yellow : Colour::Default);
}

/// The verdict and the errors, which get a line of their own beside a long
/// list of kinds.
std::vector<std::string> verdict_lines(const updating::Diagnosis& d,
                                       Standing standing,
                                       std::size_t tagged,
                                       int width) {
  if (standing == Standing::Preliminary) {
    return {fmt::format("{}   {} tried, the best leaves {}",
                        verdict_words(d),
                        d.candidates.size(),
                        percent(d.error_best))};
  }
  std::string errors = fmt::format("error {} → {}, floor {}",
                                   percent(d.error_base),
                                   percent(d.error_best),
                                   percent(d.floor));
  if (tagged > 0) errors += fmt::format("   {} tagged", tagged);
  const std::string verdict = verdict_words(d);
  const std::string both = verdict + "   " + errors;
  if (text_width(both) <= width) return {both};
  return {verdict, errors};
}

/// What stands in the way or, where nothing does, how it was compared. All of
/// it is in the details.
std::string note_line(const updating::Diagnosis& d,
                      Standing standing,
                      int width) {
  if (standing == Standing::Outdated) {
    return "outdated, diagnosing again … (where it was stopped: r)";
  }
  if (standing == Standing::Preliminary) {
    return "preliminary: what was fitted first; a adds one";
  }
  const bool warned = !d.warnings.empty();
  std::string note = warned ? "! " + d.warnings[0] : contour_words(d.contour);
  const std::string more =
      d.warnings.size() > 1
          ? fmt::format("  (1 of {} notes, i: all)", d.warnings.size())
          : "  (i: all)";
  if (text_width(note) <= width && d.warnings.size() < 2) return note;
  return clipped(note, width - text_width(more)) + more;
}

/// Of a candidate whose place does not explain most: how much it does.
std::string place_note(const DiagnoseInput& input, const Candidate& chosen) {
  if (input.frfs->frfs.empty()) return {};  // modes have no signature
  const std::optional<int> grid = signature_grid(input.bundle, chosen);
  if (!grid || has_signature(input.bundle, input.signatures, chosen)) return {};
  return fmt::format("grid {} alone explains {} of the misfit: no signature",
                     *grid,
                     percent(input.signatures.at(*grid)->explained));
}

/// The signature where it says something, else the FRFs.
void draw_left(Screen& screen,
               const Rect& rect,
               const DiagnoseInput& input,
               const DiagnoseState& state,
               const Candidate& chosen) {
  const auto say = [&](const char* words) {
    screen.text(rect.x + 1, rect.y + 1, words, {.colour = Colour::Grey});
  };
  if (!state.evidence &&
      has_signature(input.bundle, input.signatures, chosen)) {
    return draw_signature(screen, rect, input, state, chosen);
  }
  if (chosen.effect == updating::nonlinearity) {
    return say("no linear model holds it: no curve of one to plot");
  }
  if (input.standing == Standing::Preliminary) {
    return say("FRFs with and without it come with the verdict");
  }
  if (input.frfs == nullptr) return;
  draw_evidence(screen,
                rect,
                {*input.frfs, input.evidence, place_note(input, chosen)},
                state.range);
}

/// In place of table and plots, from row `top` on, scrolled down so far.
void draw_lines(Screen& screen,
                const std::vector<std::string>& lines,
                int top,
                int first) {
  const int rows = screen.height() - top;
  const int count = static_cast<int>(lines.size());
  first = std::clamp(first, 0, std::max(count - rows, 0));
  for (int i = 0; i < std::min(rows, count - first); ++i) {
    screen.text(1, top + i, lines[static_cast<std::size_t>(first + i)]);
  }
  const int right = screen.width() - 1;
  if (first > 0) screen.put(right, top, U'↑');
  if (first + rows < count) screen.put(right, screen.height() - 1, U'↓');
}

}  // namespace

Screen diagnose_view(const DiagnoseInput& input,
                     const DiagnoseState& state,
                     const Canvas& canvas) {
  Screen screen(canvas);
  const updating::Diagnosis& d = input.diagnosis;
  const std::size_t tagged = tagged_of(d, state.tagged).size();
  const int room = canvas.width - 2;
  int top = 0;
  const bool outdated = input.standing == Standing::Outdated;
  for (const std::string& line :
       verdict_lines(d, input.standing, tagged, room)) {
    screen.text(1, top++, line, {.bold = true}, room);
  }
  const bool warned = input.standing != Standing::Final || !d.warnings.empty();
  screen.text(1,
              top++,
              note_line(d, input.standing, room),
              {.colour = warned ? Colour::Yellow : Colour::Grey});
  if (state.firmness) {
    draw_lines(screen, firmness_lines(d, room), top + 1, *state.firmness);
    return screen;
  }
  if (d.candidates.empty()) {
    int y = write(screen,
                  top + 1,
                  {"No candidate: nothing in the catalogue fits.", ""},
                  Colour::Default);
    for (const std::string& warning : d.warnings) {
      y = write(screen, y, wrapped("! " + warning, canvas.width - 2), {});
    }
    return screen;
  }
  Table table = candidate_table(d, state.tagged, canvas.width, canvas.ascii);
  if (outdated) {
    for (Row& row : table.rows) row.style.colour = Colour::Grey;
  }
  const Candidate& chosen = d.candidates[settled(table, state.list)];
  if (none_shown(table, state.list)) {
    draw_table(screen, {0, top, canvas.width, 4}, table, state.list, true);
    return screen;
  }
  if (state.details) {
    draw_lines(screen,
               details_of(d, chosen, room, input.bundle.modes.has_value()),
               top + 1,
               *state.details);
    return screen;
  }
  const Rect body{0, top, canvas.width, canvas.height - top};
  const int rows = std::clamp(static_cast<int>(d.candidates.size()) + 1,
                              4,
                              std::max(body.height / 3, 4));
  const auto [list, rest] = split_top(body, rows);
  draw_table(screen, list, table, state.list, true);
  if (input.missing != nullptr) {
    write(screen,
          rest.y,
          wrapped(missing_words(*input.missing, input.standing), room),
          Colour::Yellow);
    return screen;
  }
  const int below = write_chosen(screen, rest.y, input, chosen);
  if (outdated) return screen;
  const Rect lower{0, below, canvas.width, canvas.height - below};
  const std::vector<int> grids =
      grids_of(input.bundle, chosen.where, input.deck);
  const auto [left, right] = split_left(lower, canvas.width * 5 / 8);
  draw_left(screen, left, input, state, chosen);
  if (state.map) {
    draw_map(screen, right, input, state);
  } else {
    draw_place(screen, right, input.wire, state.pose, grids);
  }
  return screen;
}

}  // namespace tapfit::tui
