#include "tui/app/mode_actions.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/app/keep_work.hpp"
#include "tui/workbench/pair_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <sstream>
#include <utility>
#include <vector>

namespace tapfit::tui {
namespace {

using updating::ModeChoices;

/// Hands over what the workbench now holds and tells how many modes there are.
std::string changed(Workbench& bench,
                    Snapshot& known,
                    const Progress& progress,
                    const std::string& done) {
  known.forget_from_modes();
  known.modes = std::make_shared<const modal::ModeSet>(bench.modes(progress));
  return fmt::format("{}: {} modes", done, known.modes->modes.size());
}

/// A job that changes the choices.
Job choose(const std::string& title,
           std::string done,
           std::function<void(ModeChoices&)> change) {
  return kept(title,
              [done = std::move(done), change = std::move(change)](
                  Workbench& bench, Snapshot& known, const Progress& p) {
                ModeChoices choices = bench.mode_choices();
                change(choices);
                bench.choose_modes(choices, p);
                return changed(bench, known, p, done);
              });
}

[[noreturn]] void refuse_choice(const std::string& word) {
  throw InputError(
      "not understood",
      ":" + word,
      "write for example :drop 12.98, :pick 12.98 (both in Hz), :pair 2:3, "
      ":pair 2:none, :band 10 60 or :band all");
}

std::vector<double> numbers(const std::string& text, const std::string& word) {
  std::istringstream stream(text);
  std::vector<double> values;
  double value = 0.0;
  while (stream >> value) values.push_back(value);
  const auto positive = [](double hz) { return std::isfinite(hz) && hz > 0.0; };
  if (!stream.eof() || values.empty() ||
      !std::all_of(values.begin(), values.end(), positive)) {
    refuse_choice(word);
  }
  return values;
}

}  // namespace

Job drop_mode(double hz) {
  return choose("dropping a mode",
                fmt::format("dropped the mode at {:.5g} Hz", hz),
                [hz](ModeChoices& choices) {
                  choices.edits.push_back({modal::PoleEdit::What::Drop, hz});
                });
}

Job add_mode(double hz) {
  return choose("putting a mode in",
                fmt::format("put a mode in at {:.5g} Hz", hz),
                [hz](ModeChoices& choices) {
                  choices.edits.push_back({modal::PoleEdit::What::Add, hz});
                });
}

Job mode_band(const std::optional<std::array<double, 2>>& band) {
  return choose(
      "identifying modes",
      band ? fmt::format("band {:.5g} to {:.5g} Hz", (*band)[0], (*band)[1])
           : std::string("all lines"),
      [band](ModeChoices& choices) { choices.band_hz = band; });
}

Job pair_mode(std::size_t measured, int model) {
  return kept(
      "pairing modes",
      [measured, model](Workbench& bench, Snapshot& known, const Progress& p) {
        const auto& modes = bench.modes(p).modes;
        if (measured >= modes.size()) {
          throw InputError(
              fmt::format("there is no measured mode {}", measured + 1),
              "pair",
              fmt::format("{} were identified", modes.size()));
        }
        const auto there = known.comparison == nullptr
                               ? Eigen::Index{model + 1}
                               : known.comparison->modes.frequency_hz.size();
        if (model >= there) {
          throw InputError(
              fmt::format("the model has no mode {} in the band", model + 1),
              "pair",
              fmt::format("it has {} there", there));
        }
        bench.choose_modes(with_pair(bench.mode_choices(),
                                     {modes[measured].frequency_hz, model}),
                           p);
        known.forget_pairs();
        return fmt::format("mode {} is paired by hand", measured + 1);
      });
}

Job undo_modes() {
  return kept("undo", [](Workbench& bench, Snapshot& known, const Progress& p) {
    if (!bench.undo_modes(p)) return std::string("nothing to undo");
    return changed(bench, known, p, "undone");
  });
}

Job redo_modes() {
  return kept("redo", [](Workbench& bench, Snapshot& known, const Progress& p) {
    if (!bench.redo_modes(p)) return std::string("nothing to redo");
    return changed(bench, known, p, "redone");
  });
}

Job mode_action(const std::string& word, const std::string& argument) {
  if (word == "pair") {
    const std::optional<modal::Pair> pair = parse_pair(argument);
    if (!pair) refuse_choice(word);
    return pair_mode(static_cast<std::size_t>(pair->measured),
                     static_cast<int>(pair->model));
  }
  if (word == "band" && argument == "all") return mode_band(std::nullopt);
  const std::vector<double> hz = numbers(argument, word);
  if (word == "band" && hz.size() == 2) return mode_band({{hz[0], hz[1]}});
  if (word == "drop" && hz.size() == 1) return drop_mode(hz[0]);
  if (word == "pick" && hz.size() == 1) return add_mode(hz[0]);
  refuse_choice(word);
}

}  // namespace tapfit::tui
