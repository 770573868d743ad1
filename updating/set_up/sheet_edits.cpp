#include "updating/set_up/sheet_edits.hpp"

#include "updating/places/held_support.hpp"
#include "updating/places/support_line.hpp"
#include "updating/set_up/point_edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace tapfit::effects {
namespace {

// The runs in which each edit is to be made.
using RunsOfEdit = std::map<std::string, std::vector<std::size_t>>;

// The file may give a sensitivity in another unit than it is kept in here.
std::string change_of(const acquisition::Channel& written,
                      const acquisition::Channel& real) {
  const double factor = real.sensitivity / written.sensitivity;
  return factor == -1.0 ? "other sign" : fmt::format("times {:.4g}", factor);
}

// Of the channel table.
void take_edits(std::size_t at,
                const acquisition::Channel& written,
                const acquisition::Channel& real,
                std::vector<std::string>& edits) {
  if (written.quantity != real.quantity) {
    edits.push_back(fmt::format("channels[{}].quantity: {} -> {}",
                                at,
                                acquisition::name(written.quantity),
                                acquisition::name(real.quantity)));
    edits.push_back(fmt::format(
        "channels[{}].unit: {} -> {}", at, written.unit, real.unit));
    edits.push_back(fmt::format("channels[{}].sensitivity: {:.5g} V/({})",
                                at,
                                real.sensitivity,
                                real.unit));
  } else if (written.sensitivity != real.sensitivity) {
    edits.push_back(fmt::format(
        "channels[{}].sensitivity: {}", at, change_of(written, real)));
  }
}

// As the file has it: a letter, or at a point of the test's own a vector.
std::string direction_text(const Dof& dof,
                           const acquisition::TestBundle& sheet) {
  const auto axis = (dof.component - 1) % 3;
  const std::string letter =
      fmt::format("{}{}", dof.sign < 0 ? '-' : '+', "XYZ"[axis]);
  const acquisition::TestPoint* point =
      acquisition::find_point(sheet.points, -dof.node);
  if (point == nullptr) return letter;
  if (point->system != 0) {
    return fmt::format("{} of system {}", letter, point->system);
  }
  // Plus zero, or a zero may have a sign.
  const Eigen::Vector3d along =
      (dof.sign * point->axes.col(axis)).array() + 0.0;
  return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", along(0), along(1), along(2));
}

void take_edits(const std::string& what,
                std::size_t run,
                const Dof& written,
                const Dof& real,
                const acquisition::TestBundle& sheet,
                RunsOfEdit& edits) {
  if (written.node != real.node) {
    edits[fmt::format("{}.node: {} -> {}",
                      what,
                      node_name(written.node),
                      node_name(real.node))]
        .push_back(run);
  }
  if (written.component != real.component || written.sign != real.sign) {
    edits[fmt::format("{}.direction: {} -> {}",
                      what,
                      direction_text(written, sheet),
                      direction_text(real, sheet))]
        .push_back(run);
  }
}

// "3", "3-5", "0,2,4".
std::string ranges(const std::vector<std::size_t>& runs) {
  std::string text;
  for (std::size_t k = 0; k < runs.size();) {
    std::size_t last = k;
    while (last + 1 < runs.size() && runs[last + 1] == runs[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ",", runs[k]);
    if (last > k) text += fmt::format("-{}", runs[last]);
    k = last + 1;
  }
  return text;
}

std::vector<std::string> line_edits(const acquisition::TestBundle& before,
                                    const acquisition::TestBundle& after) {
  RunsOfEdit edits;
  for (std::size_t r = 0; r < before.runs.size(); ++r) {
    const acquisition::Run& was = before.runs[r];
    const acquisition::Run& is = after.runs[r];
    take_edits("hammer", r, was.hammer.dof, is.hammer.dof, after, edits);
    for (std::size_t k = 0; k < was.sensors.size(); ++k) {
      take_edits(fmt::format("sensors[{}]", k),
                 r,
                 was.sensors[k].dof,
                 is.sensors[k].dof,
                 after,
                 edits);
    }
  }
  std::vector<std::string> result;
  for (std::size_t c = 0; c < before.channels.size(); ++c) {
    take_edits(c, before.channels[c], after.channels[c], result);
  }
  for (const auto& [edit, runs] : edits) {
    result.push_back(fmt::format("runs[{}].{}", ranges(runs), edit));
  }
  return result;
}

}  // namespace

std::vector<std::string> sheet_edits(const Effect& effect,
                                     const Location& where,
                                     const acquisition::TestBundle& written,
                                     const acquisition::TestBundle& before) {
  if (effect.changes_stiffness() == updating::ChangeKind::Support) {
    Location grids = where;
    grids.variant.clear();
    const bool held = updating::is_held(where);
    return {fmt::format("model: {} components {} (basic axes) at {}",
                        held ? "hold" : "release",
                        held ? updating::held_components(where.variant)
                             : updating::freed_components(where.variant),
                        describe(grids))};
  }
  acquisition::TestBundle after = before;
  effect.correct(where, written, after);
  return is_without_sheet(before) ? point_edits(before, after)
                                  : line_edits(before, after);
}

}  // namespace tapfit::effects
