#include "tui/app/actions.hpp"

#include "tui/app/keep_work.hpp"
#include "tui/screen/number.hpp"
#include "updating/session/added_effect.hpp"
#include "updating/session/effect_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace tapfit::tui {
namespace {

using updating::OverruledHit;

/// Reads the ladder anew and tells what the change did to the error.
/// @param before the error it was, where that is known
std::string told_of_change(Workbench& bench,
                           Snapshot& known,
                           const Progress& progress,
                           const std::string& done,
                           std::optional<double> before) {
  const std::vector<updating::Rung> ladder = bench.ladder(progress);
  known.ladder = std::make_shared<const std::vector<updating::Rung>>(ladder);
  known.parameters = std::make_shared<const std::vector<updating::Estimate>>(
      bench.model_parameters(progress));
  if (ladder.empty()) return done;
  const std::string now = percent(ladder.back().error);
  if (ladder.size() == 1) {
    return fmt::format("{}: base model, error {}", done, now);
  }
  if (!before) return fmt::format("{}: error {}", done, now);
  return fmt::format("{}: error {} → {}", done, percent(*before), now);
}

std::string effects_changed(Workbench& bench,
                            Snapshot& known,
                            const Progress& progress,
                            const std::string& done) {
  std::optional<double> before;
  if (known.ladder && !known.ladder->empty()) {
    before = known.ladder->back().error;
  }
  known.change_effects(bench.effects());
  return told_of_change(bench, known, progress, done, before);
}

std::string names_of(const std::vector<updating::EffectRef>& effects) {
  std::string names;
  for (const updating::EffectRef& ref : effects) {
    names += (names.empty() ? "" : "+") + ref.effect;
  }
  return names;
}

std::string add_now(Workbench& bench,
                    Snapshot& known,
                    const Progress& progress,
                    const std::vector<updating::EffectRef>& effects) {
  const std::string twice =
      updating::counted_twice(known.effects_on(), effects);
  bench.add_together(effects, progress);
  return effects_changed(bench, known, progress, "added " + names_of(effects)) +
         (twice.empty() ? "" : "; " + twice);
}

/// Overruling is its own inverse. False where it changes nothing: a truncated
/// hit stays rejected, and runs that are left out have none.
bool toggle_hit(Workbench& bench,
                Snapshot& known,
                const Progress& progress,
                const OverruledHit& which) {
  const auto& [run, hit, together] = which;
  const std::vector<acquisition::Hit>& there =
      bench.hits(progress).runs.at(run);
  if (hit >= there.size()) return false;
  const bool before = there[hit].accepted;
  bench.overrule_hit(run, hit);
  known.forget_from_hits();
  known.hits =
      std::make_shared<const acquisition::HitSet>(bench.hits(progress));
  return known.hits->runs[run][hit].accepted != before;
}

/// Carries the last act of one list over to the other; tells what it was.
std::string move_act(Workbench& bench,
                     Snapshot& known,
                     const Progress& progress,
                     std::vector<OverruledHit>& from,
                     std::vector<OverruledHit>& to,
                     const char* done) {
  const std::vector<OverruledHit> hits = updating::take_last_act(from);
  for (const OverruledHit& hit : hits) toggle_hit(bench, known, progress, hit);
  updating::add_act(to, hits);
  const std::string which =
      hits.size() == 1
          ? fmt::format("run {}, hit {}", hits[0].run + 1, hits[0].hit + 1)
          : fmt::format("{} hits", hits.size());
  return fmt::format("{}: {}", which, done);
}

}  // namespace

Job overrule_hits(
    const std::vector<std::pair<std::size_t, std::size_t>>& hits) {
  return kept("judging the hit manually",
              [hits](Workbench& bench, Snapshot& known, const Progress& p) {
                std::vector<OverruledHit> changed;
                for (const auto& [run, hit] : hits) {
                  const OverruledHit which{run, hit};
                  if (toggle_hit(bench, known, p, which))
                    changed.push_back(which);
                }
                updating::add_act(known.hit_acts.done, changed);
                if (!changed.empty()) known.hit_acts.undone.clear();
                std::string told;
                if (hits.size() > 1) {
                  told = fmt::format("{} hits judged manually", changed.size());
                }
                if (changed.size() < hits.size()) {
                  told += fmt::format("{}a truncated hit stays rejected",
                                      told.empty() ? "" : "; ");
                }
                return told;
              });
}

Job restore_hits() {
  return kept("undoing a manual judgement",
              [](Workbench& bench, Snapshot& known, const Progress& p) {
                auto& [done, undone] = known.hit_acts;
                if (done.empty()) return std::string("nothing to undo");
                return move_act(
                    bench, known, p, done, undone, "back to automatic");
              });
}

Job overrule_again() {
  return kept("judging the hit manually again",
              [](Workbench& bench, Snapshot& known, const Progress& p) {
                auto& [done, undone] = known.hit_acts;
                if (undone.empty()) return std::string("nothing to redo");
                return move_act(
                    bench, known, p, undone, done, "judged manually again");
              });
}

Job add_effects(const std::vector<updating::EffectRef>& effects) {
  return kept("adding " + names_of(effects),
              [effects](Workbench& bench, Snapshot& known, const Progress& p) {
                return add_now(bench, known, p, effects);
              });
}

Job add_effects(const std::string& typed) {
  return kept("adding " + typed,
              [typed](Workbench& bench, Snapshot& known, const Progress& p) {
                std::vector<updating::EffectRef> effects;
                std::istringstream words(typed);
                for (std::string word; words >> word;) {
                  effects.push_back(bench.parse_effect(word));
                }
                return add_now(bench, known, p, effects);
              });
}

Job toggle_effect(std::size_t effect) {
  return kept("switching an effect",
              [effect](Workbench& bench, Snapshot& known, const Progress& p) {
                bench.toggle(effect, p);
                const updating::AddedEffect switched =
                    bench.effects().at(effect);
                return effects_changed(
                    bench,
                    known,
                    p,
                    fmt::format("{} {}",
                                switched.ref.effect,
                                switched.on ? "switched on" : "switched off"));
              });
}

Job write_output(Output what,
                 const std::filesystem::path& to,
                 bool replace,
                 const std::string& note) {
  return {"writing",
          [what, to, replace, note](
              Workbench& bench, Snapshot&, const Progress& p) {
            return note + "written: " + bench.write(what, to, replace, p);
          },
          std::nullopt};
}

Job undo() {
  return kept("undo", [](Workbench& bench, Snapshot& known, const Progress& p) {
    if (!bench.undo(p)) return std::string("nothing to undo");
    return effects_changed(bench, known, p, "undone");
  });
}

Job redo() {
  return kept("redo", [](Workbench& bench, Snapshot& known, const Progress& p) {
    if (!bench.redo(p)) return std::string("nothing to redo");
    return effects_changed(bench, known, p, "redone");
  });
}

}  // namespace tapfit::tui
