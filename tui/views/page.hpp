// The room tui/views. The seven screens, one view each.
// In:  A snapshot, keys, clicks.
// Out: Cells, and what the user asks for.
// May include: its row in CONTRIBUTING.md.
//
// What the seven screens have in common.
#pragma once

#include "tui/screen/key.hpp"
#include "tui/screen/screen.hpp"
#include "tui/widgets/plot_range.hpp"
#include "tui/widgets/table.hpp"
#include "tui/workbench/snapshot.hpp"
#include "tui/workbench/workbench.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::tui {

/// What a key asks for beyond the screen itself.
struct Command {
  enum class Kind {
    None,
    OverruleHit,
    Add,
    Toggle,
    ShowRun,
    ShowFrf,
    ShowMode,
    PickPole,
    DropMode,
    Write
  };
  Kind kind = Kind::None;
  std::vector<std::pair<std::size_t, std::size_t>> hits;  ///< run, hit
  std::size_t run = 0;
  std::size_t frf = 0;
  std::optional<double> hz;    ///< of ShowFrf, PickPole, DropMode: where
  std::size_t mode = 0;        ///< of ShowMode: measured ...
  std::size_t model_mode = 0;  ///< ... and the model's beside it
  Output output = Output::Report;
  std::vector<updating::EffectRef> effects;  ///< of Add: in one step
  std::size_t added = 0;    ///< of Toggle: which of those added
  std::string message;      ///< for the message line, if not empty
  bool until_done = false;  ///< the message goes when what runs is done
};

struct KeyHelp {
  std::string key;
  std::string what;
};

class Page {
 public:
  Page() = default;
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;
  virtual ~Page() = default;

  [[nodiscard]] virtual std::string title() const = 0;
  /// True for screens that are about the model.
  [[nodiscard]] virtual bool wants_model() const { return false; }
  /// Why the screen has nothing to show of such a bundle; empty where it has.
  [[nodiscard]] virtual std::string nothing_here(
      const acquisition::TestBundle&) const {
    return {};
  }
  /// Results without which there is nothing to draw, in order.
  [[nodiscard]] virtual std::vector<Need> essential() const = 0;
  /// Whether it can do without one of them until it is there, with what was
  /// known before.
  [[nodiscard]] virtual bool can_wait_for(const Need&, const Snapshot&) const {
    return false;
  }
  /// Results that are asked for once the essential ones are there.
  [[nodiscard]] virtual std::vector<Need> welcome(const Snapshot&) const {
    return {};
  }
  /// @pre the essential results are there, but for those it can wait for
  [[nodiscard]] virtual Screen draw(const Snapshot& known,
                                    const Canvas& canvas) const = 0;
  /// @pre as of draw()
  /// @return true when the key meant something here
  virtual bool press(const Snapshot& known, Key key, Command& command) = 0;
  /// Goes back from what a key put in place of the screen's main view.
  /// @return false when that is what is shown
  virtual bool leave_view() { return false; }
  /// The list that `/` filters, if there is one.
  virtual ListState* list() { return nullptr; }
  /// The stretch of a plot that a click sets the cursor of.
  virtual PlotRange* range() { return nullptr; }
  /// What a click means: a row is selected, rows are sorted, the cursor is set.
  /// @return false when it means nothing here
  virtual bool click(const Snapshot& known, const Zone& zone, int x);
  /// Results are about to change: what was selected is to stay so, wherever it
  /// is listed then.
  virtual void follow(const Snapshot&, const Snapshot&) {}
  /// Moves what is animated by one frame; true when the screen has changed.
  virtual bool animate(const Snapshot&) { return false; }
  /// Those that do something now, most useful first; the key bar shows as many
  /// as fit.
  [[nodiscard]] virtual std::vector<KeyHelp> keys(const Snapshot&) const = 0;
  /// What the screen shows and how to read it.
  [[nodiscard]] virtual std::string help() const = 0;
};

inline bool Page::click(const Snapshot&, const Zone& zone, int x) {
  if (zone.kind == Zone::Kind::PlotX && range() != nullptr) {
    range()->cursor = zone.value_at(x);
    range()->cursor_set = true;
    return true;
  }
  if (zone.kind == Zone::Kind::Row && list() != nullptr) {
    list()->selected = zone.index;
    list()->nowhere = false;
    return true;
  }
  if (zone.kind == Zone::Kind::Heading && list() != nullptr) {
    sort_by_heading(*list(), zone);
    return true;
  }
  return false;
}

}  // namespace tapfit::tui
