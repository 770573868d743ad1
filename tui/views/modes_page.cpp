// What the keys of the Modes screen do.
#include "acquisition/bundle/channel_names.hpp"
#include "modal/mass_loading/sensor_shifts.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/views/modes_view.hpp"
#include "tui/widgets/mac_map.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::tui {
namespace {

std::string shift_statement(const Snapshot& known) {
  if (!modal::is_significant(known.modes->shifts)) return {};
  return modal::statement(*known.modes->shifts,
                          known.bundle
                              ? acquisition::channel_names(*known.bundle)
                              : std::vector<std::string>{});
}

/// The steady pole of the diagram that the cursor is meant to be on, else the
/// cursor itself.
double frequency_at(const modal::ModeSet& modes, double cursor, double reach) {
  double hz = cursor;
  double nearest = reach;
  for (const modal::DiagramPole& pole : modes.diagram) {
    const double away = std::abs(pole.frequency_hz - cursor);
    if (pole.letter != 's' || away > nearest) continue;
    nearest = away;
    hz = pole.frequency_hz;
  }
  return hz;
}

void pick_at_cursor(const Snapshot& known,
                    const PlotRange& range,
                    Command& command) {
  if (!range.cursor_set) {
    command.message = "put the cursor on a pole first: h l, or a click";
    return;
  }
  const FrequencySpan span = frequency_span(*known.frfs);
  const PlotRange shown = resolved(range, span.lo, span.hi);
  // A step of the cursor to either side.
  command.kind = Command::Kind::PickPole;
  command.hz =
      frequency_at(*known.modes, shown.cursor, 0.01 * (shown.hi - shown.lo));
}

/// Of the MAC: the model's modes, or without a model the measured ones again.
Eigen::VectorXd columns_hz(const Snapshot& known) {
  if (known.comparison) return known.comparison->modes.frequency_hz;
  Eigen::VectorXd hz(static_cast<Eigen::Index>(known.modes->modes.size()));
  for (Eigen::Index i = 0; i < hz.size(); ++i) {
    hz[i] = known.modes->modes[static_cast<std::size_t>(i)].frequency_hz;
  }
  return hz;
}

void drop_selected(const Snapshot& known,
                   const ListState& list,
                   Command& command) {
  const Table table = mode_table(*known.modes);
  if (table.rows.empty() || none_shown(table, list)) return;
  const std::size_t mode = settled(table, list);
  command.kind = Command::Kind::DropMode;
  command.hz = known.modes->modes.at(mode).frequency_hz;
}

}  // namespace

std::vector<Need> ModesPage::welcome(const Snapshot& known) const {
  std::vector<Need> needs;
  if (known.has_model) needs.push_back({Stage::Model});
  needs.push_back({Stage::Cmif});
  if (known.has_model && (state_.mac || state_.model)) {
    needs.push_back({Stage::Comparison});
  }
  return needs;
}

Screen ModesPage::draw(const Snapshot& known, const Canvas& canvas) const {
  return modes_view({*known.modes,
                     known.frfs.get(),
                     known.wire.get(),
                     known.comparison.get(),
                     shift_statement(known),
                     known.cmif.get()},
                    state_,
                    canvas);
}

bool ModesPage::press(const Snapshot& known, Key key, Command& command) {
  if (key == U'm') {
    state_.mac = !state_.mac;
  } else if (state_.mac &&
             step_column(state_.mac_column, columns_hz(known), key)) {
    return true;
  } else if (key == U'p' && given_) {
    command.message = "the modes were given: there is no pole to pick";
  } else if (key == U'p') {
    pick_at_cursor(known, state_.range, command);
  } else if (key == U'x') {
    drop_selected(known, state_.list, command);
  } else if (key == U'o') {
    state_.model = !state_.model;
  } else if (key == U'R') {
    state_.turning = !state_.turning;
  } else if (key == U' ') {
    state_.moving = !state_.moving;
    if (!state_.moving) state_.phase = 1.0;
  } else if (list_key(state_.list, mode_table(*known.modes), key)) {
    state_.model_mode.reset();
  } else if (!sort_key(
                 state_.list, mode_table(*known.modes), key, command.message) &&
             !pose_key(state_.pose, key)) {
    const FrequencySpan span = frequency_span(*known.frfs);
    return range_key(state_.range, key, span.lo, span.hi);
  }
  return true;
}

bool ModesPage::animate(const Snapshot&) {
  if (state_.turning) {
    state_.pose.azimuth_deg = std::fmod(state_.pose.azimuth_deg + 2.0, 360.0);
  }
  if (!state_.moving) return state_.turning;
  constexpr int frames = 24;  // of one swing
  state_.frame = (state_.frame + 1) % frames;
  state_.phase = std::cos(2.0 * std::numbers::pi * state_.frame / frames);
  return true;
}

std::vector<KeyHelp> ModesPage::keys(const Snapshot&) const {
  if (state_.mac) {
    return {{"j k", "mode"},
            {"h l", "model's mode"},
            {"m", "shape"},
            {"x", "drop mode"},
            {"s", "sort"},
            {"/", "filter"}};
  }
  if (given_) {
    return {{"j k", "mode"},
            {"m", "MAC"},
            {"x", "drop mode"},
            {"Space", "animate"},
            {"R", "rotate"},
            {"o", "model's shape"},
            {"< >", "turn"},
            {"( )", "tilt"},
            {"{ }", "size"},
            {"s", "sort"},
            {"/", "filter"}};
  }
  return {{"j k", "mode"},
          {"m", "MAC"},
          {"p", "pick pole"},
          {"x", "drop mode"},
          {"Space", "animate"},
          {"R", "rotate"},
          {"o", "model's shape"},
          {"< >", "turn"},
          {"( )", "tilt"},
          {"{ }", "size"},
          {"+ -", "zoom"},
          {"[ ]", "pan"},
          {"h l", "cursor"},
          {"s", "sort"},
          {"/", "filter"}};
}

std::string ModesPage::help() const {
  return "Modes identified from the FRFs, with one standard deviation. MPC is "
         "1 for a real shape. The diagram shows the poles of every model "
         "order: o new, f stable in frequency, d also in damping, v also in "
         "the vector, s in all; ▼ marks the modes that were taken, the grey "
         "curves are the complex mode indicator function: where two rise, two "
         "modes are close. The measured shape is drawn as stems, over the "
         "shape of the model's mode that is paired with it. m shows the MAC "
         "with the model, or of the measured modes among themselves where "
         "there is no model. p puts in the pole under the cursor, x takes the "
         "selected mode out, u undoes both.";
}

void ModesPage::select(std::size_t measured, std::size_t model) {
  state_.list.selected = measured;
  state_.list.filter.clear();
  state_.model_mode = model;
  state_.mac = false;
  state_.model = true;
}

}  // namespace tapfit::tui
