// What the keys of the Recording screen do.
#include "tui/screen/layout.hpp"
#include "tui/views/recording_view.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::tui {
namespace {

using acquisition::Hit;

std::size_t page_run_count(const RecordingInput& input) {
  return std::min(
      {input.bundle.runs.size(), input.traces.size(), input.hits.runs.size()});
}

/// Only as many rows as there are hits: enough to move about in.
Table rows_of(const std::vector<Hit>& hits) {
  Table table{{{"verdict"}}, {}};
  for (const Hit& hit : hits) {
    std::string words = hit.accepted ? "✓" : "✗";
    for (const auto fault : hit.reasons) words += acquisition::name(fault);
    table.rows.push_back({{std::move(words)}, {}});
  }
  return table;
}

RecordingInput recording_input(const Snapshot& known) {
  return {*known.bundle,
          *known.traces,
          *known.hits,
          nullptr,
          &known.left_out,
          known.findings.get(),
          known.frfs.get()};
}

}  // namespace

std::string RecordingPage::nothing_here(
    const acquisition::TestBundle& bundle) const {
  if (!bundle.runs.empty()) return {};
  return bundle.modes ? "The test consists of modes: it has no recordings. 3 "
                        "shows the modes."
                      : "The test consists of ready FRFs: it has no "
                        "recordings, and no hits to judge. 2 shows the FRFs.";
}

std::vector<Need> RecordingPage::essential() const {
  return {{Stage::Traces}, {Stage::Hits}};
}

std::vector<Need> RecordingPage::welcome(const Snapshot& known) const {
  if (state_.findings) return {{Stage::Findings}};
  if (state_.overview) return {{Stage::Frfs}};
  if (state_.run >= known.hits->runs.size()) return {};
  if (recording_input(known).not_used(state_.run) != nullptr) return {};
  return {{Stage::RunLook, static_cast<int>(state_.run)}};
}

Screen RecordingPage::draw(const Snapshot& known, const Canvas& canvas) const {
  RecordingInput input = recording_input(known);
  const auto look = known.run_looks.find(static_cast<int>(state_.run));
  if (look != known.run_looks.end()) input.look = look->second.get();
  return recording_view(input, state_, canvas);
}

void RecordingPage::select(std::size_t run) {
  state_ = {};
  state_.run = run;
}

bool RecordingPage::press_run(const RecordingInput& input, Key key) {
  const std::size_t runs = page_run_count(input);
  if (key == U'n' || key == U'p') {
    state_.run = (state_.run + (key == U'n' ? 1 : runs - 1)) % runs;
    state_.list = {};
    state_.playing.time_s = 0.0;
    if (state_.zoom != 0) state_.range = {};
    state_.zoom = 0;
  } else if (key == U'N') {
    next_rejected(input);
  } else if (key == keys::tab || key == U'c') {
    ++state_.sensor;
  } else {
    return false;
  }
  return true;
}

/// Among the hits after the selected one, then from the first again.
void RecordingPage::next_rejected(const RecordingInput& input) {
  const std::size_t runs = page_run_count(input);
  std::size_t run = state_.run;
  std::size_t hit = state_.list.selected + 1;
  for (std::size_t tried = 0; tried <= runs; ++tried) {
    const std::vector<Hit>& hits = input.hits.runs[run];
    for (; hit < hits.size(); ++hit) {
      if (hits[hit].accepted) continue;
      state_.run = run;
      state_.list = {hit, ""};
      if (state_.zoom != 0) zoom_on_hit(input);
      return;
    }
    run = (run + 1) % runs;
    hit = 0;
  }
}

void RecordingPage::zoom_on_hit(const RecordingInput& input) {
  const std::vector<Hit>& hits = input.hits.runs[state_.run];
  if (hits.empty() || !(input.hits.sample_rate_hz > 0.0)) return;
  const Hit& hit = hits[settled(rows_of(hits), state_.list)];
  if (state_.zoom == 1) {
    const double width = std::max(hit.pulse_s, 1e-3);
    // Both blows of a double one.
    const double other = hit.time_s + (hit.second ? hit.second->after_s : 0.0);
    state_.range = {std::min(hit.time_s, other) - 2.0 * width,
                    std::max(hit.time_s, other) + 6.0 * width,
                    other,
                    true};
  } else {
    const double rate = input.hits.sample_rate_hz;
    const double begin = static_cast<double>(hit.begin) / rate;
    state_.range = {begin,
                    begin + static_cast<double>(input.hits.block) / rate,
                    hit.time_s,
                    false};
  }
}

bool RecordingPage::press_hit(const RecordingInput& input,
                              Key key,
                              Command& command) {
  const std::vector<Hit>& hits = input.hits.runs[state_.run];
  const Table table = rows_of(hits);
  const std::size_t selected = settled(table, state_.list);
  const bool acts_on_tags = key == U' ' && !state_.tagged.empty();
  if (none_shown(table, state_.list) && is_row_key(key) && !acts_on_tags) {
    command.message = nothing_matches;
    return true;
  }
  if (key == U' ') {
    if (hits.empty()) return true;
    command.kind = Command::Kind::OverruleHit;
    command.hits.assign(state_.tagged.begin(), state_.tagged.end());
    if (command.hits.empty()) command.hits = {{state_.run, selected}};
    state_.tagged.clear();
  } else if (key == U't') {
    if (hits.empty()) return true;
    const RecordingState::HitAt at{state_.run, selected};
    if (state_.tagged.erase(at) == 0) state_.tagged.insert(at);
    state_.list.selected = std::min(selected + 1, hits.size() - 1);
  } else if (key == U'*') {
    for (const std::size_t row : visible_rows(table, state_.list)) {
      state_.tagged.insert({state_.run, row});
    }
  } else if (key == U'T') {
    state_.tagged.clear();
  } else if (key == keys::enter) {
    if (hits.empty()) return true;
    state_.zoom = state_.zoom % 2 + 1;
    zoom_on_hit(input);
  } else {
    return false;
  }
  return true;
}

bool RecordingPage::press_replay(Key key) {
  Playing& playing = state_.playing;
  if (key == U'R') {
    if (playing.on) {
      playing.paused = !playing.paused;
    } else {
      playing.on = true;
      playing.paused = false;
      playing.time_s = 0.0;
      state_.range = {};
      state_.zoom = 0;
    }
  } else if (!playing.on) {
    return false;
  } else if (key == U'>') {
    playing.speed = std::min(playing.speed * 2.0, 640.0);
  } else if (key == U'<') {
    playing.speed = std::max(playing.speed / 2.0, 1.0);
  } else if (key == keys::escape || key == U'_') {
    playing.on = false;
  } else {
    return false;
  }
  return true;
}

bool RecordingPage::leave_view() {
  if (std::exchange(state_.overview, false)) return true;
  const bool main = !state_.statements && !state_.findings && state_.zoom == 0;
  if (state_.zoom != 0) state_.range = {};
  state_.zoom = 0;
  state_.statements = false;
  state_.findings = false;
  return !main || !std::exchange(state_.tagged, {}).empty();
}

// From run to run; Enter shows the one that is chosen.
bool RecordingPage::press_overview(const RecordingInput& input,
                                   Key key,
                                   Command& command) {
  const Table table = run_table(input);
  if (key == keys::enter && !none_shown(table, state_.runs)) {
    const std::size_t run = settled(table, state_.runs);
    if (run != state_.run) {
      state_.list = {};
      state_.range = {};
      state_.zoom = 0;
    }
    state_.run = run;
    state_.overview = false;
    return true;
  }
  return list_key(state_.runs, table, key) ||
         sort_key(state_.runs, table, key, command.message);
}

// Walks along the list of findings.
bool RecordingPage::press_findings(const RecordingInput& input, Key key) {
  const std::size_t count =
      input.findings != nullptr ? input.findings->size() : 0;
  if (key == U'j' || key == keys::down) {
    if (state_.finding + 1 < count) ++state_.finding;
    return true;
  }
  if (key == U'k' || key == keys::up) {
    if (state_.finding > 0) --state_.finding;
    return true;
  }
  return false;
}

bool RecordingPage::press(const Snapshot& known, Key key, Command& command) {
  const RecordingInput input = recording_input(known);
  const std::size_t runs = page_run_count(input);
  if (runs == 0) return false;
  state_.run = std::min(state_.run, runs - 1);
  if (key == U'o') {
    state_.overview = !state_.overview;
    state_.runs.selected = state_.run;
    state_.playing.on = false;
    return true;
  }
  if (state_.overview) return press_overview(input, key, command);
  if (key == U'i') {
    state_.statements = !state_.statements;
    state_.findings = false;
    return true;
  }
  if (key == U'f') {
    state_.findings = !state_.findings;
    state_.statements = false;
    state_.finding = 0;
    return true;
  }
  // What the other keys act on is covered.
  if (state_.findings) return press_findings(input, key);
  if (state_.statements) return false;
  if (press_replay(key) || press_run(input, key)) return true;
  if (press_hit(input, key, command)) return true;
  const std::vector<Hit>& hits = input.hits.runs[state_.run];
  if (list_key(state_.list, rows_of(hits), key)) {
    if (state_.zoom != 0) zoom_on_hit(input);
    return true;
  }
  if (key == U'_') state_.zoom = 0;
  return range_key(
      state_.range, key, 0.0, input.traces[state_.run].duration_s());
}

bool RecordingPage::click(const Snapshot& known, const Zone& zone, int x) {
  const auto look = known.run_looks.find(static_cast<int>(state_.run));
  if (state_.overview) return Page::click(known, zone, x);
  if (zone.kind == Zone::Kind::Entry && look != known.run_looks.end()) {
    const std::vector<std::size_t>& hits = look->second->coherence.hits;
    if (zone.column < hits.size()) state_.list.selected = hits[zone.column];
    state_.sensor = zone.index;
    return true;
  }
  return Page::click(known, zone, x);
}

bool RecordingPage::animate(const Snapshot& known) {
  Playing& playing = state_.playing;
  if (!playing.on || playing.paused) return false;
  const RecordingInput input = recording_input(known);
  if (state_.run >= page_run_count(input)) return false;
  const double length = input.traces[state_.run].duration_s();
  constexpr double frame_s = 0.04;
  playing.time_s += frame_s * playing.speed;
  if (playing.time_s < length) return true;
  if (state_.run + 1 < page_run_count(input)) {
    ++state_.run;
    playing.time_s = 0.0;
  } else {
    playing = {};
  }
  return true;
}

std::vector<KeyHelp> RecordingPage::keys(const Snapshot&) const {
  if (state_.statements) return {{"i", "back to the hits"}};
  if (state_.overview) {
    return {{"j k", "run"},
            {"Enter", "show it"},
            {"s", "sort"},
            {"/", "filter"},
            {"o", "back"}};
  }
  if (state_.playing.on) {
    return {{"R", state_.playing.paused ? "go on" : "pause"},
            {"< >", "slower, faster"},
            {"_", "end of replay"},
            {"n p", "run"},
            {"Tab", "sensor"}};
  }
  return {{"Space", "accept/reject"},
          {"u", "undo"},
          {"n p", "run"},
          {"Enter", "zoom"},
          {"N", "next rejected"},
          {"Tab", "sensor"},
          {"R", "replay"},
          {"o", "all runs"},
          {"j k", "hit"},
          {"t", "tag"},
          {"*", "tag all listed"},
          {"T", "tags off"},
          {"i", "what was chosen"},
          {"f", "faults found"},
          {"+ -", "zoom"},
          {"[ ]", "pan"},
          {"_", "whole run"},
          {"h l", "cursor"},
          {"/", "filter"}};
}

std::string RecordingPage::help() const {
  return "The hammer's force above, responses below. ▼ is an accepted hit, ✗ "
         "one that was rejected; the list says why: double (the hammer "
         "struck twice), overload (clipped samples, or a force that the "
         "hammer's conditioner cuts off: i says which level), weak, soft (too "
         "little force at the upper band edge), truncated, outlier. Space "
         "overrules the "
         "judgement of the selected hit, or of all that are tagged; the "
         "average at the side, FRFs and all that follows are computed anew. A "
         "low row of the coherences is a bad sensor, a low column a bad hit. "
         "o lists all runs with what became of their hits. "
         "Enter zooms on the pulse with its force window, once more on the "
         "block with the exponential window. f lists what is wrong with the "
         "whole test, worst first: what was seen, what it likely is, what to "
         "do in test.json. R replays the run as if it were "
         "measured.";
}

}  // namespace tapfit::tui
