#include "tui/views/update_view.hpp"

#include "tui/report/report_parameters.hpp"
#include "tui/screen/layout.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/diagnose_panels.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/views/update_panels.hpp"
#include "tui/widgets/bars.hpp"
#include "tui/widgets/plot.hpp"
#include "updating/session/added_effect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::tui {

std::size_t selected_effect(const std::vector<updating::AddedEffect>& effects,
                            const UpdateState& state) {
  if (effects.empty()) return 0;
  return std::min(state.effect.value_or(effects.size()), effects.size() - 1);
}

Table frf_names(const signal::FrfSet& frfs) {
  Table table{{{"FRF"}}, {}};
  for (const signal::Frf& frf : frfs.frfs) {
    table.rows.push_back({{signal::name(frf)}, {}});
  }
  return table;
}

namespace {

using updating::Comparison;

/// Between two curves: magnitudes slide along their logarithms.
Eigen::VectorXcd between(const Eigen::VectorXcd& from,
                         const Eigen::VectorXcd& to,
                         double share) {
  if (from.size() != to.size() || share >= 1.0) return to;
  Eigen::VectorXcd mixed(to.size());
  for (Eigen::Index i = 0; i < to.size(); ++i) {
    const double a = std::max(std::abs(from[i]), 1e-300);
    const double b = std::max(std::abs(to[i]), 1e-300);
    mixed[i] = std::pow(a, 1.0 - share) * std::pow(b, share);
  }
  return mixed;
}

/// The part of a parameter's name before its effect's own name for it.
std::string effect_of(const std::string& name, const UpdateInput& input) {
  for (const updating::Rung& rung : input.ladder) {
    if (name.starts_with(rung.added + " ")) return rung.added;
  }
  return {};
}

/// Short enough for its column; what tells two parameters of an effect apart
/// stands at the end and is kept.
std::string parameter_name(const std::string& name,
                           const UpdateInput& input,
                           int room) {
  std::string plain = parameter_words(name);
  const std::string effect = effect_of(name, input);
  if (effect.empty()) return clipped(plain, room);
  plain.erase(0, effect.size() + 1);
  for (const auto& [word, brief] :
       {std::pair{"rotational", "rot."}, {"translational", "transl."}}) {
    const std::string whole = word;
    if (plain.starts_with(whole)) plain.replace(0, whole.size(), brief);
  }
  if (input.ladder.size() <= 2) return clipped(plain, room);
  const int left = room - text_width(plain) - 1;
  if (left < 4) return clipped(plain, room);
  return clipped(effect, left) + " " + plain;
}

Table parameter_table(const UpdateInput& input, int width) {
  constexpr int least = 12;  // for a name: values are not cut
  Table table{{{"parameter"}, {"value"}}, {}};
  int widest = 0;
  int changes = 0;
  const std::vector<updating::Estimate> parameters = told(input.parameters);
  const bool fitted = input.ladder.size() > 1;
  for (const updating::Estimate& p : parameters) {
    const bool known =
        fitted && input.bundle != nullptr && input.deck != nullptr;
    const std::string change =
        known ? change_words(*input.bundle, *input.deck, p) : "";
    table.rows.push_back({{"", size_words(p), change}, {}});
    widest = std::max(widest, text_width(table.rows.back().cells[1]));
    changes = std::max(changes, text_width(change));
  }
  int room = width - widest - 4;
  constexpr std::string_view heading = "to the deck";
  const int column = std::max(changes, text_width(heading)) + 2;
  if (changes > 0 && room - column >= least) {
    table.columns.push_back({std::string(heading), true});
    room -= column;
  } else {
    for (Row& row : table.rows) row.cells.pop_back();
  }
  room = std::max(room, least);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    table.rows[i].cells[0] = parameter_name(parameters[i].name, input, room);
  }
  return table;
}

/// Of the marked effect's fit, or of the last before it that is on. Those of
/// the effects stand last.
std::size_t selected_record(const UpdateInput& input,
                            const UpdateState& state) {
  if (state.uncertain) return 0;
  const auto is_on = [](const updating::AddedEffect& e) { return e.on; };
  const auto marked = static_cast<std::ptrdiff_t>(std::min(
      selected_effect(input.effects, state) + 1, input.effects.size()));
  const auto after =
      std::count_if(input.effects.begin() + marked, input.effects.end(), is_on);
  const std::size_t count = input.records->size();
  return count - 1 - std::min(static_cast<std::size_t>(after), count - 1);
}

struct LadderRow {
  std::string name;
  const updating::Rung* rung = nullptr;  // none for an effect that is off
  bool selected = false;
};

/// Rungs in their order, with the effects that are off where they were added.
std::vector<LadderRow> ladder_rows(const UpdateInput& input,
                                   const UpdateState& state) {
  const std::size_t selected = selected_effect(input.effects, state);
  std::vector<LadderRow> rows;
  std::size_t next = 0;
  const auto is_effect = [&input](std::size_t k) {
    const std::string& added = input.ladder[k].added;
    return added != updating::base_rung && added != updating::uncertain_rung;
  };
  while (next < input.ladder.size() && !is_effect(next)) {
    const updating::Rung& rung = input.ladder[next++];
    const bool base = rung.added == updating::base_rung;
    rows.push_back({base ? "base model" : "uncertain properties fitted",
                    &rung,
                    !base && state.uncertain});
  }
  for (std::size_t k = 0; k < input.effects.size(); ++k) {
    const updating::AddedEffect& added = input.effects[k];
    const bool has_rung = added.on && next < input.ladder.size();
    rows.push_back(
        {fmt::format("{} {}", added.ref.effect, place(added.ref.where)),
         has_rung ? &input.ladder[next++] : nullptr,
         k == selected && !state.uncertain});
  }
  return rows;
}

/// All of the names where the number and some of its bar have room beside them.
int names_width(const std::vector<LadderRow>& rows, int width) {
  int names = std::min(width - 14, 30);
  for (const LadderRow& row : rows) {
    names = std::max(names, std::min(text_width(row.name) + 2, width - 24));
  }
  return names;
}

void draw_ladder(Screen& screen,
                 const Rect& rect,
                 const UpdateInput& input,
                 const UpdateState& state) {
  double largest = 1e-9;
  for (const updating::Rung& rung : input.ladder) {
    if (std::isfinite(rung.error)) largest = std::max(largest, rung.error);
  }
  const double floor = input.current != nullptr ? input.current->floor : 0.0;
  screen.text(rect.x, rect.y, "ladder", {.colour = Colour::Grey});
  const std::vector<LadderRow> all = ladder_rows(input, state);
  const int names = names_width(all, rect.width);
  const bool with_floor = floor > 0.0;
  const int room = rect.height - (with_floor ? 2 : 1);
  const int rows = std::min(static_cast<int>(all.size()), room);
  // The newest rungs, when not all fit.
  const std::size_t first =
      all.size() - static_cast<std::size_t>(std::max(rows, 0));
  for (int i = 0; i < rows; ++i) {
    const LadderRow& row = all[first + static_cast<std::size_t>(i)];
    const int y = rect.y + 1 + i;
    if (row.selected && rect.x > 0) {
      screen.text(rect.x - 1, y, screen.ascii() ? ">" : "▸", {});
    }
    if (row.rung == nullptr) {
      screen.text(rect.x, y, row.name, {.colour = Colour::Grey}, names - 1);
      screen.text_right(rect.x + names + 7, y, "off", {.colour = Colour::Grey});
      continue;
    }
    // The brief one says as much of what was fitted.
    const bool fitted = row.name == "uncertain properties fitted";
    screen.text(
        rect.x,
        y,
        fitted ? fitting({row.name, "properties fitted"}, names - 1) : row.name,
        {},
        names - 1);
    screen.text_right(rect.x + names + 7, y, percent(row.rung->error));
    int bar_width = rect.width - names - 9;
    if (row.rung->stopped_after > 0) {
      const std::string mark = "kept";
      bar_width -= text_width(mark) + 1;
      screen.text_right(
          rect.x + rect.width - 1, y, mark, {.colour = Colour::Yellow});
    }
    draw_error_bar(screen,
                   {rect.x + names + 8, y, bar_width, 1},
                   row.rung->error,
                   floor,
                   largest);
  }
  if (!with_floor || rows < 0) return;
  const int y = rect.y + 1 + rows;
  screen.text(rect.x, y, "floor", {.colour = Colour::Grey}, names - 1);
  screen.text_right(
      rect.x + names + 7, y, percent(floor), {.colour = Colour::Grey});
}

/// Whether the ladder ends with the floor.
bool has_floor(const UpdateInput& input) {
  return input.current != nullptr && input.current->floor > 0.0;
}

std::string headline_of(const UpdateInput& input) {
  std::string text = "nothing added yet";
  const auto on = static_cast<std::size_t>(std::count_if(
      input.effects.begin(), input.effects.end(), [](const auto& added) {
        return added.on;
      }));
  const std::size_t off = input.effects.size() - on;
  if (input.ladder.size() == 1) {
    text += fmt::format(": error {}", percent(input.ladder.front().error));
  } else if (input.ladder.size() > 1) {
    text = fmt::format("{} added: error {} → {}",
                       effects_text(on),
                       percent(input.ladder.front().error),
                       percent(input.ladder.back().error));
    if (input.ladder.back().stopped_after > 0) text += ", kept early";
  }
  if (off > 0) text += fmt::format(", {} off", off);
  if (input.current != nullptr) {
    text += fmt::format(", floor {}", percent(input.current->floor));
  }
  if (input.ladder.size() <= 1) text += "; 5 finds what is missing";
  return text;
}

Plot overlay(const UpdateInput& input,
             const UpdateState& state,
             std::size_t selected) {
  const signal::Frf& frf = input.frfs.frfs[selected];
  const Eigen::VectorXd f = input.frfs.frequency_hz();
  Plot plot = frf_plot(input.frfs, state.range);
  plot.title = signal::name(frf);
  plot.curves.push_back(measured_curve("measured", f, frf, false));
  const auto has = [selected](const Comparison* c) {
    return c != nullptr && selected < c->model_frfs.size();
  };
  if (has(input.base)) {
    plot.curves.push_back(
        magnitude_curve("base",
                        f,
                        input.base->model_frfs[selected],
                        {Colour::Grey, Pattern::Dotted, '.'}));
  }
  if (has(input.current)) {
    const Eigen::VectorXcd& now = input.current->model_frfs[selected];
    const Eigen::VectorXcd shown =
        has(input.previous) && state.slide < 1.0
            ? between(input.previous->model_frfs[selected], now, state.slide)
            : now;
    plot.curves.push_back(magnitude_curve(
        "updated", f, shown, {Colour::Orange, Pattern::Dashed, 'o'}));
  }
  return in_scale(std::move(plot), state.scale);
}

void draw_record(Screen& screen,
                 const Rect& rect,
                 const UpdateInput& input,
                 const UpdateState& state) {
  if (input.records == nullptr || input.records->empty()) {
    screen.text(rect.x + 1,
                rect.y + 1,
                input.records == nullptr
                    ? "record of the fits …"
                    : "nothing was identified yet: 5 finds what to add",
                {.colour = Colour::Grey});
    return;
  }
  updating::UpdateRecord record =
      (*input.records)[selected_record(input, state)];
  for (std::string& name : record.parameters) {
    name = told_name(name, input.parameters);
  }
  using Panel = UpdateState::Panel;
  if (state.panel == Panel::Convergence) {
    draw_convergence(screen, rect, record);
  } else if (state.panel == Panel::Correlation) {
    draw_correlation(screen, rect, record, input.look_alikes);
  } else {
    draw_l_curve(screen, rect, record);
  }
}

/// What the marked effect does for the FRFs, and where it sits.
void draw_effect(Screen& screen,
                 const Rect& rect,
                 const UpdateInput& input,
                 const UpdateState& state) {
  if (input.effects.empty() && !state.uncertain) {
    screen.text(rect.x + 1,
                rect.y + 1,
                "nothing was added yet: 5 finds what to add",
                {.colour = Colour::Grey});
    return;
  }
  std::string name = "uncertain properties, before any effect";
  updating::Location where;
  if (!state.uncertain) {
    const updating::EffectRef& marked =
        input.effects[selected_effect(input.effects, state)].ref;
    where = marked.where;
    name = fmt::format("{} {}", marked.effect, place(where));
  }
  const auto [title, body] = split_top(rect, 1);
  screen.text(title.x + 1, title.y, name, {.bold = true}, title.width - 2);
  const auto [left, right] = split_left(body, body.width * 5 / 8);
  draw_evidence(screen,
                left,
                {input.frfs, input.evidence, input.look_alikes},
                state.range);
  if (input.bundle == nullptr) return;
  draw_place(screen,
             right,
             input.wire,
             state.pose,
             grids_of(*input.bundle, where, input.deck));
}

}  // namespace

Screen update_view(const UpdateInput& input,
                   const UpdateState& state,
                   const Canvas& canvas) {
  Screen screen(canvas);
  screen.text(1, 0, headline_of(input), {.bold = true}, canvas.width - 2);
  const Rect body{0, 1, canvas.width, canvas.height - 1};
  const int half = canvas.width * 7 / 12;
  const Table parameters = parameter_table(input, half);
  const int wanted =
      std::max({static_cast<int>(parameters.rows.size()),
                static_cast<int>(ladder_rows(input, state).size()) +
                    (has_floor(input) ? 1 : 0),
                2}) +
      1;
  const auto [upper, lower] =
      split_top(body, std::min(wanted, body.height * 2 / 5));
  const auto [left, right] = split_left(upper, half);
  draw_table(screen, left, parameters, {}, false);
  draw_ladder(screen, right, input, state);
  if (state.panel == UpdateState::Panel::Evidence) {
    draw_effect(screen, lower, input, state);
    return screen;
  }
  if (state.panel != UpdateState::Panel::Curves) {
    draw_record(screen, lower, input, state);
    return screen;
  }
  if (input.frfs.frfs.empty()) return screen;
  const std::size_t selected = settled(frf_names(input.frfs), state.list);
  const Plot plot = overlay(input, state, selected);
  const auto [area, line] = split_top(lower, lower.height - 1);
  draw_plot(screen, area, plot);
  if (plot.cursor) {
    screen.text(1, line.y, read_out(plot, *plot.cursor), {}, canvas.width - 2);
  } else {
    screen.text(
        1,
        line.y,
        fmt::format("FRF {} of {}", selected + 1, input.frfs.frfs.size()),
        {.colour = Colour::Grey});
  }
  return screen;
}

}  // namespace tapfit::tui
