#include "tui/views/recording_view.hpp"

#include "tui/layout.hpp"
#include "tui/number.hpp"
#include "tui/plot.hpp"
#include "tui/text.hpp"

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

std::string verdict(const Hit& hit) {
  std::vector<std::string> reasons;
  for (const acquisition::HitFault fault : hit.reasons) {
    // The user's own word counts, and stands where it is not cut off.
    const bool first = fault == acquisition::HitFault::ByHand;
    reasons.insert(first ? reasons.begin() : reasons.end(),
                   acquisition::name(fault));
  }
  return fmt::format(
      "{} {}", hit.accepted ? "✓" : "✗", fmt::join(reasons, ", "));
}

Table hit_table(const std::vector<Hit>& hits) {
  Table table{{{"#", true},
               {"time s", true},
               {"peak N", true},
               {"ms", true},
               {"verdict"}},
              {}};
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Hit& hit = hits[i];
    Row row{{std::to_string(i + 1),
             fixed(hit.time_s, 3),
             fixed(hit.peak_n, 1),
             fixed(1e3 * hit.pulse_s, 1),
             verdict(hit)},
            {.colour = hit.accepted ? Colour::Default : Colour::Red}};
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string unit_of(acquisition::Quantity quantity) {
  switch (quantity) {
    case acquisition::Quantity::Force:
      return "N";
    case acquisition::Quantity::Acceleration:
      return "m/s²";
    case acquisition::Quantity::Velocity:
      return "m/s";
    case acquisition::Quantity::Displacement:
      return "m";
  }
  return "";
}

Plot channel_plot(const RecordingInput& input,
                  const RecordingState& state,
                  std::size_t channel,
                  int columns) {
  const Trace& trace = input.traces[state.run];
  const PlotRange shown = resolved(state.range, 0.0, trace.duration_s());
  Plot plot;
  plot.x = {"t", "s", shown.lo, shown.hi, false};
  if (shown.cursor_set) plot.cursor = shown.cursor;
  if (channel < input.bundle.channels.size()) {
    const acquisition::Channel& c = input.bundle.channels[channel];
    plot.y = {c.name, unit_of(c.quantity), 0.0, 0.0, false};
  }
  const Envelope e = envelope(trace,
                              static_cast<Eigen::Index>(channel),
                              shown.lo,
                              shown.hi,
                              2 * std::max(columns, 1));
  plot.curves.push_back({"", e.time_s, {}, e.low, e.high, {Colour::Sky}});
  return plot;
}

void mark_hits(Plot& plot,
               const RecordingInput& input,
               const std::vector<Hit>& hits,
               std::size_t selected) {
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Hit& hit = hits[i];
    Style style{.colour = hit.accepted ? Colour::Green : Colour::Red};
    style.reverse = i == selected;
    plot.markers.push_back({hit.time_s, hit.accepted ? U'▼' : U'✗', style});
  }
  if (selected >= hits.size() || !(input.hits.sample_rate_hz > 0.0)) return;
  const double rate = input.hits.sample_rate_hz;
  const double begin = static_cast<double>(hits[selected].begin) / rate;
  const double block = static_cast<double>(input.hits.block) / rate;
  plot.shades.push_back({begin, begin + block, {.colour = Colour::Grey}});
}

std::string run_line(const RecordingInput& input, const RecordingState& state) {
  const acquisition::Run& run = input.bundle.runs[state.run];
  std::string text = fmt::format("run {} of {}  {}  hammer {}",
                                 state.run + 1,
                                 run_count(input),
                                 run.file.filename().string(),
                                 name(run.hammer.dof));
  for (const acquisition::Placement& sensor : run.sensors) {
    text += fmt::format("  {} {}",
                        sensor.channel < input.bundle.channels.size()
                            ? input.bundle.channels[sensor.channel].name
                            : std::string("?"),
                        name(sensor.dof));
  }
  return text;
}

/// What was decided about the recordings, on lines that fit beside the plots
/// and leave half of the height to the hits.
std::vector<std::string> statement_lines(const RecordingInput& input,
                                         const Rect& side) {
  std::vector<std::string> lines;
  for (const std::string& statement : input.hits.statements) {
    const std::vector<std::string> its = wrapped(statement, side.width - 1);
    lines.insert(lines.end(), its.begin(), its.end());
  }
  const auto room = static_cast<std::size_t>(std::max(side.height / 2, 0));
  if (lines.size() > room) {
    lines.resize(room);
    if (room > 0) lines.back() = clipped(lines.back(), side.width - 3) + " …";
  }
  return lines;
}

void draw_plots(Screen& screen,
                const Rect& area,
                const RecordingInput& input,
                const RecordingState& state,
                const std::vector<Hit>& hits,
                std::size_t selected) {
  const acquisition::Run& run = input.bundle.runs[state.run];
  const auto [upper, lower] = split_top(area, area.height / 2 - 1);
  Plot force = channel_plot(input, state, run.hammer.channel, area.width);
  force.x_labels = false;
  force.title = "hammer";
  mark_hits(force, input, hits, selected);
  draw_plot(screen, upper, force);
  if (run.sensors.empty()) return;
  const std::size_t at = state.sensor % run.sensors.size();
  Plot response =
      channel_plot(input, state, run.sensors[at].channel, area.width);
  response.title = fmt::format(
      "{} ({} of {})", name(run.sensors[at].dof), at + 1, run.sensors.size());
  mark_hits(response, input, hits, selected);
  draw_plot(screen, lower, response);
}

}  // namespace

Screen recording_view(const RecordingInput& input,
                      const RecordingState& state,
                      const Canvas& canvas) {
  Screen screen(canvas);
  if (run_count(input) == 0) {
    screen.text(
        1, 1, "The bundle holds no recordings (ready FRFs, perhaps: 2).");
    return screen;
  }
  RecordingState at = state;
  at.run = std::min(at.run, run_count(input) - 1);
  const std::vector<Hit>& hits = input.hits.runs[at.run];
  const Table table = hit_table(hits);
  const std::size_t selected = settled(table, at.list);
  screen.text(1, 0, run_line(input, at), {.bold = true}, canvas.width - 2);
  const auto accepted = std::count_if(
      hits.begin(), hits.end(), [](const Hit& h) { return h.accepted; });
  screen.text(1,
              1,
              fmt::format("{} hits, {} accepted   block {} s, trigger {} N",
                          hits.size(),
                          accepted,
                          number(static_cast<double>(input.hits.block) /
                                 std::max(input.hits.sample_rate_hz, 1e-9)),
                          number(input.hits.trigger_n)),
              {},
              canvas.width - 2);
  const int list_width = canvas.width >= 110 ? 46 : 36;
  const Rect body{0, 2, canvas.width, canvas.height - 2};
  const auto [plots, side] = split_left(body, canvas.width - list_width);
  draw_plots(screen, plots, input, at, hits, selected);
  const std::vector<std::string> statements = statement_lines(input, side);
  const auto [list, notes] =
      split_top(side, side.height - static_cast<int>(statements.size()));
  draw_table(screen, list, table, at.list, true);
  for (int i = 0; i < notes.height; ++i) {
    screen.text(notes.x + 1,
                notes.y + i,
                statements[static_cast<std::size_t>(i)],
                {.colour = Colour::Grey},
                notes.width - 1);
  }
  return screen;
}

std::vector<Need> RecordingPage::essential() const {
  return {{Stage::Traces}, {Stage::Hits}};
}

Screen RecordingPage::draw(const Snapshot& known, const Canvas& canvas) const {
  return recording_view(
      {*known.bundle, *known.traces, *known.hits}, state_, canvas);
}

bool RecordingPage::press(const Snapshot& known, Key key, Command& command) {
  const RecordingInput input{*known.bundle, *known.traces, *known.hits};
  const std::size_t runs = run_count(input);
  if (runs == 0) return false;
  state_.run = std::min(state_.run, runs - 1);
  const std::vector<Hit>& hits = input.hits.runs[state_.run];
  const Table table = hit_table(hits);
  if (key == U'n' || key == U'p') {
    state_.run = (state_.run + (key == U'n' ? 1 : runs - 1)) % runs;
    state_.list = {};
    return true;
  }
  if (key == keys::tab || key == U'c') {
    ++state_.sensor;
    return true;
  }
  if (key == U' ') {
    if (hits.empty()) return true;
    command.kind = Command::Kind::OverruleHit;
    command.run = state_.run;
    command.hit = settled(table, state_.list);
    return true;
  }
  if (key == U'u') {
    command.kind = Command::Kind::RestoreHit;
    return true;
  }
  if (key == keys::enter && !hits.empty()) {
    const Hit& hit = hits[settled(table, state_.list)];
    state_.range = {hit.time_s - 2.0 * std::max(hit.pulse_s, 1e-3),
                    hit.time_s + 6.0 * std::max(hit.pulse_s, 1e-3),
                    hit.time_s,
                    true};
    return true;
  }
  if (list_key(state_.list, table, key)) return true;
  return range_key(
      state_.range, key, 0.0, input.traces[state_.run].duration_s());
}

std::vector<KeyHelp> RecordingPage::keys() const {
  return {{"Space", "accept/reject"},
          {"u", "undo that"},
          {"n p", "run"},
          {"Tab", "sensor"},
          {"Enter", "zoom on hit"},
          {"+ -", "zoom"},
          {"[ ]", "pan"},
          {"_", "whole run"},
          {"h l", "cursor"},
          {"j k", "hit"},
          {"/", "filter"}};
}

std::string RecordingPage::help() const {
  return "The hammer's force above, one response below. ▼ is an accepted hit, "
         "✗ one that was judged out; the list says why: double (the hammer "
         "struck twice), overload (clipped samples), weak, soft (no force at "
         "the band's end), truncated, outlier. Space overrules the judgement, "
         "u "
         "takes the last overruling back; FRFs and all that follows are then "
         "computed anew. The grey stretch "
         "is the block that is cut out for the selected hit.";
}

}  // namespace tapfit::tui
