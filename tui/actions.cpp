#include "tui/actions.hpp"

#include "tui/keep_work.hpp"
#include "tui/number.hpp"

#include <fmt/format.h>

namespace tapfit::tui {
namespace {

/// Reads the ladder anew and tells its last step.
std::string last_step(Workbench& bench,
                      Snapshot& known,
                      const Progress& progress,
                      const std::string& done) {
  const std::vector<updating::Rung> ladder = bench.ladder(progress);
  known.ladder = std::make_shared<const std::vector<updating::Rung>>(ladder);
  known.parameters = std::make_shared<const std::vector<updating::Estimate>>(
      bench.model_parameters(progress));
  if (ladder.empty()) return done;
  if (ladder.size() == 1) {
    return fmt::format(
        "{}: base model, error {}", done, percent(ladder.back().error));
  }
  return fmt::format("{}: error {} → {}",
                     done,
                     percent(ladder[ladder.size() - 2].error),
                     percent(ladder.back().error));
}

std::string effects_changed(Workbench& bench,
                            Snapshot& known,
                            const Progress& progress,
                            const std::string& done) {
  known.change_effects(bench.effects());
  const std::string told = last_step(bench, known, progress, done);
  return keep_work(bench, known, progress, told);
}

std::string add_now(Workbench& bench,
                    Snapshot& known,
                    const Progress& progress,
                    const updating::EffectRef& effect) {
  bench.add(effect, progress);
  return effects_changed(bench, known, progress, "added " + effect.effect);
}

/// Overruling is its own inverse. False when the hit's judgement stood firm.
bool toggle_hit(Workbench& bench,
                Snapshot& known,
                const Progress& progress,
                std::size_t run,
                std::size_t hit) {
  const bool before = bench.hits(progress).runs.at(run).at(hit).accepted;
  bench.overrule_hit(run, hit);
  known.forget_from_hits();
  known.hits =
      std::make_shared<const acquisition::HitSet>(bench.hits(progress));
  known.overruled = bench.overruled();
  return known.hits->runs[run][hit].accepted != before;
}

}  // namespace

Job overrule_hits(
    const std::vector<std::pair<std::size_t, std::size_t>>& hits) {
  return {"overruling the hit",
          [hits](Workbench& bench, Snapshot& known, const Progress& p) {
            std::size_t firm = 0;
            known.restored.clear();
            for (const auto& [run, hit] : hits) {
              if (!toggle_hit(bench, known, p, run, hit)) ++firm;
            }
            std::string told;
            if (hits.size() > 1) {
              told = fmt::format("{} hits overruled", hits.size() - firm);
            }
            if (firm > 0) {
              told += fmt::format("{}a truncated hit stays rejected",
                                  told.empty() ? "" : "; ");
            }
            return keep_work(bench, known, p, told);
          },
          std::nullopt};
}

Job restore_hit() {
  return {
      "taking the overruling back",
      [](Workbench& bench, Snapshot& known, const Progress& p) {
        if (known.overruled.empty()) {
          return std::string("no hit was overruled");
        }
        const auto [run, hit] = known.overruled.back();
        toggle_hit(bench, known, p, run, hit);
        known.restored.push_back({run, hit});
        return keep_work(
            bench,
            known,
            p,
            fmt::format("run {}, hit {}: judged as before", run + 1, hit + 1));
      },
      std::nullopt};
}

Job overrule_again() {
  return {
      "overruling the hit again",
      [](Workbench& bench, Snapshot& known, const Progress& p) {
        if (known.restored.empty()) return std::string("nothing to redo");
        const auto [run, hit] = known.restored.back();
        known.restored.pop_back();
        toggle_hit(bench, known, p, run, hit);
        return keep_work(
            bench,
            known,
            p,
            fmt::format("run {}, hit {}: overruled again", run + 1, hit + 1));
      },
      std::nullopt};
}

Job add_effect(const updating::EffectRef& effect) {
  return {"adding " + effect.effect,
          [effect](Workbench& bench, Snapshot& known, const Progress& p) {
            return add_now(bench, known, p, effect);
          },
          std::nullopt};
}

Job add_effect(const std::string& effect) {
  return {"adding " + effect,
          [effect](Workbench& bench, Snapshot& known, const Progress& p) {
            return add_now(bench, known, p, bench.parse_effect(effect));
          },
          std::nullopt};
}

Job toggle_effect(std::size_t effect) {
  return {"switching an effect",
          [effect](Workbench& bench, Snapshot& known, const Progress& p) {
            bench.toggle(effect, p);
            const updating::AddedEffect switched = bench.effects().at(effect);
            return effects_changed(
                bench,
                known,
                p,
                fmt::format("{} {}",
                            switched.ref.effect,
                            switched.on ? "switched on" : "switched off"));
          },
          std::nullopt};
}

Job write_output(Output what, const std::filesystem::path& to) {
  return {"writing",
          [what, to](Workbench& bench, Snapshot&, const Progress& p) {
            return "written: " + bench.write(what, to, p).string();
          },
          std::nullopt};
}

Job undo() {
  return {"undo",
          [](Workbench& bench, Snapshot& known, const Progress& p) {
            if (!bench.undo(p)) return std::string("nothing to undo");
            return effects_changed(bench, known, p, "undone");
          },
          std::nullopt};
}

Job redo() {
  return {"redo",
          [](Workbench& bench, Snapshot& known, const Progress& p) {
            if (!bench.redo(p)) return std::string("nothing to redo");
            return effects_changed(bench, known, p, "redone");
          },
          std::nullopt};
}

}  // namespace tapfit::tui
