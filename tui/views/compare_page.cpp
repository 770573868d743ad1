// What the keys of the Compare screen do: from any number to its curves.
#include "tui/views/compare_view.hpp"
#include "tui/views/compared_modes.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/widgets/mac_map.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

using Focus = CompareState::Focus;

/// One step in 0 .. count - 1, or nothing for other keys.
bool step(std::size_t& at, std::size_t count, Key key, bool across) {
  const bool back =
      across ? key == U'h' || key == keys::left
             : key == U'k' || key == keys::up || key == keys::wheel_up;
  const bool on =
      across ? key == U'l' || key == keys::right
             : key == U'j' || key == keys::down || key == keys::wheel_down;
  if (!back && !on) return false;
  if (count == 0) return true;
  at = std::min(at, count - 1);
  if (back && at > 0) --at;
  if (on && at + 1 < count) ++at;
  return true;
}

/// The FRF that answers most between the two frequencies.
std::size_t loudest(const signal::FrfSet& frfs, double low, double high) {
  const Eigen::VectorXd f = frfs.frequency_hz();
  std::size_t found = 0;
  double largest = -1.0;
  for (std::size_t i = 0; i < frfs.frfs.size(); ++i) {
    for (Eigen::Index k = 0; k < f.size(); ++k) {
      if (f[k] < low || f[k] > high) continue;
      const double size = std::abs(frfs.frfs[i].H[k]);
      if (size <= largest) continue;
      largest = size;
      found = i;
    }
  }
  return found;
}

/// The FRF of that grid that fits worst.
std::size_t worst_of(const CompareInput& input,
                     int node,
                     std::size_t otherwise) {
  double largest = -1.0;
  for (std::size_t i = 0; i < input.frfs.frfs.size(); ++i) {
    const signal::Frf& frf = input.frfs.frfs[i];
    if (frf.response.node != node && frf.reference.node != node) continue;
    if (i >= input.comparison.frf_error.size()) continue;
    if (!(input.comparison.frf_error[i] > largest)) continue;
    largest = input.comparison.frf_error[i];
    otherwise = i;
  }
  return otherwise;
}

CompareInput compare_input(const Snapshot& known) {
  return {*known.comparison, *known.frfs, known.wire.get(), known.modes.get()};
}

}  // namespace

Screen ComparePage::draw(const Snapshot& known, const Canvas& canvas) const {
  return compare_view(compare_input(known), state_, canvas);
}

void ComparePage::look_at(const CompareInput& input, double low, double high) {
  const FrequencySpan span = frequency_span(input.frfs);
  state_.range = {std::max(low, span.lo), std::min(high, span.hi), 0.0, false};
}

bool ComparePage::looks_at(double low, double high) const {
  const double near = 0.02 * (high - low);
  return std::abs(state_.range.lo - low) < near &&
         std::abs(state_.range.hi - high) < near;
}

/// The curves behind the number that the cursor is on; once more the FRF
/// screen.
void ComparePage::enter(const CompareInput& input, Command& command) {
  const updating::Comparison& c = input.comparison;
  std::optional<double> hz;
  if (state_.focus == Focus::Map && state_.band < c.bands.size()) {
    const updating::BandError& band = c.bands[state_.band];
    const FrequencySpan span = frequency_span(input.frfs);
    const double low = std::max(band.low_hz, span.lo);
    const double high = std::min(band.high_hz, span.hi);
    if (!looks_at(low, high)) return look_at(input, low, high);
    hz = 0.5 * (low + high);
  } else if (state_.focus == Focus::Pairs) {
    const std::vector<ComparedMode> modes = compared_modes(input);
    if (modes.empty()) return;
    const ComparedMode& mode =
        modes[settled(compared_table(modes), state_.pairs)];
    const double low = 0.9 * std::fmin(mode.measured_hz, mode.model_hz);
    const double high = 1.1 * std::fmax(mode.measured_hz, mode.model_hz);
    const std::size_t best = loudest(input.frfs, low, high);
    if (!looks_at(low, high)) {
      state_.list.selected = best;
      state_.list.filter.clear();
      return look_at(input, low, high);
    }
    hz = mode.hz();
  } else if (state_.focus == Focus::Mac) {
    command.kind = Command::Kind::ShowMode;
    command.mode = state_.mac_row;
    command.model_mode =
        std::max(state_.mac_column,
                 static_cast<std::size_t>(rigid_modes(c.modes.frequency_hz)));
    return;
  } else if (state_.focus == Focus::Structure) {
    const auto points = worst_points(c);
    if (points.empty()) return;
    const int node = points[std::min(state_.point, points.size() - 1)].first;
    const std::size_t before = settled(compared_frfs(input), state_.list);
    const std::size_t worst = worst_of(input, node, before);
    if (worst != before) {
      state_.list.selected = worst;
      state_.list.filter.clear();
      return;
    }
  }
  command.kind = Command::Kind::ShowFrf;
  command.frf = settled(compared_frfs(input), state_.list);
  command.hz = hz;
}

/// Of modes and MAC the modes; else the FRFs.
bool ComparePage::sort(const CompareInput& input, Key key, Command& command) {
  const bool modes = state_.focus == Focus::Pairs ||
                     state_.focus == Focus::Mac || input.frfs.frfs.empty();
  return modes ? sort_key(state_.pairs,
                          compared_table(compared_modes(input)),
                          key,
                          command.message)
               : sort_key(
                     state_.list, compared_frfs(input), key, command.message);
}

bool ComparePage::move(const CompareInput& input, Key key) {
  const updating::Comparison& c = input.comparison;
  if (state_.focus == Focus::Map &&
      step(state_.band, c.bands.size(), key, true)) {
    return true;
  }
  if (state_.focus == Focus::Pairs) {
    return list_key(state_.pairs, compared_table(compared_modes(input)), key);
  }
  if (state_.focus == Focus::Mac) {
    const auto rows = static_cast<std::size_t>(c.mac.rows());
    return step(state_.mac_row, rows, key, false) ||
           step_column(state_.mac_column, c.modes.frequency_hz, key);
  }
  if (state_.focus == Focus::Structure) {
    return step(state_.point, c.point_error.size(), key, false);
  }
  return list_key(state_.list, compared_frfs(input), key);
}

// Where there are no curves the keys go between the pairs and the MAC.
bool ComparePage::press_modes_alone(const CompareInput& input,
                                    Key key,
                                    Command& command) {
  const bool on_mac = state_.focus == Focus::Mac;
  state_.focus = on_mac ? Focus::Mac : Focus::Pairs;
  if (key == keys::tab) {
    state_.focus = on_mac ? Focus::Pairs : Focus::Mac;
  } else if (key == keys::enter && on_mac) {
    enter(input, command);
  } else if (key != keys::enter) {
    return move(input, key) || sort(input, key, command);
  }
  return true;
}

bool ComparePage::press(const Snapshot& known, Key key, Command& command) {
  const CompareInput input = compare_input(known);
  if (input.frfs.frfs.empty()) return press_modes_alone(input, key, command);
  if (key == U'x') {
    state_.scale = next(state_.scale);
  } else if (key == keys::tab) {
    constexpr int all = static_cast<int>(Focus::Structure) + 1;
    state_.focus =
        static_cast<Focus>((static_cast<int>(state_.focus) + 1) % all);
  } else if (key == keys::enter) {
    enter(input, command);
  } else if (!move(input, key) && !sort(input, key, command) &&
             !pose_key(state_.pose, key)) {
    const FrequencySpan span = frequency_span(*known.frfs);
    return range_key(
        state_.range, key, span.lo, span.hi, line_spacing(*known.frfs));
  }
  return true;
}

bool ComparePage::click(const Snapshot& known, const Zone& zone, int x) {
  const auto pane = static_cast<Focus>(zone.pane);
  if (zone.kind == Zone::Kind::Entry && pane == Focus::Mac) {
    state_.focus = Focus::Mac;
    state_.mac_row = zone.index;
    state_.mac_column = zone.column;
  } else if (zone.kind == Zone::Kind::Entry) {
    state_.focus = Focus::Map;
    state_.list.selected =
        frf_order(compare_input(known), state_.list)[zone.index];
    state_.band = zone.column;
  } else if (zone.kind == Zone::Kind::Row && pane == Focus::Pairs) {
    state_.focus = Focus::Pairs;
    state_.pairs.selected = zone.index;
  } else if (zone.kind == Zone::Kind::Heading && pane == Focus::Pairs) {
    state_.focus = Focus::Pairs;
    sort_by_heading(state_.pairs, zone);
  } else {
    return Page::click(known, zone, x);
  }
  return true;
}

std::vector<KeyHelp> ComparePage::keys(const Snapshot&) const {
  const char* what = state_.focus == Focus::Map         ? "FRF, band"
                     : state_.focus == Focus::Pairs     ? "mode"
                     : state_.focus == Focus::Mac       ? "entry"
                     : state_.focus == Focus::Structure ? "point"
                                                        : "FRF, cursor";
  return {{"Tab", "next pane"},
          {"j k h l", what},
          {"Enter", state_.focus == Focus::Mac ? "open modes" : "open FRF"},
          {"s", "sort"},
          {"x", "log/lin/dB"},
          {"+ -", "zoom"},
          {"_", "whole band"},
          {"[ ]", "pan"},
          {"< > ( )", "turn"},
          {"/", "filter"}};
}

std::string ComparePage::help() const {
  return "The error is the root mean square of measured minus model over all "
         "FRFs and lines, each line divided by its mean measured magnitude, "
         "so that resonances and valleys count alike. The floor is what the "
         "scatter over hits and the mesh allow; a bar is green once it is "
         "within 1.3 times its floor, and the map is cold there; its hottest "
         "cells are ten times the floor. Tab goes from the list of FRFs to the "
         "map "
         "(which FRF fails in which band), the modes, the MAC and the "
         "structure (which point); where the window is wide they all stand "
         "beside each other. Enter shows the curves behind the number "
         "that is marked, once more the FRF by itself; Esc comes back. s sorts "
         "the FRFs by error or FRAC (the modes while their list is marked), a "
         "click on a heading does so, too.";
}

}  // namespace tapfit::tui
