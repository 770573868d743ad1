#include "tui/views/recording_view.hpp"

#include "tui/screen/layout.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/recording_plots.hpp"
#include "tui/widgets/bars.hpp"
#include "tui/widgets/finding_list.hpp"
#include "tui/widgets/heat_map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace tapfit::tui {
namespace {

using acquisition::Hit;

std::size_t run_count(const RecordingInput& input) {
  return std::min(
      {input.bundle.runs.size(), input.traces.size(), input.hits.runs.size()});
}

/// What speaks against it; of one judged by hand, "rejected manually" or
/// "accepted manually (auto: double)".
std::string reasons_of(const Hit& hit) {
  std::vector<std::string> automatic;
  bool by_hand = false;
  for (const acquisition::HitFault fault : hit.reasons) {
    const bool own = fault == acquisition::HitFault::ByHand;
    by_hand = by_hand || own;
    if (!own) automatic.push_back(acquisition::name(fault));
  }
  const std::string reasons = fmt::format("{}", fmt::join(automatic, ", "));
  if (!by_hand) return reasons;
  const std::string word =
      hit.accepted ? "accepted manually" : "rejected manually";
  return reasons.empty() ? word : fmt::format("{} (auto: {})", word, reasons);
}

/// For the table, which has no room for the automatic judgement beside it.
std::string verdict(const Hit& hit) {
  const bool by_hand =
      std::ranges::find(hit.reasons, acquisition::HitFault::ByHand) !=
      hit.reasons.end();
  return fmt::format("{} {}",
                     hit.accepted ? "✓" : "✗",
                     by_hand ? std::string("manual") : reasons_of(hit));
}

Table hit_table(const RecordingInput& input, const RecordingState& state) {
  const std::vector<Hit>& hits = input.hits.runs[state.run];
  Table table{{{"#", true},
               {"time s", true},
               {"peak N", true},
               {"ms", true},
               {"verdict"}},
              {}};
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Hit& hit = hits[i];
    const bool tagged = state.tagged.contains({state.run, i});
    Row row{{fmt::format("{}{}", tagged ? "*" : "", i + 1),
             fixed(hit.time_s, 3),
             fixed(hit.peak_n, 1),
             fixed(1e3 * hit.pulse_s, 1),
             verdict(hit)},
            {.colour = hit.accepted ? Colour::Default : Colour::Red}};
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string run_line(const RecordingInput& input,
                     const RecordingState& state,
                     int width) {
  const acquisition::Run& run = input.bundle.runs[state.run];
  std::vector<std::string> places{"hammer " + name(run.hammer.dof)};
  for (const acquisition::Placement& sensor : run.sensors) {
    places.push_back(
        fmt::format("{} {}",
                    sensor.channel < input.bundle.channels.size()
                        ? input.bundle.channels[sensor.channel].name
                        : std::string("?"),
                    name(sensor.dof)));
  }
  return listed(fmt::format("run {} of {}  {}  ",
                            state.run + 1,
                            run_count(input),
                            run.file.filename().string()),
                places,
                "  ",
                width);
}

/// All runs and hits in numbers.
std::string overview_line(const RecordingInput& input, int width) {
  std::size_t hits = 0;
  std::ptrdiff_t accepted = 0;
  for (const std::vector<Hit>& run : input.hits.runs) {
    hits += run.size();
    accepted += std::ranges::count(run, true, &Hit::accepted);
  }
  const std::size_t out =
      input.left_out == nullptr ? 0 : input.left_out->size();
  return clipped(fmt::format("{} runs{}, {} hits, {} accepted",
                             run_count(input),
                             out == 0 ? "" : fmt::format(", {} left out", out),
                             hits,
                             accepted),
                 width);
}

/// What the table has no room for on small terminals goes before the block.
std::string hits_line(const RecordingInput& input,
                      const RecordingState& state,
                      int width) {
  const std::vector<Hit>& hits = input.hits.runs[state.run];
  const auto accepted = std::count_if(
      hits.begin(), hits.end(), [](const Hit& h) { return h.accepted; });
  const std::string counts =
      fmt::format("{} hits, {} accepted", hits.size(), accepted);
  const std::string block =
      fmt::format("   block {} s",
                  number(static_cast<double>(input.hits.block) /
                         std::max(input.hits.sample_rate_hz, 1e-9)));
  const std::string trigger =
      fmt::format(", trigger {} N", number(input.hits.trigger_n));
  std::string notes;
  if (input.left_out != nullptr && !input.left_out->empty()) {
    notes += fmt::format(
        "   {} of {} runs left out", input.left_out->size(), run_count(input));
  }
  if (!state.tagged.empty()) {
    notes += fmt::format("   {} tagged", state.tagged.size());
  }
  const std::size_t at = state.list.selected;
  if (at < hits.size() && !hits[at].reasons.empty()) {
    notes += fmt::format("   #{} {}", at + 1, reasons_of(hits[at]));
  }
  return fitting({counts + block + trigger + notes,
                  counts + block + notes,
                  counts + notes},
                 width);
}

/// Why the run does not count; below it the channels, where they were read.
void draw_left_out(Screen& screen,
                   const RecordingInput& input,
                   const RecordingState& state,
                   const acquisition::LeftOut& run) {
  const bool was_read = input.traces[state.run].samples > 0;
  int y = was_read ? 1 : 2;
  for (const std::string& line :
       wrapped(acquisition::statement(run), screen.width() - 2)) {
    screen.text(1, y++, line, {.colour = Colour::Red});
  }
  if (!was_read) ++y;
  screen.text(1,
              y,
              "The others are what all screens stand on; n and p go to them.",
              {},
              screen.width() - 2);
  if (!was_read) return;
  const Rect all{0, 0, screen.width(), screen.height()};
  draw_channels(screen, split_top(all, y + 1).second, input, state, 0);
}

/// How far the replay is, instead of the line about the hits.
void draw_replay_line(Screen& screen,
                      const RecordingInput& input,
                      const RecordingState& state) {
  const double length = input.traces[state.run].duration_s();
  const std::string words =
      fmt::format("{} {} of {} s, {} times as fast, {} hits  ",
                  state.playing.paused ? "paused at" : "replay",
                  fixed(state.playing.time_s, 1),
                  fixed(length, 1),
                  number(state.playing.speed, 3),
                  hits_by(input, state.run, state.playing.time_s));
  const int x = screen.text(1, 1, words, {.colour = Colour::Sky});
  screen.text(x,
              1,
              bar(length > 0.0 ? state.playing.time_s / length : 0.0,
                  std::min(30, screen.width() - x - 1),
                  screen.ascii()),
              {.colour = Colour::Sky});
}

/// Rows: sensors; columns: accepted hits.
HeatMap coherence_map(const RecordingInput& input,
                      const RecordingState& state,
                      std::size_t selected) {
  HeatMap map;
  map.title = "coherence of each hit with the others";
  map.values = input.look->coherence.with_others;
  map.shortfall = true;
  map.scale = 0.1;
  const acquisition::Run& run = input.bundle.runs[state.run];
  for (const acquisition::Placement& sensor : run.sensors) {
    map.row_names.push_back(input.bundle.channels.at(sensor.channel).name);
  }
  const std::vector<std::size_t>& hits = input.look->coherence.hits;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    map.column_names.push_back(fmt::format("#{}", hits[k] + 1));
    if (hits[k] == selected) map.column = static_cast<int>(k);
  }
  if (!run.sensors.empty()) {
    map.selected = static_cast<int>(state.sensor % run.sensors.size());
  }
  return map;
}

void draw_statements(Screen& screen,
                     const Rect& rect,
                     const acquisition::HitSet& hits) {
  int y = rect.y;
  for (const std::string& statement : hits.statements) {
    for (const std::string& line : wrapped(statement, rect.width - 1)) {
      if (y >= rect.y + rect.height) return;
      screen.text(rect.x + 1, y++, line, {.colour = Colour::Grey}, rect.width);
    }
  }
}

/// Hits, their coherence, and below what is left: the average.
void draw_side(Screen& screen,
               const Rect& side,
               const RecordingInput& input,
               const RecordingState& state,
               const Table& table) {
  const std::size_t selected = settled(table, state.list);
  const bool agree = input.look != nullptr && !state.playing.on &&
                     input.look->coherence.with_others.cols() > 0;
  const int map_rows =
      agree ? static_cast<int>(input.look->coherence.with_others.rows()) + 2
            : 0;
  const int plot_rows =
      std::max(side.height / 3, std::min(10, side.height / 2));
  const int list_rows =
      std::clamp(static_cast<int>(table.rows.size()) + 1,
                 3,
                 std::max(side.height - map_rows - plot_rows, 3));
  const auto [list, rest] = split_top(side, list_rows);
  draw_table(screen, list, table, state.list, true);
  const auto [map, plot] =
      split_top(rest, rest.height - map_rows >= 6 ? map_rows : 0);
  if (!map.empty()) {
    const HeatMap coherence = coherence_map(input, state, selected);
    screen.text(map.x + 1,
                map.y,
                fitting({coherence.title, "coherence of hits with others"},
                        map.width - 1),
                {.colour = Colour::Grey},
                map.width - 1);
    draw_heat_map(screen, split_top(map, 1).second, coherence);
  }
  draw_average(screen, plot, input, state);
}

}  // namespace

Screen recording_view(const RecordingInput& input,
                      const RecordingState& state,
                      const Canvas& canvas) {
  Screen screen(canvas);
  if (run_count(input) == 0) {
    screen.text(1,
                1,
                "The bundle holds no recordings (ready FRFs, perhaps: 2; or "
                "modes: 3).");
    return screen;
  }
  if (state.overview) {
    const Rect all{0, 0, canvas.width, canvas.height};
    const auto [title, rows] = split_top(all, 1);
    screen.text(1, 0, overview_line(input, canvas.width - 2), {.bold = true});
    draw_table(screen, rows, run_table(input), state.runs, true);
    return screen;
  }
  RecordingState at = state;
  at.run = std::min(at.run, run_count(input) - 1);
  Table table = hit_table(input, at);
  const std::size_t selected = settled(table, at.list);
  if (at.playing.on) {
    table.rows.resize(hits_by(input, at.run, at.playing.time_s));
    at.list.selected = table.rows.empty() ? 0 : table.rows.size() - 1;
  }
  screen.text(1, 0, run_line(input, at, canvas.width - 2), {.bold = true});
  if (at.findings) {
    draw_findings(screen,
                  {0, 1, canvas.width, canvas.height - 1},
                  input.findings,
                  at.finding);
    return screen;
  }
  if (const acquisition::LeftOut* run = input.not_used(at.run)) {
    draw_left_out(screen, input, at, *run);
    return screen;
  }
  if (at.playing.on) {
    draw_replay_line(screen, input, at);
  } else {
    screen.text(
        1, 1, hits_line(input, at, canvas.width - 2), {}, canvas.width - 2);
  }
  const Rect body{0, 2, canvas.width, canvas.height - 2};
  if (at.statements) {
    draw_statements(screen, split_top(body, 1).second, input.hits);
    return screen;
  }
  const int list_width = canvas.width >= 110 ? 46 : 36;
  const auto [plots, side] = split_left(body, canvas.width - list_width);
  draw_channels(
      screen, plots, input, at, at.playing.on ? at.list.selected : selected);
  draw_side(screen, side, input, at, table);
  return screen;
}

}  // namespace tapfit::tui
