#include "tui/views/frf_view.hpp"

#include "modal/fit/frf_peaks.hpp"
#include "signal/checks/frf_quality.hpp"
#include "signal/frf_set/measured_coherence.hpp"
#include "tui/report/frf_text.hpp"
#include "tui/screen/layout.hpp"
#include "tui/screen/number.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/views/frf_panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::tui {
namespace {

using Eigen::Index;
using signal::Frf;
using signal::FrfForm;
using signal::FrfSet;
using Panel = FrfState::Panel;

Table frf_table(const FrfSet& frfs, const std::set<std::size_t>& tagged) {
  Table table{{{"FRF"}, {"coh", true}, {"sd %", true}, {"hits", true}}, {}};
  table.sortable = true;
  const std::vector<signal::FrfQuality> quality =
      signal::frf_quality(frfs, std::nullopt);
  for (std::size_t i = 0; i < frfs.frfs.size(); ++i) {
    const Frf& frf = frfs.frfs[i];
    const bool known = signal::has_coherence(frf);
    const double sd = quality[i].median_sd_percent;
    const bool poor = known && quality[i].mean_coherence < 0.9;
    table.rows.push_back({{(tagged.contains(i) ? "* " : "") + signal::name(frf),
                           known ? fixed(quality[i].mean_coherence, 3) : "–",
                           sd > 0.0 ? fixed(sd, 2) : "–",
                           frf.hits > 0 ? std::to_string(frf.hits) : "–"},
                          {.colour = poor ? Colour::Orange : Colour::Default}});
  }
  return table;
}

/// Peaks of one FRF: where, how high, how much damped.
Table peak_table(const FrfSet& frfs, const Frf& frf) {
  Table table{
      {{"peak Hz", true}, {"|H|", true}, {"phase", true}, {"damping %", true}},
      {}};
  for (const Index line : modal::peak_lines(frf)) {
    const std::optional<modal::PeakFit> fit =
        modal::fit_peak(frfs.s, frf.H, line);
    const double hz = fit ? fit->frequency_hz() : frfs.frequency_hz()[line];
    table.rows.push_back(
        {{fixed(hz, 3),
          number(std::abs(frf.H[line]), 3),
          fixed(std::arg(frf.H[line]) * 180.0 / std::numbers::pi, 0) + "°",
          fit ? fixed(100.0 * fit->damping_ratio(), 3) : "–"},
         {}});
  }
  return table;
}

/// The FRF that keys and read-outs are about.
std::size_t selected_frf(const FrfSet& frfs,
                         const FrfState& state,
                         const signal::FrfChecks* checks) {
  if (state.checks && checks != nullptr) {
    const std::size_t row =
        settled(check_table(frfs, *checks), state.check_list);
    if (const auto frf = checked_frf(*checks, row)) return *frf;
  }
  return settled(frf_table(frfs, state.tagged), state.list);
}

std::vector<std::size_t> shown_frfs(const FrfSet& frfs,
                                    const FrfState& state,
                                    std::size_t selected) {
  std::vector<std::size_t> shown{selected};
  if (state.checks) return shown;
  const auto add = [&](std::size_t i) {
    const bool there = std::find(shown.begin(), shown.end(), i) != shown.end();
    if (!there && i < frfs.frfs.size() && shown.size() < 6) shown.push_back(i);
  };
  if (state.both_ways) {
    if (const auto other = other_way(frfs, selected)) add(*other);
  }
  for (const std::size_t i : state.tagged) add(i);
  return shown;
}

void draw_frf_side(Screen& screen,
                   const Rect& side,
                   const FrfSet& frfs,
                   const FrfState& state,
                   const FrfChoice& choice) {
  const Table peaks = peak_table(choice.frfs, choice.selected());
  const int wanted = static_cast<int>(peaks.rows.size()) + 1;
  const int rows = side.height >= 16 ? std::min(wanted, side.height / 3) : 0;
  const auto [list, below] = split_top(side, side.height - rows);
  draw_table(screen, list, frf_table(frfs, state.tagged), state.list, true);
  if (rows == 0) return;
  const Index at = chosen_peak(choice.frfs, choice.selected(), state.range);
  Table marked = peaks;
  const auto lines = modal::peak_lines(choice.selected());
  ListState near;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] != at) continue;
    if (state.range.cursor_set) near.selected = i;
    marked.rows[i].style = {.colour = Colour::Yellow};
  }
  draw_table(screen, below, marked, near, false);
}

/// The peak next to the cursor on that side; none without one.
std::optional<double> next_peak(const FrfSet& frfs,
                                const Frf& frf,
                                const PlotRange& range,
                                bool upwards) {
  const Eigen::VectorXd f = frfs.frequency_hz();
  std::optional<double> found;
  for (const Index line : modal::peak_lines(frf)) {
    const double hz = f[line];
    if (upwards && (!range.cursor_set || hz > range.cursor + 1e-9)) return hz;
    if (!upwards && (!range.cursor_set || hz < range.cursor - 1e-9)) {
      found = hz;
    }
  }
  return found;
}

/// Moves the stretch on show so that it holds the cursor.
void show_cursor(PlotRange& range, double lo, double hi) {
  const PlotRange shown = resolved(range, lo, hi);
  if (range.cursor >= shown.lo && range.cursor <= shown.hi) return;
  const double width = shown.hi - shown.lo;
  range.lo = std::clamp(range.cursor - 0.5 * width, lo, hi - width);
  range.hi = range.lo + width;
}

}  // namespace

Screen frf_view(const FrfSet& frfs,
                const FrfState& state,
                const Canvas& canvas,
                const signal::FrfChecks* checks) {
  Screen screen(canvas);
  if (frfs.frfs.empty()) {
    screen.text(1, 1, "There is no FRF: no run has an accepted hit (1).");
    return screen;
  }
  const Rect all{0, 0, canvas.width, canvas.height - 1};
  const std::size_t selected = selected_frf(frfs, state, checks);
  const FrfChoice choice =
      chosen_frfs(frfs,
                  shown_frfs(frfs, state, selected),
                  state.checks ? FrfForm::Accelerance : state.form);
  if (state.checks && checks != nullptr) {
    draw_checks(screen, all, frfs, *checks, state.check_list, state.range);
  } else if (state.checks) {
    screen.text(1, 1, "checks …", {.colour = Colour::Grey});
  } else {
    const int side_width = std::min(canvas.width * 3 / 8, 38);
    const auto [side, body] = split_left(all, side_width);
    draw_frf_side(screen, side, frfs, state, choice);
    draw_panel(screen, body, choice, state);
  }
  screen.text(1,
              canvas.height - 1,
              frf_read_out(choice, state, canvas.width - 2),
              {},
              canvas.width - 2);
  return screen;
}

Screen FrfPage::draw(const Snapshot& known, const Canvas& canvas) const {
  if (known.bundle && known.bundle->modes) {
    Screen screen(canvas);
    screen.text(1, 1, "The test consists of modes: there are no FRFs (3, 4).");
    return screen;
  }
  return frf_view(*known.frfs, state_, canvas, known.frf_checks.get());
}

void FrfPage::select(std::size_t frf, std::optional<double> hz) {
  state_.list.selected = frf;
  state_.list.filter.clear();
  state_.checks = false;
  if (!hz) return;
  state_.range = {};
  state_.range.cursor = *hz;
  state_.range.cursor_set = true;
}

bool FrfPage::press_view(const Snapshot& known, Key key) {
  const FrfSet& frfs = *known.frfs;
  const Table table = frf_table(frfs, state_.tagged);
  const std::size_t selected = settled(table, state_.list);
  if (key == U'X') {
    state_.log_f = !state_.log_f;
  } else if (key == U'b') {
    state_.band = !state_.band;
  } else if (key == U'd') {
    state_.checks = !state_.checks;
  } else if (key == U'o') {
    state_.both_ways = !state_.both_ways;
  } else if (state_.checks) {
    return press_panel(key);  // of accelerances, whatever is shown else
  } else if (key == U'x') {
    state_.scale = next(state_.scale);
  } else if (key == U'v') {
    state_.form = next(state_.form);
  } else if (key == U't' || key == U' ') {
    if (none_shown(table, state_.list)) return true;
    if (state_.tagged.erase(selected) == 0) state_.tagged.insert(selected);
    static_cast<void>(list_key(state_.list, table, keys::down));
  } else if (key == U'*') {
    for (const std::size_t row : visible_rows(table, state_.list)) {
      state_.tagged.insert(row);
    }
  } else if (key == U'T') {
    state_.tagged.clear();
  } else {
    return press_panel(key);
  }
  return true;
}

bool FrfPage::press_panel(Key key) {
  if (key != keys::tab && key != U'c') return false;
  constexpr int panels = static_cast<int>(Panel::Magnitude) + 1;
  state_.panel =
      static_cast<Panel>((static_cast<int>(state_.panel) + 1) % panels);
  state_.checks = false;
  return true;
}

bool FrfPage::leave_view() {
  const bool main = !state_.checks && state_.panel == Panel::Phase;
  state_.checks = false;
  state_.panel = Panel::Phase;
  return !main || !std::exchange(state_.tagged, {}).empty();
}

bool FrfPage::press_band(const FrfSet& frfs, const Frf& frf, Key key) {
  const FrequencySpan span = frequency_span(frfs);
  PlotRange& range = state_.range;
  if (key == U'n' || key == U'p') {
    if (const auto hz = next_peak(frfs, frf, range, key == U'n')) {
      range.cursor = *hz;
      range.cursor_set = true;
      show_cursor(range, span.lo, span.hi);
    }
  } else if (key == U'm') {
    if (state_.mark) {
      state_.mark.reset();
    } else if (range.cursor_set) {
      state_.mark = range.cursor;
    }
  } else if (key == U'z') {
    if (state_.mark &&
        std::abs(*state_.mark - range.cursor) > line_spacing(frfs)) {
      range.lo = std::min(*state_.mark, range.cursor);
      range.hi = std::max(*state_.mark, range.cursor);
    }
  } else {
    return false;
  }
  return true;
}

bool FrfPage::press(const Snapshot& known, Key key, Command& command) {
  const FrfSet& frfs = *known.frfs;
  if (frfs.frfs.empty()) return false;
  const Frf& frf =
      frfs.frfs[selected_frf(frfs, state_, known.frf_checks.get())];
  if (key == keys::enter && !known.bundle->runs.empty()) {
    command.kind = Command::Kind::ShowRun;
    command.run = frf.run;
    return true;
  }
  const FrfForm form = state_.checks ? FrfForm::Accelerance : state_.form;
  const FrfChoice peaks = chosen_frfs(
      frfs, {selected_frf(frfs, state_, known.frf_checks.get())}, form);
  if (press_view(known, key)) return true;
  if (press_band(peaks.frfs, peaks.selected(), key)) return true;
  const Table table = state_.checks && known.frf_checks
                          ? check_table(frfs, *known.frf_checks)
                          : frf_table(frfs, state_.tagged);
  if (state_.checks && table.rows.empty()) {
    command.message = "there is nothing to check; d goes back to the FRFs";
    return true;
  }
  if (list_key(*list(), table, key)) return true;
  if (sort_key(*list(), table, key, command.message)) return true;
  const FrequencySpan span = frequency_span(frfs);
  return range_key(state_.range, key, span.lo, span.hi, line_spacing(frfs));
}

std::vector<KeyHelp> FrfPage::keys(const Snapshot&) const {
  if (state_.checks) {
    return {{"d", "back to FRFs"},
            {"j k", "check"},
            {"h l", "cursor"},
            {"n p", "peak"},
            {"Enter", "its hits"},
            {"+ -", "zoom"},
            {"[ ]", "pan"},
            {"_", "whole band"},
            {"H L", "cursor faster"},
            {"m", "band cursor"},
            {"z", "zoom to band"},
            {"/", "filter"}};
  }
  return {
      {"Tab", "next plot"},  {"j k", "FRF"},           {"t", "tag: overlay"},
      {"h l", "cursor"},     {"n p", "peak"},          {"d", "checks"},
      {"m", "band cursor"},  {"Enter", "its hits"},    {"x", "log/lin/dB"},
      {"z", "zoom to band"}, {"+ -", "zoom"},          {"[ ]", "pan"},
      {"_", "whole band"},   {"X", "log frequency"},   {"b", "confidence"},
      {"v", "acc/vel/disp"}, {"o", "other way round"}, {"*", "tag all listed"},
      {"T", "tags off"},     {"H L", "cursor faster"}, {"s", "sort"},
      {"/", "filter"}};
}

std::string FrfPage::help() const {
  return "Accelerance of the selected point (response / reference) from all "
         "accepted hits of its run; coh is the mean coherence, sd % the median "
         "relative deviation, the faint band the 95 % confidence from the "
         "scatter over hits. Tab goes round: phase, coherence, real and "
         "imaginary, Nyquist with the circle of the peak at the cursor, "
         "magnitude. Tagged FRFs are laid over the selected one, with o also "
         "the one measured the other way round. m sets one end of the band "
         "cursor, the cursor "
         "is the other. d checks driving points and pairs measured both ways "
         "against physics. v turns accelerances into mobilities and "
         "receptances, "
         "and back; x goes from a logarithmic to a linear scale and decibels. "
         "Damping is corrected for the exponential window, "
         "the FRF curve is not.";
}

}  // namespace tapfit::tui
